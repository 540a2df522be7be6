// SPDX-License-Identifier: Apache-2.0
// Oracles of section 3.1 for plane waves on a lattice of equal particles: every answer is the wave times a
// symbol of analytic/lattice.hpp. c = cos(k.r_i), s = sin(k.r_i) at the particle in question.
#pragma once

#include "analytic/lattice/lattice.hpp"

namespace aneurysm::analytic
{

/// Blood at rest on a lattice.
struct Medium {
    Lattice lattice;
    double mass = 0;    ///< of a particle [kg]
    double density = 0; ///< rho, of each [kg/m^3]

    double volume() const { return mass / density; } ///< [m^3]
};

/// Velocity v = v_1 cos(k.r).
struct Wave {
    Eigen::Vector3d k;
    Eigen::Vector3d v_1 = Eigen::Vector3d::Zero();
};

/// Eq. (2)  -m (v_1.G) s; tends to rho (k.v_1) s = -rho div v [kg/(m^3 s)].
Estimate density_rate(const Medium& medium, const Wave& wave, double s);

/// Eq. (5)  m sum_x W(x) [kg/m^3].
Estimate density(const Medium& medium);

/// Eq. (7)  -mu m/rho L v_1 c with L = viscosity_sum; tends to -mu k^2 v [N/m^3].
VectorEstimate viscosity_force(const Medium& medium, double mu, const Wave& wave, double c);

/// Eq. (15)  What a shear wave loses by friction, dv/dt = -rate v:
/// rate = mu m/rho^2 L; tends to mu k^2/rho [1/s].
Estimate shear_decay_rate(const Medium& medium, double mu, const Eigen::Vector3d& k);

/// Eq. (EOS)  Pressure from the speed of sound c^2 = dp/drho = kappa,
/// int c^2 drho from rho_0 by quadrature [Pa].
Estimate pressure_of_sound_speed(double kappa, double rho, double rho_0);

/// Eq. (EOS)  Square of the angular frequency of a sound wave whose displacement a sin(k.r), a parallel to G,
/// is small: kappa m^2 |G|^2/(2 rho^2); tends to kappa k^2/2, since (6) has half of the gradient [1/s^2].
Estimate sound_frequency_squared(const Medium& medium, double kappa, const Eigen::Vector3d& k);

} // namespace aneurysm::analytic
