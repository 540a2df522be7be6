// SPDX-License-Identifier: Apache-2.0
// Exact flows of a viscous fluid along a straight duct with walls at rest, driven by a force g(t) per mass:
// the solutions of (1) with (27) where nothing changes along the duct,
//
//     du/dt = g(t) + nu lap u,   u = 0 at the wall, u = 0 at t = 0,
//
// named after Poiseuille (steady) and Womersley (pulsating). White, Viscous Fluid Flow, 3-3 and 3-5.
#pragma once

#include "analytic/gsl.hpp"

namespace aneurysm::analytic
{

enum class Section {
    channel, ///< between planes, |r| <= a; flow rates are per depth
    pipe,    ///< circular, 0 <= r <= a
};

struct Duct {
    Section section = Section::channel;
    double a = 0;  ///< from the middle to the wall [m]
    double nu = 0; ///< kinematic viscosity [m^2/s]
};

/// g(t) = g, or g sin(omega t) if omega is not 0.
struct Drive {
    double g = 0;     ///< [m/s^2]
    double omega = 0; ///< [1/s]

    bool steady() const { return omega == 0; }
};

/// alpha = a sqrt(omega/nu) [1]
double womersley_number(const Duct& duct, const Drive& drive);

// What the flow tends to, whatever it started from. Steady: Poiseuille's parabola,
//
//     channel  u = g/(2 nu) (a^2 - r^2),   Q = 2 g a^3/(3 nu),     -du/dr = g a/nu at the wall
//     pipe     u = g/(4 nu) (a^2 - r^2),   Q = pi g a^4/(8 nu),    -du/dr = g a/(2 nu)
//
// and pulsating: Womersley's profile, the imaginary part of e^(i omega t) times
//
//     channel  g/(i omega) [1 - cosh(l r)/cosh(l a)],     l = sqrt(i omega/nu)
//     pipe     g/(i omega) [1 - J_0(i l r)/J_0(i l a)].
//
// The bracket cancels as alpha tends to 0, which the error says.

/// Eq. (1) with Eq. (27)  [m/s]
Estimate developed_velocity(const Duct& duct, const Drive& drive, double r, double t);
/// Its integral over the cross-section: [m^2/s] in a channel, [m^3/s] in a pipe.
Estimate developed_flow_rate(const Duct& duct, const Drive& drive, double t);
/// Its -du/dr at the wall, which times mu is the wall's shear stress [1/s].
Estimate developed_wall_shear(const Duct& duct, const Drive& drive, double t);

// From rest: what the flow tends to and the transient sum_n b_n T_n(t) phi_n(r), where 1 = sum_n b_n phi_n,
//
//     channel  phi_n = cos(k_n r),  k_n a = (n + 1/2) pi,     b_n = 2 (-1)^n/(k_n a)
//     pipe     phi_n = J_0(k_n r),  k_n a = j_n, J_0's zeros, b_n = 2/(k_n a J_1(k_n a))
//
// and with lambda = nu k_n^2, T_n = -g/lambda e^(-lambda t) if steady, else
// g omega/(lambda^2 + omega^2) e^(-lambda t). The errors include a bound of all terms that are left out.

/// Eq. (1) with Eq. (27)  [m/s]
Estimate velocity(const Duct& duct, const Drive& drive, double r, double t);
/// [m^2/s] in a channel, [m^3/s] in a pipe
Estimate flow_rate(const Duct& duct, const Drive& drive, double t);
/// [1/s]
Estimate wall_shear(const Duct& duct, const Drive& drive, double t);

/// Eq. (1) with Eq. (27)  velocity(), t > 0, from its Laplace transform, without any series in r or t [m/s]:
///
///     u = 1/(2 pi i) int e^(s t) ghat(s)/s [1 - C(r sqrt(s/nu))/C(a sqrt(s/nu))] ds,
///     C(x) = cosh x, J_0(i x)
///
/// along Talbot's contour with the constants of Weideman (SIAM J. Numer. Anal. 44, 2006), by the midpoint
/// rule; the error is the change since 8 points fewer. The contour encloses +- i omega while omega t < 6.
/// \throws std::invalid_argument beyond
Estimate velocity_by_laplace(const Duct& duct, const Drive& drive, double r, double t);

} // namespace aneurysm::analytic
