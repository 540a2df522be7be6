// SPDX-License-Identifier: Apache-2.0
// A column of blood between an inlet and an outlet, without walls: what it moves with, (25), and what is beyond it, (26).
#include "analytic/boundary.hpp"
#include "analytic/kernel_function.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/pressure_level.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

/// A column of blood is neither stored nor lost on its way.
void duct(Probe& probe)
{
    const Scenario s = shipped_scenario("verify_duct");
    const auto layer = s.domain.cells_x * s.domain.cells_z;
    Quantity& stored = probe.quantity(
        "particles stored in the duct, in - out", Source::truncation,
        "(3) keeps the volume as far as the density: the frame's largest density error times the particles, "
        "and half a layer at each end (docs/bounds.md, B12)");
    Plot plot{"Blood between an inlet and an outlet", "frame", "velocity [m/s]", false, false, {}};
    Series inlet{"inlet, (25)", {}, {}, true};
    Series blood{"blood in the middle", {}, {}, false};
    const auto flow = probe.simulate(s);
    const double L = static_cast<double>(s.domain.cells_y) * s.domain.spacing_m;
    const auto first = std::ranges::count(flow->state().particles.kind, Kind::fluid);
    for (int n = 1; n <= 800; ++n) { // forth and back
        const FrameRecord r = flow->advance();
        const double density =
            std::max({r.density_error_max, -r.density_error_min, r.density_error_max_ends});
        stored.within(static_cast<double>(r.fluid), static_cast<double>(first),
                      static_cast<double>(first) * density + static_cast<double>(layer),
                      "frame " + std::to_string(n));
        double v = 0;
        double count = 0;
        const Particles& p = flow->state().particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (p.kind[i] == Kind::fluid && p.position[i].y > L / 4 && p.position[i].y < 3 * L / 4) {
                v += p.velocity[i].y;
                ++count;
            }
        }
        inlet.x.push_back(n);
        inlet.y.push_back(r.inlet_velocity);
        blood.x.push_back(n);
        blood.y.push_back(v / count);
    }
    plot.series = {inlet, blood};
    probe.plot(std::move(plot));
}

/// One step in which the blood of verify_duct, an undisturbed lattice, moves with `speed` and has no pressure but that
/// beyond the outlet.
struct OutletStep {
    std::string name;
    PressureModel model = PressureModel::dfsph;
    std::int64_t frame = 1;
    double p_const = 0; ///< [Pa]
    double speed = 0;   ///< [m/s]
};

Scenario scenario_of(const OutletStep& step)
{
    Scenario s = shipped_scenario("verify_duct");
    s.particles.jitter_spacings = 0;
    s.pressure.model = step.model;
    s.pressure.stiffness_m2_s2 = 0;
    s.pressure.density_correction = 0;
    s.pressure.tolerance_per_s = 1e11; // stops before the first iteration
    s.pressure.max_tolerance_per_s = 1e11;
    s.outlet.pressure_pa = step.p_const;
    return s;
}

/// The level of the pressure in this step: p_const at most, and in the model `eos`; else the margin times what a straight
/// tube as long and as wide pulls [Pa].
double level(const OutletStep& step, const Scenario& s)
{
    if (step.model == PressureModel::eos) {
        return step.p_const;
    }
    const double L = static_cast<double>(s.domain.cells_y) * s.domain.spacing_m;
    const double a = static_cast<double>(s.domain.cells_x) * s.domain.spacing_m / 2;
    const double t = static_cast<double>(step.frame) * s.time.frame_s;
    return std::min(step.p_const, s.outlet.level_margin * pull(s, {{L, a}}, t));
}

/// Eq. (5) of blood in a layer at the distance z from the plane behind which there is none [kg/m^3].
double density_before_nothing(const Scenario& s, double m, double z)
{
    const double dx = s.domain.spacing_m;
    const double h = s.kernel.smoothing_length_spacings * dx;
    const int reach = static_cast<int>(std::ceil(2 * h / dx));
    double sum = 0;
    for (int k = -reach; k <= reach; ++k) {
        for (int n = 0; z + k * dx > 0 && n < (2 * reach + 1) * (2 * reach + 1); ++n) {
            const double i = n % (2 * reach + 1) - reach;
            const double j = n / (2 * reach + 1) - reach;
            sum += analytic::kernel(s.kernel.function, h, dx * std::sqrt(i * i + j * j + k * k));
        }
    }
    return m * sum;
}

