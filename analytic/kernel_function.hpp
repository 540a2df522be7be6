// SPDX-License-Identifier: Apache-2.0
// Oracles of the kernel W and of the Laplacian of (7):
// truncated powers and expanded polynomials, exact moments.
#pragma once

#include "analytic/gsl.hpp"
#include "common/scenario/scenario.hpp"

#include <functional>

namespace aneurysm::analytic
{

/// A radial function of r [m].
using Radial = std::function<double(double)>;

/// W(r) of Eq. (4) [1/m^3], by powers of the distance from the support's end, s = (2 - q)_+, q = r/h:
///
///     cubic spline   W = [ s^3 - 4 (1 - q)_+^3 ] / (4 pi h^3)
///     Wendland C2    W = 21/(16 pi h^3) ( 5/16 s^4 - 1/8 s^5 )
///
/// The sum of the terms' magnitudes is at most 9 W(0); 16 roundings.
double kernel(KernelName name, double h, double r);

/// Sum of the magnitudes of those terms [1/m^3].
double kernel_terms(KernelName name, double h, double r);

/// dW/dr [1/m^4], term by term from the forms above.
double kernel_slope(KernelName name, double h, double r);

/// Laplacian of Mueller's viscosity kernel, Eq. (7) [1/m^5], from the polynomial of Mueller et al. 2003
/// itself, W_visc = 15/(2 pi H^3) ( -r^3/(2 H^3) + r^2/H^2 + H/(2 r) - 1 ), as (1/r) d^2(r W)/dr^2; r > 0.
/// Rounding error at most gamma_8 times twice the value at r = 0.
double viscosity_kernel_laplacian(double H, double r);

/// Moment of order p, int f(r) r^p dV = int 4 pi r^(2 + p) f dr over the support radius 2 h. Piecewise Gauss
/// rules: no error but rounding for piecewise polynomials with breaks at h and 2 h.
Estimate moment(const Radial& f, double h, int p);

/// The exact moment of W, a rational times h^p: p = 0, 2 or 4.
/// (The second moment an axis is a third of p = 2.)
double exact_moment(KernelName name, double h, int p);

/// int |grad W|^2 dV, exact: 12/(7 pi h^5) and 105/(44 pi h^5).
double exact_gradient_norm(KernelName name, double h);

/// What(k) = int W e^{-i k.x} dV, which only depends on |k| [1]: closed form for the cubic spline,
///
///     What = -3/(h^2 k) d/dk sinc^4(k h/2) = 3 sin^3(x) (sin x - x cos x) / x^6,   x = k h/2,
///
/// and for Wendland's the sine transform of its polynomial by repeated integration by parts.
/// Below k h = 1 the series sum_n (-1)^n k^2n <r^2n> / (2n + 1)! replaces both,
/// where they cancel. The error is that of rounding.
Estimate kernel_transform(KernelName name, double h, double k);

/// Fourier transform of the viscosity Laplacian, [1/m^2]: 180/(H^6 k^4) (2 - 2 cos kH - kH sin kH); 15/H^2 at
/// k = 0.
Estimate viscosity_transform(double H, double k);

} // namespace aneurysm::analytic
