// SPDX-License-Identifier: Apache-2.0
#include "analytic/kernel_function.hpp"

#include <array>
#include <numbers>

namespace aneurysm::analytic
{
namespace
{

using std::numbers::pi;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

double positive_part(double x)
{
    return x > 0 ? x : 0;
}

/// Coefficients of q^0 .. q^5 of Wendland's C2 kernel, 1 at q = 0.
constexpr std::array<double, 6> wendland{1, 0, -5.0 / 2, 5.0 / 2, -15.0 / 16, 1.0 / 8};

double shape_scale(KernelName name)
{
    return name == KernelName::wendland_c2 ? 21 / (16 * pi) : 1 / pi;
}

/// int_0^2 q^(n + 2) w dq of the kernel's shape w; 8 roundings on each term.
Estimate shape_moment(KernelName name, int n)
{
    if (name == KernelName::wendland_c2) {
        Estimate sum;
        for (int j = 0; j < 6; ++j) {
            const double term = wendland[static_cast<std::size_t>(j)] * std::pow(2, n + 3 + j) / (n + 3 + j);
            sum.value += term;
            sum.error += 8 * u * std::abs(term);
        }
        return sum;
    }
    // int_0^a (a - q)^3 q^s dq = 6 a^(s + 4) / ((s + 1)(s + 2)(s + 3)(s + 4)) for both powers
    const double s = n + 2;
    const double value = (std::pow(2, s + 4) - 4) * 6 / ((s + 1) * (s + 2) * (s + 3) * (s + 4)) / 4;
    return {value, 8 * u * value};
}

/// The series; its terms from n = 26 on are below 1e-20.
Estimate transform_near_zero(KernelName name, double x)
{
    Estimate sum;
    double factor = 4 * pi * shape_scale(name);
    for (int n = 0; n <= 24; n += 2) {
        const Estimate moment = shape_moment(name, n);
        sum.value += factor * moment.value;
        sum.error += std::abs(factor) * (moment.error + (2 * n + 8) * u * moment.value);
        factor *= -x * x / ((n + 2) * (n + 3));
    }
    return sum;
}

/// 4 pi / x int_0^2 q w sin(x q) dq by parts; x = k h.
Estimate wendland_transform(double x)
{
    std::array<double, 7> p{}; // q w
    for (std::size_t j = 0; j < 6; ++j) {
        p[j + 1] = wendland[j];
    }
    const auto value_at = [&p](double q) {
        double sum = 0;
        for (std::size_t j = p.size(); j-- > 0;) {
            sum = sum * q + p[j];
        }
        return sum;
    };
    const auto magnitude_at_2 = [&p] {
        double sum = 0;
        for (std::size_t j = p.size(); j-- > 0;) {
            sum = sum * 2 + std::abs(p[j]);
        }
        return sum;
    };
    Estimate integral;
    for (int n = 0; n < 7; ++n) { // the n-th antiderivative of the sine meets the n-th derivative of q w
        const double phase = (n + 1) * pi / 2;
        const auto antiderivative = [&](double q) { return std::sin(x * q - phase) / std::pow(x, n + 1); };
        const double sign = n % 2 == 0 ? 1 : -1;
        integral.value += sign * (value_at(2) * antiderivative(2) - value_at(0) * antiderivative(0));
        // 24 roundings on the values, those of the angle on the sines
        integral.error += (24 + 2 * x + phase) * u * (magnitude_at_2() + std::abs(p[0])) / std::pow(x, n + 1);
        for (std::size_t j = 1; j < p.size(); ++j) {
            p[j - 1] = static_cast<double>(j) * p[j];
        }
        p.back() = 0;
    }
    const double factor = shape_scale(KernelName::wendland_c2) * 4 * pi / x;
    return {factor * integral.value, factor * integral.error};
}

/// 3 sin^3 x (sin x - x cos x) / x^6; 16 roundings on both terms, 2 of x, which moves them.
Estimate spline_transform(double x)
{
    const double s = std::sin(x);
    const double c = std::cos(x);
    const double terms = std::abs(s) + x * std::abs(c);
    const double moved = 2 * x * (3 * s * s * terms + x * std::pow(s, 4));
    return {3 * std::pow(s, 3) * (s - x * c) / std::pow(x, 6),
            3 * u * (16 * std::pow(std::abs(s), 3) * terms + moved) / std::pow(x, 6)};
}

} // namespace

double kernel(KernelName name, double h, double r)
{
    const double q = r / h;
    const double s = positive_part(2 - q);
    if (name == KernelName::cubic_spline) {
        return (std::pow(s, 3) - 4 * std::pow(positive_part(1 - q), 3)) / (4 * pi * std::pow(h, 3));
    }
    return shape_scale(name) * (5 * std::pow(s, 4) / 16 - std::pow(s, 5) / 8) / std::pow(h, 3);
}

double kernel_terms(KernelName name, double h, double r)
{
    const double q = r / h;
    const double s = positive_part(2 - q);
    if (name == KernelName::cubic_spline) {
        return (std::pow(s, 3) + 4 * std::pow(positive_part(1 - q), 3)) / (4 * pi * std::pow(h, 3));
    }
    return shape_scale(name) * (5 * std::pow(s, 4) / 16 + std::pow(s, 5) / 8) / std::pow(h, 3);
}

double kernel_slope(KernelName name, double h, double r)
{
    const double q = r / h;
    const double s = positive_part(2 - q);
    if (name == KernelName::cubic_spline) {
        return -3 * (s * s - 4 * std::pow(positive_part(1 - q), 2)) / (4 * pi * std::pow(h, 4));
    }
    return -shape_scale(name) * (5 * std::pow(s, 3) / 4 - 5 * std::pow(s, 4) / 8) / std::pow(h, 4);
}

double viscosity_kernel_laplacian(double H, double r)
{
    return r < H ? 15 / (2 * pi * std::pow(H, 3)) * (6 / std::pow(H, 2) - 6 * r / std::pow(H, 3)) : 0;
}

Estimate moment(const Radial& f, double h, int p)
{
    const auto shell = [&](double r) { return 4 * pi * std::pow(r, 2 + p) * f(r); };
    const Estimate inner = integrate_polynomial(shell, 0, h);
    const Estimate outer = integrate_polynomial(shell, h, 2 * h);
    return {inner.value + outer.value, inner.error + outer.error};
}

double exact_moment(KernelName name, double h, int p)
{
    const bool cubic = name == KernelName::cubic_spline;
    switch (p) {
    case 0:
        return 1;
    case 2:
        return (cubic ? 9.0 / 10 : 4.0 / 5) * h * h;
    case 4:
        return (cubic ? 17.0 / 14 : 32.0 / 33) * h * h * h * h;
    default:
        throw std::invalid_argument("exact_moment: the order must be 0, 2 or 4");
    }
}

double exact_gradient_norm(KernelName name, double h)
{
    return (name == KernelName::cubic_spline ? 12 / (7 * pi) : 105 / (44 * pi)) / std::pow(h, 5);
}

Estimate kernel_transform(KernelName name, double h, double k)
{
    const double kh = std::abs(k) * h;
    if (kh < 1) {
        return transform_near_zero(name, kh);
    }
    return name == KernelName::wendland_c2 ? wendland_transform(kh) : spline_transform(kh / 2);
}

Estimate viscosity_transform(double H, double k)
{
    const double a = std::abs(k) * H;
    if (a < 1) { // sum_n (-1)^n (2n - 2)/(2n)! a^(2n - 4), n >= 2
        double sum = 0;
        double factor = 1.0 / 24;
        for (int n = 2; n < 14; ++n) {
            sum += factor * (2 * n - 2);
            factor *= -a * a / ((2 * n + 1) * (2 * n + 2));
        }
        const double value = 180 / std::pow(H, 2) * sum;
        return {value, 32 * u * value};
    }
    const double factor = 180 / (std::pow(H, 2) * std::pow(a, 4));
    return {factor * (2 - 2 * std::cos(a) - a * std::sin(a)), factor * (16 * (4 + a) + a * (1 + a)) * u};
}

} // namespace aneurysm::analytic
