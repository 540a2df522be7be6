// SPDX-License-Identifier: Apache-2.0
// The decaying vortices of Taylor and Green (Proc. R. Soc. A 158, 1937) in the plane, an exact solution of
// (1) and (3) with convection:
//
//     u = U F sin(k x) cos(k y),   v = -U F cos(k x) sin(k y),   F = exp(-2 nu k^2 t)
//     p = rho U^2 F^2/4 (cos 2 k x + cos 2 k y) + const
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace aneurysm::analytic
{

struct TaylorGreen {
    double U = 0;   ///< largest velocity at t = 0 [m/s]
    double k = 0;   ///< the box has a multiple of 2 pi/k as its edge [1/m]
    double rho = 0; ///< [kg/m^3]
    double nu = 0;  ///< kinematic viscosity [m^2/s]

    /// F [1]
    double decay(double t) const { return std::exp(-2 * nu * k * k * t); }
    /// [m/s]
    Eigen::Vector2d velocity(double x, double y, double t) const
    {
        return U * decay(t) *
               Eigen::Vector2d(std::sin(k * x) * std::cos(k * y), -std::cos(k * x) * std::sin(k * y));
    }
    /// With the mean 0 [Pa].
    double pressure(double x, double y, double t) const
    {
        return rho * std::pow(U * decay(t), 2) / 4 * (std::cos(2 * k * x) + std::cos(2 * k * y));
    }
    /// Mean kinetic energy [J/m^3].
    double energy(double t) const { return rho * std::pow(U * decay(t), 2) / 4; }
};

} // namespace aneurysm::analytic
