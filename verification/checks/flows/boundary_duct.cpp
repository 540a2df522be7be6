// SPDX-License-Identifier: Apache-2.0
// A column of blood between an inlet and an outlet, without walls: it must move with the inlet, (25), against
// the pressure of the outlet, (26).
#include "analytic/boundary.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace aneurysm::checks
{
namespace
{

/// The oracle's bound of any text's rounding in double, and the subject's.
constexpr double both_errors(double oracle_error, double u)
{
    return oracle_error * (1 + u / 0x1p-53);
}

/// int_0^t v dt of (25) as the inlet's ghosts move: the steps' sum
/// of v_0 sin(2 pi k dt/T) dt, in closed form [m].
double inlet_way(const Scenario& s, std::int64_t n)
{
    const double half = std::numbers::pi * s.time.frame_s / s.inlet.cycle_s;
    const auto steps = static_cast<double>(n);
    return s.time.frame_s * s.inlet.peak_velocity_m_s * std::sin(steps * half) *
           std::sin((steps + 1) * half) / std::sin(half);
}

void duct(Probe& probe)
{
    const Scenario s = shipped_scenario("verify_duct");
    const double dx = s.domain.spacing_m;
    const auto layer = s.domain.cells_x * s.domain.cells_z;
    const double L = static_cast<double>(s.domain.cells_y) * dx;
    Quantity& in = probe.quantity("particles in at the inlet", Source::exact,
                                  "integers: a layer of ghosts passes the inlet when the inlet's way has "
                                  "reached it; frames in which rounding decides that are left out "
                                  "(docs/bounds.md, B12)");
    Quantity& stored = probe.quantity(
        "particles stored in the duct, in - out", Source::truncation,
        "(3) keeps the volume as far as the density: the frame's largest density error times the particles, "
        "and one layer (docs/bounds.md, B12)");
    Quantity& passed = probe.quantity(
        "particles that have passed the middle of the duct, against the inlet's way", Source::truncation,
        "the frame's largest density error times half of the particles, half a layer at the inlet, and one "
        "in the middle (docs/bounds.md, B12)");
    Plot plot{"Blood between an inlet and an outlet", "frame", "velocity [m/s]", false, false, {}};
    Series inlet{"inlet, (25)", {}, {}, true};
    Series blood{"blood in the middle", {}, {}, false};
    const auto flow = probe.simulate(s);
    const auto first = std::ranges::count(flow->state().particles.kind, Kind::fluid);
    const auto upstream = [&] {
        const Particles& p = flow->state().particles;
        std::int64_t n = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            n += p.kind[i] == Kind::fluid && p.position[i].y < L / 2 ? 1 : 0;
        }
        return n;
    };
    const std::int64_t first_upstream = upstream();
    double largest_gap = 0;
    for (std::int64_t n = 1; n <= 380; ++n) { // the inflow; as it turns, the outlet's layers meet at random
        const FrameRecord r = flow->advance();
        const double layers = inlet_way(s, n) / dx + 0.5;
        const std::string where = "frame " + std::to_string(n);
        if (std::abs(layers - std::round(layers)) > 4 * static_cast<double>(n) * probe.roundoff() * L / dx) {
            in.equal(r.ledger.inlet_in, layer * static_cast<std::int64_t>(std::floor(layers)), where);
        }
        const double density = std::max(r.density_error_max, r.density_error_max_ends);
        stored.within(static_cast<double>(r.fluid), static_cast<double>(first),
                      static_cast<double>(first) * density + static_cast<double>(layer), where);
        const auto way = static_cast<double>(layer) * inlet_way(s, n) / dx;
        passed.within(static_cast<double>(r.ledger.inlet_in - (upstream() - first_upstream)), way,
                      static_cast<double>(first_upstream) * density + 1.5 * static_cast<double>(layer),
                      where);
        double v = 0;
        double count = 0;
        const Particles& p = flow->state().particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (p.kind[i] == Kind::fluid && p.position[i].y > L / 4 && p.position[i].y < 3 * L / 4) {
                v += p.velocity[i].y;
                ++count;
            }
        }
        const double mean = v / count;
        largest_gap = std::max(largest_gap, std::abs(mean - r.inlet_velocity));
        inlet.x.push_back(static_cast<double>(n));
        inlet.y.push_back(r.inlet_velocity);
        blood.x.push_back(static_cast<double>(n));
        blood.y.push_back(mean);
    }
    plot.series = {inlet, blood};
    probe.plot(std::move(plot));
    probe.note("largest gap between blood and inlet [m/s]", largest_gap,
               "of 1 m/s at the crest; a layer of ghosts enters at once");
}

