// SPDX-License-Identifier: Apache-2.0
// Section 3.4: the radii of a branching artery, (24).
#include "analytic/bifurcation.hpp"
#include "analytic/relations.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"

#include <cmath>
#include <numbers>

namespace aneurysm::checks
{
namespace
{

using analytic::Estimate;
using std::numbers::pi;

void eq24_murray(Probe& probe)
{
    Quantity& cubes = probe.quantity("r_0^3 = r_1^3 + r_2^3, 50 digits [1]", Source::rounding,
                                     "3 gamma_2: the cube root of 2 and a quotient, three times in the cube");
    Quantity& cheapest =
        probe.quantity("daughter against the cheapest vessel for half the flow [m]", Source::solver,
                       "the last brackets of both roots and 16 u/6 of each; gamma_2 of the daughter");
    Quantity& oracles = probe.quantity("cheapest vessels in the sum of cubes [1]", Source::solver,
                                       "3 times the brackets and 16 u/6 of each root");
    Arguments a(24);
    for (int n = 0; n < 60; ++n) {
        const double r_0 = a.between(1e-4, 0.8);
        const double r_1 = probe.equations().daughter_radius(r_0);
        cubes.within(analytic::murray_imbalance(r_0, {r_1, r_1}), 0, 3 * rounding(2), at({{"r_0", r_0}}));

        const analytic::VesselCost blood{a.between(2e-3, 5e-3), a.between(300, 1500)};
        const double Q = a.between(1e-7, 1e-4);
        const Estimate parent = analytic::cheapest_radius(blood, Q);
        const Estimate daughter = analytic::cheapest_radius(blood, Q / 2);
        const std::string where = at({{"mu", blood.mu}, {"b", blood.b}, {"Q", Q}});
        cheapest.within(probe.equations().daughter_radius(parent.value), daughter.value,
                        daughter.error + parent.error + rounding(2) * daughter.value, where);
        oracles.within(analytic::murray_imbalance(parent.value, {daughter.value, daughter.value}), 0,
                       3 * (parent.error / parent.value + daughter.error / daughter.value), where);
    }
}

void eq24_oracles(Probe& probe)
{
    Quantity& search = probe.quantity(
        "cheapest radius by its derivative against a search [m]", Source::solver,
        "sqrt(16 u/4) and the simplex' size, since the cost is flat there; the root's bracket");
    Quantity& exponent =
        probe.quantity("exponent of r in the flow that r is cheapest for [1]", Source::solver,
                       "the radii's relative errors times 3/ln n; 6 roundings of the ratio of logarithms");
    Quantity& branches =
        probe.quantity("n equal branches against the cheapest vessels for 1/n of the flow [m]",
                       Source::solver, "both roots' brackets; gamma_8 of the power");
    Quantity& shear =
        probe.quantity("wall's shear stress in the cheapest vessel over sqrt(b mu) [1]", Source::solver,
                       "3 times the radius' relative error; gamma_10 of the ratio");
    Quantity& cost = probe.quantity(
        "least cost over 3/2 of the blood's own [1]", Source::rounding,
        "gamma_20: 10 of the cost, 10 of the ratio; an error of the radius counts only squared");
    const analytic::VesselCost blood{3.5e-3, 800};
    const double Q = 2.4e-6;
    const Estimate at_Q = analytic::cheapest_radius(blood, Q);
    const Estimate found = analytic::cheapest_radius_by_search(blood, Q);
    search.within(found.value, at_Q.value, found.error + at_Q.error);
    const double r = at_Q.value;
    shear.within(4 * blood.mu * Q / (pi * r * r * r) / std::sqrt(blood.b * blood.mu), 1,
                 3 * at_Q.error / r + rounding(10));
    cost.within(analytic::vessel_cost(blood, Q, r) / (1.5 * blood.b * pi * r * r), 1, rounding(20));
    for (const int n : {2, 3, 5}) {
        const Estimate share = analytic::cheapest_radius(blood, Q / n);
        const double power = std::log(n) / std::log(at_Q.value / share.value);
        const double relative = at_Q.error / at_Q.value + share.error / share.value;
        exponent.within(power, 3, 3 * (relative + rounding(6)) * power / std::log(n), at({{"n", double(n)}}));
        branches.within(analytic::branch_radius(at_Q.value, n, 3), share.value,
                        at_Q.error + share.error + rounding(8) * share.value, at({{"n", double(n)}}));
    }
}

} // namespace

std::vector<Check> bifurcation_checks()
{
    return {
        formula_check("eq24_murray", {"24"},
                      "two equal daughters are the cheapest vessels for half the flow each",
                      {"GSL root of the cost's derivative", "sum of cubes, 50 digits"}, eq24_murray),
        oracle_check("eq24_oracles", Level::scalar, {"24"},
                     "the cheapest radius is a minimum, and grows with the cube root of the flow",
                     {"GSL root of the cost's derivative", "GSL search for the minimum",
                      "shear stress sqrt(b mu), equal in all vessels", "power"},
                     eq24_oracles),
    };
}

} // namespace aneurysm::checks
