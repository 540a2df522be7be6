// SPDX-License-Identifier: Apache-2.0
// The three open ends of the artery, particle by particle: a few of them are put near the ends, nothing pushes them but
// what an end does, and each must be afterwards what section 3.4 and (25) make of it.
#include "analytic/kernel_function.hpp"
#include "common/scenario/shipped.hpp"
#include "common/vessel/geometry.hpp"
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

constexpr double D = 3;         ///< depth of a buffer [dx]
constexpr double beside = 1e-4; ///< to either side of a limit, relative; far more than float rounds
constexpr std::array<Kind, 3> buffer{Kind::inlet, Kind::outlet_1, Kind::outlet_2};

/// A particle near open end k, and what becomes of it.
struct Visitor {
    std::size_t k = 0;
    Kind kind = Kind::fluid;
    double beyond = 0; ///< the end's plane, after its move [dx]
    double aside = 0;  ///< of the end's axis, along z [dx]
    double before = 0; ///< its outward velocity; the inlet's buffer gets another [m/s]
    Kind becomes = Kind::fluid;

    bool in_buffer() const { return kind != Kind::fluid; }
};

/// One step of an artery that holds these alone.
struct Scene {
    std::string name;
    std::int64_t frame = 0; ///< of the step; says what (25) is
    std::vector<Visitor> visitors{};
};

/// A particle as a step must leave it.
struct Expected {
    Kind kind = Kind::reserve;
    Vec3 position;
    Vec3 velocity;
    double pressure = 0; ///< [Pa]
};

struct Quantities {
    Quantity& kind;
    Quantity& place;
    Quantity& velocity;
    Quantity& outlet;
    Quantity& potentials;
    Quantity& counts;
};

/// An artery in which nothing pushes: kappa = 0 in (6), no viscosity, and p_const = 0 in (26).
Scenario still_artery()
{
    Scenario s = shipped_scenario("quick");
    s.particles.count = 20000; // room for visitors that don't see one another
    s.particles.jitter_spacings = 0;
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 0;
    s.fluid.viscosity_pa_s = 0;
    s.outlet.pressure_pa = 0;
    s.inlet.waveform = Waveform::sine;
    s.inlet.profile = InletProfile::parabolic;
    s.inlet.ramp_s = 0;
    s.inlet.peak_velocity_m_s = 2;
    return s;
}

void count(const Visitor& v, Ledger& l)
{
    const bool inlet = v.k == 0;
    if (v.in_buffer() && v.becomes == Kind::fluid) {
        ++(inlet ? l.inlet_in : l.outlet_in);
    } else if (!v.in_buffer() && v.becomes != Kind::fluid) {
        ++(inlet ? l.inlet_out : l.outlet_out);
    } else if (v.becomes == Kind::reserve) {
        ++l.recycled;
    }
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

    void check(const Scene& scene, Quantities& q) const
    {
        const SimulationState before = state_before(scene);
        const auto flow = probe_->simulate(scenario_, before);
        const FrameRecord record = flow->advance();
        const std::vector<Expected> expected = expect(scene);
        const Particles& p = flow->state().particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Expected& e = expected[i];
            const std::string where = scene.name + ", particle " + std::to_string(i);
            q.kind.equal(static_cast<int>(p.kind[i]), static_cast<int>(e.kind), where);
            if (e.kind != Kind::reserve) {
                q.place.within(p.position[i], e.position, probe_->gamma(40) * (length(e.position) + D * dx()),
                               where);
                q.velocity.within(p.velocity[i], e.velocity, probe_->gamma(60) * v_unit(), where);
                q.potentials.within(p.pressure[i], e.pressure, 0, where);
                q.potentials.within(p.kappa[i], 0, 0, where);
                q.potentials.within(p.drift[i], 0, 0, where);
            }
        }
        for (const std::size_t k : {1U, 2U}) {
            q.outlet.within(flow->state().outlet_velocity.at(k - 1), mean_before(scene, k),
                            probe_->gamma(40) * v_unit(), scene.name + ", outlet " + std::to_string(k));
        }
        check_ledger(scene, record.ledger, q);
    }

    /// The first place of buffer k's far layer, or the last one, and from there `distance` along z.
    Visitor near_place(std::size_t k, bool first, double distance) const
    {
        std::vector<Vec3> places = far_places(k);
        std::ranges::sort(places, {}, &Vec3::z);
        const Vec3& x = first ? places.front() : places.back();
        const Vec3 d = x - end(k).center;
        const double beyond = dot(d, end(k).outward);
        Visitor v{k, buffer.at(k), beyond / dx(), (d.z + (first ? distance : -distance) * dx()) / dx(),
                  0, buffer.at(k)};
        return v;
    }
    double refill_distance() const { return scenario_.controller.refill_distance_spacings; }

