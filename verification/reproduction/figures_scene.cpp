// SPDX-License-Identifier: Apache-2.0
// Figures 4, 5, 6 and 8: what the flow and the wall look like.
#include "common/error.hpp"
#include "common/text.hpp"
#include "verification/reproduction/ensemble.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/reproduction/variants.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>

namespace aneurysm::reproduction
{
namespace
{

/// One picture with a tile for each run and frame.
Picture sheet(Reproduction& reproduction, const std::string& id, const std::string& state,
              const std::vector<Scenario>& scenarios, const std::vector<std::string>& labels,
              const std::string& frames, const std::string& caption)
{
    const std::filesystem::path folder = reproduction.folder(id) / state;
    std::vector<std::string> words;
    words.reserve(scenarios.size());
    for (const Scenario& scenario : scenarios) {
        words.push_back(reproduction.runs.directory(scenario).string());
    }
    words.insert(words.end(), {"--frames", frames, "--state", state, "--sheet", "--out", folder.string()});
    if (!labels.empty()) {
        words.insert(words.end(), {"--labels", joined(labels, ",")});
    }
    render(words);
    return {folder / "sheet.png", caption};
}

/// A member of the ensemble, with a yield limit that lets its wall rupture nearest to the paper's frame, and
/// early enough that the last pictures show the bleeding.
struct Typical {
    int seed = 0;
    double yield_limit = 0; ///< [Pa]
    std::int64_t frame = 0; ///< of rupture
};

Typical typical_member(Reproduction& reproduction, std::int64_t wanted)
{
    constexpr std::int64_t latest = 2400;
    constexpr double step = 1.005;
    constexpr int steps = 60; // 35 % to either side, the nearest first
    const Scenario scenario = calibrated_scenario();
    const double calibrated = scenario.rupture.yield_limit_pa;
    Typical best;
    for (const Member& member :
         ensemble(reproduction.runs, scenario, reproduction.first_seed, reproduction.seeds)) {
        const RuptureTimes times(scenario, member);
        for (int k = 0; k <= 2 * steps; ++k) {
            const int power = (k % 2 == 0 ? 1 : -1) * ((k + 1) / 2);
            const double yield_limit = std::round(calibrated * std::pow(step, power));
            const std::int64_t frame = times.frame(yield_limit);
            if (frame <= latest &&
                (best.frame == 0 || std::abs(frame - wanted) < std::abs(best.frame - wanted))) {
                best = {member.seed(), yield_limit, frame};
            }
        }
    }
    return best;
}

/// A live run, rupture and bleeding included, with particles every 100 frames.
Scenario bleeding_run(Reproduction& reproduction, Typical& typical)
{
    typical = typical_member(reproduction, 2299);
    if (typical.frame == 0) {
        throw Error("fig4", "no member of the ensemble ruptures by frame 2400", "needed: more --seeds");
    }
    Scenario scenario = with_seed(calibrated_scenario(), typical.seed);
    scenario.name += "_pictures";
    scenario.rupture.yield_limit_pa = typical.yield_limit;
    scenario.time.frames = 2500;
    scenario.output.particles_every_frames = 100;
    reproduction.runs.make({scenario});
    return scenario;
}

std::string paper_frames(const Reproduction& reproduction)
{
    std::vector<std::string> frames;
    for (const int frame : reproduction.paper.at("figures").at("fig4_frames")) {
        frames.push_back(std::to_string(frame));
    }
    return joined(frames, ",");
}

std::string which_run(const Typical& typical)
{
    return "Seed " + std::to_string(typical.seed) + " with Y = " + number(typical.yield_limit) +
           " Pa (calibrated: " + number(calibrated_scenario().rupture.yield_limit_pa) +
           " Pa), whose wall ruptures in frame " + std::to_string(typical.frame) +
           ": of the ensemble of Table 4, with Y up to a third off, the nearest to the paper's 2299 that "
           "lets the last pictures show the bleeding.";
}

Section frames_figure(Reproduction& reproduction, const std::string& id, const std::string& title,
                      const std::string& state, const std::string& caption)
{
    Typical typical;
    const Scenario scenario = bleeding_run(reproduction, typical);
    Section section{id, title};
    section.text = {which_run(typical)};
    section.pictures = {sheet(reproduction, id, state, {scenario}, {}, paper_frames(reproduction), caption)};
    const std::vector<FrameRecord> records = reproduction.runs.records(scenario);
    ResultTable table{"", {"frame", "phase", "R [m]", "h [m]", "F_b [N]", "P_c [Pa]", "through the breach"}};
    for (const int frame : reproduction.paper.at("figures").at("fig4_frames")) {
        const FrameRecord& r = records.at(static_cast<std::size_t>(frame - 1));
        const std::vector<std::string> phases{"warm-up", "growing", "fully developed", "ruptured"};
        table.add(frame, phases.at(static_cast<std::size_t>(r.phase)), r.radius, r.thickness, r.impact_force,
                  r.critical_pressure, r.ledger.escaped);
    }
    section.tables = {table};
    section.claims = {{"The wall is whole at frame 2200 and has ruptured at frame 2400",
                       records[2199].phase != Phase::ruptured && records[2399].phase == Phase::ruptured,
                       "rupture in frame " + std::to_string(typical.frame)},
                      {"After the rupture blood leaves through the breach", records.back().ledger.escaped > 0,
                       std::to_string(records.back().ledger.escaped) + " particles by frame " +
                           std::to_string(records.back().frame)}};
    return section;
}

/// The first seed of each, with a wall that holds; makes those that are missing.
std::vector<Member> first_runs(Reproduction& reproduction, const std::vector<Variant>& variants)
{
    std::vector<Scenario> scenarios;
    for (const Variant& v : variants) {
        scenarios.push_back(with_seed(unbreakable(v.scenario), reproduction.first_seed));
    }
    return steady_runs(reproduction.runs, scenarios);
}

/// Variants side by side in one frame: particles, and the blood's surface.
Section variants_figure(Reproduction& reproduction, const std::vector<Variant>& variants,
                        const std::vector<Member>& runs, const std::string& frame, Section section)
{
    std::vector<Scenario> scenarios;
    std::vector<std::string> labels;
    for (std::size_t k = 0; k < runs.size(); ++k) {
        scenarios.push_back(runs[k].scenario);
        labels.push_back(variants[k].name);
    }
    section.text = {"Frame " + frame + " of walls that are kept from rupturing."};
    section.pictures = {
        sheet(reproduction, section.id, "particles", scenarios, labels, frame, "Particles by speed."),
        sheet(reproduction, section.id, "fluid", scenarios, labels, frame, "Surface of the blood.")};
    return section;
}

} // namespace

Section figure4(Reproduction& reproduction)
{
    return frames_figure(reproduction, "fig4", "Fig. 4: particles at the paper's frames", "particles",
                         "Particles colored by speed, the wall translucent; orange: the rim of the breach.");
}

Section figure5(Reproduction& reproduction)
{
    return frames_figure(
        reproduction, "fig5", "Fig. 5: blood at the paper's frames", "fluid",
        "The surface of the blood, reconstructed from the particles; orange: the rim of the breach.");
}

Section figure6(Reproduction& reproduction)
{
    const std::vector<Variant> shapes = shape_variants(reproduction);
    return variants_figure(reproduction, shapes, first_runs(reproduction, shapes), "3000",
                           {"fig6", "Fig. 6: hemispherical, spherical and piriform aneurysms"});
}

Section figure8(Reproduction& reproduction)
{
    const std::vector<Variant> angles = angle_variants(reproduction);
    const std::vector<Member> runs = first_runs(reproduction, angles);
    Section section = variants_figure(reproduction, angles, runs, "2500",
                                      {"fig8", "Fig. 8: bifurcation angles of 30, 40, 60 and 75 degrees"});
    ResultTable table{
        "",
        {"angle", "mean F_b, frames 400-2500 [N]", "R at 2500 [m]", "largest density error before the end"}};
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const auto late = std::span(runs[k].records).subspan(400);
        const double density = std::ranges::max(late, {}, &FrameRecord::density_error_max).density_error_max;
        table.add(angles[k].name, mean(late, &FrameRecord::impact_force), late.back().radius,
                  number(100 * density, 3) + " %");
    }
    section.tables = {table};
    return section;
}

} // namespace aneurysm::reproduction
