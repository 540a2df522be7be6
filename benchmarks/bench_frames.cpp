// SPDX-License-Identifier: Apache-2.0
// Frames per second of whole frames, growth included and without output, for every backend and particle
// number, with the errors that they were reached at: a speed without its error says nothing. Prints a table
// with the paper's numbers beside ours.
//
//     bench_frames DATA [--table FILE] [Google Benchmark's options]
//     bench_frames data --benchmark_filter='frames/(tc1|tc2|tc3|tc4)/cpu'
#include "benchmarks/machine.hpp"
#include "common/error.hpp"
#include "common/exception.hpp"
#include "common/parallel.hpp"
#include "common/process/descriptors.hpp"
#include "common/scenario/limits.hpp"
#include "output/file.hpp"
#include "verification/backends/make_simulation.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

namespace
{

using namespace aneurysm;

/// What is run.
struct Case {
    std::string name;
    Scenario scenario;
    double paper_cpu = 0; ///< FPS of the paper's Table 3; 0: it has none
    double paper_gpu = 0;
};

Scenario with_count(const std::filesystem::path& data, std::int64_t count)
{
    Scenario s = read_scenario(data / "scenarios/paper_tc1.json");
    s.particles.count = count;
    s.name = std::to_string(count);
    // A frame is one step here, as long as the flow stays stable for at this resolution.
    s.time.frame_s = std::min(s.time.frame_s, 0.9 * step_limits(s, estimated_spacing(s)).smallest());
    return s;
}

std::vector<Case> cases(const std::filesystem::path& data)
{
    std::vector<Case> all;
    const auto paper = [&](const char* name, double cpu, double gpu) {
        all.push_back(
            {name, read_scenario(data / "scenarios" / ("paper_" + std::string(name) + ".json")), cpu, gpu});
    };
    paper("tc1", 5.65, 86.95);
    paper("tc2", 1.61, 54.56);
    paper("tc3", 1.72, 54.15);
    paper("tc4", 0.45, 11.10);
    for (const std::int64_t count : {150'000, 1'000'000, 8'000'000}) {
        all.push_back({std::to_string(count), with_count(data, count), 0, 0});
    }
    return all;
}

/// Sums over the timed frames, as counters.
struct Tally {
    double count = 0;
    double iterations = 0;
    double corrections = 0;
    double density_mean = 0;
    double density_max = -1;
    double divergence_mean = 0;
    double divergence_max = 0;

    void add(const FrameRecord& r)
    {
        ++count;
        iterations += static_cast<double>(r.iterations);
        corrections += static_cast<double>(r.corrections);
        density_mean += r.density_error_mean;
        density_max = std::max(density_max, r.density_error_max);
        divergence_mean += r.divergence_mean;
        divergence_max = std::max(divergence_max, r.divergence_max);
    }
};

void frames(benchmark::State& state, const Case& c, const backends::BackendChoice& choice, int start_up)
{
    const auto particles = static_cast<double>(c.scenario.particles.count);
    std::unique_ptr<Simulation> simulation;
    try {
        simulation = backends::make_simulation(choice, c.scenario, std::nullopt);
    } catch (const Error& error) {
        state.SkipWithError(error.what());
        return;
    }
    for (int frame = 0; frame < start_up; ++frame) {
        simulation->advance();
    }
    simulation->take_profile();
    Tally tally;
    for ([[maybe_unused]] auto _ : state) { // NOLINT(clang-analyzer-deadcode.DeadStores)
        tally.add(simulation->advance());
    }
    auto& counters = state.counters;
    const double n = tally.count;
    counters["FPS"] = benchmark::Counter(n, benchmark::Counter::kIsRate);
    counters["particles"] = particles;
    counters["particle_frames_per_s"] = benchmark::Counter(n * particles, benchmark::Counter::kIsRate);
    counters["iterations"] = tally.iterations / n;
    counters["corrections"] = tally.corrections / n;
    counters["density_error_mean"] = tally.density_mean / n;
    counters["density_error_max"] = tally.density_max;
    counters["divergence_mean_per_s"] = tally.divergence_mean / n;
    counters["divergence_max_per_s"] = tally.divergence_max;
    counters["bytes_per_particle"] = static_cast<double>(simulation->bytes()) / particles;
    for (const auto& [pass, seconds] : simulation->take_profile()) {
        counters["ms_" + pass] = 1e3 * seconds / n;
        const auto [free_pairs, ghost_pairs] = simulation->pairs();
        const auto free = static_cast<double>(free_pairs);
        const auto all = static_cast<double>(free_pairs + ghost_pairs);
        if (pass == "pressure") { // two passes over all pairs of free particles in every evaluation of (3)
            counters["ns_per_pair"] = 1e9 * seconds / (2 * free * (tally.iterations + n));
        } else if (pass == "neighbors") {
            counters["search_ns_per_pair"] = 1e9 * seconds / (all * n);
        }
    }
}

void copy(benchmark::State& state, int threads)
{
    for ([[maybe_unused]] auto _ : state) { // NOLINT(clang-analyzer-deadcode.DeadStores)
        state.counters["GB_per_s"] = 1e-9 * benchmarks::copy_bandwidth(threads);
    }
}

void bare_pairs(benchmark::State& state, int threads, std::int32_t particles)
{
    for ([[maybe_unused]] auto _ : state) { // NOLINT(clang-analyzer-deadcode.DeadStores)
        state.counters["ns_per_pair"] = 1e9 * benchmarks::bare_pair_seconds(threads, particles);
    }
}

/// Collects what the console shows, for the table.
class Collector final : public benchmark::ConsoleReporter
{
public:
    Collector() : ConsoleReporter(OO_Tabular) {}
    void ReportRuns(const std::vector<Run>& runs) override
    {
        ConsoleReporter::ReportRuns(runs);
        runs_.insert(runs_.end(), runs.begin(), runs.end());
    }
    const std::vector<Run>& runs() const { return runs_; }

private:
    std::vector<Run> runs_;
};

double counter(const benchmark::BenchmarkReporter::Run& run, const std::string& name)
{
    const auto at = run.counters.find(name);
    return at == run.counters.end() ? NAN : at->second.value;
}

std::string number(double value, int digits)
{
    if (!std::isfinite(value)) {
        return "-";
    }
    std::ostringstream text;
    text << std::setprecision(digits) << value;
    return text.str();
}

/// Google Benchmark before 1.8 calls it an error.
template <class Run>
std::string why_not_run(const Run& run)
{
    if constexpr (requires { run.skipped; }) {
        return run.skipped != decltype(run.skipped){} ? run.skip_message : std::string();
    } else {
        return run.error_occurred ? run.error_message : std::string();
    }
}

std::string table(const std::vector<benchmark::BenchmarkReporter::Run>& runs, const std::vector<Case>& all)
{
    std::ostringstream text;
    text
        << "| benchmark | particles | FPS | paper CPU | paper GPU | iterations, corrections | density error mean, max | "
           "divergence mean, max [1/s] | ns a pair | bytes a particle |\n"
           "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const auto& run : runs) {
        const std::string name = run.run_name.function_name;
        if (const std::string reason = why_not_run(run); !reason.empty()) {
            text << "| " << name << " | not run: " << reason << " |\n";
            continue;
        }
        if (run.counters.contains("GB_per_s")) {
            text << "| " << name << " | " << number(counter(run, "GB_per_s"), 3) << " GB/s |\n";
            continue;
        }
        if (!run.counters.contains("FPS")) {
            text << "| " << name << " | " << number(counter(run, "ns_per_pair"), 3) << " ns a pair |\n";
            continue;
        }
        const auto c = std::ranges::find_if(
            all, [&](const Case& one) { return name.starts_with("frames/" + one.name + "/"); });
        const auto paper = [&](double fps) { return c != all.end() && fps > 0 ? number(fps, 4) : "-"; };
        text << "| " << name << " | " << number(counter(run, "particles"), 8) << " | "
             << number(counter(run, "FPS"), 4) << " | " << (c != all.end() ? paper(c->paper_cpu) : "-")
             << " | " << (c != all.end() ? paper(c->paper_gpu) : "-") << " | "
             << number(counter(run, "iterations"), 4) << ", " << number(counter(run, "corrections"), 4)
             << " | " << number(100 * counter(run, "density_error_mean"), 3) << " %, "
             << number(100 * counter(run, "density_error_max"), 3) << " % | "
             << number(counter(run, "divergence_mean_per_s"), 3) << ", "
             << number(counter(run, "divergence_max_per_s"), 3) << " | "
             << number(counter(run, "ns_per_pair"), 3) << " | "
             << number(counter(run, "bytes_per_particle"), 4) << " |\n";
    }
    return text.str();
}

/// Frames that are timed: some ten seconds of them.
int timed_frames(Backend backend, std::int64_t particles)
{
    const double per_second = backend == Backend::reference ? 2e5 : backend == Backend::cpu ? 1.5e6 : 2e8;
    return static_cast<int>(std::clamp(10 * per_second / static_cast<double>(particles), 3.0, 1000.0));
}

void register_all(const std::vector<Case>& all)
{
    const int cores = paying_threads();
    const auto add = [](const Case& c, Backend backend, Precision precision, int threads) {
        const std::string words = name_of(backend) +
                                  (backend == Backend::reference ? "" : "/" + name_of(precision)) +
                                  (backend == Backend::cpu ? "/threads:" + std::to_string(threads) : "");
        const int timed = timed_frames(backend, c.scenario.particles.count);
        benchmark::RegisterBenchmark(("frames/" + c.name + "/" + words).c_str(), frames, c,
                                     backends::BackendChoice{backend, precision, threads},
                                     std::min(timed, 100))
            ->Iterations(timed)
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
    };
    std::vector<int> teams{1};
    if (cores > 1) {
        teams.push_back(cores);
    }
    for (const int threads : teams) {
        const std::string name = "/threads:" + std::to_string(threads);
        benchmark::RegisterBenchmark(("copy" + name).c_str(), copy, threads)->Iterations(1);
        for (const std::int32_t n : {5'520, 40'296}) {
            benchmark::RegisterBenchmark(("bare_pairs/" + std::to_string(n) + name).c_str(), bare_pairs,
                                         threads, n)
                ->Iterations(1);
        }
    }
    for (const Case& c : all) {
        if (c.scenario.particles.count < 100'000) {
            add(c, Backend::reference, Precision::double_, 1);
        }
        for (const int threads : teams) {
            add(c, Backend::cpu, Precision::float_, threads);
        }
        add(c, Backend::cpu, Precision::double_, teams.back());
        add(c, Backend::cuda, Precision::float_, 0);
        add(c, Backend::cuda, Precision::double_, 0);
    }
}

} // namespace

int main(int argc, char** argv)
{
    fill_standard_descriptors();
    benchmark::Initialize(&argc, argv);
    std::string data;
    std::string table_file;
    for (int i = 1; i < argc; ++i) {
        if (std::string(argv[i]) == "--table" && i + 1 < argc) {
            table_file = argv[++i];
        } else {
            data = argv[i];
        }
    }
    try {
        if (data.empty()) {
            throw InputError("bench_frames", "no data directory given", "needed: bench_frames data");
        }
        const std::vector<Case> all = cases(data);
        register_all(all);
        Collector collector;
        if (benchmark::RunSpecifiedBenchmarks(&collector) == 0) {
            throw InputError("--benchmark_filter", "matches no benchmark",
                             "needed: an expression for names as --benchmark_list_tests prints them");
        }
        const std::string text = table(collector.runs(), all);
        std::cout << "\n" << text;
        if (!table_file.empty()) {
            output::write_atomically(table_file, text);
        }
    } catch (const std::exception& error) {
        std::cerr << text_of(error) << "\n";
        return is_bad_input(error) ? 2 : 1;
    }
    return 0;
}
