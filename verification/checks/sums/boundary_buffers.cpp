// SPDX-License-Identifier: Apache-2.0
// Section 3.5, the buffers of blood at the open ends, against all pairs: the velocity (25) of the inlet's, the force (26)
// on an outlet's, what both add to every sum of section 3.1 and to both solves of (3), and the level of the pressure.
#include "common/scenario/shipped.hpp"
#include "common/vessel/sampling.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/pressure_level.hpp"
#include "verification/checks/sums/duct.hpp"
#include "verification/checks/sums/incompressible.hpp"
#include "verification/checks/sums/one_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

/// (5), (6) with the equation of state, (7) and (26), then (2) of the new velocity.
void by_state(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& rho = probe.quantity("density of the blood [kg/m^3]", Source::rounding,
                                   "the bound of the sum (5) over all pairs, for oracle and subject");
    Quantity& driven =
        probe.quantity("velocity of the inlet's buffer [m/s]", Source::rounding,
                       "gamma_16 of 2 v_0: eight operations on r/R and as many on the oracle's");
    Quantity& velocity = probe.quantity(
        "velocity after one step [m/s]", Source::rounding,
        "dt/rho times the bounds of the sums (6), (7) and (26) over all pairs, of gamma_(2n + 8) of rho V^2/2 over the depth, "
        "where the mean is of n velocities of at most V, and of gamma_1 of the force at the outlet, for oracle and subject, "
        "+ gamma_8 of |v| + dt |a|");
    Quantity& divergence =
        probe.quantity("mean and largest |Drho/Dt|/rho_0 of the new velocity [1/s]", Source::rounding,
                       "the bound of the sum (2) over all pairs and gamma_N of the mean's additions");
    Quantity& mean =
        probe.quantity("recorded outward velocity of the outlets' buffers [m/s]", Source::rounding,
                       "gamma_2N of the largest velocity; one of the two outlets isn't there");
    for (const double along : {0.25, -0.25}) {
        Scenario s = duct::scenario();
        s.pressure.model = PressureModel::eos;
        s.pressure.stiffness_m2_s2 = 256;
        s.fluid.viscosity_pa_s = 64;
        const double dt = s.time.frame_s;
        const double rho_0 = s.fluid.density_kg_m3;
        const SimulationState before = duct::disturbed(probe, s, along);
        const Particles& p = before.particles;
        const auto flow = probe.simulate(s, before);
        const FrameRecord record = flow->advance();
        auto cloud = duct::cloud_of(s, before, flow->density());
        for (std::size_t i = 0; i < p.size(); ++i) {
            cloud.pressure[i] = s.pressure.stiffness_m2_s2 * (cloud.density[i] - rho_0);
        }
        auto after = cloud;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!duct::is_blood(p.kind[i])) {
                continue;
            }
            const std::string where = "particle " + std::to_string(i);
            const auto density = analytic::pair_density(cloud, i);
            rho.within(cloud.density[i], density.value, both(density.error, u), where);
            const Vec3& v = flow->state().particles.velocity[i];
            if (p.kind[i] == Kind::inlet) {
                driven.within(v, duct::inlet_velocity_at(s, p.position[i]),
                              probe.gamma(16) * 2 * s.inlet.peak_velocity_m_s, where);
                continue;
            }
            const auto pressing = analytic::pair_pressure_force(cloud, i);
            const auto viscous = analytic::pair_viscosity_force(cloud, s.fluid.viscosity_pa_s, i);
            const auto outlet = duct::force_at_outlet(s, before, cloud, s.outlet.pressure_pa, i);
            const Vec3 a = to_vec3(pressing.value + viscous.value + outlet.value) / cloud.density[i];
            const Vec3& v_0 = p.velocity[i];
            velocity.within(v, v_0 + dt * a,
                            dt / cloud.density[i] * both(pressing.error + viscous.error + outlet.error, u) +
                                probe.gamma(8) * (length(v_0) + dt * length(a)),
                            where);
            after.velocity[i] = to_eigen(v_0 + dt * a);
        }
        recorded_rates(after, rho_0, u).compare(divergence, record);
        mean.within(record.outlet_velocity, duct::outlet_buffer(p).mean / 2,
                    probe.gamma(2 * static_cast<double>(p.size())), at({{"along", along}}));
    }
}

