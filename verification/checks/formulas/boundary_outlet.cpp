// SPDX-License-Identifier: Apache-2.0
// Section 3.5: the pressure of the outlets (26), and the wall's velocity (27).
#include "analytic/boundary.hpp"
#include "analytic/kernel_function.hpp"
#include "analytic/laminar_flow.hpp"
#include "analytic/relations.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/formulas/kernel_rounding.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks
{
namespace
{

using analytic::Estimate;

void eq26_force(Probe& probe)
{
    Quantity& relation = probe.quantity("F rho_0 = -m p_const grad W, 50 digits [1]", Source::rounding,
                                        "gamma_3: two products and a quotient");
    Quantity& half_space =
        probe.quantity("force of a half space of ghosts [N/m^3]", Source::rounding,
                       "the lattice sum's own bound; gamma_3 and gamma_243 for as many additions on the "
                       "terms, which are positive across, and the rounding of grad W");
    Arguments a(26);
    for (int n = 0; n < 200; ++n) {
        const double m = a.between(0.01, 2);
        const double rho_0 = a.between(900, 1100);
        const double p = a.between(1e3, 6e5);
        const Vec3 grad_W = a.vector(3e4);
        const Vec3 F = probe.equations().outlet_pressure_force(m, rho_0, p, grad_W);
        const std::string where = at({{"m", m}, {"rho_0", rho_0}, {"p_const", p}});
        for (const auto& [force, slope] :
             {std::pair{F.x, grad_W.x}, std::pair{F.y, grad_W.y}, std::pair{F.z, grad_W.z}}) {
            relation.within(analytic::outlet_force_imbalance(m, rho_0, p, slope, force), 0, rounding(3),
                            where);
        }
    }
    const double h = 0.02;
    const double dx = 0.02;
    const double p = 5e5;
    const double rho_0 = 1050;
    for (const KernelName name : both_kernels) {
        for (const double z : {0.5 * dx, 0.31 * dx}) {
            Vec3 force;
            double rounded = 0;
            for (int k = 0; k < 3; ++k) {
                for (int j = -4; j <= 4; ++j) {
                    for (int i = -4; i <= 4; ++i) {
                        const Vec3 x{-i * dx, -j * dx, z + (k + 0.5) * dx};
                        const double m = rho_0 * dx * dx * dx;
                        const Vec3 grad_W = probe.equations().kernel_gradient(name, h, x);
                        force += probe.equations().outlet_pressure_force(m, rho_0, p, grad_W);
                        rounded += p * dx * dx * dx * gradient_rounding(name, h, length(x), 2);
                    }
                }
            }
            const Estimate expected = analytic::outlet_force(name, h, dx, p, z);
            const double allowed = rounding(3 + 4 + 243) * expected.value + rounded + expected.error;
            const std::string where = kernel_text(name) + at({{"z/dx", z / dx}});
            half_space.within(force.z, expected.value, allowed, where);
        }
    }
}

void eq26_pressure(Probe& probe)
{
    Quantity& outflow = probe.quantity("pressure while blood leaves or rests over p_const [1]", Source::exact,
                                       "0: nothing is computed");
    Quantity& relation =
        probe.quantity("p + rho_0 v^2/2 = p_const of inflow, 50 digits [1]", Source::rounding,
                       "gamma_3 of p_const, or of p and the dynamic pressure where p < 0: two products, a "
                       "difference; the factor 1/2 is exact");
    Quantity& streamline =
        probe.quantity("p against -int rho_0 u du along the streamline [Pa]", Source::quadrature,
                       "28 u on the Gauss rule's terms; gamma_3 (p_const + rho_0 v^2/2)");
    Quantity& oracles = probe.quantity("p along the streamline in the relation [1]", Source::quadrature,
                                       "28 u on the Gauss rule's terms, 1 of the difference");
    Arguments a(261);
    for (int n = 0; n < 200; ++n) {
        const double p_const = a.between(1e3, 1e5);
        const double rho_0 = a.between(900, 1100);
        const double v = a.between(1e-3, 13);
        const std::string where = at({{"p_const", p_const}, {"rho_0", rho_0}, {"v", v}});
        outflow.within(probe.equations().outlet_pressure(p_const, rho_0, v) / p_const, 1, 0, where);
        outflow.within(probe.equations().outlet_pressure(p_const, rho_0, 0) / p_const, 1, 0,
                       where + ": at rest");
        const double p = probe.equations().outlet_pressure(p_const, rho_0, -v);
        relation.within(analytic::outlet_pressure_imbalance(p_const, rho_0, -v, p), 0, rounding(3), where);
        const Estimate fall = analytic::integrate_polynomial([&](double u) { return rho_0 * u; }, 0, v);
        const double expected = p_const - fall.value;
        streamline.within(p, expected, fall.error + rounding(3) * (p_const + fall.value), where);
        oracles.within(analytic::outlet_pressure_imbalance(p_const, rho_0, -v, expected), 0,
                       (fall.error + rounding(1) * std::abs(expected)) / std::max(p_const, fall.value),
                       where);
    }
}

void eq26_oracles(Probe& probe)
{
    Quantity& half =
        probe.quantity("int F dz of a continuum of ghosts over p_const/2 [1]", Source::quadrature,
                       "28 u each of two nested Gauss rules on positive terms, whose two pieces add up");
    for (const KernelName name : both_kernels) {
        const double h = 0.02;
        const double p = 5e5;
        const auto force = [&](double z) { return analytic::outlet_force_continuum(name, h, p, z).value; };
        const double total = analytic::integrate_polynomial(force, 0, h).value +
                             analytic::integrate_polynomial(force, h, 2 * h).value;
        half.within(total / (p / 2), 1, rounding(56 * 2), kernel_text(name));
    }
}

void eq27_no_slip(Probe& probe)
{
    Quantity& rest = probe.quantity("v_wall against viscous flows at their walls [m/s]", Source::exact,
                                    "0: a difference of equal numbers, a^2 - r^2 at r = a, and erf(0)");
    const Vec3 v = probe.equations().wall_velocity();
    const double a = 0.3;
    for (const auto section : {analytic::Section::channel, analytic::Section::pipe}) {
        const Estimate u = analytic::developed_velocity({section, a, 3.3e-6}, {1.7, 0}, a, 0);
        rest.within(v, {u.value, 0, 0}, 0,
                    section == analytic::Section::pipe ? "Poiseuille, pipe" : "Poiseuille, channel");
    }
    for (const double t : {0.02, 7.0}) {
        rest.within(v, {analytic::started_flow(0.3, 3.3e-6, t, 0), 0, 0}, 0,
                    "Stokes' first problem, " + at({{"t", t}}));
    }
}

} // namespace

std::vector<Check> boundary_outlet_checks()
{
    return {
        formula_check("eq26_force", {"26"},
                      "the outlet's ghosts push with p_const along the kernel's gradient",
                      {"lattice sum over a half space", "the relation, 50 digits"}, eq26_force),
        formula_check(
            "eq26_pressure", {"26"},
            "the outlet has p_const while blood leaves, and p_const is what it stagnates at while it "
            "comes back",
            {"Gauss rule along the streamline", "Bernoulli's sum, 50 digits"}, eq26_pressure),
        oracle_check("eq26_oracles", Level::scalar, {"26"}, "a continuum of ghosts carries half of p_const",
                     {"nested Gauss rules", "exact half"}, eq26_oracles),
        formula_check(
            "eq27_no_slip", {"27"}, "the wall's ghosts are at rest",
            {"Poiseuille's parabola at the walls", "GSL's erf of Stokes' first problem at the wall"},
            eq27_no_slip),
    };
}

} // namespace aneurysm::checks