/// The pressure beyond the outlet stands in for the neighbors that are missing at the far end of its buffer, with twice
/// the half space's force, as (3) has it; what comes back is held by rho_0 v^2 / 2 over the buffer.
void outlet_step(Probe& probe, Quantity& velocity, const OutletStep& step)
{
    const Scenario s = scenario_of(step);
    const double dx = s.domain.spacing_m;
    const double dt = s.time.frame_s;
    const double rho_0 = s.fluid.density_kg_m3;
    SimulationState state = probe.simulate(s)->state();
    state.frame = step.frame - 1;
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        state.particles.velocity[i] = {0, step.speed, 0};
        state.particles.pressure[i] = 0;
    }
    const SimulationState before = state;
    const auto flow = probe.simulate(s, std::move(state));
    flow->advance();
    const double D = 3 * dx; // depth of the buffer
    const double far_end = static_cast<double>(s.domain.cells_y) * dx + D;
    const double p = level(step, s);
    const double L = far_end - D;
    const double p_error = s.outlet.level_margin * rho_0 * L * rounding(16) * s.inlet.peak_velocity_m_s / dt;
    const double holding = step.speed < 0 ? rho_0 * step.speed * step.speed / (2 * D) : 0;
    for (std::size_t i = 0; i < before.particles.size(); ++i) {
        const double z = far_end - before.particles.position[i].y;
        const bool in_buffer = before.particles.kind[i] == Kind::outlet_1;
        if (!in_buffer && !(before.particles.kind[i] == Kind::fluid && z < D + 2 * dx)) {
            continue;
        }
        const double h = s.kernel.smoothing_length_spacings * dx;
        const auto F = analytic::outlet_force(s.kernel.function, h, dx, p, z);
        const double rho = density_before_nothing(s, before.particles.mass, z);
        const double volume = before.particles.mass / (rho_0 * dx * dx * dx); // the oracle's fill their cells
        const double gain = in_buffer ? dt * volume / rho : 0;
        const double held = in_buffer ? dt * holding / rho : 0;
        velocity.within(flow->state().particles.velocity[i].y, step.speed - gain * F.value + held,
                        gain * (F.error * (1 + probe.roundoff() / 0x1p-53) + p_error / p * F.value) +
                            probe.gamma(120) * (std::abs(step.speed) + gain * F.value + held),
                        step.name + ", " + std::to_string(z / dx).substr(0, 3) + " dx from the far end");
    }
}

void outlet(Probe& probe)
{
    Quantity& velocity = probe.quantity(
        "velocity of the rows before the outlet's far end after one step [m/s]", Source::rounding,
        "dt/rho times the bound of the lattice sum for oracle and subject and what the level's difference of "
        "velocities loses, and gamma_120 of |v| + dt F/rho, which the density (5) is part of (docs/bounds.md, B1)");
    constexpr double high = 1e6; // more than any flow needs
    for (const OutletStep& step : {OutletStep{"blood leaves, p_const", PressureModel::dfsph, 300, 1000, 0.5},
                                   {"blood leaves, slowing", PressureModel::dfsph, 300, high, 0.5},
                                   {"blood comes back, slowing", PressureModel::dfsph, 450, high, -0.5},
                                   {"blood comes back, speeding up", PressureModel::dfsph, 700, high, -0.5},
                                   {"blood at rest, eos", PressureModel::eos, 300, 4000, 0}}) {
        outlet_step(probe, velocity, step);
    }
}

} // namespace

std::vector<Check> boundary_duct_checks()
{
    return {
        flow_check(
            "eq26_outlet", {"26"},
            "an outlet presses on the far end of its buffer with the level of the pressure, and holds what "
            "comes back",
            {"lattice sum over a half space", "straight tube's inertia and friction"}, outlet),
        flow_check("eq25_duct", {"25", "26", "3"},
                   "a column of blood that moves with the inlet is neither stored nor lost",
                   {"conservation of volume"}, duct)};
}

} // namespace aneurysm::checks
