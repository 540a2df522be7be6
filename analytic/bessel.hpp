// SPDX-License-Identifier: Apache-2.0
// Bessel functions J_0 and J_1 of complex argument, which GSL doesn't have, in three independent ways.
#pragma once

#include "analytic/gsl.hpp"

#include <complex>

namespace aneurysm::analytic
{

/// A complex number and the bound of its absolute error.
struct ComplexEstimate {
    std::complex<double> value;
    double error = 0;
};

/// J_n(z), n = 0 or 1 [1], by the power series
///
///     J_n(z) = (z/2)^n sum_k (-z^2/4)^k / (k! (k + n)!).
///
/// Its terms cancel: the error is about u times the sum of their magnitudes, I_n(|z|).
ComplexEstimate bessel_by_series(int n, std::complex<double> z);

/// J_n(z), n = 0 or 1 [1], by the trapezoidal rule for Bessel's integral
///
///     J_n(z) = 1/(2 pi) int_0^2pi exp(i (z sin t - n t)) dt.
///
/// With N points the rule gives sum_m J_{n + m N}(z),
/// so the error but for rounding is the terms with m other than 0, |J_k(z)| <= |z/2|^k / k! e^|Im z|.
/// It loses nothing to cancellation where J_n is as large as e^|Im z|.
ComplexEstimate bessel_by_integral(int n, std::complex<double> z);

/// J_n(z), n = 0 or 1 [1], by GSL's integration of Bessel's equation along the ray from 0 to z = s e,
///
///     d^2y/ds^2 + 1/s dy/ds + e^2 y = 0,   y(0) = 1, y'(0) = 0;   J_0 = y, J_1 = -y'/e.
///
/// The error is that of all steps, and holds where neighboring solutions don't diverge from y: on rays on
/// which no other grows faster.
ComplexEstimate bessel_by_ode(int n, std::complex<double> z);

} // namespace aneurysm::analytic
