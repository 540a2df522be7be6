// SPDX-License-Identifier: Apache-2.0
// Section 3.1: the kernel W of (4)-(6) and the Laplacian of (7).
#pragma once

#include "common/scenario/scenario.hpp"

#include <numbers>

namespace aneurysm::reference
{

/// W(r, h), normalized in three dimensions, zero from the support
/// radius 2 h on. The paper names none; q = r / h:
///
///     cubic spline   W = 1/(pi h^3)     { 1 - 3/2 q^2 + 3/4 q^3   for q < 1;   (2 - q)^3 / 4   for q < 2 }
///     Wendland C2    W = 21/(16 pi h^3) (1 - q/2)^4 (1 + 2 q)                                  for q < 2
class Kernel
{
public:
    /// `smoothing_length`: h [m]
    Kernel(KernelName name, double smoothing_length) : name_(name), h_(smoothing_length) {}

    double smoothing_length() const { return h_; } ///< h [m]
    double support() const { return 2 * h_; }      ///< [m]

    /// W(r) [1/m^3]
    double value(double r) const
    {
        const double q = r / h_;
        if (q >= 2.0) {
            return 0;
        }
        if (name_ == KernelName::wendland_c2) {
            const double a = 1 - q / 2;
            return wendland_norm() * a * a * a * a * (1 + 2 * q);
        }
        if (q < 1.0) {
            return spline_norm() * (1 - 1.5 * q * q + 0.75 * q * q * q);
        }
        const double a = 2 - q;
        return spline_norm() * 0.25 * a * a * a;
    }

    /// dW/dr [1/m^4]; never positive
    double derivative(double r) const
    {
        const double q = r / h_;
        if (q >= 2.0) {
            return 0;
        }
        if (name_ == KernelName::wendland_c2) {
            const double a = 1 - q / 2;
            return wendland_norm() / h_ * -5 * q * a * a * a;
        }
        if (q < 1.0) {
            return spline_norm() / h_ * (-3 * q + 2.25 * q * q);
        }
        const double a = 2 - q;
        return spline_norm() / h_ * -0.75 * a * a;
    }

    /// grad W of a pair at x = r_i - r_j [1/m^4]; zero at x = 0
    Vec3 gradient(const Vec3& x) const
    {
        const double r = length(x);
        return r > 0 ? derivative(r) / r * x : Vec3{};
    }

private:
    double spline_norm() const { return 1 / (std::numbers::pi * h_ * h_ * h_); }
    double wendland_norm() const { return 21 / (16 * std::numbers::pi * h_ * h_ * h_); }

    KernelName name_;
    double h_;
};

/// The Laplacian of the viscosity kernel of the paper's reference 15 (Mueller et al. 2003), which (7) is
/// taken from; positive everywhere, so that viscosity only takes energy away. H = 2 h is the support radius:
///
///     lap W = 45 / (pi H^6) (H - r)   for r < H                                              [1/m^5]
inline double viscosity_laplacian(double r, double support)
{
    const double H = support;
    const double norm = 45 / (std::numbers::pi * H * H * H * H * H * H);
    return r < H ? norm * (H - r) : 0;
}

} // namespace aneurysm::reference
