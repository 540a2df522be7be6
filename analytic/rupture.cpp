// SPDX-License-Identifier: Apache-2.0
#include "analytic/rupture.hpp"

#include <gsl/gsl_min.h>
#include <gsl/gsl_sf_lambert.h>

#include <complex>
#include <numbers>

namespace aneurysm::analytic
{
namespace
{

using Complex = std::complex<double>;
using std::numbers::pi;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// f'(x) = Im f(x + i e)/e, exact to rounding for a tiny e.
template <class Function>
double complex_step(Function f, double x)
{
    const double e = x * 1e-100;
    return std::imag(f(Complex(x, e))) / e;
}

template <class Number>
Number thickness_of(const Wall& wall, Number R)
{
    return wall.h_0 * std::exp(-wall.sigma * std::log(R / wall.R_0));
}

template <class Number>
Number pressure_of(const Wall& wall, Number R)
{
    const Number growth = std::log(R / wall.R_0);
    const double rise = 2 * wall.modulus() * wall.h_0 / wall.R_0;
    return std::exp(-(1 + wall.sigma) * growth) * (wall.P_0 + rise * growth);
}

/// dP/dR of (12) turned over, written with E.
double slope_of(const Wall& wall, double R, double P)
{
    return (2 * wall.modulus() * thickness_of(wall, R) / R - (1 + wall.sigma) * P) / R;
}

double lambert_argument(const Wall& wall, double P)
{
    return (1 + wall.sigma) * P * wall.R_0 / (2 * wall.modulus() * wall.h_0);
}

} // namespace

Estimate cut_sphere_stress(double P, double R, double h)
{
    const auto ring = [&](double theta) { return P * std::cos(theta) * 2 * pi * R * std::sin(theta) * R; };
    const Estimate resultant = integrate(ring, 0, pi / 2);
    const double cut = 2 * pi * R * h;
    return {resultant.value / cut, resultant.error / cut};
}

double thickness(const Wall& wall, double R)
{
    return thickness_of(wall, R);
}

double thickness_slope(const Wall& wall, double R)
{
    return complex_step([&](Complex x) { return thickness_of(wall, x); }, R);
}

double porosity_slope(const Wall& wall, double R)
{
    return -complex_step([&](Complex x) { return std::log(4 * pi * x * x * thickness_of(wall, x)); }, R);
}

Estimate porous_stress(double Y, double phi)
{
    const Estimate logarithm = integrate([](double x) { return 1 / x; }, phi, 1);
    return {2 * Y * logarithm.value / 3, 2 * Y * logarithm.error / 3};
}

double pressure(const Wall& wall, double R)
{
    return pressure_of(wall, R);
}

double pressure_slope(const Wall& wall, double R)
{
    return complex_step([&](Complex x) { return pressure_of(wall, x); }, R);
}

Estimate pressure_by_integration(const Wall& wall, double R)
{
    return integrate_ode([&](double r, double P) { return slope_of(wall, r, P); }, wall.R_0, wall.P_0, R);
}

Estimate radius_by_integration(const Wall& wall, double P)
{
    Estimate R =
        integrate_ode([&](double p, double r) { return 1 / slope_of(wall, r, p); }, wall.P_0, wall.R_0, P);
    // an error dR made on the way stays on a neighboring solution: dP = dP/dR dR, and dP/dR falls from R_0 on
    R.error *= slope_of(wall, wall.R_0, wall.P_0);
    return R;
}

Estimate radius_by_lambert(const Wall& wall, double P, bool stable)
{
    const double x = lambert_argument(wall, P);
    gsl_return_errors();
    gsl_sf_result W;
    gsl_check(stable ? gsl_sf_lambert_W0_e(-x, &W) : gsl_sf_lambert_Wm1_e(-x, &W), "Lambert's W");
    const double R = wall.R_0 * std::exp(-W.val / (1 + wall.sigma));
    const double argument_error = 8 * u * std::abs(W.val / (1 + W.val)); // dW = W/(1 + W) dx/x
    return {R, R * ((W.err + argument_error) / (1 + wall.sigma) + 4 * u)};
}

double critical_radius(const Wall& wall)
{
    const double start = wall.P_0 * wall.R_0 / (2 * wall.modulus() * wall.h_0);
    return wall.R_0 * std::exp(1 / (1 + wall.sigma) - start);
}

double largest_pressure(const Wall& wall)
{
    const double without_start = 2 * wall.modulus() * wall.h_0 / (wall.R_0 * (1 + wall.sigma));
    return without_start * std::exp(lambert_argument(wall, wall.P_0) - 1);
}

Estimate largest_pressure_by_search(const Wall& wall)
{
    auto negative = [&](double R) { return -pressure_of(wall, R); };
    gsl_function wrapped = gsl_function_of(negative);
    gsl_return_errors();
    const Owned<gsl_min_fminimizer, gsl_min_fminimizer_free> search(
        gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent));
    const double middle =
        wall.R_0 * std::exp(1 / (1 + wall.sigma)); // the maximum for P_0 = 0, somewhere near it else
    gsl_check(gsl_min_fminimizer_set(search.get(), &wrapped, middle, middle / 3, middle * 3),
              "bracket of a maximum");
    for (int step = 0; step < 100; ++step) {
        gsl_check(gsl_min_fminimizer_iterate(search.get()), "search of a maximum");
    }
    const double width = gsl_min_fminimizer_x_upper(search.get()) - gsl_min_fminimizer_x_lower(search.get());
    const double P = -gsl_min_fminimizer_f_minimum(search.get());
    const double R = gsl_min_fminimizer_x_minimum(search.get());
    // second order in the bracket: d2P/dR2 = -(1 + sigma)^2 P/R^2 at the maximum
    return {P, P * std::pow((1 + wall.sigma) * width / R, 2) / 2 + 64 * u * P};
}

Estimate speed_after_pulse(double mean_force, double m, double dt)
{
    const auto pulse = [&](double t) { return mean_force * pi / 2 * std::sin(pi * t / dt); };
    const Estimate impulse = integrate(pulse, 0, dt);
    return {impulse.value / m, impulse.error / m};
}

double largest_norm(const Eigen::Matrix3Xd& columns)
{
    return columns.colwise().norm().maxCoeff();
}

} // namespace aneurysm::analytic
