// SPDX-License-Identifier: Apache-2.0
// Section 3.1: the kernel W of (4)-(6) and the Laplacian of (7).
#pragma once

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
        const Number a = select(q < Number(2), Number(2) - q, Number(0));
        if (is_wendland_) {
            const Number b = Number(Real(0.5)) * a;
            const Number b2 = b * b;
            return Number(norm_) * b2 * b2 * (Number(1) + Number(2) * q);
        }
        const Number inner = Number(Real(1.5)) - Number(Real(0.75)) * q;
        const Number near = Number(1) - q * q * inner;
        const Number far = Number(Real(0.25)) * a * a * a;
        return Number(norm_) * select(q < Number(1), near, far);
    }

    /// W'(r) / r, so that grad W = this times (r_i - r_j) [1/m^5]; never positive
    ANEURYSM_INLINE Number gradient_factor(const Number& r) const
    {
        const Number q = r * Number(per_h_);
        const Number a = select(q < Number(2), Number(2) - q, Number(0));
        if (is_wendland_) {
            const Number b = Number(Real(0.5)) * a;
            return Number(gradient_norm_) * Number(-5) * b * b * b;
        }
        const Number near = Number(Real(2.25)) * q - Number(3);
        const Number far = Number(Real(-0.75)) * a * a / q; // not taken where q is 0
        return Number(gradient_norm_) * select(q < Number(1), near, far);
    }

    /// Laplacian of the viscosity kernel, 45 / (pi H^6) (H - r) for r < H = 2 h [1/m^5]
    ANEURYSM_INLINE Number viscosity_laplacian(const Number& r) const
    {
        return select(r < Number(support_), Number(viscosity_norm_) * (Number(support_) - r), Number(0));
    }

private:
    bool is_wendland_;
    Real per_h_;
    Real norm_;
    Real gradient_norm_;
    Real support_;
    Real viscosity_norm_;
};

} // namespace aneurysm::device
