// SPDX-License-Identifier: Apache-2.0
#include "analytic/bessel.hpp"

#include <array>
#include <numbers>

namespace aneurysm::analytic
{
namespace
{

using std::numbers::pi;
using Complex = std::complex<double>;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// y and y' of Bessel's equation along the ray in the direction e.
int slope_along_ray(double s, const double* y, double* dyds, void* direction)
{
    const Complex e = *static_cast<const Complex*>(direction);
    const Complex value(y[0], y[1]);
    const Complex slope(y[2], y[3]);
    const Complex bend = s > 0 ? -e * e * value - slope / s : -e * e * value / 2.0;
    dyds[0] = slope.real();
    dyds[1] = slope.imag();
    dyds[2] = bend.real();
    dyds[3] = bend.imag();
    return GSL_SUCCESS;
}

} // namespace

ComplexEstimate bessel_by_series(int n, Complex z)
{
    const Complex w = -z * z / 4.0;
    Complex term = n == 0 ? Complex(1) : z / 2.0;
    ComplexEstimate sum{term, 8 * u * std::abs(term)};
    double largest = std::abs(term);
    for (int k = 1; std::abs(term) > u * u * largest; ++k) {
        term *= w / static_cast<double>(k * (k + n));
        sum.value += term;
        // each factor has 8 roundings: z squared, the quotient and the product
        sum.error += (8 * k + 8) * u * std::abs(term) + u * std::abs(sum.value);
        largest = std::max(largest, std::abs(term));
    }
    return sum;
}

ComplexEstimate bessel_by_integral(int n, Complex z)
{
    const double size = std::abs(z);
    const int N = 48 + 2 * static_cast<int>(std::ceil(size));
    const Complex i(0, 1);
    ComplexEstimate sum;
    for (int point = 0; point < N; ++point) {
        const double t = 2 * pi * point / N;
        const Complex term = std::exp(i * (z * std::sin(t) - n * t)) / static_cast<double>(N);
        sum.value += term;
        // the exponent has at most 6 roundings, of which its own size makes an error of the exponential
        sum.error += (N + 4 + 6 * (size + n * t)) * u * std::abs(term);
    }
    // both signs of m, and the rest of a series that falls faster than 2^-m
    const int nearest = N - n;
    sum.error +=
        4 * std::exp(nearest * std::log(size / 2 + u) - std::lgamma(nearest + 1) + std::abs(z.imag()));
    return sum;
}

ComplexEstimate bessel_by_ode(int n, Complex z)
{
    constexpr double step_error = 1e-14;
    gsl_return_errors();
    const double end = std::abs(z);
    Complex e = z / end;
    const gsl_odeiv2_system system{slope_along_ray, nullptr, 4, &e};
    const Owned<gsl_odeiv2_driver, gsl_odeiv2_driver_free> driver(
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, end / 100, step_error, step_error));
    std::array<double, 4> y{1, 0, 0, 0};
    double s = 0;
    gsl_check(gsl_odeiv2_driver_apply(driver.get(), &s, end, y.data()), "Bessel's equation");
    const Complex value(y[0], y[1]);
    const Complex slope(y[2], y[3]);
    const double size = 1 + std::abs(value) + std::abs(slope);
    return {n == 0 ? value : -slope / e, static_cast<double>(driver->n) * 2 * step_error * size};
}

} // namespace aneurysm::analytic
