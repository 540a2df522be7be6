// SPDX-License-Identifier: Apache-2.0
// What particles do to one another, by pressure (3) and friction (7), gives nothing to all of them: momentum and
// angular momentum of a drop that hangs in the middle of the periodic box, touching nothing.
#include "analytic/kernel_function.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks
{
namespace
{

constexpr int inside = 4; ///< particles along the drop's edge
constexpr double neighbors = inside * inside * inside;

/// Blood in the middle of the box, disturbed and moving together at `speed`; the rest waits in the reserve.
Box drop(const Probe& probe, const Scenario& s, double speed)
{
    Box box(probe, s);
    box.disturb(0.15, 0.05, 2441);
    box.keep_drop(inside);
    Particles& p = box.state().particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::fluid) {
            p.velocity[i] -= speed / (inside * s.domain.spacing_m) * (p.position[i] - box.middle());
        }
        p.pressure[i] = 0;
    }
    return box;
}

/// Sums of the particles' changes of velocity, and of these across their places before the step.
struct Change {
    Vec3 momentum;  ///< over the mass [m/s]
    Vec3 angular;   ///< about the middle, over the mass [m^2/s]
    Vec3 corrected; ///< of the ways that the density's correction adds [m]
    double speeds = 0;
    double reach = 0; ///< of the drop [m]
};
Change change(const Box& box, const SimulationState& after)
{
    Change sum;
    for (std::size_t i = 0; i < box.size(); ++i) {
        if (box.state().particles.kind[i] != Kind::fluid) {
            continue;
        }
        const Vec3& v_0 = box.state().particles.velocity[i];
        const Vec3& v = after.particles.velocity[i];
        const Vec3 x = box.state().particles.position[i] - box.middle();
        const Vec3 dv = v - v_0;
        sum.momentum += dv;
        sum.angular += Vec3{x.y * dv.z - x.z * dv.y, x.z * dv.x - x.x * dv.z, x.x * dv.y - x.y * dv.x};
        sum.corrected +=
            after.particles.position[i] - box.state().particles.position[i] - box.scenario().time.frame_s * v;
        sum.speeds += length(v) + length(v_0);
        sum.reach = std::max(sum.reach, length(x));
    }
    return sum;
}

void pressure(Probe& probe)
{
    Scenario s = box_scenario();
    s.fluid.viscosity_pa_s = 0;
    s.pressure.tolerance_per_s = 1e-3;
    s.pressure.density_correction = 0.5;
    Quantity& momentum = probe.quantity("sum of the velocities' changes by the solve [m/s]", Source::rounding,
                                        "the pairs cancel exactly, only the additions round: gamma_2n of the "
                                        "sum of |terms|, n = 64 particles, and gamma_2 of the velocities "
                                        "(docs/bounds.md, B3)");
    Quantity& angular =
        probe.quantity("sum of places x changes [m^2/s]", Source::rounding,
                       "the same times the drop's reach: the forces of (3) point along the pairs");
    Quantity& middle =
        probe.quantity("sum of the ways that the density's correction adds [m]", Source::rounding,
                       "as for the velocities, with kappa and dt^2; gamma_5 L for each place in the box");
    Quantity& works = probe.quantity("iterations of each solve", Source::exact,
                                     "a claim: at least one, else there would be nothing to cancel");
    const Box box = drop(probe, s, 1);
    const auto flow = probe.simulate(s, box.state());
    const FrameRecord record = flow->advance();
    works.holds(record.iterations > 0, "pressure");
    works.holds(record.corrections > 0, "correction");
    const Change sum = change(box, flow->state());
    const double h = box.medium().lattice.h;
    const double steepest = -analytic::kernel_slope(box.medium().lattice.kernel, h, 2 * h / 3);
    const double rho_0 = s.fluid.density_kg_m3;
    const double dt = s.time.frame_s;
    const auto rounded = [&](const std::vector<double>& potentials) {
        double terms = 0;
        for (const double p : potentials) {
            terms += dt * 2 * std::abs(p) * box.medium().mass * neighbors * steepest / (rho_0 * rho_0);
        }
        return probe.gamma(2 * neighbors) * terms;
    };
    const double allowed = rounded(flow->solved_pressure()) + probe.gamma(2) * sum.speeds;
    momentum.within(sum.momentum, {}, allowed);
    angular.within(sum.angular, {}, 2 * sum.reach * allowed);
    middle.within(sum.corrected, {},
                  dt * rounded(flow->solved_kappa()) + probe.gamma(5) * neighbors * box.edge());
}

void viscosity(Probe& probe)
{
    Scenario s = box_scenario();
    s.fluid.viscosity_pa_s = 16;
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 0;
    Quantity& momentum = probe.quantity(
        "sum of the velocities' changes by friction [m/s]", Source::rounding,
        "the pairs cancel exactly, only the additions round: gamma_2n of the sum of |terms|, n = 64 "
        "particles, and gamma_2 of the velocities (docs/bounds.md, B3)");
    const Box box = drop(probe, s, 0.5);
    const auto flow = probe.simulate(s, box.state());
    flow->advance();
    const Change sum = change(box, flow->state());
    const double largest = analytic::viscosity_kernel_laplacian(2 * box.medium().lattice.h, 0);
    const double rho = *std::ranges::min_element(flow->density());
    const double terms = s.time.frame_s * s.fluid.viscosity_pa_s * box.medium().mass / (rho * rho) * largest *
                         neighbors * 2 * sum.speeds;
    momentum.within(sum.momentum, {}, probe.gamma(2 * neighbors) * terms + probe.gamma(2) * sum.speeds);
    probe.note("angular momentum that friction takes, over the mass [m^2/s]", length(sum.angular),
               "(7) acts along v_j - v_i, not along the pair: it does not conserve it");
}

} // namespace

std::vector<Check> blood_flow_momentum_checks()
{
    return {
        sum_check(
            "eq03_momentum", {"3"},
            "the pressure gives a drop neither momentum nor angular momentum, the correction moves it nowhere",
            {"Newton's third law", "central forces"}, pressure),
        sum_check("eq07_momentum", {"7", "15"}, "friction gives a drop no momentum", {"Newton's third law"},
                  viscosity),
    };
}

} // namespace aneurysm::checks
