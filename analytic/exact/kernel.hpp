// SPDX-License-Identifier: Apache-2.0
// The kernels from what defines them, with 50 digits, and their derivatives by differences alone.
#pragma once

#include "analytic/gsl.hpp"
#include "common/scenario/scenario.hpp"

#include <Eigen/Core>

namespace aneurysm::analytic
{

/// A function's value, rounded to double, and how much it changes at most where its argument is off by the
/// relative amount that was asked for.
struct Exact {
    double value = 0;
    double change = 0;
};

/// W(r) of Eq. (4) [1/m^3]: the cubic spline as 3/2 times the B-spline on the knots -2 h, -h, 0, h, 2 h by
/// the recursion of Cox and de Boor; Wendland's C2 as the integral 20 int_x^1 t (1 - t)^3 dt, x = r/(2 h),
/// that defines it. `off`: relative error of r.
Exact exact_kernel(KernelName name, double h, double r, double off);

/// dW/dr by a difference, whose own error of 1e-30 W(0)/h counts
/// as change [1/m^4]. `off`: relative error of r.
Exact exact_kernel_slope(KernelName name, double h, double r, double off);

/// grad W of Eq. (6) as differences of W(|x|) along each axis [1/m^4].
Eigen::Vector3d exact_kernel_gradient(KernelName name, double h, const Eigen::Vector3d& x);

/// Laplacian of Mueller's viscosity kernel of Eq. (7), (1/r) d^2(r W)/dr^2, as a difference [1/m^5]; 0 from
/// the support radius H on. The difference over 2e-12 H leaves 2e-25 H/r of the largest value as its error.
/// \throws std::invalid_argument for r < H/1000
Estimate exact_viscosity_laplacian(double H, double r);

} // namespace aneurysm::analytic
