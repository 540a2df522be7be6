// SPDX-License-Identifier: Apache-2.0
// Section 3.1 at one particle or point: (1), (4), the equation of state and (15).
#include "analytic/blood_flow.hpp"
#include "analytic/beltrami_flow.hpp"
#include "analytic/exact/kernel.hpp"
#include "analytic/lattice/pair_sums.hpp"
#include "analytic/relations.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/formulas/kernel_rounding.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace aneurysm::checks
{
namespace
{

/// Flows whose viscosity, pressure, gravity and inertia are of about
/// the same size, each at a point of its own.
template <class Look>
void for_all_flows(Look look)
{
    Arguments a(1);
    for (int n = 0; n < 10; ++n) {
        const double k = a.between(1, 3);
        const analytic::BeltramiFlow flow{
            a.between(900, 1100), a.between(500, 1500), to_eigen(a.vector(9)), k,
            a.between(0.5, 3),    a.between(0.5, 3),    a.between(0.5, 3)};
        const Eigen::Vector3d r = to_eigen(a.vector(2 / k));
        look(flow, analytic::momentum_terms(flow, r, a.between(0, 0.1)), at({{"flow", double(n)}}));
    }
}

Vec3 magnitude(const Vec3& v)
{
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

/// Component by component, each with its own bound.
void compare(Quantity& quantity, const Vec3& found, const Vec3& expected, const Vec3& allowed,
             const std::string& where)
{
    quantity.within(found.x, expected.x, allowed.x, where + ", x");
    quantity.within(found.y, expected.y, allowed.y, where + ", y");
    quantity.within(found.z, expected.z, allowed.z, where + ", z");
}

void eq01_momentum(Probe& probe)
{
    Quantity& flow_force =
        probe.quantity("force in a Beltrami flow against rho Dv/Dt [N/m^3]", Source::rounding,
                       "gamma_4 of the terms' magnitudes + u |F|: a product, two sums, one rounding of each "
                       "of the oracle's terms");
    for_all_flows([&](const analytic::BeltramiFlow& flow, const analytic::MomentumTerms& terms,
                      const std::string& where) {
        const Vec3 g = to_vec3(flow.g);
        const Vec3 viscosity = to_vec3(terms.viscosity);
        const Vec3 pressure = to_vec3(terms.pressure);
        const Vec3 expected = to_vec3(terms.force);
        const Vec3 sizes = flow.rho * magnitude(g) + magnitude(viscosity) + magnitude(pressure);
        compare(flow_force, probe.equations().momentum_force(flow.rho, g, viscosity, pressure), expected,
                rounding(4) * sizes + rounding(1) * magnitude(expected), where);
    });
    Quantity& whole = probe.quantity("force of whole numbers [N/m^3]", Source::exact,
                                     "0: whole numbers below 2^53 are added and multiplied without rounding");
    Arguments a(2);
    for (int n = 0; n < 200; ++n) {
        const std::int64_t rho = a.whole(1 << 20);
        std::array<std::array<std::int64_t, 3>, 3> x{}; // g, viscosity, pressure
        for (std::size_t axis = 0; axis < 3; ++axis) {
            x[0][axis] = a.whole(1 << 20);
            x[1][axis] = a.whole(std::int64_t{1} << 45);
            x[2][axis] = a.whole(std::int64_t{1} << 45);
        }
        const auto vector = [&](std::size_t k) {
            return Vec3{double(x[k][0]), double(x[k][1]), double(x[k][2])};
        };
        const Vec3 F = probe.equations().momentum_force(double(rho), vector(0), vector(1), vector(2));
        const std::array found{F.x, F.y, F.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::int64_t expected = rho * x[0][axis] + x[1][axis] + x[2][axis];
            whole.within(found[axis], double(expected), 0, at({{"set", double(n)}, {"axis", double(axis)}}));
        }
    }
}

void eq15_acceleration(Probe& probe)
{
    Quantity& along =
        probe.quantity("acceleration in a Beltrami flow against Dv/Dt [m/s^2]", Source::rounding,
                       "gamma_3 |a|: a quotient, one rounding of the oracle's force and of its Dv/Dt");
    for_all_flows([&](const analytic::BeltramiFlow& flow, const analytic::MomentumTerms& terms,
                      const std::string& where) {
        const Vec3 expected = to_vec3(terms.acceleration);
        compare(along, probe.equations().acceleration(flow.rho, to_vec3(terms.force)), expected,
                rounding(3) * magnitude(expected), where);
    });
    Quantity& newton =
        probe.quantity("rho a = F, 50 digits [1]", Source::rounding, "gamma_1: a quotient, rounded once");
    Arguments a(15);
    for (int n = 0; n < 200; ++n) {
        const double rho = a.between(300, 3000);
        const Vec3 F = a.vector(1e5);
        const Vec3 found = probe.equations().acceleration(rho, F);
        const std::string where = at({{"rho", rho}, {"set", double(n)}});
        newton.within(analytic::acceleration_imbalance(rho, F.x, found.x), 0, rounding(1), where);
        newton.within(analytic::acceleration_imbalance(rho, F.y, found.y), 0, rounding(1), where);
        newton.within(analytic::acceleration_imbalance(rho, F.z, found.z), 0, rounding(1), where);
    }
}

/// Bodies around a point, some beyond the support, some in the reserve, the first one at the point itself.
std::vector<backends::Carrier> carriers(Arguments& a, const Vec3& r, double h, int count)
{
    std::vector<backends::Carrier> all;
    for (int j = 0; j < count; ++j) {
        const Vec3 x = j == 0 ? r : r + a.vector(1.6 * h);
        const double mass = a.between(0.5, 2);
        all.push_back({x, mass, a.between(900, 1100), a.between(-3, 3), j % 7 == 5});
    }
    return all;
}

void eq04_interpolation(Probe& probe)
{
    const std::string of_sum = "on each term m/rho |A|: the rounding of W with gamma_4 more in the distance, "
                               "gamma_(3 + n) more for two products, a quotient and n - 1 sums";
    Quantity& definition = probe.quantity("A(r) against the kernels' definition [A]", Source::rounding,
                                          of_sum + "; gamma_(n + 4) of the oracle's sum");
    Quantity& brute = probe.quantity("A(r) against all pairs with truncated powers [A]", Source::rounding,
                                     of_sum + "; the oracle's own bound");
    Quantity& oracles = probe.quantity("all pairs against the definition [A]", Source::rounding,
                                       "the own bound of the one, gamma_(n + 4) of the other");
    Quantity& single = probe.quantity("A(r) of a single body at r over A m W(0)/rho [1]", Source::rounding,
                                      "gamma_23: 15 of W(0), to which only the first term adds, 3 of the "
                                      "sum's term, 1 of the oracle's value, 4 of this ratio");
    for (const KernelName name : both_kernels) {
        Arguments a(4);
        for (const int count : {1, 2, 7, 8, 9, 21, 40}) {
            const double h = a.between(0.02, 0.06);
            const Vec3 r = a.vector(h);
            const std::vector<backends::Carrier> all = carriers(a, r, h, count);
            const std::string where = kernel_text(name) + at({{"bodies", double(count)}, {"h", h}});
            analytic::Cloud cloud{name, h, 8 * h, {}, {}, {}, {}, {}, {}};
            analytic::Estimate exact;
            double allowed = 0;
            for (const backends::Carrier& c : all) {
                if (c.absent) {
                    continue;
                }
                cloud.position.push_back(to_eigen(c.position));
                cloud.mass.push_back(c.mass);
                cloud.density.push_back(c.rho);
                cloud.pressure.push_back(c.A);
                const double distance = (to_eigen(r) - to_eigen(c.position)).norm();
                const double factor = c.A * c.mass / c.rho;
                const double term = factor * analytic::exact_kernel(name, h, distance, 0).value;
                exact.value += term;
                exact.error +=
                    rounding(count + 4) * std::abs(term) +
                    std::abs(factor) * analytic::exact_kernel(name, h, distance, rounding(4)).change;
                allowed += std::abs(factor) * value_rounding(name, h, distance, 4, 16 + 3 + count);
            }
            const double found = probe.equations().interpolate(name, h, r, all);
            const analytic::Estimate pairs = analytic::pair_interpolation(cloud, to_eigen(r));
            definition.within(found, exact.value, exact.error + allowed, where);
            brute.within(found, pairs.value, pairs.error + allowed, where);
            oracles.within(pairs.value, exact.value, pairs.error + exact.error, where);
            const backends::Carrier& own = all.front();
            const double alone = probe.equations().interpolate(name, h, r, std::span(&own, 1));
            const double W_0 = analytic::exact_kernel(name, h, 0, 0).value;
            single.within(alone * own.rho / (own.A * own.mass * W_0), 1, rounding(23), where);
        }
    }
}

void eqEOS_pressure(Probe& probe)
{
    Quantity& relation = probe.quantity("p = kappa (rho - rho_0), 50 digits [1]", Source::rounding,
                                        "gamma_2: a difference and a product");
    Quantity& sound =
        probe.quantity("p against int c^2 drho [Pa]", Source::quadrature,
                       "GSL's estimate and 16 u of the value; gamma_2, 1 of the interval's length");
    Quantity& oracles = probe.quantity("int c^2 drho in the relation [1]", Source::quadrature,
                                       "GSL's estimate and 16 u, over the value");
    Quantity& rest =
        probe.quantity("p at the density of rest [Pa]", Source::exact, "0: a difference of equal numbers");
    Arguments a(7);
    for (int n = 0; n < 100; ++n) {
        const double kappa = n % 2 == 0 ? 1 : a.between(0.3, 400);
        const double rho_0 = a.between(900, 1100);
        const double rho = rho_0 * a.between(0.3, 1.8);
        const std::string where = at({{"kappa", kappa}, {"rho", rho}, {"rho_0", rho_0}});
        const double p = probe.equations().equation_of_state(kappa, rho, rho_0);
        const analytic::Estimate integral = analytic::pressure_of_sound_speed(kappa, rho, rho_0);
        relation.within(analytic::state_imbalance(kappa, rho, rho_0, p), 0, rounding(2), where);
        sound.within(p, integral, rounding(3), where);
        oracles.within(analytic::state_imbalance(kappa, rho, rho_0, integral.value), 0,
                       integral.error / std::abs(integral.value) + rounding(1), where);
        rest.within(probe.equations().equation_of_state(kappa, rho_0, rho_0), 0, 0, where);
    }
}

} // namespace

std::vector<Check> blood_flow_checks()
{
    return {
        formula_check(
            "eq01_momentum", {"1"}, "gravity, viscosity and pressure add up to mass times acceleration",
            {"an exact flow of Arnold, Beltrami and Childress, 50 digits", "whole numbers"}, eq01_momentum),
        formula_check(
            "eq04_interpolation", {"4"},
            "a field is interpolated from the bodies that take part and no others",
            {"sum over the kernels' definition, 50 digits", "sum over all pairs with truncated powers"},
            eq04_interpolation),
        formula_check(
            "eqEOS_pressure", {"EOS"}, "the pressure belongs to the density, and to the speed of sound",
            {"GSL quadrature of the squared speed of sound", "the relation, 50 digits"}, eqEOS_pressure),
        formula_check(
            "eq15_acceleration", {"15"}, "density times acceleration is force",
            {"an exact flow of Arnold, Beltrami and Childress, 50 digits", "the relation, 50 digits"},
            eq15_acceleration),
    };
}

} // namespace aneurysm::checks
