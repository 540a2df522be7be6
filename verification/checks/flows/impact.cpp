// SPDX-License-Identifier: Apache-2.0
// The impact on the sac's wall, (14)-(16), from the particles of two frames.
#include "common/scenario/shipped.hpp"
#include "common/vessel/geometry.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

std::string frame(const FrameRecord& r)
{
    return "frame " + std::to_string(r.frame);
}

/// (16): the largest force on a particle at the wall is its mass times its change of velocity in the frame, for those
/// that the wall has not turned round and put back onto itself. Gravity has no part in it: the pressure is counted
/// from that of blood at rest.
void impact(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& force =
        probe.quantity("F_b against m |dv|/dt of the particle that made it [N]", Source::rounding,
                       "m/dt times gamma_4 of both velocities and gamma_60 of the acceleration's "
                       "parts, each of the size of F_b, whose sum the frame rounds in another order");
    Quantity& others =
        probe.quantity("m |dv|/dt of the others in S, no larger than F_b [N]", Source::rounding,
                       "as of F_b: m/dt gamma_4 of both velocities and gamma_60 of F_b");
    Quantity& members =
        probe.quantity("particles in S beyond those whose place leaves no doubt", Source::exact,
                       "integers: at least none, at most those that the wall has put back and those within "
                       "32 u of a border");
    const Scenario s = shipped_scenario("quick");
    const Vessel vessel(s, s.vessel.radius_m / std::cbrt(2.0));
    const double dt = s.time.frame_s;
    const auto flow = probe.simulate(s);
    SimulationState before = flow->state();
    for (int n = 0; n < 100; ++n) {
        const FrameRecord r = flow->advance();
        const SimulationState after = flow->state();
        const double R = before.aneurysm.radius + before.aneurysm.displacement;
        const double m = after.particles.mass;
        std::int64_t sure = 0;
        std::int64_t doubtful = 0;
        for (std::size_t i = 0; i < after.particles.size(); ++i) {
            const Vec3& x = after.particles.position[i];
            const Vec3& v = after.particles.velocity[i];
            const bool blood =
                before.particles.kind[i] == Kind::fluid && after.particles.kind[i] == Kind::fluid;
            const double band = s.rupture.impact_band_spacings * after.spacing;
            const double margin = 32 * u * length(x);
            const bool untouched = vessel.wall(x, R).value < -margin;
            const double to_wall = vessel.wall(x, R).value + band;
            const double to_sac = vessel.tubes(x).value - vessel.sac(x, R).value;
            if (before.particles.kind[i] == Kind::fluid && untouched && blood && to_wall > margin &&
                to_sac > margin) {
                ++sure;
            } else if (before.particles.kind[i] == Kind::fluid &&
                       (!untouched || !blood || std::min(to_wall, to_sac) > -margin)) {
                doubtful += to_sac > -after.spacing ? 1 : 0; // at a tube's wall none is in S
            }
            if (!untouched || !blood || vessel.wall(x, R).value <= -band + margin ||
                vessel.sac(x, R).value >= vessel.tubes(x).value - margin) {
                continue;
            }
            const double F = m * length(v - before.particles.velocity[i]) / dt;
            const double speeds = length(v) + length(before.particles.velocity[i]);
            const double allowed = m / dt * probe.gamma(4) * speeds + probe.gamma(60) * r.impact_force;
            if (r.impact_particle == static_cast<std::int64_t>(i)) {
                force.within(r.impact_force, F, allowed, frame(r));
            } else {
                others.within(std::max(F, r.impact_force), r.impact_force, allowed, frame(r));
            }
        }
        const std::int64_t more = r.impact_count - sure;
        members.equal(std::clamp<std::int64_t>(more, 0, doubtful), more, frame(r));
        before = after;
    }
}

} // namespace

std::vector<Check> impact_checks()
{
    return {flow_check("eq16_impact", {"14", "15", "16"},
                       "the impact force is the largest mass times change of velocity at the sac's wall",
                       {"momentum balance (14) of each particle"}, impact)};
}

} // namespace aneurysm::checks
