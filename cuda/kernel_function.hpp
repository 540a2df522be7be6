// SPDX-License-Identifier: Apache-2.0
// Section 3.1: the kernel W of (4)-(6) and the Laplacian of (7).
#pragma once

#include "common/fault.hpp"
#include "common/scenario/scenario.hpp"
#include "cuda/executor/lanes.hpp"

#include <numbers>

namespace aneurysm::device
{

/// W(r, h) as in reference/kernel_function.hpp, for eight pairs at once; zero from the support radius 2 h on.
template <class Real>
class Kernel
{
public:
    using Number = Lanes<Real>;

    Kernel(KernelName name, double h)
        : is_wendland_(name == KernelName::wendland_c2), per_h_(static_cast<Real>(1 / h)),
          norm_(static_cast<Real>((is_wendland_ ? 21.0 / 16 : 1.0) / (std::numbers::pi * h * h * h))),
          gradient_norm_(
              static_cast<Real>((is_wendland_ ? 21.0 / 16 : 1.0) / (std::numbers::pi * h * h * h * h * h))),
          support_(static_cast<Real>(2 * h)),
          viscosity_norm_(static_cast<Real>(45 / (std::numbers::pi * 64 * h * h * h * h * h * h)))
    {
    }

    ANEURYSM_HD Real support() const { return support_; } ///< 2 h [m]

    /// W(r) [1/m^3]
    ANEURYSM_INLINE Number value(const Number& r) const
    {
        const Number q = r * Number(per_h_);
        const Number a = select(q < support_edge(), Number(2) - q, Number(0));
        const Number norm = fault(eq04_norm, Number(norm_));
        if (is_wendland_) {
            const Number b = fault(eq04_wendland, Number(Real(0.5)) * a);
            const Number b2 = b * b;
            return norm * b2 * b2 * (Number(1) + fault(eq04_wendland_line, Number(2) * q));
        }
        const Number inner = fault(eq04_square, Number(Real(1.5))) - fault(eq04_cube, Number(Real(0.75)) * q);
        const Number b = fault(eq04_outer, a);
        const Number near = Number(1) - q * q * inner;
        const Number far = Number(Real(0.25)) * b * b * b;
        return norm * select(q < inner_edge(), near, far);
    }

    /// W'(r) / r, so that grad W = this times (r_i - r_j) [1/m^5]; never positive
    ANEURYSM_INLINE Number gradient_factor(const Number& r) const
    {
        const Number q = r * Number(per_h_);
        const Number a = select(q < support_edge(), Number(2) - q, Number(0));
        const Number norm = fault(eq04_slope_norm, Number(gradient_norm_));
        if (is_wendland_) {
            const Number b = fault(eq04_slope_wendland, Number(Real(0.5)) * a);
            return norm * Number(-5) * b * b * b;
        }
        const Number b = fault(eq04_slope_outer, a);
        const Number near =
            fault(eq04_slope_square, Number(Real(2.25)) * q) - fault(eq04_slope_line, Number(3));
        const Number far = Number(Real(-0.75)) * b * b / q; // not taken where q is 0
        return norm * select(q < inner_edge(), near, far);
    }

    /// Laplacian of the viscosity kernel, 45 / (pi H^6) (H - r) for r < H = 2 h [1/m^5]
    ANEURYSM_INLINE Number viscosity_laplacian(const Number& r) const
    {
        const Number norm = fault(eq07_norm, Number(viscosity_norm_));
        return select(r < fault(eq07_support, Number(support_)),
                      norm * fault(eq07_distance, Number(support_) - r), Number(0));
    }

private:
    ANEURYSM_INLINE static Number inner_edge() { return fault(eq04_inner_edge, Number(1)); }
    ANEURYSM_INLINE static Number support_edge() { return fault(eq04_support, Number(2)); }

    bool is_wendland_;
    Real per_h_;
    Real norm_;
    Real gradient_norm_;
    Real support_;
    Real viscosity_norm_;
};

} // namespace aneurysm::device
