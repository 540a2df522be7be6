// SPDX-License-Identifier: Apache-2.0
// Disturbed blood between two plates: what the wall's ghosts add
// to every sum of section 3.1, against all pairs.
#include "common/scenario/shipped.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace aneurysm::checks
{
namespace
{

constexpr int rows = 3; ///< between the plates; few, so that the cloud's cube holds them and their ghosts
constexpr int cells = 8;

Scenario plates()
{
    Scenario s = shipped_scenario("verify_channel");
    s.domain.cells_x = s.domain.cells_z = cells;
    s.domain.cells_y = rows;
    s.particles.count = cells * rows * cells;
    s.particles.jitter_spacings = 0;
    s.kernel.smoothing_length_spacings = 1;
    s.time.frame_s = 0x1p-12;
    s.fluid.viscosity_pa_s = 64;
    s.fluid.gravity_m_s2 = {};
    s.fluid.gravity_cycle_s = 0;
    s.pressure.relaxation = 0.2;
    s.pressure.density_correction = 0; // else a fresh start settles
    return s;
}

/// Each particle up to a quarter of a spacing from its place, with velocities up to 0.5 m/s.
SimulationState disturbed(const Probe& probe, const Scenario& s)
{
    SimulationState state = probe.simulate(s)->state();
    std::mt19937_64 bits(2449);
    const auto random = [&] { return std::ldexp(static_cast<double>(bits() >> 54U), -9) - 1; };
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            state.particles.position[i].*axis += s.domain.spacing_m / 4 * random();
            state.particles.velocity[i].*axis = random() / 2;
        }
    }
    return state;
}

/// The blood, and two layers of the wall's ghosts on either side: lattice points with a particle's mass, at
/// rest, of the rest density.
analytic::Cloud cloud_of(const Scenario& s, const SimulationState& state, const std::vector<double>& density)
{
    const double dx = s.domain.spacing_m;
    analytic::Cloud c;
    c.kernel = s.kernel.function;
    c.h = dx;
    c.period = cells * dx;
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        c.position.push_back(to_eigen(state.particles.position[i]));
        c.velocity.push_back(to_eigen(state.particles.velocity[i]));
    }
    c.free.assign(c.position.size(), true);
    c.density = density;
    for (const double y : {-1.5, -0.5, rows + 0.5, rows + 1.5}) {
        for (int i = 0; i < cells; ++i) {
            for (int k = 0; k < cells; ++k) {
                c.position.emplace_back((i + 0.5) * dx, y * dx, (k + 0.5) * dx);
                c.velocity.emplace_back(0, 0, 0);
                c.free.push_back(false);
                c.density.push_back(s.fluid.density_kg_m3);
            }
        }
    }
    c.mass.assign(c.position.size(), state.particles.mass);
    c.pressure.assign(c.position.size(), 0);
    return c;
}

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
    double mean = 0;
    double largest = 0;
    double error = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const auto rate = analytic::pair_density_rate(after, i);
        mean += std::abs(rate.value) / rho_0 / static_cast<double>(n);
        largest = std::max(largest, std::abs(rate.value) / rho_0);
        error = std::max(error, both(rate.error, u) / rho_0);
    }
    const double allowed = error + rounding(static_cast<double>(n)) * largest;
    divergence.within(record.divergence_mean, mean, allowed, "mean");
    divergence.within(record.divergence_max, largest, allowed, "largest");
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

std::vector<Check> wall_cloud_checks()
{
    return {{.id = "eq27_cloud_frame",
             .level = Level::lattice,
             .equations = {"27", "2", "5", "6", "7", "EOS"},
             .title = "disturbed blood between plates feels the ghosts of both in every sum",
             .oracles = {"brute force over all pairs"},
             .scope = Scope::flows,
             .run = by_state},
            {.id = "eq27_cloud_iteration",
             .level = Level::lattice,
             .equations = {"27", "2", "3"},
             .title = "between plates an iteration of (3) answers each particle's residual by its own factor",
             .oracles = {"brute force over all pairs"},
             .scope = Scope::flows,
             .run = by_solve}};
}

} // namespace aneurysm::checks
