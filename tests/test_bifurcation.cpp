// SPDX-License-Identifier: Apache-2.0
// Section 3.4, (24).
#include "analytic/bifurcation.hpp"
#include "reference/bifurcation.hpp"
#include "tests/support.hpp"

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

constexpr double fault = 1e-12;
const analytic::VesselCost blood{3.5e-3, 800};
constexpr double Q = 2.4e-6;

} // namespace

BOOST_AUTO_TEST_CASE(eq24_daughters_are_the_cheapest_vessels_for_half_the_flow)
{
    const auto holds = [](auto daughter_radius) {
        const auto parent = analytic::cheapest_radius(blood, Q);
        const auto daughter = analytic::cheapest_radius(blood, Q / 2);
        // 3 roundings, the cube root's among them
        const double allowed = daughter.error + parent.error + rounding(3) * daughter.value;
        return within(daughter_radius(parent.value), daughter.value, allowed);
    };
    BOOST_TEST(holds(reference::daughter_radius));
    BOOST_TEST(!holds(off_by(fault, reference::daughter_radius)));
    BOOST_TEST(!holds([](double r_0) { return r_0 / std::sqrt(2.0); })); // area kept instead
}

BOOST_AUTO_TEST_CASE(eq24_cubes_add_up)
{
    const auto holds = [](auto daughter_radius) {
        const double r_0 = 0.3;
        const double r_1 = daughter_radius(r_0);
        // 3 times the 3 roundings of r_1, 2 + 2 of the cubes
        return within(2 * r_1 * r_1 * r_1, r_0 * r_0 * r_0, rounding(13) * r_0 * r_0 * r_0) &&
               within(r_1, analytic::branch_radius(r_0, 2, 3), rounding(3 + 8) * r_1);
    };
    BOOST_TEST(holds(reference::daughter_radius));
    BOOST_TEST(!holds(off_by(fault, reference::daughter_radius)));
}

BOOST_AUTO_TEST_CASE(eq24_oracles_agree_on_the_exponent_3)
{
    const auto at_Q = analytic::cheapest_radius(blood, Q);
    const auto found = analytic::cheapest_radius_by_search(blood, Q);
    BOOST_TEST(within(found.value, at_Q.value, found.error + at_Q.error));
    for (const int n : {2, 3, 5}) {
        const auto at_share = analytic::cheapest_radius(blood, Q / n);
        const double exponent = std::log(n) / std::log(at_Q.value / at_share.value);
        // d ln n / ln x = exponent/ln x times the radii's relative errors; 6 roundings
        const double relative =
            (at_Q.error / at_Q.value + at_share.error / at_share.value) * exponent / std::log(n);
        BOOST_TEST(within(exponent, 3, 3 * (relative + rounding(6) * exponent / std::log(n))));
        BOOST_TEST(within(analytic::branch_radius(at_Q.value, n, 3), at_share.value,
                          at_Q.error + at_share.error + rounding(8) * at_share.value));
    }
}
