// SPDX-License-Identifier: Apache-2.0
// What the reproduction works out: walls along recorded impacts, frames of rupture by yield limit, kept runs.
#include "common/error.hpp"
#include "output/file.hpp"
#include "tests/files.hpp"
#include "tests/vessels.hpp"
#include "verification/reproduction/calibrate.hpp"
#include "verification/reproduction/ensemble.hpp"
#include "verification/reproduction/wall_history.hpp"

#include <cmath>
#include <filesystem>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

const backends::BackendChoice cpu{Backend::cpu, Precision::float_, 1, 0};

std::vector<FrameRecord> run(const Scenario& scenario, const backends::BackendChoice& choice)
{
    const std::unique_ptr<Simulation> backend = backends::make_simulation(choice, scenario, std::nullopt);
    std::vector<FrameRecord> records;
    while (std::ssize(records) < scenario.time.frames) {
        records.push_back(backend->advance());
    }
    return records;
}

Scenario quick()
{
    Scenario scenario = shipped_scenario("quick");
    scenario.time.frames = 350;
    return scenario;
}

/// Without rupture; made once.
const reproduction::Member& held()
{
    const Scenario scenario = reproduction::unbreakable(quick());
    static const reproduction::Member member{scenario, run(scenario, cpu)};
    return member;
}

/// Walls of both kinds: some rupture, one while the sac still grows, one holds.
std::vector<reproduction::RuptureRow> walls()
{
    return {{0.4, 0.006, 0}, {0.3, 0.006, 0}, {0.6, 0.0055, 0}, {0.4, 0.001, 0}};
}

} // namespace

BOOST_AUTO_TEST_CASE(walls_along_recorded_impacts_rupture_in_the_frame_of_the_live_run)
{
    int ruptured = 0;
    for (const reproduction::RuptureRow& row : walls()) {
        const Scenario scenario = reproduction::with_wall(quick(), row);
        const std::vector<FrameRecord> live = run(scenario, cpu);
        const reproduction::WallHistory history = reproduction::wall_along(scenario, held().records);
        const auto end = std::ranges::find(live, Phase::ruptured, &FrameRecord::phase);
        const auto frames = history.rupture_frame ? *history.rupture_frame : std::ssize(live);
        BOOST_TEST(history.rupture_frame.value_or(-1) == (end == live.end() ? -1 : end->frame));
        BOOST_TEST_REQUIRE(std::ssize(history.frames) == frames);
        for (std::size_t k = 0; k < history.frames.size(); ++k) {
            // to the bit, until the breach changes the flow
            BOOST_TEST(held().records[k].impact_force == live[k].impact_force);
            BOOST_TEST(history.frames[k].radius == live[k].radius);
            BOOST_TEST(history.frames[k].thickness == live[k].thickness);
            BOOST_TEST(history.frames[k].critical_pressure == live[k].critical_pressure);
        }
        ruptured += history.rupture_frame ? 1 : 0;
    }
    BOOST_TEST(ruptured == 3);
}

BOOST_AUTO_TEST_CASE(the_reference_runs_by_the_same_walls)
{
    Scenario scenario = quick();
    scenario.time.frames = 120;
    const std::vector<FrameRecord> records = run(scenario, {Backend::reference, Precision::double_, 1, 0});
    const reproduction::WallHistory history = reproduction::wall_along(scenario, records);
    BOOST_TEST(history.frames.back().thickness == records.back().thickness);
    BOOST_TEST(history.frames.back().critical_pressure == records.back().critical_pressure);
}

BOOST_AUTO_TEST_CASE(impacts_that_are_not_the_runs_own_are_refused)
{
    std::vector<FrameRecord> records = held().records;
    records[60].wall_load *= 1 + 1e-9;
    BOOST_CHECK_THROW(reproduction::wall_along(quick(), records), Error);
    Scenario other = quick();
    other.growth.wall_mass_kg *= 1.001;
    BOOST_CHECK_THROW(reproduction::wall_along(other, held().records), Error);
}