/// One iteration of the pressure, then one of the correction, from known potentials and drifts.
void by_solve(Probe& probe)
{
    Quantity& pressure =
        probe.quantity("pressure after one iteration [Pa]", Source::rounding, of_one_iteration);
    Quantity& kappa = probe.quantity("kappa after one iteration [Pa]", Source::rounding, of_one_iteration);
    Quantity& far = probe.quantity("kappa that would pull in the far layers", Source::exact,
                                   "a claim: some, in both buffers, else their bound would not be seen");
    Scenario s = without_iterations(duct::scenario(), 0.75);
    s.pressure.start = PressureStart::last;
    s.pressure.shifting = 0.125;
    s.fluid.viscosity_pa_s = 0;
    s.pressure.tolerance_per_s = s.pressure.correction_tolerance_per_s = 1e-300;
    s.pressure.max_iterations = s.pressure.correction_max_iterations = 1;
    const double dt = s.time.frame_s;
    const double rho_0 = s.fluid.density_kg_m3;
    const double level = s.outlet.level_margin * rho_0 * std::pow(s.inlet.peak_velocity_m_s, 2);
    SimulationState before = duct::disturbed(probe, s, -0.25);
    Particles& p = before.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.pressure[i] = static_cast<double>(i * i % 1021) - 510;
        p.kappa[i] = static_cast<double>(i * i % 1019) - 510;
        p.drift[i] = duct::is_blood(p.kind[i]) ? (static_cast<double>(i * i % 1013) - 510) / 64 : 0;
    }
    const auto flow = probe.simulate(s, before);
    flow->advance();
    auto cloud = duct::cloud_of(s, before, flow->density());
    const double of_start = duct::push_at_outlet(probe, s, before, level, cloud);
    for (std::size_t i = 0; i < p.size(); ++i) {
        cloud.pressure[i] = cloud.free[i] ? p.pressure[i] : 0;
    }
    const OneIteration of_pressure(probe, s, cloud, of_start);
    auto after = cloud; // and all take part in the correction, at rest
    for (std::size_t i = 0; i < p.size(); ++i) {
        after.velocity[i] = cloud.free[i] ? to_eigen(flow->state().particles.velocity[i]) : cloud.velocity[i];
    }
    const Shifts shifts = shifts_of(s, cloud, p.kind);
    const auto way = shifts.and_ways(ways_of(after, dt));
    const auto lowest = [&](std::size_t i) {
        return duct::is_far(s, p, i) ? 0 : lowest_kappa(cloud.density[i], rho_0);
    };
    auto at_rest = after;
    at_rest.given = analytic::Given::at_rest;
    at_rest.free.assign(p.size(), true);
    std::ranges::fill(at_rest.velocity, Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < p.size(); ++i) {
        at_rest.pressure[i] = std::max(lowest(i), p.kappa[i]);
    }
    const OneIteration of_kappa(probe, s, at_rest);
    std::array<int, 2> held{};
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!duct::is_blood(p.kind[i])) {
            continue;
        }
        const std::string where = "particle " + std::to_string(i);
        if (cloud.free[i]) {
            const auto drift = analytic::pair_mean(cloud, p.drift, i);
            const auto missing = duct::missing_density(s, p, cloud, i);
            const analytic::Estimate source{(drift.value + missing.value) / dt,
                                            (drift.error + missing.error) / dt};
            const auto expected = of_pressure.potential(i, source, level - s.outlet.pressure_pa);
            pressure.within(flow->solved_pressure()[i], expected.value, expected.error, where);
        }
        const auto ahead = analytic::pair_density_ahead(after, way, i, shifts.error);
        const double beta = s.pressure.density_correction;
        const analytic::Estimate source{beta * (ahead.value - rho_0) / dt,
                                        beta * (ahead.error + rounding(4) * rho_0) / dt};
        const auto expected = of_kappa.potential(i, source, lowest(i));
        kappa.within(flow->solved_kappa()[i], expected.value, expected.error, where);
        if (expected.value == 0 && p.kind[i] != Kind::fluid) {
            ++held[p.kind[i] == Kind::inlet ? 0 : 1];
        }
    }
    far.holds(held[0] > 0, "inlet");
    far.holds(held[1] > 0, "outlet");
}

