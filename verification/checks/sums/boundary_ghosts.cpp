// SPDX-License-Identifier: Apache-2.0
// Disturbed blood between two plates: what the ghosts of a wall at rest, (27), add to every sum of section 3.1,
// against all pairs.
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/sums/plates.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

/// (5), (6) with the equation of state and (7), then (2) of the new velocity.
void by_state(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& rho = probe.quantity("density [kg/m^3]", Source::rounding,
                                   "the bound of the sum (5) over all pairs, for oracle and subject");
    Quantity& velocity = probe.quantity("velocity after one step [m/s]", Source::rounding,
                                        "dt/rho times the bounds of the sums (6) and (7) over all pairs, for "
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
    for (std::size_t i = 0; i < n; ++i) {
        const std::string where = "particle " + std::to_string(i);
        const auto density = analytic::pair_density(cloud, i);
        rho.within(flow->density()[i], density.value, both(density.error, u), where);
        const auto pressing = analytic::pair_pressure_force(cloud, i);
        const auto viscous = analytic::pair_viscosity_force(cloud, s.fluid.viscosity_pa_s, i);
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

/// One iteration of (3) from known pressures: the pressures' acceleration, (2), the DFSPH factor.
void by_solve(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& pressure = probe.quantity(
        "pressure after one iteration [Pa]", Source::rounding,
        "omega rho_0^2/dt times the bounds of the sums of (2), of its velocity through dt times those of the "
        "pressure's acceleration, and of alpha, for oracle and subject, + gamma_12 of all terms");
    Scenario s = plates();
    s.pressure.model = PressureModel::dfsph;
    s.pressure.tolerance_per_s = 1e-300;
    s.pressure.max_iterations = 1;
    s.fluid.viscosity_pa_s = 0;
    const double dt = s.time.frame_s;
    const double rho_0 = s.fluid.density_kg_m3;
    const double factor = s.pressure.relaxation * rho_0 * rho_0 / dt;
    SimulationState before = disturbed(probe, s);
    const std::size_t n = before.particles.size();
    for (std::size_t i = 0; i < n; ++i) {
        before.particles.pressure[i] = static_cast<double>(1 + i * i % 1021);
    }
    const auto flow = probe.simulate(s, before);
    flow->advance();
    auto cloud = cloud_of(s, before, flow->density());
    std::copy(before.particles.pressure.begin(), before.particles.pressure.end(), cloud.pressure.begin());
    auto moved = cloud;
    double of_velocity = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto a = analytic::pair_pressure_acceleration(cloud, rho_0, i);
        moved.velocity[i] += dt * a.value;
        of_velocity =
            std::max(of_velocity, dt * both(a.error, u) +
                                      probe.gamma(4) * (cloud.velocity[i].norm() + dt * a.value.norm()));
    }
    for (std::size_t i = 0; i < n; ++i) {
        const auto rate = analytic::pair_density_rate(moved, i);
        const auto alpha = analytic::pair_dfsph_factor(cloud, i);
        // sum_j |m_j grad W_ij|, by Cauchy and Schwarz over at most 64 neighbors
        const double slopes = std::sqrt(64 / alpha.value);
        const double error =
            both(rate.error, u) + 2 * of_velocity * slopes + probe.gamma(12) * std::abs(rate.value);
        const double p = cloud.pressure[i];
        pressure.within(
            flow->solved_pressure()[i], std::max(0.0, p + factor * alpha.value * rate.value),
            factor * (alpha.value * error + (both(alpha.error, u) + probe.gamma(12) * alpha.value) *
                                                (std::abs(rate.value) + error)) +
                probe.gamma(4) * p,
            "particle " + std::to_string(i));
    }
}

} // namespace

std::vector<Check> boundary_ghosts_checks()
{
    return {sum_check("eq27_cloud_frame", {"27", "2", "5", "6", "7", "EOS"},
                      "disturbed blood between plates feels the ghosts of both in every sum",
                      {"brute force over all pairs"}, by_state),
            sum_check("eq27_cloud_iteration", {"27", "2", "3"},
                      "between plates an iteration of (3) answers each particle's residual by its own factor",
                      {"brute force over all pairs"}, by_solve)};
}

} // namespace aneurysm::checks
