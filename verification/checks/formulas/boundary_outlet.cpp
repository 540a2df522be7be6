// SPDX-License-Identifier: Apache-2.0
// Section 3.5: the pressure beyond the outlets (26), and the wall's velocity (27).
#include "analytic/boundary.hpp"
#include "analytic/kernel_function.hpp"
#include "analytic/laminar_flow.hpp"
#include "analytic/relations.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/formulas/kernel_rounding.hpp"

#include <cmath>
#include <vector>

namespace aneurysm::checks
{
namespace
{

using analytic::Estimate;

/// Neighbors of a particle, as (26) sums them up.
struct Neighborhood {
    std::vector<double> mass;
    std::vector<Vec3> grad_W;

    std::vector<double> slopes(double Vec3::*axis) const
    {
        std::vector<double> along;
        for (const Vec3& g : grad_W) {
            along.push_back(g.*axis);
        }
        return along;
    }
};

void eq26_relation(Quantity& relation, const backends::Equations& equations)
{
    Arguments a(26);
    for (int n = 0; n < 200; ++n) {
        const double rho_0 = a.between(900, 1100);
        const double p = a.between(1e3, 6e5);
        const int count = n % 9;
        Neighborhood around;
        for (int j = 0; j < count; ++j) {
            around.mass.push_back(a.between(0.01, 2));
            around.grad_W.push_back(a.vector(3e4));
        }
        const Vec3 F = equations.outlet_pressure_force(around.mass, around.grad_W, rho_0, p);
        for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            relation.within(
                analytic::outlet_force_imbalance(around.mass, rho_0, p, around.slopes(axis), F.*axis), 0,
                2 * rounding(count + 3), at({{"neighbors", double(count)}, {"rho_0", rho_0}, {"p", p}}));
        }
    }
}

void eq26_force(Probe& probe)
{
    Quantity& relation = probe.quantity(
        "F rho_0 = 2 p sum_j m_j grad W_ij, 50 digits [1]", Source::rounding,
        "twice gamma_(n + 3), over half the terms' magnitudes: n additions, two products and a quotient");
    Quantity& half_space = probe.quantity(
        "force into a half space of blood at its end [N/m^3]", Source::rounding,
        "the lattice sum's own bound; gamma_(n + 3) of the sum of |terms| over n neighbors, and "
        "the rounding of each grad W");
    eq26_relation(relation, probe.equations());
    const double h = 0.02;
    const double dx = 0.02;
    const double p = 5e5;
    const double rho_0 = 1050;
    const double m = rho_0 * dx * dx * dx;
    for (const KernelName name : both_kernels) {
        for (const double z : {0.5 * dx, 0.31 * dx, 1.2 * dx}) {
            Neighborhood around;
            double rounded = 0;
            for (int layer = 0; layer < 5; ++layer) {
                for (int j = -4; j <= 4; ++j) {
                    for (int i = -4; i <= 4; ++i) {
                        const Vec3 x{-i * dx, -j * dx, (layer + 0.5) * dx - z}; // z: out of the half space
                        around.mass.push_back(m);
                        around.grad_W.push_back(probe.equations().kernel_gradient(name, h, x));
                        rounded += 2 * p * m / rho_0 *
                                   (gradient_rounding(name, h, length(x), 3) +
                                    rounding(405 + 3) * std::abs(around.grad_W.back().z));
                    }
                }
            }
            const Vec3 F = probe.equations().outlet_pressure_force(around.mass, around.grad_W, rho_0, p);
            const Estimate expected = analytic::outlet_force(name, h, dx, p, z);
            half_space.within(-F.z, expected.value, rounded + expected.error,
                              kernel_text(name) + at({{"z/dx", z / dx}}));
        }
    }
}

void eq26_pressure(Probe& probe)
{
    Quantity& outflow = probe.quantity("force on a buffer that moves outwards or rests [N/m^3]",
                                       Source::exact, "0: only blood that comes back is slowed down");
    Quantity& relation = probe.quantity("F D = rho_0 v^2/2 of inflow, 50 digits [1]", Source::rounding,
                                        "gamma_5: three products and a quotient, a product along the normal");
    Quantity& streamline =
        probe.quantity("F D against int rho_0 u du along the streamline [Pa]", Source::quadrature,
                       "28 u on the Gauss rule's terms; gamma_6 rho_0 v^2/2");
    Arguments a(261);
    for (int n = 0; n < 200; ++n) {
        const double rho_0 = a.between(900, 1100);
        const double v = a.between(1e-3, 13);
        const double D = a.between(0.01, 0.3);
        const Vec3 normal = a.vector(1);
        const Vec3 outward = normal / length(normal);
        const std::string where = at({{"rho_0", rho_0}, {"v", v}, {"D", D}});
        outflow.within(probe.equations().inflow_force(rho_0, v, D, outward), {}, 0, where);
        outflow.within(probe.equations().inflow_force(rho_0, 0, D, outward), {}, 0, where + ": at rest");
        const double along = probe.equations().inflow_force(rho_0, -v, D, {0, 1, 0}).y;
        const Vec3 F = probe.equations().inflow_force(rho_0, -v, D, outward);
        for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            relation.within(analytic::inflow_imbalance(rho_0, v, D, F.*axis / (outward.*axis)), 0,
                            rounding(6), where);
        }
        const Estimate fall = analytic::integrate_polynomial([&](double u) { return rho_0 * u; }, 0, v);
        streamline.within(along * D, fall.value, fall.error + rounding(6) * fall.value, where);
    }
}

void eq26_oracles(Probe& probe)
{
    Quantity& whole =
        probe.quantity("int F dz of a continuum of blood over p [1]", Source::quadrature,
                       "28 u each of two nested Gauss rules on positive terms, whose two pieces add up");
    for (const KernelName name : both_kernels) {
        const double h = 0.02;
        const double p = 5e5;
        const auto force = [&](double z) { return analytic::outlet_force_continuum(name, h, p, z).value; };
        const double total = analytic::integrate_polynomial(force, 0, h).value +
                             analytic::integrate_polynomial(force, h, 2 * h).value;
        whole.within(total / p, 1, rounding(56 * 2), kernel_text(name));
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
        formula_check(
            "eq26_force", {"26"},
            "p beyond the end of a half space of blood pushes into it, along the kernel's gradients",
            {"lattice sum over a half space", "the relation, 50 digits"}, eq26_force),
        formula_check(
            "eq26_pressure", {"26"},
            "blood that comes back through a buffer has lost there what it takes to speed it up from rest",
            {"Gauss rule along the streamline", "Bernoulli's sum, 50 digits"}, eq26_pressure),
        oracle_check("eq26_oracles", Level::scalar, {"26"},
                     "the end of a continuum of blood carries all of p", {"nested Gauss rules", "1"},
                     eq26_oracles),
        formula_check(
            "eq27_no_slip", {"27"}, "the wall is at rest",
            {"Poiseuille's parabola at the walls", "GSL's erf of Stokes' first problem at the wall"},
            eq27_no_slip),
    };
}

} // namespace aneurysm::checks
