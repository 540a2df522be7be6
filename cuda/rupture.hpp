// SPDX-License-Identifier: Apache-2.0
// Section 3.2: when the wall of the aneurysm ruptures, (8)-(16).
// sigma: Poisson's ratio, phi: porosity, Y: yield limit [Pa],
// R: radius [m], h: wall thickness [m], P: pressure [Pa].
#pragma once

#include "common/host_device.hpp"
#include "common/vec3.hpp"
#include "cuda/executor/lanes.hpp"

#include <cmath>

namespace aneurysm::device
{

/// Eq. (8)  Stress of a thin spherical wall: Sigma = P R / (2 h)                               [Pa]
ANEURYSM_HD inline double wall_stress(double P, double R, double h)
{
    return P * R / (2 * h);
}

/// Eq. (9)  The wall thins as it grows: dh = -sigma h dR / R                                   [m]
ANEURYSM_HD inline double thickness_differential(double sigma, double h, double R, double dR)
{
    return -sigma * h * dR / R;
}

/// Eq. (10)  Porosity falls as the wall's volume rises: dphi = -(2 - sigma) dR / R             [1]
ANEURYSM_HD inline double porosity_differential(double sigma, double R, double dR)
{
    return -(2.0 - sigma) * dR / R;
}

/// Eq. (11)  Stress of a ductile wall with voids: Sigma = -2/3 Y ln phi                        [Pa]
///
/// On the host: no run needs it.
inline double stress_of_porosity(double Y, double phi)
{
    return -2.0 / 3.0 * Y * std::log(phi);
}

/// Eq. (12)  How fast the radius grows with pressure, with its pole at (13):
///
///     dR/dP = (R / 2h) / ( 2 Y (2 - sigma) / (3 R phi) - P (1 + sigma) / (2 h) )             [m/Pa]
ANEURYSM_HD inline double radius_per_pressure(double P, double R, double h, double Y, double sigma,
                                              double phi)
{
    const double strength = 2 * Y * (2 - sigma) / (3 * R * phi);
    const double load = P * (1 + sigma) / (2 * h);
    return (R / (2 * h)) / (strength - load);
}

/// Eq. (13)  The pressure at which dR/dP becomes infinite:
///
///     P_c = 4 h Y (2 - sigma) / (3 R phi (1 + sigma))                                         [Pa]
ANEURYSM_HD inline double critical_pressure(double h, double R, double Y, double sigma, double phi)
{
    return 4 * h * Y * (2 - sigma) / (3 * R * phi * (1 + sigma));
}

/// Eq. (14)  Impulse and momentum, F dt = m v: F = m v / dt                                    [N]
template <class Real>
ANEURYSM_HD Vec3T<Real> impulse_force(Real m, const Vec3T<Real>& v, Real dt)
{
    return m / dt * v;
}

/// The hardest hit so far and who made it: the larger force, of two equal ones the lower particle. A force
/// that is no number counts as the largest, so that it can't hide.
struct Impact {
    double force = 0;     ///< [N]
    double force_eos = 0; ///< largest, with (6) and the equation of state [N]
    Index particle = -1;
    Index count = 0; ///< of S

    ANEURYSM_HD Impact& operator+=(const Impact& b)
    {
        const bool harder =
            b.force > force || std::isnan(b.force) || (b.force == force && b.particle < particle);
        if (b.count > 0 && (count == 0 || harder)) {
            force = b.force;
            particle = b.particle;
        }
        force_eos =
            b.count > 0 && (b.force_eos > force_eos || std::isnan(b.force_eos)) ? b.force_eos : force_eos;
        count += b.count;
        return *this;
    }
};

/// Eq. (16)  The hit of one particle on the wall; F_b is the largest among those of S:
///
///     | m/rho_i (rho_i g + F_i^pressure + F_i^viscosity) |                                    [N]
///
/// `force`: the bracket, a force per volume [N/m^3].
template <class Real>
ANEURYSM_HD Real impact_force(Real m, Real rho, const Vec3T<Real>& force)
{
    return length(m / rho * force);
}

/// The force of the mass M that strikes the wall as the particle of F_b does, whose mass is m. In (21), (28) and the
/// criterion it takes F_b's place:
///
///     F = F_b M / m                                                                           [N]
ANEURYSM_HD inline double wall_load(double F_b, double M, double m)
{
    return F_b * (M / m);
}

/// The criterion of section 3.2: the wall ruptures when its load F, taken as a pressure on `area`, exceeds P_c.
ANEURYSM_HD inline bool ruptures(double F, double area, double P_c)
{
    return F / area > P_c;
}

} // namespace aneurysm::device
