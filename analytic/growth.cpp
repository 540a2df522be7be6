// SPDX-License-Identifier: Apache-2.0
#include "analytic/growth.hpp"

#include <Eigen/Dense>

#include <gsl/gsl_sf_gamma.h>
#include <gsl/gsl_sf_lambert.h>

#include <complex>
#include <numbers>

namespace aneurysm::analytic
{
namespace
{

constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// Increment f(R) of repeated steps under the force F, and its derivative.
double increment(double F, double M, double K, double R)
{
    return F * R / (M * R + K);
}
double increment_slope(double F, double M, double K, double R)
{
    return F * K / std::pow(M * R + K, 2);
}

} // namespace

Balance backward_euler_from_rest(const Resistance& wall, double F_B, double R, double dt)
{
    using Matrix6 = Eigen::Matrix<double, 6, 6>;
    using Vector6 = Eigen::Matrix<double, 6, 1>;
    Matrix6 A = Matrix6::Zero(); // columns: dR, u_t, epsilon, F_F, F_P, F_T
    Vector6 b = Vector6::Zero();
    A(0, 1) = dt; // u_t dt = dR
    A(0, 0) = -1;
    A(1, 2) = R; // epsilon R = dR
    A(1, 0) = -1;
    A(2, 3) = 1; // F_F = rho_F a c u_t
    A(2, 1) = -wall.impedance;
    A(3, 4) = 1; // F_P = K epsilon
    A(3, 2) = -wall.stiffness;
    A(4, 5) = dt; // F_T dt = m u_t: the momentum after a step from rest
    A(4, 1) = -wall.m;
    A.row(5) << 0, 0, 0, 1, 1, 1; // F_T + F_F + F_P = F_B
    b(5) = F_B;

    const Vector6 x = A.fullPivLu().solve(b);
    const Vector6 residual = (b - A * x).cwiseAbs() + 8 * u * (A.cwiseAbs() * x.cwiseAbs() + b.cwiseAbs());
    const Vector6 error = A.inverse().cwiseAbs() * residual;
    const auto unknown = [&](int k) { return Estimate{x(k), error(k)}; };
    return {unknown(0), unknown(1), unknown(2), unknown(3), unknown(4), unknown(5)};
}

double column_momentum_rate(double rho_F, double a, double c, double u_t, double dt)
{
    const double mass_set_in_motion = rho_F * a * (c * dt);
    return mass_set_in_motion * u_t / dt;
}

double fiber_energy_slope(double K_E, double A_E, double K_C, double A_C, double epsilon)
{
    constexpr double step = 1e-100;
    const std::complex<double> strain(epsilon, step);
    const std::complex<double> energy = K_E * A_E * strain * strain / 2.0 + K_C * A_C * strain * strain / 2.0;
    return energy.imag() / step;
}

Estimate circumference_strain(double dR, double R)
{
    const double before = 2 * std::numbers::pi * R;
    const Estimate growth = integrate([&](double) { return dR; }, 0, 2 * std::numbers::pi);
    return {growth.value / before, growth.error / before + 4 * u * std::abs(growth.value / before)};
}

Estimate radius_after_steps(const Resistance& wall, double F, double R_0, double dt, int n)
{
    const double M = wall.inertia(dt);
    const double K = wall.stiffness;
    gsl_return_errors();
    const auto flow = [&](double N) {
        gsl_sf_result W;
        gsl_check(gsl_sf_lambert_W0_e(M * R_0 / K * std::exp((M * R_0 + F * N) / K), &W), "Lambert's W");
        const double exponent_error = 8 * u * (M * R_0 + F * N) / K; // dW = W/(1 + W) d ln(argument)
        return Estimate{K / M * W.val, K / M * (W.err + exponent_error) + 4 * u * R_0};
    };
    const double f_0 = increment(F, M, K, R_0);
    const double R_n = flow(n).value;
    const double log_ratio = std::log(increment(F, M, K, R_n) / f_0);
    Estimate R = flow(n - log_ratio / 2);
    const double slope_0 = increment_slope(F, M, K, R_0); // f' falls with R
    const double slope_n = increment_slope(F, M, K, R_n);
    R.error += (slope_0 * std::abs(log_ratio) + slope_0 - slope_n) / 12 * increment(F, M, K, R_n);
    return R;
}

Estimate thickness_after_steps(double h_0, double R_0, double sigma, double D, int n)
{
    const double x = R_0 / D;
    gsl_return_errors();
    gsl_sf_result top;
    gsl_sf_result bottom; // ln of (a)_p = Gamma(a + p)/Gamma(a)
    gsl_check(gsl_sf_lnpoch_e(x - sigma, n, &top), "Pochhammer's symbol");
    gsl_check(gsl_sf_lnpoch_e(x, n, &bottom), "Pochhammer's symbol");
    const double value = h_0 * std::exp(top.val - bottom.val);
    return {value, value * (top.err + bottom.err + 4 * u)};
}

Estimate euler_thinning_error(double R_0, double sigma, double D, int n)
{
    const double R_n = R_0 + n * D;
    const auto A = [&](double p) { return std::pow(R_0, -p) - std::pow(R_n, -p); };
    const double s = sigma;
    const double first = -D / 2 * s * (1 + s) * A(1);
    const double second = -D * D * A(2) * (s / 12 + s * s / 4 + s * s * s / 6);
    const double third = -D * D * D * A(3) * (s * s / 12 + s * s * s / 6 + s * s * s * s / 12);
    return {std::expm1(first + second + third), std::abs(third) * D / (R_0 - D)};
}

Estimate thickness_developed_after_steps(double h_0, double alpha, double D, int n)
{
    const double exponent = n * std::log1p(-alpha * D);
    const double value = h_0 * std::exp(exponent);
    return {value, value * (4 * std::abs(exponent) + 2) * u};
}

Estimate exponential_thinning_error(double alpha, double D, int n)
{
    const double x = alpha * D;
    const double cubic = n * x * x * x / 3;
    const double half_of_rest = cubic * x / (2 * (1 - x));
    return {std::expm1(-n * x * x / 2 - cubic - half_of_rest), half_of_rest};
}

} // namespace aneurysm::analytic