private:
    const Opening& end(std::size_t k) const { return vessel_.openings().at(k); }
    double dx() const { return start_.spacing; }
    double dt() const { return scenario_.time.frame_s; }
    /// The largest velocity that is made of the others [m/s].
    double v_unit() const { return 4 * scenario_.inlet.peak_velocity_m_s; }

    /// (25) in the step to this frame [m/s].
    double v_in(std::int64_t frame) const
    {
        const auto& in = scenario_.inlet;
        return in.peak_velocity_m_s *
               std::sin(2 * std::numbers::pi * static_cast<double>(frame) * dt() / in.cycle_s);
    }
    /// Velocity of the inlet's blood at x: a parabola whose mean over the circle is (25) [m/s].
    Vec3 inlet_velocity(const Vec3& x, double v) const
    {
        const double r_0 = scenario_.vessel.radius_m; // the parent's axis is y
        return 2 * v * (r_0 * r_0 - x.x * x.x - x.z * x.z) / (r_0 * r_0) * Vec3{0, 1, 0};
    }

    Vec3 place(const Visitor& v) const
    {
        return end(v.k).center + v.beyond * dx() * end(v.k).outward + Vec3{0, 0, v.aside * dx()};
    }

    /// Mean outward velocity of an outlet's buffer before the step [m/s].
    static double mean_before(const Scene& scene, std::size_t k)
    {
        double sum = 0;
        double n = 0;
        for (const Visitor& v : scene.visitors) {
            if (v.kind == buffer.at(k)) {
                sum += v.before;
                ++n;
            }
        }
        return n > 0 ? sum / n : 0;
    }

    /// While it moves. Blood that comes back from an outlet is slowed down by rho_0 v^2 / (2 D) per volume; it is so
    /// far from the others that its density (5) is m W(0).
    Vec3 velocity(const Scene& scene, const Visitor& v) const
    {
        if (v.kind == Kind::inlet) {
            return inlet_velocity(place(v), v_in(scene.frame));
        }
        const double mean = v.in_buffer() ? std::min(0.0, mean_before(scene, v.k)) : 0;
        const double h = scenario_.kernel.smoothing_length_spacings * dx();
        const double rho = start_.particles.mass * analytic::kernel(scenario_.kernel.function, h, 0);
        const double slower = dt() / rho * scenario_.fluid.density_kg_m3 * mean * mean / (2 * D * dx());
        return (v.before + slower) * end(v.k).outward;
    }

    SimulationState state_before(const Scene& scene) const
    {
        SimulationState state = start_;
        state.frame = scene.frame - 1;
        Particles& p = state.particles;
        std::ranges::fill(p.kind, Kind::reserve);
        for (std::vector<double>* potential : {&p.pressure, &p.kappa, &p.drift}) {
            std::ranges::fill(*potential, 7.0); // what waits may have been anything
        }
        for (std::size_t i = 0; i < scene.visitors.size(); ++i) {
            const Visitor& v = scene.visitors[i];
            p.kind[i] = v.kind;
            p.position[i] = place(v) - dt() * velocity(scene, v);
            p.velocity[i] = v.before * end(v.k).outward;
            p.pressure[i] = p.kappa[i] = p.drift[i] = 0;
        }
        return state;
    }

    /// Of the buffer as sampled: those that are filled.
    std::vector<Vec3> far_places(std::size_t k) const
    {
        std::vector<Vec3> places;
        for (std::size_t i = 0; i < start_.particles.size(); ++i) {
            const Vec3& x = start_.particles.position[i];
            if (start_.particles.kind[i] == buffer.at(k) && end(k).beyond(x) > (D - 1) * dx()) {
                places.push_back(x);
            }
        }
        return places;
    }

    std::vector<Expected> expect(const Scene& scene) const
    {
        std::vector<Expected> all(start_.particles.size());
        for (std::size_t i = 0; i < scene.visitors.size(); ++i) {
            const Visitor& v = scene.visitors[i];
            const bool unset = v.kind == Kind::inlet && v.becomes == Kind::fluid;
            all[i] = {v.becomes, place(v), velocity(scene, v), unset ? unset_pressure : 0};
        }
        std::size_t next = 0;
        for (const std::size_t k : {0U, 1U, 2U}) {
            fill(scene, k, all, next);
        }
        return all;
    }

    /// Free places of the far layer, while the buffer doesn't move outwards, in the order of the pattern; from the
    /// reserve the lowest number first.
    void fill(const Scene& scene, std::size_t k, std::vector<Expected>& all, std::size_t& next) const
    {
        std::vector<Expected> blood;
        std::ranges::copy_if(all, std::back_inserter(blood),
                             [k](const Expected& e) { return e.kind == buffer.at(k); });
        double outward = 0;
        for (const Expected& e : blood) {
            outward += dot(e.velocity, end(k).outward) / static_cast<double>(blood.size());
        }
        if ((k == 0 ? -v_in(scene.frame) : outward) > 0) {
            return;
        }
        for (const Vec3& x : far_places(k)) {
            const bool is_free = std::ranges::none_of(
                blood, [&](const Expected& e) { return length(e.position - x) < refill_distance() * dx(); });
            if (!is_free) {
                continue;
            }
            while (all[next].kind != Kind::reserve) {
                ++next;
            }
            all[next++] = {buffer.at(k), x,
                           k == 0 ? inlet_velocity(x, v_in(scene.frame)) : outward * end(k).outward, 0};
        }
    }

    static void check_ledger(const Scene& scene, const Ledger& l, Quantities& q)
    {
        Ledger expected;
        for (const Visitor& v : scene.visitors) {
            count(v, expected);
        }
        for (const auto& [found, wanted] :
             {std::pair{l.inlet_in, expected.inlet_in}, std::pair{l.inlet_out, expected.inlet_out},
              std::pair{l.outlet_out, expected.outlet_out}, std::pair{l.outlet_in, expected.outlet_in},
              std::pair{l.recycled, expected.recycled}, std::pair{l.missed, expected.missed}}) {
            q.counts.equal(found, wanted, scene.name);
        }
    }

    const Probe* probe_;
    Scenario scenario_;
    Vessel vessel_;
    SimulationState start_;
};

