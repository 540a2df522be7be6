// SPDX-License-Identifier: Apache-2.0
// Section 3.1: blood flow by smoothed particle hydrodynamics, (1), (4)-(7), (15) and the equation of state. Sums
// run over the neighbors j of body i, which include i itself.
#pragma once

#include "reference/neighbors.hpp"

#include <span>

namespace aneurysm::reference
{

/// Eq. (1)  The forces on a unit volume of blood, rho Dv/Dt = rho g + mu lap v - grad p:
///
///     F = rho g + F^viscosity + F^pressure                                                    [N/m^3]
inline Vec3 momentum_force(double rho, const Vec3& g, const Vec3& F_viscosity, const Vec3& F_pressure)
{
    return rho * g + F_viscosity + F_pressure;
}

/// Eq. (4)  A field at any point r from its values A_j at the bodies:
///
///     A(r) = sum_j A_j m_j / rho_j W(r - r_j, h)                                              [A]
inline double interpolate(const Bodies& b, std::span<const double> rho, std::span<const double> A,
                          const Kernel& W, const Vec3& r)
{
    double value = 0;
    for (std::size_t j = 0; j < b.size(); ++j) {
        if (b.role[j] != Role::absent) {
            const double w = W.value(length(r - b.position[j]));
            value += A[j] * b.mass[j] / rho[j] * w;
        }
    }
    return value;
}

/// Eq. (5)  Density by summation:
///
///     rho_i = sum_j m_j W_ij                                                                  [kg/m^3]
inline double density(const Bodies& b, std::span<const Neighbor> neighbors)
{
    double rho = 0;
    for (const Neighbor& n : neighbors) {
        rho += b.mass[n.j] * n.W;
    }
    return rho;
}

/// Eq. (EOS)  Equation of state:
///
///     p_i = kappa (rho_i - rho_0)                                                             [Pa]
inline double equation_of_state(double kappa, double rho, double rho_0)
{
    return kappa * (rho - rho_0);
}

/// Eq. (6)  Pressure force, literally:
///
///     F_i^pressure = -sum_j m_j (p_i + p_j) / (2 rho_j) grad W_ij                             [N/m^3]
///
/// A wall's ghost and the inlet's blood have their neighbor's pressure p_i.
/// The printed mean makes this half of -grad p.
inline Vec3 pressure_force(const Bodies& b, std::span<const Neighbor> neighbors, std::span<const double> rho,
                           std::span<const double> p, std::size_t i)
{
    Vec3 force;
    for (const Neighbor& n : neighbors) {
        const double p_j = b.free(n.j) ? p[n.j] : p[i];
        force += -b.mass[n.j] * (p[i] + p_j) / (2 * rho[n.j]) * n.grad_W;
    }
    return force;
}

/// Eq. (7)  Viscosity force:
///
///     F_i^viscosity = mu sum_j m_j (v_j - v_i) / rho_j lap W_ij                               [N/m^3]
///
/// over all j but the ghosts of a wall that lets blood slip; v: by body, that of a wall's ghosts from (27).
inline Vec3 viscosity_force(const Bodies& b, std::span<const Neighbor> neighbors, std::span<const double> rho,
                            std::span<const Vec3> v, double mu, std::size_t i)
{
    Vec3 force;
    for (const Neighbor& n : neighbors) {
        if (b.role[n.j] == Role::slip) {
            continue;
        }
        force += mu * b.mass[n.j] / rho[n.j] * n.lap_W * (v[n.j] - v[i]);
    }
    return force;
}

/// Eq. (15)  Acceleration of a particle by the force (1):
///
///     a_i = (rho_i g + F_i^pressure + F_i^viscosity) / rho_i                                  [m/s^2]
inline Vec3 acceleration(double rho, const Vec3& force)
{
    return force / rho;
}

} // namespace aneurysm::reference
