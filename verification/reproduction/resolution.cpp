// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/resolution.hpp"

#include "common/scenario/shipped.hpp"
#include "output/checkpoint.hpp"
#include "output/run_directory.hpp"
#include "verification/reproduction/ensemble.hpp"

#include <cmath>

namespace aneurysm::reproduction
{
namespace
{

/// One resolution.
struct Impact {
    std::int64_t particles = 0;
    double spacing = 0; ///< [m]
    double force = 0;   ///< mean F_b over a whole cycle [N]
    double load = 0;    ///< mean load of the wall over it [N]
};

/// The sac keeps its first radius: the warm-up doesn't end.
Scenario rigid(Scenario scenario, std::int64_t particles)
{
    const auto cycle =
        static_cast<std::int64_t>(std::llround(scenario.inlet.cycle_s / scenario.time.frame_s));
    scenario.particles.count = particles;
    scenario.time.frames = 2 * cycle;
    scenario.growth.warm_up_frames = scenario.time.frames;
    scenario.aneurysm.initial_radius_radii = scenario.aneurysm.base_width_radii / 2;
    const char* reason = "study of the resolution: the sac is rigid and fully grown";
    for (const char* path :
         {"particles.count", "growth.warm_up_frames", "aneurysm.initial_radius_radii", "time.frames"}) {
        scenario.assumed[path] = reason;
    }
    scenario.name += "_rigid_" + std::to_string(particles);
    return scenario;
}

/// Exponent of a force over the spacing, c spacing^n, by least squares of the logarithms.
double exponent(const std::vector<Impact>& impacts, double Impact::*force)
{
    const double mx = mean(impacts, [](const Impact& i) { return std::log(i.spacing); });
    const double my = mean(impacts, [force](const Impact& i) { return std::log(i.*force); });
    double xy = 0;
    double xx = 0;
    for (const Impact& i : impacts) {
        const double x = std::log(i.spacing) - mx;
        xy += x * (std::log(i.*force) - my);
        xx += x * x;
    }
    return xy / xx;
}

} // namespace

ResultTable resolution_study(Reproduction& reproduction, std::vector<std::string>& text)
{
    // Slow enough for the finest to be stable with one step a frame.
    const Scenario scenario = shipped_scenario("paper_tc1");
    std::vector<Scenario> scenarios;
    for (const std::int64_t particles : {2760, 5520, 11040, 15456}) {
        scenarios.push_back(rigid(unbreakable(scenario), particles));
    }
    reproduction.runs.make(scenarios);
    std::vector<Impact> impacts;
    for (const Scenario& s : scenarios) {
        const std::vector<FrameRecord> records = reproduction.runs.records(s);
        const auto second = std::span(records).subspan(records.size() / 2);
        const double spacing =
            output::read_checkpoint(output::RunDirectory::checkpoint_file(reproduction.runs.directory(s)))
                .state.spacing;
        impacts.push_back({s.particles.count, spacing, mean(second, &FrameRecord::impact_force),
                           mean(second, &FrameRecord::wall_load)});
    }
    ResultTable table{
        "Impact by resolution, mean over the second cycle, rigid sac",
        {"particles", "spacing [m]", "F_b [N]", "the wall's load F_b M/m [N]", "acceleration F_b/m [m/s^2]"},
        {}};
    const double M = scenario.rupture.impact_mass_kg;
    for (const Impact& i : impacts) {
        table.add(i.particles, i.spacing, i.force, i.load, i.load / M);
    }
    text.push_back(
        "The force on one particle depends on its size: over the resolutions of the last table F_b "
        "goes as the spacing to the power " +
        number(exponent(impacts, &Impact::force), 3) +
        ". What lets the wall grow and breaks it is its load, the force of M = " + number(M) +
        " kg of blood with the acceleration of the particle of F_b, whose mass is m. It goes as the power " +
        number(exponent(impacts, &Impact::load), 3) +
        "; 0 would be an acceleration that doesn't depend on the particles' size. Y and the conversion area hold "
        "for a resolution as far as that is so.");
    return table;
}

} // namespace aneurysm::reproduction
