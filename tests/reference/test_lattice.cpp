// SPDX-License-Identifier: Apache-2.0
// What the reference knows of a full lattice, against lattice sums: the mass that makes the rest density, and
// the largest relaxation.
#include "analytic/incompressible.hpp"
#include "analytic/lattice/lattice.hpp"
#include "reference/incompressible.hpp"
#include "tests/support.hpp"

using namespace aneurysm;
using namespace aneurysm::test;
using analytic::Lattice;

namespace
{

constexpr double dx = 1.0 / 64;
constexpr double fault = 1e-12;
constexpr auto cubic = KernelName::cubic_spline;
constexpr auto c2 = KernelName::wendland_c2;

Lattice lattice(KernelName kernel, double ratio)
{
    return {kernel, ratio * dx, dx};
}

} // namespace

BOOST_AUTO_TEST_CASE(eq05_lattice_mass_makes_the_rest_density)
{
    const auto holds = [](auto lattice_kernel_sum) {
        for (const auto name : {cubic, c2}) {
            for (const double ratio : {1.0, 1.3, 2.0}) {
                const auto expected = analytic::kernel_sum(lattice(name, ratio));
                const double sum = lattice_kernel_sum(reference::Kernel(name, ratio * dx), dx);
                if (!within(sum, expected.value,
                            2 * expected.error)) { // the reference rounds as the oracle does
                    return false;
                }
            }
        }
        return true;
    };
    BOOST_TEST(holds(reference::lattice_kernel_sum));
    BOOST_TEST(!holds(off_by(fault, reference::lattice_kernel_sum)));
}

BOOST_AUTO_TEST_CASE(eq03_relaxation_limit_is_safe_and_no_lower_than_its_margin)
{
    // the reference searches a grid and takes 0.2 % off:
    // never above the exact limit, never more than that below
    const auto holds = [](auto relaxation_limit) {
        for (const auto kernel : {cubic, c2}) {
            for (const double ratio : {1.0, 1.2, 1.3}) {
                const auto exact = analytic::relaxation_limit(lattice(kernel, ratio));
                const double found = relaxation_limit(kernel, ratio);
                BOOST_TEST_MESSAGE("    limit " << found << " of " << exact.value << ": "
                                                << found / exact.value);
                if (found > exact.value + exact.error || found < (exact.value - exact.error) / 1.002) {
                    return false;
                }
            }
        }
        return true;
    };
    BOOST_TEST(holds(reference::relaxation_limit));
    BOOST_TEST(!holds(off_by(0.002, reference::relaxation_limit)));
    BOOST_TEST(!holds(off_by(-0.002, reference::relaxation_limit)));
}