BOOST_AUTO_TEST_CASE(a_wall_under_a_steady_impact_is_the_wall_along_a_record_of_it)
{
    const Scenario scenario = reproduction::unbreakable(quick());
    const std::vector<reproduction::WallFrame> frames = reproduction::wall_under(scenario, 400, 150);
    std::vector<FrameRecord> records;
    for (const reproduction::WallFrame& frame : frames) {
        records.emplace_back();
        records.back().frame = std::ssize(records);
        records.back().wall_load = 400;
        records.back().radius = frame.radius;
    }
    const reproduction::WallHistory history = reproduction::wall_along(scenario, records);
    BOOST_TEST_REQUIRE(history.frames.size() == frames.size());
    BOOST_TEST(history.frames.back().thickness == frames.back().thickness);
    BOOST_TEST(history.frames.back().critical_pressure == frames.back().critical_pressure);
    BOOST_TEST(frames.back().radius > frames.front().radius);
}

BOOST_AUTO_TEST_CASE(frames_of_rupture_by_yield_limit_are_those_of_the_walls)
{
    for (const reproduction::RuptureRow& row : walls()) {
        Scenario scenario = reproduction::with_wall(quick(), row);
        const reproduction::RuptureTimes times(scenario, held());
        for (const double yield_limit : {150.0, 280.0, 320.0, 380.0, 1e6}) {
            scenario.rupture.yield_limit_pa = yield_limit;
            const auto holds = std::ssize(held().records) + 1;
            BOOST_TEST(times.frame(yield_limit) ==
                       reproduction::wall_along(scenario, held().records).rupture_frame.value_or(holds));
        }
    }
}

BOOST_AUTO_TEST_CASE(spread_and_log_rms_by_hand)
{
    const reproduction::Spread s = reproduction::spread({2, 4, 9});
    BOOST_TEST(s.mean == 5);
    BOOST_TEST(std::abs(s.deviation - std::sqrt(13.0)) < 1e-15);
    BOOST_TEST(s.least == 2);
    BOOST_TEST(s.most == 9);
    const double e = std::exp(1.0);
    BOOST_TEST(std::abs(reproduction::log_rms({e, 1, 1, 1}, {1, 1, 1, 1}) - 0.5) < 1e-15);
}

BOOST_AUTO_TEST_CASE(kept_runs_are_used_again_and_others_made_anew)
{
    const Scratch scratch;
    Scenario scenario = quick();
    scenario.time.frames = 20;
    scenario.output.particles_every_frames = 0;
    reproduction::RunStore runs(scratch.path, cpu, 2);
    runs.make({scenario, reproduction::with_seed(scenario, 2)});
    const fs::path manifest = runs.directory(scenario) / "manifest.json";
    const auto first = read_text(manifest);
    const double impact = runs.records(scenario).back().impact_force;
    BOOST_TEST((runs.records(reproduction::with_seed(scenario, 2)).back().impact_force != impact));
    runs.make({scenario});
    BOOST_TEST((read_text(manifest) == first)); // its dates, too
    Scenario other = scenario;
    other.inlet.peak_velocity_m_s *= 0.5;
    runs.make({other});
    BOOST_TEST((runs.records(other).back().impact_force != impact));
    BOOST_CHECK_THROW(runs.records(quick()), InputError); // another number of frames
}

BOOST_AUTO_TEST_CASE(a_failed_run_is_said_and_the_others_keep_their_rows)
{
    const Scratch scratch;
    Scenario bad = quick();
    bad.time.frames = 20;
    bad.pressure.blow_up_density_ratio = 1.0001;
    reproduction::RunStore runs(scratch.path, cpu, 1);
    BOOST_CHECK_THROW(runs.make({bad}), SimulationError);
}

BOOST_AUTO_TEST_CASE(an_ensemble_whose_reserve_ran_dry_is_refused)
{
    const Scratch scratch;
    reproduction::RunStore runs(scratch.path, cpu, 1);
    Scenario scenario = quick();
    scenario.time.frames = 60;
    BOOST_TEST(reproduction::ensemble(runs, scenario, 1, 1).size() == 1U);
    for (const auto& file : std::filesystem::recursive_directory_iterator(scratch.path)) {
        if (file.path().filename() == "frames.csv") {
            std::string rows = read_text(file.path()); // its last number counts what the reserve lacked
            rows.replace(rows.size() - 2, 1, "1");
            write_text(file.path(), rows);
        }
    }
    BOOST_CHECK_THROW(reproduction::ensemble(runs, scenario, 1, 1), Error);
}

