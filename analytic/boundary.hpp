// SPDX-License-Identifier: Apache-2.0
// Oracles of section 3.5, (25)-(28), and of the collision handling of Fig. 1.
#pragma once

#include "analytic/gsl.hpp"
#include "common/scenario/scenario.hpp"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace aneurysm::analytic
{

/// Eq. (25)  v_0 times a waveform that GSL's own trigonometric functions know: sin, |sin|, sin^2(x/2 + pi/4)
/// = (1 + sin x)/2, 1; x = 2 pi t/T [m/s].
Estimate waveform_velocity(Waveform waveform, double v_0, double T, double t);

/// Eq. (25)  A table, periodic and piecewise linear, by gsl_interp [m/s];
/// relative error 8 u of the largest entry.
double interpolated_velocity(std::vector<double> time, std::vector<double> velocity, double T, double t);

/// Eq. (25)  What a velocity transports in a cycle, int_0^T v dt, by quadrature between breaks [m].
Estimate cycle_transport(const std::function<double(double)>& velocity, const std::vector<double>& breaks);

/// Eq. (25)  The exact transport of each waveform, in units of v_0 T: 0, 2/pi, 1/2, 1.
double exact_transport(Waveform waveform);

/// Eq. (26)  Force per volume on blood at the depth z in a half space of blood on a cubic lattice of spacing dx
/// (at the depths dx/2, 3/2 dx, ..., one of the columns through z), from the kernel's own text: 2 p dx^3 sum_j
/// dW/dz [N/m^3], along the normal into the half space.
Estimate outlet_force(KernelName name, double h, double dx, double p, double z);

/// Eq. (26)  The same for a continuum, 2 p int W dx dy over the plane at the distance z, by quadrature. Over
/// all depths it amounts to p.
Estimate outlet_force_continuum(KernelName name, double h, double p, double z);

/// Eq. (27)  Velocity at the distance y from a wall at rest, t after the fluid was set in motion with U
/// (Stokes' first problem): U erf(y/(2 sqrt(nu t))) [m/s].
double started_flow(double U, double nu, double t, double y);

/// Wall of (28): m u'' = F - k u.
struct Oscillator {
    double m = 0;   ///< [kg]
    double k = 0;   ///< [N/m]
    double u_0 = 0; ///< displacement at 0 [m]
    double v_0 = 0; ///< velocity at 0 [m/s]

    double frequency() const { return std::sqrt(k / m); } ///< [rad/s]
};

/// Eq. (28)  Displacement under a constant force F, from t = 0 [m]:
///
///     u = F/k + (u_0 - F/k) cos wt + v_0/w sin wt
double displacement(const Oscillator& wall, double F, double t);

/// Eq. (28)  Displacement under F sin(Ot) [m], resonance O = w included:
///
///     u = u_0 cos wt + v_0/w sin wt + F/(m (w^2 - O^2)) [ sin Ot - O/w sin wt ]
///     u = u_0 cos wt + v_0/w sin wt + F/(2 m w^2) [ sin wt - wt cos wt ]                          O = w
double displacement_driven(const Oscillator& wall, double F, double O, double t);

/// Eq. (28)  What a force adds to the free motion, by quadrature of the response to each of its impulses
/// (Duhamel's integral), int_0^t F(s) sin(w(t - s))/(m w) ds [m].
Estimate driven_response(const Oscillator& wall, const std::function<double(double)>& force, double t);

/// Eq. (28)  What n symplectic Euler steps give, exactly: theta = 2 asin(w dt/2), force F + G sin(O k dt) in
/// the step from k to k + 1,
///
///     u_n = F/k + A cos(n theta) + B sin(n theta) + G_n,
///     G_n = G dt^2/m sin(O n dt)/((w dt)^2 - 4 sin^2(O dt/2))
///
/// The error is that of the angle, n theta u, and of ten operations.
Estimate displacement_after_steps(const Oscillator& wall, double F, double G, double O, double dt, int n);

/// Eq. (28)  v^2/2 + w^2 x^2/2 - dt/2 w^2 x v, x = displaced - F/k: what those steps conserve [m^2/s^2].
double step_invariant(const Oscillator& wall, double F, double dt, double displaced, double v);

/// Eq. (28)  The wall that carries a column of blood of mass M, from rest under F: in each step the column
/// answers with -M times the wall's last change of velocity over dt. With x = u - F/k = z^n,
///
///     (z - 1)^2 (m z + M) + k dt^2 z^2 = 0
///
/// whose roots by GSL, with Newton's method in long double, give u_n by Lagrange's formula for x_0 = x_-1 =
/// x_-2 = -F/k. M < m, else the steps grow.
Estimate wall_with_column(const Oscillator& wall, double M, double F, double dt, int n);

/// Fig. 1  The velocity mirrored at the tangential plane: (I - 2 n n^T) v [m/s].
Eigen::Vector3d mirrored(const Eigen::Vector3d& v, const Eigen::Vector3d& n);

} // namespace aneurysm::analytic
