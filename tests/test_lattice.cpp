// SPDX-License-Identifier: Apache-2.0
// The oracles of section 3.1 against one another: direct lattice sums, Poisson's formula, and what is known
// of them.
#include "analytic/incompressible.hpp"
#include "analytic/kernel_function.hpp"
#include "analytic/lattice.hpp"
#include "reference/incompressible.hpp"
#include "tests/support.hpp"

#include <array>
#include <numbers>

using namespace aneurysm;
using namespace aneurysm::test;
using analytic::Lattice;
using Eigen::Vector3d;

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

const std::array waves{Vector3d(0.5, 0, 0), Vector3d(0.4, -0.9, 1.3), Vector3d(2.1, 2.9, 0.3)}; // times 1/dx

} // namespace

BOOST_AUTO_TEST_CASE(eq04_transforms_equal_their_sine_integrals)
{
    for (const auto kernel : {cubic, c2}) {
        for (const double kh : {0.3, 0.99, 1.01, 2.5, 7.0, 20.0}) {
            const auto wave = [&](double r) {
                return 4 * std::numbers::pi * r * analytic::kernel(kernel, 1, r) * std::sin(kh * r) / kh;
            };
            const auto inner = analytic::integrate(wave, 0, 1);
            const auto outer = analytic::integrate(wave, 1, 2);
            // the transform's own bound of 1e-12, the quadratures' and 16 u of a kernel whose whole integral
            // is 1
            BOOST_TEST(within(analytic::kernel_transform(kernel, 1, kh), inner.value + outer.value,
                              1e-12 + inner.error + outer.error + rounding(16)));
        }
    }
}

BOOST_AUTO_TEST_CASE(eq07_transform_equals_its_sine_integral)
{
    const double H = 2;
    for (const double kH : {0.3, 0.99, 1.01, 2.5, 7.0, 20.0}) {
        const double k = kH / H;
        const auto wave = [&](double r) {
            return 4 * std::numbers::pi * r * analytic::viscosity_kernel_laplacian(H, r) * std::sin(k * r) /
                   k;
        };
        const auto integral = analytic::integrate(wave, 0, H);
        // the closed form's terms cancel to a^4/12 of 4 + a, a = kH >= 1, the quadrature's from 15/H^2
        const double a = std::max(kH, 1.0);
        const double allowed =
            rounding(16) * 180 / (H * H * a * a * a * a) * (4 + a) + rounding(32) * 15 / (H * H);
        BOOST_TEST(within(analytic::viscosity_transform(H, k), integral.value, integral.error + allowed));
    }
}

BOOST_AUTO_TEST_CASE(eq05_direct_and_poisson_sums_agree)
{
    for (const auto kernel : {cubic, c2}) {
        for (const double ratio : {1.0, 1.2, 1.3, 2.0}) {
            const Lattice l = lattice(kernel, ratio);
            const auto direct = analytic::kernel_sum(l);
            const auto poisson = analytic::kernel_sum_by_poisson(l);
            BOOST_TEST(within(direct.value, poisson.value, direct.error + poisson.error));
            // the bound tells this lattice from a continuum
            BOOST_TEST(poisson.error < 0.1 * std::abs(direct.value - 1 / l.cell()));
        }
    }
}

BOOST_AUTO_TEST_CASE(eq05_lattice_offsets_are_the_recorded_ones)
{
    // rho/rho_0 - 1 of a lattice whose particles have the mass rho_0 dx^3, recorded with three digits
    const auto offset = [](KernelName kernel, double ratio) {
        const Lattice l = lattice(kernel, ratio);
        return analytic::kernel_sum(l).value * l.cell() - 1;
    };
    BOOST_TEST(within(offset(cubic, 1.0), -2.75e-5, 0.005e-5));
    BOOST_TEST(within(offset(cubic, 1.2), 8.10e-4, 0.005e-4));
    BOOST_TEST(within(offset(cubic, 1.3), -2.74e-3, 0.005e-3));
    BOOST_TEST(within(offset(cubic, 2.0), 7.92e-5, 0.005e-5));
    BOOST_TEST(within(offset(c2, 1.0), 3.4e-2, 0.05e-2));
    BOOST_TEST(within(offset(c2, 2.0), 5.5e-4, 0.05e-4));
}

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