/// The undisturbed lattice of verify_duct, in a step that has no pressure but the outlet's.
Scenario unpressed_duct(PressureModel model)
{
    Scenario s = shipped_scenario("verify_duct");
    s.particles.jitter_spacings = 0;
    s.pressure.model = model;
    s.pressure.stiffness_m2_s2 = 0;
    s.pressure.density_correction = 0;
    s.pressure.tolerance_per_s = 1e11; // stops before the first iteration
    s.pressure.max_tolerance_per_s = 1e11;
    s.fluid.viscosity_pa_s = 0;
    return s;
}

/// What the outlet's ghosts do to the blood before them, and to themselves, when all moves with v_0.
void outlet_step(Probe& probe, Quantity& velocity, Quantity& plug, PressureModel model, double v_0)
{
    const Scenario s = unpressed_duct(model);
    const double dx = s.domain.spacing_m;
    const double dt = s.time.frame_s;
    const double rho_0 = s.fluid.density_kg_m3;
    SimulationState state = probe.simulate(s)->state();
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        state.particles.velocity[i] = {0, v_0, 0};
        state.particles.pressure[i] = 0;
    }
    state.outlet_velocity = {v_0, 0};
    const SimulationState before = state;
    const auto flow = probe.simulate(s, std::move(state));
    const FrameRecord r = flow->advance();
    const double change = dt * s.outlet.pressure_pa / (rho_0 * 3 * dx); // a slab is three layers deep
    const double v_out = v_0 - change;
    const std::string name = model == PressureModel::eos ? "eos, " : "dfsph, ";
    plug.within(2 * r.outlet_velocity, v_out, probe.gamma(80) * (v_0 + change), name);
    // blood that comes back was at rest under p_const; (6) has half of a pressure's gradient
    const double p = s.outlet.pressure_pa - (v_out < 0 ? rho_0 * v_out * v_out / 2 : 0);
    const double part = model == PressureModel::eos ? 0.5 : 1;
    const double L = static_cast<double>(s.domain.cells_y) * dx;
    for (std::size_t i = 0; i < before.particles.size(); ++i) {
        const double z = L - before.particles.position[i].y;
        if (before.particles.kind[i] != Kind::fluid || z > 3 * dx) {
            continue;
        }
        const auto F =
            analytic::outlet_force(s.kernel.function, s.kernel.smoothing_length_spacings * dx, dx, p, z);
        const double scale =
            before.particles.mass / (rho_0 * dx * dx * dx); // the oracle's ghosts fill their cells
        const double gain = part * dt * scale / rho_0;
        velocity.within(flow->state().particles.velocity[i].y, v_0 - gain * F.value,
                        gain * both_errors(F.error, probe.roundoff()) +
                            probe.gamma(60) * (v_0 + gain * F.value),
                        name + "depth " + std::to_string(z / dx).substr(0, 3) + " dx");
    }
}

void outlet(Probe& probe)
{
    Quantity& velocity =
        probe.quantity("velocity of the rows at the outlet after one step [m/s]", Source::rounding,
                       "dt/rho times (n + 40 + 16) u of the lattice sum of |terms|, for oracle and subject, "
                       "and gamma_60 of v + dt F/rho (docs/bounds.md, B1)");
    Quantity& plug =
        probe.quantity("velocity of the outlet's slab [m/s]", Source::rounding,
                       "gamma_80 of v + dt p/(rho_0 D): the mean over 72 particles, then eight operations");
    for (const PressureModel model : {PressureModel::dfsph, PressureModel::eos}) {
        outlet_step(probe, velocity, plug, model, 0.5); // blood leaves
        outlet_step(probe, velocity, plug, model, 0);   // blood is pressed back in
    }
}

} // namespace

std::vector<Check> boundary_duct_checks()
{
    return {flow_check("eq26_outlet", {"26"},
                       "an outlet presses on the blood before it with p_const, and is pressed back by it",
                       {"lattice sum over a half space of ghosts", "Newton's law for the slab"}, outlet),
            flow_check("eq25_duct", {"25", "26", "3"},
                       "a column of blood moves with the inlet against the outlet's pressure, and is neither "
                       "stored nor lost",
                       {"particle balance from the integral of (25)", "conservation of volume"}, duct)};
}

} // namespace aneurysm::checks