BOOST_AUTO_TEST_CASE(a_calibration_finds_the_values_that_made_its_rows)
{
    const Scratch scratch;
    reproduction::RunStore runs(scratch.path / "runs", cpu, 2);
    Scenario scenario = shipped_scenario("quick");
    scenario.name += "_as_it_is";
    const std::vector<reproduction::Member> members = reproduction::ensemble(runs, scenario, 5, 2);
    double yield_limit = 50; // one that the search comes to, as other frames of rupture lie between
    while (yield_limit < 150) {
        yield_limit *= 1.01;
    }
    nlohmann::json paper{{"table4", nlohmann::json::array()}};
    nlohmann::json plan{{"scenario", "quick"},
                        {"first_seed", 5},
                        {"seeds", 2},
                        {"rows", nlohmann::json::array()},
                        {"candidates",
                         {{"thick", {{"aneurysm", {{"initial_radius_radii", 0.6}}}}},
                          {"as_it_is", nlohmann::json::object()}}},
                        {"yield_limit_pa", {{"from", 50}, {"to", 500}}}};
    for (const reproduction::RuptureRow& row :
         {reproduction::RuptureRow{0.4, 0.006, 0}, {0.6, 0.006, 0}, {0.4, 0.005, 0}}) {
        const double frame = reproduction::mean(members, [&](const reproduction::Member& member) {
            const Scenario wall = reproduction::with_wall(scenario, row);
            return reproduction::RuptureTimes(wall, member).frame(yield_limit);
        });
        paper["table4"].push_back({{"sigma", row.sigma}, {"phi", row.phi}, {"frame", std::lround(frame)}});
        plan["rows"].push_back({{"sigma", row.sigma}, {"phi", row.phi}});
    }
    reproduction::Reproduction reproduction{runs, paper, scratch.path, 2};
    const reproduction::Section section = reproduction::calibrate(reproduction, plan, std::nullopt);
    BOOST_TEST(section.text.front().find("Best: as_it_is") != std::string::npos);
    const std::vector<std::string>& row = section.tables.front().rows.at(0); // names are in order
    BOOST_TEST(row.front() == "as_it_is");
    BOOST_TEST(std::abs(std::stod(row.at(row.size() - 2)) / yield_limit - 1) < 0.05); // Y, up to a plateau
    BOOST_TEST(std::stod(row.back()) < 0.01);                 // half a frame of a mean
    plan["rows"].push_back({{"sigma", 0.9}, {"phi", 0.006}}); // none of the table's
    BOOST_CHECK_THROW(reproduction::calibrate(reproduction, plan, std::nullopt), InputError);
}

BOOST_AUTO_TEST_CASE(pages_hold_their_pictures_and_escape_what_they_say)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "dot.png";
    output::write_atomically(file, std::string_view("Man"));
    reproduction::Section section{"fig1", "A < B"};
    section.pictures.push_back({file, "caption"});
    section.claims = {{"it is", true, "1"}, {"it isn't", false, "2"}};
    section.tables.push_back({"t", {"a", "b"}, {{"1,5", "say \"x\""}}});
    const std::string html = reproduction::page({section}, "command");
    BOOST_TEST(html.find("data:image/png;base64,TWFu\"") != std::string::npos); // RFC 4648
    BOOST_TEST(html.find("A &lt; B") != std::string::npos);
    BOOST_TEST(html.find("1 of 2 claims hold") != std::string::npos);
    BOOST_TEST(to_csv(section.tables[0]) == "a,b\n\"1,5\",\"say \"\"x\"\"\"\n");
    output::write_atomically(file, std::string_view("Ma"));
    BOOST_TEST(reproduction::page({section}, "").find("base64,TWE=\"") != std::string::npos);
}
