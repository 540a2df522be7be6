// SPDX-License-Identifier: Apache-2.0
// Bounds of the rounding of the kernels, for any text that evaluates their polynomials.
#pragma once

#include "analytic/exact/kernel.hpp"
#include "analytic/kernel_function.hpp"
#include "verification/checks/checks.hpp"

#include <array>

namespace aneurysm::checks
{

inline constexpr std::array both_kernels{KernelName::cubic_spline, KernelName::wendland_c2};

inline std::string kernel_text(KernelName name)
{
    return name == KernelName::cubic_spline ? "cubic spline " : "Wendland C2 ";
}

/// Bound of the error of W(r) [1/m^3] by `roundings` on each term of the polynomial. Where the spline
/// subtracts, for r < h, its terms' magnitudes add up to 1 + 3/2 + 3/4 times W(0) at most; elsewhere W is a
/// product of exact differences. `of_r`: number of roundings of r before the call. q = r/h adds 2 more,
/// and an error of q changes W, too.
inline double value_rounding(KernelName name, double h, double r, double of_r = 0, double roundings = 16)
{
    const analytic::Exact W = analytic::exact_kernel(name, h, r, rounding(of_r + 2));
    const bool subtracts = name == KernelName::cubic_spline && r < h;
    const double terms = subtracts ? 3.25 * analytic::kernel(name, h, 0) : W.value;
    return W.change + rounding(roundings) * terms;
}

/// Bound of the error of analytic::kernel [1/m^3]: 16 roundings on the magnitudes of its powers, 2 of q.
inline double power_rounding(KernelName name, double h, double r)
{
    return analytic::exact_kernel(name, h, r, rounding(2)).change +
           rounding(16) * analytic::kernel_terms(name, h, r);
}

/// Bound of the error of each component of grad W at the distance r [1/m^4]. For r < h the spline's terms are
/// 3 q and 9/4 q^2, whose sum is at most 7 times their difference. The length has 3 roundings, q = r/h
/// adds 2, and `of_r` those of the vector itself.
inline double gradient_rounding(KernelName name, double h, double r, double of_r = 0)
{
    const analytic::Exact slope = analytic::exact_kernel_slope(name, h, r, rounding(of_r + 5));
    const bool subtracts = name == KernelName::cubic_spline && r < h;
    return slope.change + rounding(of_r + 24) * (subtracts ? 7 : 1) * std::abs(slope.value);
}

} // namespace aneurysm::checks
