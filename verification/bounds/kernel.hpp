// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/kernel_function.hpp"
#include "verification/bounds/inexact.hpp"

namespace aneurysm::bounds
{

/// The kernels of a pair.
struct PairBounds {
    Inexact W;
    Inexact grad_W; ///< its length; the error is of the vector, as a 2-norm
    Inexact lap_W;
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
