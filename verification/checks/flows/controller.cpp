// SPDX-License-Identifier: Apache-2.0
// The three open ends of the artery, particle by particle: a few of them are put near the ends, nothing
// pushes them but what an end does, and each must be afterwards what section 3.4, (25) and (26) make of it.
#include "common/scenario/shipped.hpp"
#include "common/vessel/geometry.hpp"
#include "common/vessel/initial_state.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace aneurysm::checks
{
namespace
{

constexpr double D = 3;         ///< depth of a slab [dx]
constexpr double beside = 1e-4; ///< to either side of a limit, relative; far more than float rounds
constexpr std::array<Kind, 3> ghost{Kind::inlet, Kind::outlet_1, Kind::outlet_2};

/// A particle on the way to or from open end k: where it is when it has moved, if nothing holds it, and what
/// becomes of it.
struct Visitor {
    std::size_t k = 0;
    Kind kind = Kind::fluid;
    double beyond = 0;   ///< the end's plane, after its move [dx]
    double outward = 0;  ///< its velocity while it moves [m/s]
    double before = 0;   ///< a ghost's velocity before its slab moves it [m/s]
    double pressure = 0; ///< [Pa]
    Kind becomes = Kind::fluid;
    double ends = 0;  ///< beyond the plane, then [dx]
    double speed = 0; ///< outward, then [m/s]

    /// A ghost that becomes blood; another ghost takes its place one slab behind.
    bool enters() const { return kind != Kind::fluid && becomes == Kind::fluid; }
    /// Blood that ends in an oblique plane: rounding says whether it is still blood.
    bool is_on_plane() const { return k > 0 && kind == Kind::fluid && ends == 0; }
};

void count(const Visitor& v, Kind becomes, Ledger& l)
{
    const bool inlet = v.k == 0;
    if (v.enters()) {
        ++(inlet ? l.inlet_in : l.outlet_in);
    } else if (v.kind == Kind::fluid && becomes != Kind::fluid) {
        ++(inlet ? l.inlet_out : l.outlet_out);
    } else if (becomes == Kind::reserve) {
        ++l.recycled;
    }
}

/// One step of an artery that holds these alone.
struct Scene {
    std::string name;
    std::int64_t frame = 0;                  ///< of the step; says what (25) is
    std::array<double, 2> outlet_velocity{}; ///< of the slabs before the step [m/s]
    double p_const = 0;                      ///< of (26) [Pa]
    std::vector<Visitor> visitors{};
    std::array<double, 2> expected_velocity{}; ///< of the slabs in the step [m/s]
};

struct Quantities {
    Quantity& kind;
    Quantity& place;
    Quantity& velocity;
    Quantity& slab;
    Quantity& pressure;
    Quantity& counts;
};

/// An artery in which nothing pushes: kappa = 0 in (6), no viscosity, no gravity.
Scenario still_artery()
{
    Scenario s = shipped_scenario("quick");
    s.particles.jitter_spacings = 0;
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 0;
    s.pressure.density_correction = 0;
    s.fluid.viscosity_pa_s = 0;
    s.fluid.gravity_m_s2 = {};
    s.inlet.waveform = Waveform::sine;
    s.inlet.peak_velocity_m_s = 2;
    s.inlet.cycle_s = 0.7995; // its zeros are between two steps
    return s;
}

class OpenEnds
{
public:
    explicit OpenEnds(const Probe& probe)
        : probe_(&probe), scenario_(still_artery()),
          vessel_(scenario_, scenario_.vessel.radius_m / std::cbrt(2.0)),
          start_(probe.simulate(scenario_)->state())
    {
    }

    double dx() const { return start_.spacing; }
    double dt() const { return scenario_.time.frame_s; }
    const Scenario::Controller& controller() const { return scenario_.controller; }
    double rho_0() const { return scenario_.fluid.density_kg_m3; }
    /// (25) in the step to this frame [m/s].
    double v_in(std::int64_t frame) const
    {
        const auto& in = scenario_.inlet;
        return in.peak_velocity_m_s *
               std::sin(2 * std::numbers::pi * static_cast<double>(frame) * dt() / in.cycle_s);
    }
    const Opening& end(std::size_t k) const { return vessel_.openings().at(k); }

    /// Makes the step.
    std::unique_ptr<Simulation> step(const Scene& scene, FrameRecord& record) const
    {
        Scenario s = scenario_;
        s.outlet.pressure_pa = scene.p_const;
        SimulationState state = start_;
        state.frame = scene.frame - 1;
        state.outlet_velocity = scene.outlet_velocity;
        Particles& p = state.particles;
        std::ranges::fill(p.kind, Kind::reserve);
        for (std::size_t i = 0; i < scene.visitors.size(); ++i) {
            const Visitor& v = scene.visitors[i];
            const Vec3& n = end(v.k).outward;
            p.kind[i] = v.kind;
            p.position[i] = place(v.k, v.beyond * dx() - dt() * v.outward);
            p.velocity[i] = (v.kind == Kind::fluid ? v.outward : v.before) * n;
            p.pressure[i] = v.pressure;
        }
        auto flow = probe_->simulate(s, std::move(state));
        record = flow->advance();
        return flow;
    }

    void check(const Scene& scene, Quantities& q) const
    {
        FrameRecord record;
        const auto flow = step(scene, record);
        const SimulationState& after = flow->state();
        Ledger expected;
        std::size_t next = scene.visitors.size(); // of the reserve
        for (std::size_t i = 0; i < scene.visitors.size(); ++i) {
            const Visitor& v = scene.visitors[i];
            const std::string where = scene.name + ", particle " + std::to_string(i);
            const bool crossed = v.is_on_plane() && after.particles.kind[i] == ghost.at(v.k);
            const Kind becomes = crossed ? ghost.at(v.k) : v.becomes;
            count(v, becomes, expected);
            see(after.particles, i, v, becomes, v.ends, where, q);
            if (v.enters()) {
                q.pressure.within(after.particles.pressure[i], unset_pressure, 0, where);
                see(after.particles, next++, v, v.kind, v.ends + D, where + ", its successor", q);
            }
        }
        for (std::size_t k = 0; k < 2; ++k) {
            q.slab.within(after.outlet_velocity.at(k), scene.expected_velocity.at(k),
                          probe_->gamma(40) * v_unit(), scene.name + ", outlet " + std::to_string(k + 1));
        }
        const Ledger& l = record.ledger;
        for (const auto& [found, wanted] :
             {std::pair{l.inlet_in, expected.inlet_in}, std::pair{l.inlet_out, expected.inlet_out},
              std::pair{l.outlet_out, expected.outlet_out}, std::pair{l.outlet_in, expected.outlet_in},
              std::pair{l.recycled, expected.recycled}, std::pair{l.missed, expected.missed}}) {
            q.counts.equal(found, wanted, scene.name);
        }
    }

    /// Slab k as it was sampled, moved with `outward` for a step.
    void check_pattern(const Scene& scene, std::size_t k, double outward, Quantities& q) const
    {
        FrameRecord record;
        const auto flow = step(scene, record);
        const Particles& p = flow->state().particles;
        std::vector<Vec3> pattern;
        for (std::size_t i = 0; i < start_.particles.size(); ++i) {
            if (start_.particles.kind[i] == ghost.at(k)) {
                pattern.push_back(start_.particles.position[i] + dt() * outward * end(k).outward);
            }
        }
        std::size_t seen = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (p.kind[i] == ghost.at(k) && seen < pattern.size()) {
                see(p, i, pattern[seen], outward * end(k).outward,
                    scene.name + ", ghost " + std::to_string(seen), q);
                ++seen;
            }
        }
        q.counts.equal(std::ranges::count(p.kind, ghost.at(k)), static_cast<std::int64_t>(pattern.size()),
                       scene.name);
    }

private:
    /// Beyond the plane of end k [m], and a little beside its axis.
    Vec3 place(std::size_t k, double beyond) const
    {
        return end(k).center + beyond * end(k).outward + Vec3{0, 0, 0.1 * dx()};
    }

    /// The largest velocity that is made of the others [m/s].
    double v_unit() const { return 2 * scenario_.inlet.peak_velocity_m_s; }

    void see(const Particles& p, std::size_t i, const Vec3& x, const Vec3& v, const std::string& where,
             Quantities& q) const
    {
        q.place.within(p.position[i], x, probe_->gamma(40) * (length(x) + D * dx()), where);
        q.velocity.within(p.velocity[i], v, probe_->gamma(40) * v_unit(), where);
    }
    /// Particle i as v, or what follows it, must be.
    void see(const Particles& p, std::size_t i, const Visitor& v, Kind kind, double beyond,
             const std::string& where, Quantities& q) const
    {
        q.kind.equal(static_cast<int>(p.kind[i]), static_cast<int>(kind), where);
        if (kind != Kind::reserve) {
            see(p, i, place(v.k, beyond * dx()), v.speed * end(v.k).outward, where, q);
        }
    }

    const Probe* probe_;
    Scenario scenario_;
    Vessel vessel_;
    SimulationState start_;
};

Visitor blood(std::size_t k, double beyond, double outward, double ends, double speed)
{
    return {.k = k, .kind = Kind::fluid, .beyond = beyond, .outward = outward, .ends = ends, .speed = speed};
}
Visitor leaving(std::size_t k, double beyond, double outward)
{
    Visitor v = blood(k, beyond, outward, beyond, outward);
    v.becomes = ghost.at(k);
    return v;
}
/// `before`: its velocity before its slab drives it to `outward`.
Visitor of_slab(std::size_t k, double beyond, double outward, double before, Kind becomes, double ends)
{
    return {.k = k,
            .kind = ghost.at(k),
            .beyond = beyond,
            .outward = outward,
            .before = before,
            .becomes = becomes,
            .ends = ends,
            .speed = outward};
}

/// The slab of outlet k moves on as it did: no blood is near it.
Scene scene_of(const OpenEnds& ends, std::string name, std::int64_t frame, std::array<double, 2> outlets)
{
    return {.name = std::move(name),
            .frame = frame,
            .outlet_velocity = outlets,
            .p_const = ends.rho_0() / 2, // blood that comes back with 1 m/s has no pressure
            .expected_velocity = outlets};
}

constexpr std::int64_t forth = 200; ///< a frame in which the inlet pushes with v_0,
constexpr std::int64_t back = 600;  ///< and one in which it draws

Scene piston(const OpenEnds& ends)
{
    Scene s = scene_of(ends, "piston", forth, {1, 1});
    const double v = ends.v_in(forth);
    const double reach = ends.controller().piston_reach_spacings;
    s.visitors = {blood(0, -reach * (1 - beside), 0.5, -reach * (1 - beside), -v),
                  blood(0, -reach * (1 + beside), 0.5, -reach * (1 + beside), 0.5),
                  blood(0, -0.2, -1.2, -0.2, -v),
                  blood(0, -0.1, -3, -0.1, -3),
                  blood(0, 0.05, 1.5, 0, -v),
                  of_slab(0, 0.5, -v, 7, Kind::inlet, 0.5)};
    return s;
}

/// The inlet draws: it holds nothing back, and what crosses an end outwards joins its slab.
Scene leaving_blood(const OpenEnds& ends)
{
    Scene s = scene_of(ends, "what leaves", back, {1, 1});
    s.p_const = 0;
    s.visitors = {blood(0, -0.1, 3, -0.1, 3), leaving(0, 0.05, 3), leaving(0, 0.02, 1)};
    for (const std::size_t k : {1U, 2U}) {
        s.visitors.push_back(leaving(k, 0.01, k == 1 ? 1.5 : 0.8));
        s.visitors.push_back(blood(k, -1e-3, 0.5, -1e-3, 0.5));
    }
    s.expected_velocity = {1, 0.65}; // the mean of that blood, whose pressure is the outlet's
    return s;
}

/// While outlets draw blood back none of it leaves.
Scene held_blood(const OpenEnds& ends)
{
    Scene s = scene_of(ends, "what is held back", forth, {-1, -1});
    for (const std::size_t k : {1U, 2U}) {
        s.visitors.push_back(blood(k, 0.05, 1, 0, 0));
        s.visitors.push_back(blood(k, 0.02, -3, 0, -3));
    }
    return s;
}

Scene entering_ghosts(const OpenEnds& ends)
{
    Scene s = scene_of(ends, "what enters", forth, {-1, -0.4});
    const std::array<double, 3> outward{-ends.v_in(forth), -1, -0.4};
    for (const std::size_t k : {0U, 1U, 2U}) {
        s.visitors.push_back(of_slab(k, -0.002, outward.at(k), 5, Kind::fluid, -0.002));
        s.visitors.push_back(of_slab(k, 0.002, outward.at(k), 5, ghost.at(k), 0.002));
        s.visitors.push_back(of_slab(k, -0.01, outward.at(k), -5, Kind::fluid, -0.01));
    }
    for (Visitor& v : s.visitors) {
        v.pressure = 7; // a ghost's, which is no blood's
    }
    return s;
}

/// Blood that is too near keeps a ghost from entering: it goes back by a slab.
Scene nearby_blood(const OpenEnds& ends, bool near)
{
    Scene s = scene_of(ends, near ? "blood in the way" : "blood out of the way", forth, {-1, -1});
    const double distance = ends.controller().closest_entry_spacings * (near ? 1 - beside : 1 + beside);
    const std::array<double, 3> outward{-ends.v_in(forth), -1, -1};
    for (const std::size_t k : {0U, 1U, 2U}) {
        const double z = -0.002;
        s.visitors.push_back(near ? of_slab(k, z, outward.at(k), 5, ghost.at(k), z + D)
                                  : of_slab(k, z, outward.at(k), 5, Kind::fluid, z));
        const double speed = k == 0 ? 0 : -1; // with the slab: its velocity is the blood's
        s.visitors.push_back(blood(k, z - distance, speed, z - distance, speed));
    }
    return s;
}

Scene recycled_ghosts(const OpenEnds& ends)
{
    Scene s = scene_of(ends, "what leaves its slab", back, {1, 0.5});
    const std::array<double, 3> outward{-ends.v_in(back), 1, 0.5};
    for (const std::size_t k : {0U, 1U, 2U}) {
        for (const double side : {-beside, beside}) {
            const double z = D * (1 + side);
            s.visitors.push_back(
                of_slab(k, z, outward.at(k), outward.at(k), side > 0 ? Kind::reserve : ghost.at(k), z));
        }
    }
    return s;
}

/// Newton's law of the outlets' slabs: v' = v + dt (p - p_outlet) / (rho_0 D).
Scene pushed_slabs(const OpenEnds& ends)
{
    Scene s = scene_of(ends, "slabs that blood pushes", forth, {0.3, -0.2});
    s.p_const = 1000;
    const double depth = ends.controller().probe_depth_spacings;
    for (std::size_t k = 1; k <= 2; ++k) {
        const double sign = k == 1 ? 1 : 0.6;
        // Looked at before it moves.
        const auto probed = [&](double beyond, double speed, double pressure) {
            const double z = beyond + ends.dt() * speed / ends.dx();
            s.visitors.push_back(blood(k, z, speed, z, speed));
            s.visitors.back().pressure = pressure;
        };
        probed(-depth * (1 - beside), sign * 1.2, sign * 8e4);
        probed(-1.1, sign * 0.7, -5e4); // counts as none
        probed(-depth * (1 + beside), -5, 1e6);
        const double before = s.outlet_velocity.at(k - 1);
        const double p_outlet = s.p_const - (before < 0 ? ends.rho_0() * before * before / 2 : 0);
        const double v =
            sign * (1.2 + 0.7) / 2 + ends.dt() * (sign * 4e4 - p_outlet) / (ends.rho_0() * D * ends.dx());
        s.expected_velocity.at(k - 1) = v;
        for (const double own :
             {1.5, 0.1, -2.0}) { // each takes part in the slab's change, but none turns back
            const double speed = std::max(0.0, own + v - before);
            const double z = 1.6 + 0.1 * own;
            s.visitors.push_back(of_slab(k, z, speed, own, ghost.at(k), z));
        }
    }
    return s;
}

/// A slab that begins to move inwards starts from its pattern.
void patterns(const OpenEnds& ends, Quantities& q)
{
    constexpr std::int64_t turning = 800; // the inlet's first step forwards of its second cycle
    Scene inlet = scene_of(ends, "the inlet's slab turns", turning, {1, 1});
    inlet.visitors = {of_slab(0, 0.3, -1, 5, Kind::inlet, 0.3), of_slab(0, 1.7, -1, 5, Kind::inlet, 1.7)};
    ends.check_pattern(inlet, 0, -ends.v_in(turning), q);
    for (const std::size_t k : {1U, 2U}) {
        Scene outlet = scene_of(ends, "outlet " + std::to_string(k) + "'s slab turns", forth, {0.5, 0.5});
        outlet.p_const = 0;
        outlet.visitors = {blood(k, -1.5, -0.8, 0, 0), of_slab(k, 0.3, 5, 5, ghost.at(k), 0.3),
                           of_slab(k, 1.7, 5, 5, ghost.at(k), 1.7)};
        ends.check_pattern(outlet, k, -0.8, q);
    }
}

void open_ends(Probe& probe)
{
    const char* of_step =
        "gamma_40 of the place's size: the end's place and axis, the move, the way back to a "
        "plane or by a slab, each a product and a sum of three components";
    Quantities q{
        probe.quantity("what each particle becomes", Source::exact,
                       "integers; limits are approached to 1e-4 from both sides, a hundred times what "
                       "single precision rounds; on an oblique plane rounding decides, and both are right"),
        probe.quantity("its place [m]", Source::rounding, of_step),
        probe.quantity("its velocity [m/s]", Source::rounding,
                       "gamma_40 of twice v_0: (25), the slab's sums over three particles, and a projection"),
        probe.quantity("velocity of an outlet's slab [m/s]", Source::rounding,
                       "gamma_40 of twice v_0: two means over two particles, then eight operations"),
        probe.quantity("pressure of blood that has just entered [Pa]", Source::exact,
                       "a mark: it has been through no solve yet"),
        probe.quantity("particles that entered, left or were recycled", Source::exact,
                       "integers: the visitors that cross a plane or the far side of a slab in this step")};
    const OpenEnds ends(probe);
    for (const Scene& scene :
         {piston(ends), leaving_blood(ends), held_blood(ends), entering_ghosts(ends),
          nearby_blood(ends, true), nearby_blood(ends, false), recycled_ghosts(ends), pushed_slabs(ends)}) {
        ends.check(scene, q);
    }
    patterns(ends, q);
}

} // namespace

std::vector<Check> controller_checks()
{
    return {flow_check("sec34_open_ends", {"25", "26"},
                       "an open end pushes, holds, takes in and lets out each particle as section 3.4 says",
                       {"the rules, particle by particle"}, open_ends)};
}

} // namespace aneurysm::checks