constexpr std::int64_t forth = 200; ///< a frame in which the inlet pushes with v_0,
constexpr std::int64_t back = 600;  ///< and one in which it draws

/// All three flows go through the artery from the inlet to the outlets.
Scene onwards()
{
    Scene s{"onwards", forth};
    s.visitors = {{0, Kind::inlet, -0.002, 0, 7, Kind::fluid},
                  {0, Kind::inlet, 0.002, 2.1, -7, Kind::inlet},
                  {0, Kind::inlet, 1.5, -2.1, 0, Kind::inlet},
                  {0, Kind::fluid, -0.1, 4.2, 0.5, Kind::fluid},
                  {0, Kind::fluid, 0.05, -4.2, 3, Kind::inlet}};
    for (const std::size_t k : {1U, 2U}) {
        const double v = k == 1 ? 0.8 : 1.5;
        const Kind own = buffer.at(k);
        s.visitors.insert(s.visitors.end(), {{k, own, D * (1 - beside), 0, v, own},
                                             {k, own, D * (1 + beside), 2.1, v, Kind::reserve},
                                             {k, own, 0.5, -2.1, -0.4, own}, // one that comes back
                                             {k, Kind::fluid, 0.01, 4.2, v, own},
                                             {k, Kind::fluid, -0.001, -4.2, v, Kind::fluid}});
    }
    return s;
}

