// SPDX-License-Identifier: Apache-2.0
// Disturbed blood between two plates: what the ghosts of a wall at rest, (27), add to every sum of section 3.1 and to
// both solves of (3), against all pairs.
#include "analytic/kernel_function.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/sums/incompressible.hpp"
#include "verification/checks/sums/one_iteration.hpp"
#include "verification/checks/sums/plates.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

/// (7), with the ghosts' velocities extrapolated from the blood: their rounding counts, too.
analytic::VectorEstimate friction(const analytic::Cloud& moving, double mu, double of_ghosts, std::size_t i)
{
    constexpr double neighbors = 64; // at most
    auto force = analytic::pair_viscosity_force(moving, mu, i);
    const double lap = 2 * analytic::viscosity_kernel_laplacian(2 * moving.h, moving.h); // at r = 0
    force.error += neighbors * mu * moving.mass[i] / moving.density.back() * lap * of_ghosts;
    return force;
}

/// Gives the ghosts of a cloud behind its n particles their velocity in (7); the largest error of one.
double extrapolate(analytic::Cloud& cloud, std::size_t n)
{
    double error = 0;
    for (std::size_t j = n; j < cloud.velocity.size(); ++j) {
        const auto v = analytic::pair_no_slip_velocity(cloud, j);
        cloud.velocity[j] = v.value;
        error = std::max(error, v.error);
    }
    return error;
}

/// (5), (6) with the equation of state and (7), then (2) of the new velocity.
void by_state(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& rho = probe.quantity("density [kg/m^3]", Source::rounding,
                                   "the bound of the sum (5) over all pairs, for oracle and subject");
    Quantity& velocity =
        probe.quantity("velocity after one step [m/s]", Source::rounding,
                       "dt/rho times the bounds of the sums (6) and (7) over all pairs, and of "
                       "the ghosts' extrapolated velocities times 64 mu m/rho_0 lap W(0), for "
                       "oracle and subject, + gamma_8 of |v| + dt |a|");
    Quantity& divergence =
        probe.quantity("mean and largest |Drho/Dt|/rho_0 of the new velocity [1/s]", Source::rounding,
                       "the bound of the sum (2) over all pairs and gamma_N of the mean's additions");
    Scenario s = plates();
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 256;
    const double dt = s.time.frame_s;
    const double rho_0 = s.fluid.density_kg_m3;
    const SimulationState before = disturbed(probe, s);
    const auto flow = probe.simulate(s, before);
    const FrameRecord record = flow->advance();
    const std::size_t n = before.particles.size();
    auto cloud = cloud_of(s, before, flow->density());
    for (std::size_t i = 0; i < n; ++i) {
        cloud.pressure[i] = s.pressure.stiffness_m2_s2 * (cloud.density[i] - rho_0);
    }
    auto after = cloud;
    auto moving = cloud;
    const double of_ghosts = extrapolate(moving, n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::string where = "particle " + std::to_string(i);
        const auto density = analytic::pair_density(cloud, i);
        rho.within(flow->density()[i], density.value, both(density.error, u), where);
        const auto pressing = analytic::pair_pressure_force(cloud, i);
        const auto viscous = friction(moving, s.fluid.viscosity_pa_s, of_ghosts, i);
        const Vec3 a = to_vec3(pressing.value + viscous.value) / cloud.density[i];
        const Vec3& v_0 = before.particles.velocity[i];
        const Vec3& v = flow->state().particles.velocity[i];
        // one that has hit a plate has been turned round
        const Vec3 way = flow->state().particles.position[i] - before.particles.position[i] - dt * v;
        const double y = flow->state().particles.position[i].y;
        if (std::abs(way.y) <= 8 * u * (std::abs(y) + dt * length(v))) {
            velocity.within(v, v_0 + dt * a,
                            dt / cloud.density[i] * both(pressing.error + viscous.error, u) +
                                probe.gamma(8) * (length(v_0) + dt * length(a)),
                            where);
        }
        after.velocity[i] = to_eigen(v_0 + dt * a);
    }
    recorded_rates(after, rho_0, u).compare(divergence, record);
}

/// One iteration of the pressure from known ones.
void by_solve(Probe& probe)
{
    Quantity& pressure =
        probe.quantity("pressure after one iteration [Pa]", Source::rounding, of_one_iteration);
    Scenario s = plates();
    s.pressure.model = PressureModel::dfsph;
    s.pressure.tolerance_per_s = 1e-300;
    s.pressure.max_iterations = 1;
    s.fluid.viscosity_pa_s = 0;
    SimulationState before = disturbed(probe, s);
    const std::size_t n = before.particles.size();
    for (std::size_t i = 0; i < n; ++i) {
        before.particles.pressure[i] = static_cast<double>(1 + i * i % 1021);
    }
    const auto flow = probe.simulate(s, before);
    flow->advance();
    auto cloud = cloud_of(s, before, flow->density());
    std::ranges::copy(before.particles.pressure, cloud.pressure.begin());
    const OneIteration iteration(probe, s, cloud);
    for (std::size_t i = 0; i < n; ++i) {
        const auto expected = iteration.potential(i, {}, 0);
        pressure.within(flow->solved_pressure()[i], expected.value, expected.error,
                        "particle " + std::to_string(i));
    }
}

