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
/// `difference` [in U] before it is computed (docs/bounds.md, B23).
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
