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

/// Exponent of y = c x^n by least squares of the logarithms.
double exponent(const std::vector<Impact>& impacts)
{
    const double mx = mean(impacts, [](const Impact& i) { return std::log(i.spacing); });
    const double my = mean(impacts, [](const Impact& i) { return std::log(i.force); });
    double xy = 0;
    double xx = 0;
    for (const Impact& i : impacts) {
        const double x = std::log(i.spacing) - mx;
        xy += x * (std::log(i.force) - my);
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
        impacts.push_back({s.particles.count, spacing, mean(second, &FrameRecord::impact_force)});
    }
    ResultTable table{
        "F_b by resolution, mean over the second cycle, rigid sac",
        {"particles", "spacing [m]", "F_b [N]", "F_b / spacing^2 [Pa]", "F_b / spacing^3 [N/m^3]"},
        {}};
    for (const Impact& i : impacts) {
        table.add(i.particles, i.spacing, i.force, i.force / (i.spacing * i.spacing),
                  i.force / std::pow(i.spacing, 3));
    }
    const double n = exponent(impacts);
    text.push_back(
        "The force on one particle depends on its size: over the resolutions of the last table F_b "
        "goes as the spacing to the power " +
        number(n, 3) +
        ". Divided by the particle's own face, spacing^2, it is a pressure, as P_c is, "
        "and goes as the power " +
        number(n - 2, 3) +
        "; a conversion area proportional to spacing^2 takes most of it back over these resolutions. It has no "
        "limit for all that: (16) is mass times acceleration, and goes as spacing^3 where the acceleration is "
        "converged. Y holds for 5,520 particles and this area.");
    return table;
}

} // namespace aneurysm::reproduction