/// One iteration of the correction from known kappa: between ghosts at rest, over densities predicted for the ways that
/// the blood goes; and what these ways add to the density beyond (2).
void by_correction(Probe& probe)
{
    Quantity& kappa = probe.quantity("kappa after one iteration [Pa]", Source::rounding, of_one_iteration);
    Quantity& drift =
        probe.quantity("density that the ways add beyond dt Drho/Dt [kg/m^3]", Source::rounding, of_drift);
    Scenario s = without_iterations(plates(), 0.75);
    s.pressure.shifting = 0.125;
    s.pressure.model = PressureModel::dfsph;
    s.pressure.correction_tolerance_per_s = 1e-300;
    s.pressure.correction_max_iterations = 1;
    s.fluid.viscosity_pa_s = 0;
    const double dt = s.time.frame_s;
    const double rho_0 = s.fluid.density_kg_m3;
    const double beta = s.pressure.density_correction;
    SimulationState before = disturbed(probe, plates());
    const std::size_t n = before.particles.size();
    for (std::size_t i = 0; i < n; ++i) {
        before.particles.kappa[i] = static_cast<double>(i * i % 1021) - 510;
    }
    const auto flow = probe.simulate(s, before);
    flow->advance();
    const auto cloud = cloud_of(s, before, flow->density());
    const std::vector<Eigen::Vector3d> straight = ways_of(cloud, dt);
    const Shifts shifts = shifts_of(s, cloud, before.particles.kind);
    const std::vector<Eigen::Vector3d> way = shifts.and_ways(straight);
    auto at_rest = cloud;
    at_rest.given = analytic::Given::at_rest;
    std::ranges::fill(at_rest.velocity, Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < n; ++i) {
        at_rest.pressure[i] = std::max(lowest_kappa(cloud.density[i], rho_0), before.particles.kappa[i]);
    }
    const OneIteration iteration(probe, s, at_rest);
    for (std::size_t i = 0; i < n; ++i) {
        const std::string where = "particle " + std::to_string(i);
        compare_drift(probe, drift, flow->state().particles.drift[i], cloud, straight, dt, i);
        const auto shifted = analytic::pair_density_ahead(cloud, way, i, shifts.error);
        const analytic::Estimate source{beta * (shifted.value - rho_0) / dt,
                                        beta * (shifted.error + rounding(4) * rho_0) / dt};
        const auto expected = iteration.potential(i, source, lowest_kappa(cloud.density[i], rho_0));
        kappa.within(flow->solved_kappa()[i], expected.value, expected.error, where);
    }
}

/// Velocity along the plates that rises in proportion to the distance from the nearer one.
void shear(Probe& probe)
{
    Quantity& velocity =
        probe.quantity("velocity of the rows at the plates after one step [m/s]", Source::rounding,
                       "dt/rho times the bound of the sum (7) over all pairs, with that of the "
                       "ghosts' velocities, for oracle and subject, + gamma_8 |v|");
    Quantity& middle = probe.quantity("rows in the middle are slowed down", Source::exact,
                                      "a claim: friction acts where the profile has a kink");
    Scenario s = plates(4);
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 0;
    const double dx = s.domain.spacing_m;
    SimulationState before = probe.simulate(s)->state();
    Particles& p = before.particles;
    const auto row = [&](std::size_t i) { return std::lround(p.position[i].y / dx - 0.5); };
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.velocity[i] = {row(i) == 0 || row(i) == 3 ? 0.25 : 0.75, 0, 0};
    }
    const auto flow = probe.simulate(s, before);
    flow->advance();
    auto moving = cloud_of(s, before, flow->density());
    const double of_ghosts = extrapolate(moving, p.size());
    for (std::size_t i = 0; i < p.size(); ++i) {
        const std::string where = "particle " + std::to_string(i);
        const Vec3& v = flow->state().particles.velocity[i];
        if (row(i) == 0 || row(i) == 3) {
            const auto force = friction(moving, s.fluid.viscosity_pa_s, of_ghosts, i);
            velocity.within(v, p.velocity[i],
                            s.time.frame_s / moving.density[i] * both(force.error, probe.roundoff()) +
                                probe.gamma(8) * length(p.velocity[i]),
                            where);
        } else {
            middle.holds(v.x < p.velocity[i].x, where);
        }
    }
}

} // namespace

std::vector<Check> boundary_ghosts_checks()
{
    return {
        sum_check("eq27_cloud_frame", {"27", "2", "5", "6", "7", "EOS"},
                  "disturbed blood between plates feels the ghosts of both in every sum",
                  {"brute force over all pairs"}, by_state),
        sum_check("eq27_shear", {"27", "7"}, "blood that is sheared evenly at a plate feels no friction",
                  {"a velocity that rises with the distance"}, shear),
        sum_check("eq27_cloud_iteration", {"27", "2", "3"},
                  "between plates an iteration of (3) answers each particle's residual by its own factor",
                  {"brute force over all pairs"}, by_solve),
        sum_check("eq27_cloud_correction", {"27", "2", "3", "5"},
                  "between plates an iteration of the density's correction answers what the ways do to it",
                  {"brute force over all pairs"}, by_correction)};
}

} // namespace aneurysm::checks
