// SPDX-License-Identifier: Apache-2.0
#include "analytic/laminar_flow.hpp"

#include "analytic/bessel.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <cmath>
#include <numbers>

namespace aneurysm::analytic
{
namespace
{

using std::numbers::pi;
using Complex = std::complex<double>;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;
constexpr Complex i(0, 1);

ComplexEstimate quotient(const ComplexEstimate& a, const ComplexEstimate& b)
{
    const Complex q = a.value / b.value;
    return {q, (a.error + std::abs(q) * b.error) / std::abs(b.value) + 8 * u * std::abs(q)};
}

/// z is off by 4 u of itself.
ComplexEstimate hyperbolic_cosine(Complex z)
{
    return {std::cosh(z), (8 + 4 * std::abs(z)) * u * std::exp(std::abs(z.real()))};
}
ComplexEstimate hyperbolic_sine(Complex z)
{
    return {std::sinh(z), (8 + 4 * std::abs(z)) * u * std::exp(std::abs(z.real()))};
}

/// Im(U e^(i omega t)) for U off by `error`.
Estimate at_time(const ComplexEstimate& U, double omega, double t)
{
    return {(U.value * std::exp(i * omega * t)).imag(),
            U.error + (8 + 4 * std::abs(omega * t)) * u * std::abs(U.value)};
}

/// factor (1 - x)
ComplexEstimate deficit(Complex factor, const ComplexEstimate& x)
{
    const Complex rest = 1.0 - x.value;
    return {factor * rest,
            std::abs(factor) * (x.error + u * (1 + std::abs(x.value)) + 8 * u * std::abs(rest))};
}

/// sqrt(i omega/nu), by which the pulsating flow decays from the wall [1/m]
Complex wave_number(const Duct& duct, const Drive& drive)
{
    return std::sqrt(i * drive.omega / duct.nu);
}

/// C(l r)/C(l a), C = cosh or J_0(i x).
ComplexEstimate profile(const Duct& duct, Complex l, double r,
                        ComplexEstimate (*bessel)(int, Complex) = bessel_by_series)
{
    if (duct.section == Section::channel) {
        return quotient(hyperbolic_cosine(l * r), hyperbolic_cosine(l * duct.a));
    }
    // the argument is off by 6 u of itself, and |J_0'| <= e^|Im z|
    const auto J_0 = [&](Complex z) {
        ComplexEstimate J = bessel(0, z);
        J.error += 6 * u * std::abs(z) * std::exp(std::abs(z.imag()));
        return J;
    };
    return quotient(J_0(i * l * r), J_0(i * l * duct.a));
}

/// What d/d(l r) of the profile is at the wall: tanh(l a), or -i J_1/J_0 of i l a.
ComplexEstimate wall_slope(const Duct& duct, Complex l)
{
    const Complex z = l * duct.a;
    if (duct.section == Section::channel) {
        return quotient(hyperbolic_sine(z), hyperbolic_cosine(z));
    }
    ComplexEstimate slope = quotient(bessel_by_series(1, i * z), bessel_by_series(0, i * z));
    slope.value *= -i;
    slope.error +=
        6 * u * std::abs(z) * (1 + std::norm(slope.value)); // its derivative, by Riccati's equation
    return slope;
}

double area(const Duct& duct)
{
    return duct.section == Section::channel ? 2 * duct.a : pi * duct.a * duct.a;
}

/// What e^(-lambda t) is multiplied by in T_n.
double starting_amplitude(const Drive& drive, double lambda)
{
    return drive.steady() ? -drive.g / lambda
                          : drive.g * drive.omega / (lambda * lambda + drive.omega * drive.omega);
}

/// One term's wave number and b_n.
struct Mode {
    double k = 0; ///< [1/m]
    double b = 0; ///< [1]
};
Mode mode(const Duct& duct, int n)
{
    if (duct.section == Section::channel) {
        const double ka = (n + 0.5) * pi;
        return {ka / duct.a, (n % 2 == 0 ? 2 : -2) / ka};
    }
    const double ka = gsl_sf_bessel_zero_J0(static_cast<unsigned>(n + 1));
    return {ka / duct.a, 2 / (ka * gsl_sf_bessel_J1(ka))};
}

/// sum_n T_n(t) weight(mode), where |weight(mode)| <= largest for all modes. Terms from N on have
/// k_n a >= (n + 1/2) pi, or (n + 3/4) pi in a pipe, so sum 1/lambda_n and sum 1/lambda_n^2 from there are
/// below (a^2/(nu pi^2)) / (N - 1/2) and (a^2/(nu pi^2))^2 / (3 (N - 1/2)^3).
template <class Weight>
Estimate transient(const Duct& duct, const Drive& drive, double t, double largest, Weight weight)
{
    constexpr int most = 1000;
    Estimate sum;
    int N = 0;
    double decay = 1;
    for (; N < most && decay > u * u; ++N) {
        const Mode m = mode(duct, N);
        const double lambda = duct.nu * m.k * m.k;
        decay = std::exp(-lambda * t);
        const double term = starting_amplitude(drive, lambda) * decay * weight(m);
        sum.value += term;
        // zeros of J_0 are good to 4 u; k r <= j_n makes that an error of phi_n
        sum.error += (64 + 8 * m.k * duct.a + 12 * lambda * t) * u *
                     std::abs(starting_amplitude(drive, lambda)) * decay * largest;
        sum.error += u * std::abs(sum.value);
    }
    const double unit = duct.a * duct.a / (duct.nu * pi * pi);
    const double from = N - 0.5;
    const double tail = drive.steady() ? unit / from : drive.omega * unit * unit / (3 * from * from * from);
    sum.error += std::abs(drive.g) * tail * decay * largest;
    return sum;
}

Estimate sum(const Estimate& a, const Estimate& b)
{
    return {a.value + b.value, a.error + b.error + u * std::abs(a.value + b.value)};
}

/// A product of few factors.
Estimate product(double value)
{
    return {value, 8 * u * std::abs(value)};
}

} // namespace

double womersley_number(const Duct& duct, const Drive& drive)
{
    return duct.a * std::sqrt(drive.omega / duct.nu);
}

Estimate developed_velocity(const Duct& duct, const Drive& drive, double r, double t)
{
    if (drive.steady()) {
        const double dimensions = duct.section == Section::channel ? 1 : 2;
        return product(drive.g / (2 * dimensions * duct.nu) * (duct.a - r) * (duct.a + r));
    }
    const Complex driven = drive.g / (i * drive.omega);
    return at_time(deficit(driven, profile(duct, wave_number(duct, drive), r)), drive.omega, t);
}

Estimate developed_flow_rate(const Duct& duct, const Drive& drive, double t)
{
    if (drive.steady()) {
        const double parabola = duct.section == Section::channel ? 1.0 / 3 : 1.0 / 8;
        return product(area(duct) * parabola * drive.g * duct.a * duct.a / duct.nu);
    }
    const double dimensions = duct.section == Section::channel ? 1 : 2;
    const Complex l = wave_number(duct, drive);
    ComplexEstimate mean = wall_slope(duct, l); // the profile's mean over the section
    mean.value *= dimensions / (l * duct.a);
    mean.error = mean.error * dimensions / std::abs(l * duct.a) + 12 * u * std::abs(mean.value);
    return at_time(deficit(area(duct) * drive.g / (i * drive.omega), mean), drive.omega, t);
}

Estimate developed_wall_shear(const Duct& duct, const Drive& drive, double t)
{
    if (drive.steady()) {
        const double dimensions = duct.section == Section::channel ? 1 : 2;
        return product(drive.g * duct.a / (dimensions * duct.nu));
    }
    const Complex l = wave_number(duct, drive);
    ComplexEstimate shear = wall_slope(duct, l);
    const Complex factor = drive.g / (i * drive.omega) * l;
    shear.value *= factor;
    shear.error = shear.error * std::abs(factor) + 12 * u * std::abs(shear.value);
    return at_time(shear, drive.omega, t);
}

Estimate velocity(const Duct& duct, const Drive& drive, double r, double t)
{
    constexpr double largest = 1.7; // |b_n phi_n| <= b_0: 4/pi in a channel, 1.602 in a pipe
    return sum(developed_velocity(duct, drive, r, t), transient(duct, drive, t, largest, [&](const Mode& m) {
                   return m.b *
                          (duct.section == Section::channel ? std::cos(m.k * r) : gsl_sf_bessel_J0(m.k * r));
               }));
}

Estimate flow_rate(const Duct& duct, const Drive& drive, double t)
{
    // b_n int phi_n dA
    const double share = duct.section == Section::channel ? 4 / duct.a : 4 * pi;
    const double k_0 = mode(duct, 0).k;
    return sum(
        developed_flow_rate(duct, drive, t),
        transient(duct, drive, t, share / (k_0 * k_0), [&](const Mode& m) { return share / (m.k * m.k); }));
}

Estimate wall_shear(const Duct& duct, const Drive& drive, double t)
{
    // -b_n dphi_n/dr at the wall, the same for all n
    const double share = 2 / duct.a;
    return sum(developed_wall_shear(duct, drive, t),
               transient(duct, drive, t, share, [&](const Mode&) { return share; }));
}

Estimate velocity_by_laplace(const Duct& duct, const Drive& drive, double r, double t)
{
    constexpr double farthest = 6;
    if (!(t > 0) || drive.omega * t >= farthest) {
        throw std::invalid_argument("velocity_by_laplace: time outside the contour's reach");
    }
    const auto transform = [&](Complex s) {
        const Complex force =
            drive.steady() ? drive.g / s : drive.g * drive.omega / (s * s + drive.omega * drive.omega);
        return deficit(force / s, profile(duct, std::sqrt(s / duct.nu), r, bessel_by_integral));
    };
    const auto along_contour = [&](int N) {
        Estimate sum;
        for (int n = 0; n < N; ++n) {
            const double theta = (2 * n + 1 - N) * pi / N;
            const double c = 1 / std::tan(0.6407 * theta);
            const Complex z = 1.0 * N * (0.5017 * theta * c - 0.6122 + 0.2645 * i * theta);
            const Complex slope = 0.5017 * (c - 0.6407 * theta * (1 + c * c)) + 0.2645 * i;
            const ComplexEstimate f = transform(z / t);
            const Complex weight = -i * std::exp(z) * slope / t;
            sum.value += (weight * f.value).real();
            sum.error += std::abs(weight) * (f.error + (16 + 8 * std::abs(z)) * u * std::abs(f.value));
        }
        return sum;
    };
    const int points = 32 + 8 * static_cast<int>(std::ceil(drive.omega * t));
    const Estimate coarse = along_contour(points - 8);
    const Estimate fine = along_contour(points);
    return {fine.value, fine.error + coarse.error + std::abs(fine.value - coarse.value)};
}

} // namespace aneurysm::analytic