/// They go through it the other way.
Scene backwards()
{
    Scene s{"backwards", back};
    s.visitors = {{0, Kind::inlet, D * (1 - beside), 0, 7, Kind::inlet},
                  {0, Kind::inlet, D * (1 + beside), 2.1, 0, Kind::reserve},
                  {0, Kind::inlet, 0.01, -2.1, 0, Kind::inlet},
                  {0, Kind::fluid, 0.05, 4.2, 1, Kind::inlet},
                  {0, Kind::fluid, -0.01, -4.2, 3, Kind::fluid}};
    for (const std::size_t k : {1U, 2U}) {
        const double v = k == 1 ? -1 : -0.4;
        const Kind own = buffer.at(k);
        s.visitors.insert(s.visitors.end(), {{k, own, -0.002, 0, v, Kind::fluid},
                                             {k, own, 0.002, 2.1, v, own},
                                             {k, own, D * (1 + beside), -2.1, 0.1, Kind::reserve},
                                             {k, Kind::fluid, 0.01, 4.2, 0.2, own}, // one that leaves
                                             {k, Kind::fluid, -0.01, -4.2, v, Kind::fluid}});
    }
    return s;
}

/// Blood that is too near to a place keeps it from being filled.
Scene places(const OpenEnds& ends, std::int64_t frame)
{
    Scene s{"places, frame " + std::to_string(frame), frame};
    for (const std::size_t k : {0U, 1U, 2U}) {
        s.visitors.push_back(ends.near_place(k, true, ends.refill_distance() * (1 - beside)));
        s.visitors.push_back(ends.near_place(k, false, ends.refill_distance() * (1 + beside)));
    }
    return s;
}

void open_ends(Probe& probe)
{
    Quantities q{
        probe.quantity("what each particle becomes", Source::exact,
                       "integers; limits are approached to 1e-4 from both sides, a hundred times what "
                       "single precision rounds"),
        probe.quantity("its place [m]", Source::rounding,
                       "gamma_40 of the place's size: the end's place and axis and the move, each a product "
                       "and a sum of three components"),
        probe.quantity("its velocity [m/s]", Source::rounding,
                       "gamma_60 of four times v_0: (25) and its profile, or the mean over a buffer, the "
                       "density (5) and the force on what comes back"),
        probe.quantity("velocity of an outlet's buffer [m/s]", Source::rounding,
                       "gamma_40 of four times v_0: a mean over three particles and a projection"),
        probe.quantity("its pressure, kappa and drift", Source::exact,
                       "marks: blood from the inlet has been through no solve yet, the rest is at 0"),
        probe.quantity("particles that entered, left or were recycled", Source::exact,
                       "integers: the visitors that cross a plane or the far end of a buffer in this step")};
    const OpenEnds ends(probe);
    for (const Scene& scene : {onwards(), backwards(), places(ends, forth), places(ends, back)}) {
        ends.check(scene, q);
    }
}

} // namespace

std::vector<Check> controller_checks()
{
    return {flow_check("sec34_open_ends", {"25", "26"},
                       "an open end lets in, lets out and fills its buffer as section 3.4 says",
                       {"the rules, particle by particle"}, open_ends)};
}

} // namespace aneurysm::checks
