// SPDX-License-Identifier: Apache-2.0
// Fig. 1 and the breach: what holds the blood, a wall that (21) and (28) move, and where the blood gets out.
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

/// Of the wall's geometry: the artery that (24) makes of the scenario.
Vessel vessel_of(const Scenario& s)
{
    return Vessel(s, s.vessel.radius_m / std::cbrt(2.0));
}

/// Blood that nothing but the wall holds, flying at a wall that has grown and is displaced.
SimulationState flying_blood(const Probe& probe, const Scenario& s, const Vessel& vessel)
{
    SimulationState state = probe.simulate(s)->state();
    AneurysmState& wall = state.aneurysm;
    wall.phase = Phase::growing;
    wall.radius *= 1.1;
    wall.displacement = 0.1 * state.spacing;
    Particles& p = state.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::fluid) {
            p.velocity[i] = 4.0 * vessel.wall(p.position[i], wall.radius + wall.displacement).gradient;
        }
    }
    return state;
}

/// The wall of a frame is that of (21) and (28) from the frame before; it holds all blood until it ruptures.
void containment(Probe& probe)
{
    Quantity& beyond = probe.quantity(
        "distance of blood beyond the wall of radius R + u [m]", Source::rounding,
        "gamma_64 of the place's size: the foot of the normal is found to that, and the distance is computed "
        "again in double");
    Quantity& outside = probe.quantity("particles that no normal led back", Source::exact,
                                       "integers: none, a normal leads back to the wall");
    Quantity& touching =
        probe.quantity("frames in which blood was put back", Source::exact,
                       "a claim: more than one, with the wall displaced; else nothing was held");
    Quantity& velocity =
        probe.quantity("velocity of blood that nothing but the wall touches [m/s]", Source::rounding,
                       "gamma_32 of its size: kept, or mirrored, which keeps its magnitude");
    Scenario s = shipped_scenario("quick");
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 0;
    s.fluid.viscosity_pa_s = 0;
    s.outlet.pressure_pa = 0;
    for (const Rebound rebound : {Rebound::elastic, Rebound::none}) {
        s.collision.rebound = rebound;
        const Vessel vessel = vessel_of(s);
        const auto flow = probe.simulate(s, flying_blood(probe, s, vessel));
        std::int64_t held = 0;
        for (int n = 0; n < 25; ++n) {
            const AneurysmState wall = flow->state().aneurysm;
            const Particles before = flow->state().particles;
            const FrameRecord r = flow->advance();
            const double R = wall.radius + wall.displacement;
            const Particles& p = flow->state().particles;
            for (std::size_t i = 0; i < p.size(); ++i) {
                if (before.kind[i] != Kind::fluid || p.kind[i] != Kind::fluid ||
                    !vessel.between_openings(p.position[i])) {
                    continue;
                }
                const Vec3& v = before.velocity[i];
                beyond.within(std::max(0.0, vessel.wall(p.position[i], R).value), 0,
                              probe.gamma(64) * (length(p.position[i]) + R), frame(r));
                if (rebound == Rebound::none) {
                    velocity.within(p.velocity[i], v, probe.gamma(32) * length(v), frame(r));
                } else {
                    velocity.within(length(p.velocity[i]), length(v), probe.gamma(32) * length(v), frame(r));
                }
            }
            outside.equal(r.outside, 0, frame(r));
            held += r.collisions > 0 && wall.displacement != 0 ? 1 : 0;
        }
        touching.holds(held > 1);
    }
}

/// After the rupture blood leaves through the hole, and only there; it returns to the reserve when it is far
/// away, or near an open end, and not before.
void breach(Probe& probe)
{
    const char* of_place = "gamma_64 of the place's size and of the hole's and the wall's measures";
    Quantity& hole = probe.quantity("how far beside the hole blood got out [m]", Source::rounding, of_place);
    Quantity& wall =
        probe.quantity("how far within the wall blood counts as escaped [m]", Source::rounding, of_place);
    Quantity& held =
        probe.quantity("distance of other blood beyond the wall [m]", Source::rounding, of_place);
    Quantity& stays = probe.quantity("how far escaped blood is beyond the recycling distance [m]",
                                     Source::rounding, of_place);
    Quantity& returns = probe.quantity("how far recycled blood is within the recycling distance [m]",
                                       Source::rounding, of_place);
    Quantity& number = probe.quantity("blood that has escaped", Source::exact,
                                      "integers: the particles that changed from blood to escaped");
    Quantity& some = probe.quantity("escaped and recycled particles", Source::exact,
                                    "a claim: there are some of both, else nothing was looked at");
    Scenario s = shipped_scenario("quick");
    s.growth.warm_up_frames = 5;
    s.rupture.yield_limit_pa = 1; // ruptures at once
    s.rupture.recycle_distance_radii = 0.8;
    const double hole_radius = s.rupture.breach_radius_radii * s.vessel.radius_m;
    const double far = s.rupture.recycle_distance_radii * s.vessel.radius_m;
    const double support = 2 * s.kernel.smoothing_length_spacings;
    const Vessel vessel = vessel_of(s);
    const auto flow = probe.simulate(s);
    const double reach = support * flow->state().spacing;
    std::int64_t escaped = 0;
    std::int64_t recycled = 0;
    for (int n = 0; n < 70; ++n) {
        const SimulationState before = flow->state();
        const FrameRecord r = flow->advance();
        if (before.aneurysm.phase != Phase::ruptured) {
            continue;
        }
        const double R = before.aneurysm.radius + before.aneurysm.displacement;
        const Vec3 center = vessel.dome(R);
        const Particles& p = flow->state().particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec3& x = p.position[i];
            const double allowed = probe.gamma(64) * (length(x) + R + far);
            const Kind from = before.particles.kind[i];
            const double distance = length(x - center);
            const double to_end = -vessel.openings().at(vessel.nearest_tube(x)).beyond(x);
            if (from == Kind::fluid && p.kind[i] == Kind::escaped) {
                ++escaped;
                hole.within(std::max({0.0, std::hypot(x.x, x.z) - hole_radius, center.y - hole_radius - x.y}),
                            0, allowed, frame(r));
                wall.within(std::max(0.0, -vessel.wall(x, R).value), 0, allowed, frame(r));
            } else if (from == Kind::fluid && p.kind[i] == Kind::fluid && vessel.between_openings(x)) {
                held.within(std::max(0.0, vessel.wall(x, R).value), 0, allowed, frame(r));
            }
            if (p.kind[i] == Kind::escaped) {
                stays.within(std::max({0.0, distance - far, reach - to_end}), 0, allowed, frame(r));
            } else if (from == Kind::escaped && p.kind[i] == Kind::reserve) {
                ++recycled;
                returns.within(std::max(0.0, std::min(far - distance, to_end - reach)), 0, allowed, frame(r));
            }
        }
        number.equal(r.ledger.escaped, escaped, frame(r));
    }
    some.holds(escaped > 0, "escaped");
    some.holds(recycled > 0, "recycled");
}

} // namespace

std::vector<Check> containment_checks()
{
    return {
        flow_check("fig1_containment", {"21", "28"},
                   "the wall that holds the blood is the one that has grown and is displaced",
                   {"distance to the wall in double"}, containment),
        flow_check(
            "fig1_breach", {},
            "after the rupture blood leaves through the hole and nowhere else, and is recycled far from it",
            {"places in the hole by their definition"}, breach),
    };
}

} // namespace aneurysm::checks
