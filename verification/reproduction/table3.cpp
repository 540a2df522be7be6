// SPDX-License-Identifier: Apache-2.0
// Table 3: frames per second.
#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "common/scenario/shipped.hpp"
#include "output/provenance.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/suite/subjects.hpp"

#include <algorithm>
#include <chrono>
#include <map>

namespace aneurysm::reproduction
{
namespace
{

using Clock = std::chrono::steady_clock;

/// What one backend made of one test condition.
struct Speed {
    double fps = 0;
    double iterations = 0;    ///< of the pressure solve, per frame
    double density_error = 0; ///< mean
    std::int64_t frames = 0;
};

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Whole frames without output, after the start has settled.
Speed measure(const Scenario& scenario, const backends::BackendChoice& choice, double seconds)
{
    const std::unique_ptr<Simulation> backend = backends::make_simulation(choice, scenario, std::nullopt);
    constexpr std::int64_t first = 10;
    const Clock::time_point beginning = Clock::now();
    for (std::int64_t k = 0; k < first && (k == 0 || seconds_since(beginning) < seconds); ++k) {
        backend->advance();
    }
    Speed speed;
    const Clock::time_point start = Clock::now();
    while (speed.frames < 3 || (seconds_since(start) < seconds && speed.frames < 500)) {
        const FrameRecord record = backend->advance();
        speed.iterations += static_cast<double>(record.iterations);
        speed.density_error += record.density_error_mean;
        ++speed.frames;
        if (InterruptWatch::interrupted()) {
            throw Interrupted();
        }
    }
    const auto n = static_cast<double>(speed.frames);
    speed.fps = n / seconds_since(start);
    speed.iterations /= n;
    speed.density_error /= n;
    return speed;
}

/// Speed of a scenario against another's. They take turns, so that a machine whose own speed changes with
/// time treats both alike; the median leaves out turns that something else disturbed.
double relative_speed(const Scenario& scenario, const Scenario& other, const backends::BackendChoice& choice,
                      double seconds)
{
    constexpr std::int64_t turn = 20; // frames
    constexpr std::size_t fewest = 5; // turns
    constexpr std::size_t most = 25;  // before any wall ruptures
    const std::unique_ptr<Simulation> backend = backends::make_simulation(choice, scenario, std::nullopt);
    const std::unique_ptr<Simulation> other_backend = backends::make_simulation(choice, other, std::nullopt);
    const auto time_of_turn = [](Simulation& b) {
        const Clock::time_point start = Clock::now();
        for (std::int64_t k = 0; k < turn; ++k) {
            b.advance();
        }
        if (InterruptWatch::interrupted()) {
            throw Interrupted();
        }
        return seconds_since(start);
    };
    time_of_turn(*backend); // not counted: caches are cold, and the start settles
    time_of_turn(*other_backend);
    std::vector<double> ratios;
    const Clock::time_point start = Clock::now();
    while (ratios.size() < fewest || (seconds_since(start) < seconds && ratios.size() < most)) {
        const double time = time_of_turn(*backend);
        ratios.push_back(time_of_turn(*other_backend) / time);
    }
    const auto middle = ratios.begin() + std::ssize(ratios) / 2;
    std::ranges::nth_element(ratios, middle);
    return *middle;
}

struct Column {
    std::string name;
    backends::BackendChoice backend;
    std::string missing; ///< why it can't be run here
};

std::vector<Column> columns()
{
    std::vector<Column> all;
    for (const suite::SuiteSubject& s : suite::make_subjects()) {
        backends::BackendChoice backend = s.subject.choice;
        backend.threads = 0; // all cores
        all.push_back({name_of(backend), backend, s.missing});
    }
    return all;
}

std::string ratio(double ours, double theirs)
{
    return number(ours / theirs, 3);
}

using Speeds = std::map<std::string, std::map<std::string, double>>; ///< by condition and backend

/// `seconds`: that the comparison of TC2 with TC3 may take
std::vector<Claim> claims_about(const nlohmann::json& conditions, const Speeds& fps, double seconds)
{
    const auto condition = [&conditions](const std::string& name) {
        return *std::ranges::find_if(conditions,
                                     [&name](const nlohmann::json& row) { return row.at("name") == name; });
    };
    const nlohmann::json with = condition("TC2");
    const nlohmann::json without = condition("TC3");
    const double ours =
        relative_speed(shipped_scenario(with.at("scenario")), shipped_scenario(without.at("scenario")),
                       {Backend::cpu, Precision::float_}, seconds);
    const auto theirs = [&](const char* column) {
        return ratio(with.at(column).get<double>(), without.at(column).get<double>());
    };
    const auto speed = [&fps](const std::string& name) { return fps.at(name).at("cpu float"); };
    return {{"The aneurysm has little influence on the speed (TC2 against TC3)", std::abs(ours - 1) < 0.25,
             "TC2 / TC3, by turns: " + number(ours, 3) + " here (cpu float), " + theirs("cpu_fps") +
                 " on CPU and " + theirs("cuda_fps") + " with CUDA in the paper"},
            {"The speed falls as the particle number rises",
             speed("TC1") > speed("TC2") && speed("TC2") > speed("TC4"),
             number(speed("TC1"), 3) + ", " + number(speed("TC2"), 3) + ", " + number(speed("TC4"), 3)}};
}

} // namespace

Section table3(Reproduction& reproduction)
{
    constexpr double seconds = 8;
    Section section{"table3", "Table 3: frames per second under four test conditions"};
    ResultTable table{"Frames per second",
                      {"condition", "particles", "aneurysm", "paper, CPU", "paper, CUDA"}};
    ResultTable errors{"At which errors",
                       {"condition", "backend", "frames", "iterations a frame", "mean density error"}};
    const std::vector<Column> all = columns();
    for (const Column& column : all) {
        table.columns.push_back(column.name);
        if (!column.missing.empty()) {
            section.text.push_back("Not run: " + column.name + ", " + column.missing);
        }
    }
    table.columns.insert(table.columns.end(), {"best here / paper, CPU", "best here / paper, CUDA"});
    const nlohmann::json& conditions = reproduction.paper.at("table3");
    Progress progress("measurement", 0, static_cast<std::int64_t>(conditions.size() * all.size() + 1));
    std::int64_t done = 0;
    Speeds fps;
    for (const auto& row : conditions) {
        const std::string name = row.at("name");
        const Scenario scenario = shipped_scenario(row.at("scenario"));
        table.add(name, row.at("particles").get<int>(), row.at("aneurysm").get<bool>() ? "yes" : "no",
                  row.at("cpu_fps").get<double>(), row.at("cuda_fps").get<double>());
        double best = 0;
        for (const Column& column : all) {
            progress.show(done++, name + " " + column.name);
            if (!column.missing.empty()) {
                table.rows.back().push_back("not run");
                continue;
            }
            const Speed speed = measure(scenario, column.backend, seconds);
            best = std::max(best, speed.fps);
            fps[name][column.name] = speed.fps;
            table.rows.back().push_back(number(speed.fps, 3));
            errors.add(name, column.name, speed.frames, number(speed.iterations, 3),
                       number(100 * speed.density_error, 2) + " %");
        }
        table.rows.back().push_back(ratio(best, row.at("cpu_fps")));
        table.rows.back().push_back(ratio(best, row.at("cuda_fps")));
    }
    section.text.push_back(
        "On " + output::machine() +
        ". Whole frames with growth and without output or "
        "rendering, from the start of a run, where the solve takes the most iterations; "
        "bench_frames measures the same with more care. The paper's processor is an i5-9300H; "
        "its times seem to include rendering.");
    progress.show(done, "TC2 and TC3 by turns");
    section.claims = claims_about(conditions, fps, 2 * seconds);
    section.tables = {table, errors};
    return section;
}

} // namespace aneurysm::reproduction
