// SPDX-License-Identifier: Apache-2.0
// Oracles of section 3.3, (17)-(23).
#pragma once

#include "analytic/gsl.hpp"

namespace aneurysm::analytic
{

/// What resists the growth of a sac: mass, radiation into the tissue fluid, fibers.
struct Resistance {
    double m = 0;         ///< [kg]
    double impedance = 0; ///< rho_F a c [kg/s]
    double stiffness = 0; ///< K_E A_E + K_C A_C [N]

    double inertia(double dt) const { return m / (dt * dt) + impedance / dt; } ///< [N/m]
};

/// The unknowns of one step.
struct Balance {
    Estimate dR;     ///< [m]
    Estimate speed;  ///< u_t [m/s]
    Estimate strain; ///< epsilon [1]
    Estimate tissue; ///< F_F [N]
    Estimate fibers; ///< F_P [N]
    Estimate net;    ///< F_T [N]
};

/// Eq. (17), Eq. (18), Eq. (19), Eq. (20) and Eq. (21) as one linear system of the six unknowns, which is one
/// backward-Euler step from rest of m x'' + rho_F a c x' + (K/R) x = F_B. Solved by elimination; the errors
/// are Higham's a posteriori bound, |A^-1| (|b - A x| + gamma_7 (|A||x| + |b|)).
Balance backward_euler_from_rest(const Resistance& wall, double F_B, double R, double dt);

/// Eq. (18)  Momentum that a wall at speed u_t gives a fluid column each second: the wave takes up c dt of it
/// [N]; relative error 8 u.
double column_momentum_rate(double rho_F, double a, double c, double u_t, double dt);

/// Eq. (19)  Force of the fibers, the derivative of their energy K A epsilon^2/2 by the complex step [N];
/// relative error 16 u.
double fiber_energy_slope(double K_E, double A_E, double K_C, double A_C, double epsilon);

/// Eq. (20)  Strain of the sac's circumference: int dl over the grown circle against the old one [1].
Estimate circumference_strain(double dR, double R);

/// Eq. (21)  Where repeated steps under a constant force lead: M = m/dt^2 + rho_F a c/dt, K the stiffness,
/// N = n - 1/2 ln(f(R_n)/f(R_0)), f(R) = F R/(M R + K) the increment,
///
///     R(N) = K/M W_0[ M R_0/K exp( (M R_0 + F N)/K ) ]                                            [m]
///
/// the flow of dR/dn = f with the first correction of backward error analysis. The error is the next one,
/// (max |f'| |ln f_n/f_0| + |f'_n - f'_0|)/12 steps of f, and that of W.
Estimate radius_after_steps(const Resistance& wall, double F, double R_0, double dt, int n);

/// Eq. (22)  n equal steps D exactly: h_0 prod (1 - sigma D/R_k) = h_0 Gamma(x + n - sigma) Gamma(x) /
/// (Gamma(x - sigma) Gamma(x + n)), x = R_0/D [m].
Estimate thickness_after_steps(double h_0, double R_0, double sigma, double D, int n);

/// Eq. (22)  Relative error of those steps against the power law of (9), by Euler-Maclaurin: with
/// A_p = 1/R_0^p - 1/R_n^p,
///
///     ln(h_n/h) = -D/2 sigma (1 + sigma) A_1 - D^2 A_2 (sigma/12 + sigma^2/4 + sigma^3/6)
///                 - D^3 A_3 (sigma^2/12 + sigma^3/6 + sigma^4/12) + O(D^4)
///
/// The error is the third-order term times x/(1 - x), x = D/R_0: the further orders fall at least like a
/// geometric series in x.
Estimate euler_thinning_error(double R_0, double sigma, double D, int n);

/// Eq. (23)  n equal steps: h_0 (1 - alpha D)^n as exp(n log1p(-alpha D)) [m].
Estimate thickness_developed_after_steps(double h_0, double alpha, double D, int n);

/// Eq. (23)  Relative distance of those steps from their limit h_0 exp(-alpha n D): expm1(-n (x^2/2 + r)), x
/// = alpha D, where r = x^3/3 + x^4/4 + ... lies between x^3/3 and x^3/(3 (1 - x)); the middle of that, and
/// half of it as the error.
Estimate exponential_thinning_error(double alpha, double D, int n);

} // namespace aneurysm::analytic