BOOST_AUTO_TEST_CASE(eq06_direct_and_poisson_sums_agree)
{
    for (const auto kernel : {cubic, c2}) {
        const Lattice l = lattice(kernel, 1.3);
        for (const Vector3d& k : waves) {
            const auto direct = analytic::gradient_sum(l, k / dx);
            const auto poisson = analytic::gradient_sum_by_poisson(l, k / dx);
            for (int a = 0; a < 3; ++a) {
                BOOST_TEST(within(direct.value(a), poisson.value(a), direct.error + poisson.error));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(eq06_gradient_floors_are_the_recorded_ones)
{
    const auto floor = [](double ratio) { return analytic::gradient_floor(lattice(cubic, ratio)).value; };
    BOOST_TEST(within(floor(1.2), -1.831e-2, 0.0005e-2));
    BOOST_TEST(within(floor(1.3), -0.652e-2, 0.0005e-2));
    BOOST_TEST(within(floor(2.0), -4.9e-5, 0.05e-5));
}

BOOST_AUTO_TEST_CASE(eq07_direct_and_poisson_sums_agree)
{
    for (const double ratio : {1.0, 1.32}) { // with and without lattice points at the support's end
        const Lattice l = lattice(cubic, ratio);
        for (const Vector3d& k : waves) {
            const auto direct = analytic::viscosity_sum(l, k / dx);
            const auto poisson = analytic::viscosity_sum_by_poisson(l, k / dx);
            BOOST_TEST(within(direct.value, poisson.value, direct.error + poisson.error));
        }
    }
}

BOOST_AUTO_TEST_CASE(eq03_relaxation_limits_are_the_recorded_ones)
{
    // 2/max lambda, the limit without momentum, recorded with three digits from a grid of wave vectors, which
    // misses the maximum: up to 0.2 % above; momentum leaves two thirds
    const auto holds = [](KernelName kernel, double ratio, double recorded) {
        const double limit = 3.0 / 2 * analytic::relaxation_limit(lattice(kernel, ratio)).value;
        BOOST_TEST_MESSAGE("    limit " << limit << ", recorded " << recorded);
        return limit < recorded + 0.0005 && limit > 0.998 * recorded - 0.0005;
    };
    BOOST_TEST(holds(cubic, 1.0, 0.710));
    BOOST_TEST(holds(cubic, 1.2, 0.507));
    BOOST_TEST(holds(cubic, 1.3, 0.408));
    BOOST_TEST(holds(cubic, 2.0, 0.114));
    BOOST_TEST(holds(c2, 1.0, 0.768));
    BOOST_TEST(holds(c2, 1.3, 0.476));
}

BOOST_AUTO_TEST_CASE(eq03_momentum_damps_modes_down_to_minus_a_third)
{
    // theta up to 0.999, where the roots are at least 5e-4 inside the unit circle for g = -1/3
    const auto damps_all = [](double lowest) {
        for (int i = 0; i < 1000; ++i) {
            for (int j = 0; j < 100; ++j) {
                if (!(analytic::largest_root(0.001 * i, lowest + (1 - lowest) * 0.01 * j) < 1)) {
                    return false;
                }
            }
        }
        return true;
    };
    BOOST_TEST(damps_all(-1.0 / 3));
    BOOST_TEST(!damps_all(-1.0 / 3 - 0.001));
    // without momentum all down to -1 are
    BOOST_TEST(analytic::largest_root(0, -0.999) < 1);
    BOOST_TEST(analytic::largest_root(0, -1.001) > 1);
}

BOOST_AUTO_TEST_CASE(eq03_relaxation_limit_is_safe_and_no_lower_than_its_margin)
{
    // the reference searches a grid and takes 0.2 % off: never above the exact limit, never more than that
    // below
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
