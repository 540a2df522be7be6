// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/kernel_function.hpp"

namespace aneurysm::bounds
{

/// The kernels of a pair and how far two computations of them can be apart, in units of U.
struct PairBounds {
    double W = 0;
    double grad_W = 0; ///< its length
    double lap_W = 0;
    double W_error = 0;
    double grad_W_error = 0; ///< 2-norm
    double lap_W_error = 0;
};

/// Rounding of W, grad W and lap W of a pair at the distance r, whose difference vector is within
/// `difference` [in U] before it is computed.
///
/// The subtraction moves the vector by r, its length by 3 r more, the division by h (or the product with a
/// rounded 1/h, and h's own rounding) by 4 r: together the distance is within
///
///     delta = difference + 8 r.
///
/// W: |dW/dr| delta, and 20 roundings of the largest partial sum of its polynomial: 10 of the norm 1/(pi h^3)
/// with h's own, 6 of the polynomial.
///
/// grad W = f(r) x, f = (dW/dr)/r: a displacement acts through its Hessian, whose eigenvalues are W'' along x
/// and f across; the error of the length alone through r f' = W'' - f:
///
///     max(|W''|, |f|) (difference + r) + |W'' - f| 8 r + 20 roundings
///
/// lap W = K (H - r): K (delta + 2 H) for r, H and their difference, and 20 roundings of K = 45/(pi H^6).
///
/// The spline's polynomials are taken as they stand in reference/kernel_function.hpp; a difference of two
/// cubes would lose more near r = 0.
class KernelBounds
{
public:
    KernelBounds(KernelName name, double h) : name_(name), kernel_(name, h) {}

    PairBounds of(double r, double difference) const;

private:
    struct Shape { ///< of the kernel at q, in units of its norm
        double second = 0;
        double across = 0;
        double largest_term = 0;       ///< of W's polynomial
        double largest_slope_term = 0; ///< of dW/dq's
    };
    Shape shape(double q) const;

    KernelName name_;
    reference::Kernel kernel_;
};

} // namespace aneurysm::bounds
