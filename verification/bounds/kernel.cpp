// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/kernel.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::bounds
{

KernelBounds::Shape KernelBounds::shape(double q) const
{
    if (q >= 2) {
        return {};
    }
    if (name_ == KernelName::wendland_c2) {
        const double a = 1 - q / 2;
        const double across = -5 * a * a * a;
        return {across + 7.5 * q * a * a, across, a * a * a * a * (1 + 2 * q), 5 * q * a * a * a};
    }
    if (q < 1) {
        return {-3 + 4.5 * q, -3 + 2.25 * q, 1 + 1.5 * q * q + 0.75 * q * q * q, 3 * q + 2.25 * q * q};
    }
    const double a = 2 - q;
    return {1.5 * a, -0.75 * a * a / q, 0.25 * a * a * a, 0.75 * a * a};
}

PairBounds KernelBounds::of(double r, double difference) const
{
    constexpr double roundings = 20;
    const double h = kernel_.smoothing_length();
    const double H = kernel_.support();
    // value(0) is 1 in units of either kernel's norm.
    const double norm = kernel_.value(0);
    const Shape s = shape(r / h);
    const double curvature = norm / (h * h);
    const double delta = difference + 8 * r;
    const double K = reference::viscosity_laplacian(0, H) / H;

    const double W = kernel_.value(r);
    const double slope = std::abs(kernel_.derivative(r));
    const double laplacian = reference::viscosity_laplacian(r, H);
    return {{W, slope * delta + roundings * norm * s.largest_term},
            {slope, curvature * (std::max(std::abs(s.second), std::abs(s.across)) * (difference + r) +
                                 std::abs(s.second - s.across) * 8 * r) +
                        roundings * norm / h * s.largest_slope_term},
            {laplacian, K * (delta + 2 * H) + roundings * laplacian}};
}

} // namespace aneurysm::bounds