/// Two particles at `place` that leave each other so fast that their pressure is the lowest there may be.
SimulationState parting(const Probe& probe, const Scenario& s, const Vec3& place)
{
    constexpr double speed = 32; // [m/s]
    SimulationState state = probe.simulate(s)->state();
    Particles& p = state.particles;
    std::ranges::fill(p.kind, Kind::reserve);
    for (std::size_t i = 0; i < 2; ++i) {
        const Vec3 aside{(i == 0 ? -0.5 : 0.5), 0, 0};
        p.kind[i] = Kind::fluid;
        p.position[i] = place + state.spacing * aside;
        p.velocity[i] = speed * aside;
    }
    return state;
}

void level(Probe& probe)
{
    Quantity& pressure = probe.quantity(
        "pressure of particles that part, the level less p_const [Pa]", Source::rounding,
        "gamma_32 of all terms, and gamma_8 v_0/dt for the difference of two velocities; gamma_4 p_const");
    Quantity& inlet = probe.quantity("recorded velocity of the inlet [m/s]", Source::rounding,
                                     "gamma_32 v_0: sine, start and a product, of oracle and subject");
    Scenario s = shipped_scenario("quick");
    s.pressure.density_correction = 0; // else a fresh start settles
    s.outlet.pressure_pa = 0x1p20;
    const double dt = s.time.frame_s;
    const double r_0 = s.vessel.radius_m;
    const double r = r_0 / std::cbrt(2.0);
    const double L_0 = s.vessel.parent_length_radii * r_0;
    const double L_1 = s.vessel.daughter_length_radii * r_0;
    const std::vector<Tube> tubes{{L_0, r_0}, {L_1, r, r_0 * r_0 / (2 * r * r)}};
    const double mass = s.fluid.density_kg_m3 * (L_0 + L_1 * tubes[1].share); // over the inlet's area
    const SimulationState start = parting(probe, s, {0, -L_0 / 2, 0});
    const double cap = s.outlet.pressure_pa;
    for (const double margin : {1.5, 30.0}) {
        s.outlet.level_margin = margin;
        for (const int frame : {10, 130, 250, 450, 700}) {
            SimulationState state = start;
            state.frame = frame - 1;
            const double pulled = margin * pull(s, tubes, frame * dt);
            const auto flow = probe.simulate(s, state);
            const FrameRecord record = flow->advance();
            inlet.within(record.inlet_velocity, inlet_velocity(s, frame * dt),
                         rounding(32) * s.inlet.peak_velocity_m_s, at({{"frame", double(frame)}}));
            const double of_slowing = margin * mass * rounding(8) * s.inlet.peak_velocity_m_s / dt;
            for (std::size_t i = 0; i < 2; ++i) {
                pressure.within(flow->solved_pressure()[i], std::min(cap, pulled) - cap,
                                rounding(32) * pulled + of_slowing + probe.gamma(4) * cap,
                                at({{"margin", margin}, {"frame", double(frame)}}));
            }
        }
    }
}

} // namespace

std::vector<Check> boundary_buffers_checks()
{
    return {
        sum_check("eq26_cloud_frame", {"26", "25", "2", "5", "6", "7", "EOS"},
                  "in a short duct the inlet's buffer moves with (25), and (26) pushes the outlet's",
                  {"brute force over all pairs", "Poiseuille's parabola"}, by_state),
        sum_check(
            "eq26_cloud_iteration", {"26", "25", "2", "3", "5"},
            "in a short duct an iteration of each solve sees the inlet's buffer as what it is there, and "
            "nothing pulls at the far ends",
            {"brute force over all pairs"}, by_solve),
        sum_check(
            "eq26_level", {"26", "3"},
            "the level of the pressure is what inertia, friction and the flow itself can pull it down by",
            {"Newton's law and Poiseuille's drop for tubes in a row"}, level),
    };
}

} // namespace aneurysm::checks
