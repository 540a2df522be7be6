// SPDX-License-Identifier: Apache-2.0
// The vortices of Taylor and Green in the periodic box, so slow that they move nothing: (7), (1) and (15).
#include "verification/checks/flows/taylor_green.hpp"

#include <cmath>
#include <numbers>

namespace aneurysm::checks
{
Scenario vortex_scenario()
{
    Scenario s = box_scenario();
    s.domain.cells_x = s.domain.cells_y = vortex_cells;
    s.domain.cells_z = 6;
    s.particles.count = vortex_cells * vortex_cells * 6;
    return s;
}

SimulationState vortices(const Probe& probe, const Scenario& s, const analytic::TaylorGreen& flow)
{
    SimulationState state = probe.simulate(s)->state();
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        const Vec3& x = state.particles.position[i];
        const Eigen::Vector2d v = flow.velocity(x.x, x.y, 0);
        state.particles.velocity[i] = {v.x(), v.y(), 0};
    }
    return state;
}

analytic::TaylorGreen flow_of(const Scenario& s, double U)
{
    return {U, 2 * std::numbers::pi / (static_cast<double>(vortex_cells) * s.domain.spacing_m),
            s.fluid.density_kg_m3, s.fluid.viscosity_pa_s / s.fluid.density_kg_m3};
}

namespace
{

void resting(Probe& probe)
{
    constexpr int steps = 20;
    constexpr double weak = 0x1p-60;
    Quantity& velocity = probe.quantity(
        "velocity of resting vortices after 20 steps, relative to their first crest [1]", Source::rounding,
        "their four waves decay by one rate; each step adds dt times the error of the rate, for oracle and "
        "subject, and gamma_8; 8 u of the wave at the start (docs/bounds.md, B13)");
    const Scenario s = vortex_scenario();
    const analytic::TaylorGreen flow = flow_of(s, weak);
    const SimulationState start = vortices(probe, s, flow);
    const auto simulated = probe.simulate(s, start);
    for (int n = 0; n < steps; ++n) {
        simulated->advance();
    }
    const double dx = s.domain.spacing_m;
    const analytic::Lattice lattice{s.kernel.function, s.kernel.smoothing_length_spacings * dx, dx};
    const double rho = s.fluid.density_kg_m3;
    const analytic::Medium medium{lattice, rho / analytic::kernel_sum(lattice).value, rho};
    const auto rate = analytic::shear_decay_rate(medium, s.fluid.viscosity_pa_s, {flow.k, flow.k, 0});
    const double left = std::pow(1 - rate.value * s.time.frame_s, steps);
    const double u = probe.roundoff();
    const double allowed = steps * (s.time.frame_s * both(rate.error, u) + probe.gamma(8)) + probe.gamma(8);
    for (std::size_t i = 0; i < start.particles.size(); ++i) {
        velocity.within(simulated->state().particles.velocity[i] / weak,
                        left / weak * start.particles.velocity[i], allowed);
    }
}

} // namespace

std::vector<Check> taylor_green_checks()
{
    return {flow_check("eq07_resting_vortices", {"7", "1", "15"},
                       "resting vortices decay as the lattice says",
                       {"(1 - rate dt)^n with the rate's lattice symbol"}, resting)};
}

} // namespace aneurysm::checks
