// SPDX-License-Identifier: Apache-2.0
// The kernel of (4)-(6) and the Laplacian of (7).
#include "analytic/kernel_function.hpp"
#include "reference/kernel_function.hpp"
#include "tests/support.hpp"

#include <array>
#include <vector>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

constexpr double h = 0.037;
constexpr double fault = 1e-12;

const std::array both{KernelName::cubic_spline, KernelName::wendland_c2};

/// Radii across the support, the breaks and their neighbours included.
std::vector<double> radii()
{
    std::vector<double> r{
        0, h, 2 * h, std::nextafter(h, 0), std::nextafter(h, 1), std::nextafter(2 * h, 0), 3 * h};
    for (int i = 1; i < 200; ++i) {
        r.push_back(i * h / 90);
    }
    return r;
}

/// Sum of the magnitudes of the terms that either text of W adds up, for rounding bounds.
double magnitude(KernelName name)
{
    return 9 * analytic::kernel(name, h, 0);
}

} // namespace

BOOST_AUTO_TEST_CASE(eq04_kernel_equals_its_truncated_powers)
{
    for (const KernelName name : both) {
        const reference::Kernel W(name, h);
        const auto holds = [&](auto candidate) {
            return std::ranges::all_of(radii(), [&](double r) {
                // 16 roundings in each text, on terms of that magnitude
                return std::abs(candidate(r) - analytic::kernel(name, h, r)) <=
                       2 * rounding(16) * magnitude(name);
            });
        };
        const auto value = [&](double r) { return W.value(r); };
        BOOST_TEST(holds(value));
        BOOST_TEST(!holds(off_by(fault, value)));
        BOOST_TEST(!holds([&](double r) { return r < h ? W.value(r) : 0; })); // the outer piece dropped
    }
}

BOOST_AUTO_TEST_CASE(eq04_kernel_has_its_exact_moments)
{
    for (const KernelName name : both) {
        const reference::Kernel W(name, h);
        const auto holds = [&](auto candidate) {
            return std::ranges::all_of(std::vector{0, 2, 4}, [&](int p) {
                return within(analytic::exact_moment(name, h, p), analytic::moment(candidate, h, p),
                              rounding(4));
            });
        };
        const auto value = [&](double r) { return W.value(r); };
        BOOST_TEST(holds(value));
        BOOST_TEST(!holds(off_by(fault, value)));
    }
}

BOOST_AUTO_TEST_CASE(eq06_slope_integrates_to_the_kernel)
{
    for (const KernelName name : both) {
        const reference::Kernel W(name, h);
        const auto holds = [&](auto slope) {
            return std::ranges::all_of(radii(), [&](double r) {
                double rise = 0;
                double error = 0;
                for (const auto& [a, b] : {std::pair{std::min(r, h), h}, std::pair{std::max(r, h), 2 * h}}) {
                    if (a < b) {
                        const auto part = analytic::integrate_polynomial(slope, a, b);
                        rise += part.value;
                        error += part.error;
                    }
                }
                // int_r^2h W' = -W(r); W itself has 16 roundings
                return std::abs(rise + W.value(r)) <= error + rounding(16) * W.value(0);
            });
        };
        const auto derivative = [&](double r) { return W.derivative(r); };
        BOOST_TEST(holds(derivative));
        BOOST_TEST(!holds(off_by(fault, derivative)));
    }
}

BOOST_AUTO_TEST_CASE(eq06_gradient_has_its_exact_moments)
{
    for (const KernelName name : both) {
        const reference::Kernel W(name, h);
        const Vec3 direction{0.36, -0.48, 0.8};
        const auto holds = [&](auto gradient) {
            // int x_a dW/dx_b dV = -delta_ab: r W'/3 over all directions
            const auto first = [&](double r) { return dot(r * direction, gradient(r * direction)) / 3; };
            const auto square = [&](double r) {
                return dot(gradient(r * direction), gradient(r * direction));
            };
            return within(-1, analytic::moment(first, h, 0), 0) &&
                   within(analytic::exact_gradient_norm(name, h), analytic::moment(square, h, 0),
                          rounding(8));
        };
        const auto gradient = [&](const Vec3& x) { return W.gradient(x); };
        BOOST_TEST(holds(gradient));
        BOOST_TEST(!holds(off_by(fault, gradient)));
        BOOST_TEST(!holds(off_by(-2, gradient))); // the sign
    }
}

BOOST_AUTO_TEST_CASE(eq06_gradient_is_antisymmetric_and_finite_at_zero)
{
    for (const KernelName name : both) {
        const reference::Kernel W(name, h);
        const Vec3 x{0.011, -0.023, 0.017};
        BOOST_TEST((W.gradient(x) == -W.gradient(-x)));
        BOOST_TEST((W.gradient(Vec3{}) == Vec3{}));
        BOOST_TEST((W.gradient(Vec3{2 * h, 0, 0}) == Vec3{}));
    }
}

BOOST_AUTO_TEST_CASE(eq07_laplacian_equals_that_of_the_viscosity_kernel)
{
    const double H = 2 * h;
    const auto holds = [&](auto laplacian) {
        return std::ranges::all_of(radii(), [&](double r) {
            // 12 roundings in each text; the oracle subtracts terms as large as its value at 0
            const double allowed = 4 * rounding(12) * analytic::viscosity_kernel_laplacian(H, 0);
            return std::abs(laplacian(r, H) - analytic::viscosity_kernel_laplacian(H, r)) <= allowed;
        });
    };
    BOOST_TEST(holds(reference::viscosity_laplacian));
    BOOST_TEST(!holds(off_by(fault, reference::viscosity_laplacian)));
}

BOOST_AUTO_TEST_CASE(eq07_laplacian_of_a_parabola_is_exact)
{
    // int r^2/6 lap W dV = int W_visc lap(r^2/6) dV = 1
    const double H = 2 * h;
    const auto holds = [&](auto laplacian) {
        return within(1, analytic::moment([&](double r) { return r * r / 6 * laplacian(r, H); }, h, 0), 0);
    };
    BOOST_TEST(holds(reference::viscosity_laplacian));
    BOOST_TEST(!holds(off_by(fault, reference::viscosity_laplacian)));
}
