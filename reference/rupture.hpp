// SPDX-License-Identifier: Apache-2.0
// Section 3.2: when the wall of the aneurysm ruptures, (8)-(16).
// sigma: Poisson's ratio, phi: porosity, Y: yield limit [Pa],
// R: radius [m], h: wall thickness [m], P: pressure [Pa].
#pragma once

#include "common/vec3.hpp"
#include "common/wall.hpp"

#include <cmath>
#include <cstdint>
#include <span>

namespace aneurysm::reference
{

/// Eq. (8)  Laplace's law of a thin sphere, P pi R^2 = Sigma 2 pi R h, solved for the wall's stress:
///
///     Sigma = P R / (2 h)                                                                     [Pa]
inline double wall_stress(double P, double R, double h)
{
    return P * R / (2 * h);
}

/// Eq. (9)  The wall thins as it grows, dh/h = -sigma dR/R:
///
///     dh = -sigma h dR / R                                                                    [m]
inline double thickness_differential(double sigma, double h, double R, double dR)
{
    return -sigma * h * dR / R;
}

/// Eq. (10)  Porosity falls as the wall's volume V = 4 pi R^2 h rises; with (9) dV/V = (2 - sigma) dR/R:
///
///     dphi = -dV / V = -(2 - sigma) dR / R                                                    [1]
inline double porosity_differential(double sigma, double R, double dR)
{
    return -(2.0 - sigma) * dR / R;
}

/// Eq. (11)  Stress of a ductile wall with voids:
///
///     Sigma = -2/3 Y ln phi                                                                   [Pa]
inline double stress_of_porosity(double Y, double phi)
{
    return -2.0 / 3.0 * Y * std::log(phi);
}

/// Eq. (12)  How fast the radius grows with pressure, from (8)-(11):
///
///     dR/dP = (R / 2h) / ( 2 Y (2 - sigma) / (3 R phi) - P (1 + sigma) / (2 h) )             [m/Pa]
///
/// Positive below the critical pressure (13), where it has its pole, and negative above.
inline double radius_per_pressure(double P, double R, double h, double Y, double sigma, double phi)
{
    return (R / (2 * h)) / (2 * Y * (2 - sigma) / (3 * R * phi) - P * (1 + sigma) / (2 * h));
}

/// Eq. (13)  The pressure at which dR/dP becomes infinite:
///
///     P_c = 4 h Y (2 - sigma) / (3 R phi (1 + sigma))                                         [Pa]
inline double critical_pressure(double h, double R, double Y, double sigma, double phi)
{
    return 4 * h * Y * (2 - sigma) / (3 * R * phi * (1 + sigma));
}

/// Eq. (14)  Impulse and momentum, F dt = m v, solved for the force:
///
///     F = m v / dt                                                                            [N]
inline Vec3 impulse_force(double m, const Vec3& v, double dt)
{
    return m / dt * v;
}

/// Eq. (16)  The hardest hit on the wall among the particles of S:
///
///     F_b = max_{i in S} | m/rho_i (rho_i g + F_i^pressure + F_i^viscosity) |                 [N]
///
/// `force`: the bracket, a force per volume [N/m^3], by particle index; `density`: rho by particle index.
inline Impact impact_force(std::span<const std::int64_t> S, double m, std::span<const double> density,
                           std::span<const Vec3> force)
{
    Impact impact;
    for (const std::int64_t i : S) {
        const auto k = static_cast<std::size_t>(i);
        const double F = length(m / density[k] * force[k]);
        if (impact.particle < 0 || F > impact.force || std::isnan(F)) { // a NaN must not hide
            impact = {F, i};
        }
    }
    return impact;
}

/// The force of the mass M that strikes the wall as the particle of F_b does, whose mass is m. F_b / m is an
/// acceleration, while F_b goes with the particle's mass. In (21), (28) and the criterion this takes F_b's place:
///
///     F = F_b M / m                                                                           [N]
inline double wall_load(double F_b, double M, double m)
{
    return F_b * (M / m);
}

/// The criterion of section 3.2: the wall ruptures when its load F, taken as a pressure on `area`, exceeds P_c.
inline bool ruptures(double F, double area, double P_c)
{
    return F / area > P_c;
}

} // namespace aneurysm::reference
