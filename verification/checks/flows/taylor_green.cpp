// SPDX-License-Identifier: Apache-2.0
// The vortices of Taylor and Green in the periodic box: (1), (3), (7) and (15) together.
#include "analytic/taylor_green.hpp"

#include "common/scenario/shipped.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"

#include <cmath>
#include <numbers>

namespace aneurysm::checks
{
namespace
{

constexpr std::int64_t edge = 24; ///< in cells; 6 in z

Scenario vortex_scenario()
{
    Scenario s = box_scenario();
    s.domain.cells_x = s.domain.cells_y = edge;
    s.domain.cells_z = 6;
    s.particles.count = edge * edge * 6;
    return s;
}

/// At rest, then given the vortices' velocity.
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
    return {U, 2 * std::numbers::pi / (static_cast<double>(edge) * s.domain.spacing_m), s.fluid.density_kg_m3,
            s.fluid.viscosity_pa_s / s.fluid.density_kg_m3};
}

/// So slow that they move nothing.
void frozen(Probe& probe)
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

/// At a Reynolds number of 100, with the artery's pressure solve.
Scenario moving_scenario(double U)
{
    Scenario s = vortex_scenario();
    s.fluid.viscosity_pa_s = s.fluid.density_kg_m3 * U * static_cast<double>(edge) * s.domain.spacing_m / 100;
    s.time.frame_s = 2e-3;
    s.inlet.peak_velocity_m_s = U;
    const Scenario artery = shipped_scenario("base");
    s.pressure = artery.pressure;
    s.settling = artery.settling;
    s.particles.jitter_spacings = artery.particles.jitter_spacings;
    return s;
}

/// Kinetic energy over time, over that of the start.
Series energy(const Probe& probe, const Scenario& s, const analytic::TaylorGreen& flow)
{
    const auto simulated = probe.simulate(s, vortices(probe, s, flow));
    Series found{"disordered blood", {}, {}, false};
    double start = 0;
    for (int n = 1; n <= 200; ++n) {
        const FrameRecord r = simulated->advance();
        start = n == 1 ? r.kinetic_energy / std::pow(flow.decay(s.time.frame_s), 2) : start;
        if (n % 4 == 0) {
            found.x.push_back(n * s.time.frame_s);
            found.y.push_back(r.kinetic_energy / start);
        }
    }
    return found;
}

void moving(Probe& probe)
{
    constexpr double U = 0.5;
    const Scenario s = moving_scenario(U);
    const analytic::TaylorGreen flow = flow_of(s, U);
    const Series found = energy(probe, s, flow);
    Series exact{"exact", {}, {}, true};
    for (const double t : found.x) {
        exact.x.push_back(t);
        exact.y.push_back(std::pow(flow.decay(t), 2));
    }
    const std::string name = "kinetic energy of moving vortices at t = 0.4 s over that of the start, ";
    probe.note(name + "exact [1]", exact.y.back());
    probe.note(name + "of disordered blood [1]", found.y.back(), "no bound");
    probe.plot({"Decay of Taylor and Green's vortices, Reynolds number 100",
                "t [s]",
                "kinetic energy / that of the start",
                false,
                true,
                {found, exact}});
}

void taylor_green(Probe& probe)
{
    frozen(probe);
    moving(probe);
}

} // namespace

std::vector<Check> taylor_green_checks()
{
    return {limit_check("taylor_green", {"7", "1", "3", "15"},
                        "resting vortices decay as the lattice says; how moving ones do is reported",
                        {"(1 - rate dt)^n with the rate's lattice symbol", "Taylor and Green's solution"},
                        taylor_green)};
}

} // namespace aneurysm::checks
