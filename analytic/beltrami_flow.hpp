// SPDX-License-Identifier: Apache-2.0
// An oracle of (1) and (15): a flow that solves them exactly, and every term of theirs at one of its points.
#pragma once

#include <Eigen/Core>

namespace aneurysm::analytic
{

/// Blood and the flow of Arnold, Beltrami and Childress in it, whose curl is k times itself:
///
///     v = exp(-mu k^2 t/rho) (A sin kz + C cos ky, B sin kx + A cos kz, C sin ky + B cos kx)
///     p = rho g.r - rho v^2/2
struct BeltramiFlow {
    double rho = 0;    ///< [kg/m^3]
    double mu = 0;     ///< [Pa s]
    Eigen::Vector3d g; ///< [m/s^2]
    double k = 0;      ///< [1/m]
    double A = 0;      ///< [m/s]
    double B = 0;      ///< [m/s]
    double C = 0;      ///< [m/s]
};

/// Its terms at a point, each rounded once.
struct MomentumTerms {
    Eigen::Vector3d viscosity;    ///< mu lap v [N/m^3]
    Eigen::Vector3d pressure;     ///< -grad p [N/m^3]
    Eigen::Vector3d force;        ///< rho Dv/Dt [N/m^3]
    Eigen::Vector3d acceleration; ///< Dv/Dt [m/s^2]
};

/// Eq. (1) and Eq. (15)  From v and p alone, by differences with 50 digits; Dv/Dt along the particle's way.
MomentumTerms momentum_terms(const BeltramiFlow& flow, const Eigen::Vector3d& r, double t);

} // namespace aneurysm::analytic
