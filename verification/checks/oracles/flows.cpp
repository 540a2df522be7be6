// SPDX-License-Identifier: Apache-2.0
// The oracles of laminar flow, (1) with (27), against one another: no flow of a backend can be judged by them
// otherwise.
#include "analytic/bessel.hpp"
#include "analytic/laminar_flow.hpp"
#include "analytic/taylor_green.hpp"
#include "verification/checks/checks.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <cmath>
#include <numbers>

namespace aneurysm::checks
{
namespace
{

using analytic::Drive;
using analytic::Duct;
using analytic::Estimate;
using analytic::Section;
using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double a = 0.125; ///< half of the channel's height, the pipe's radius [m]
constexpr double nu = 0.01; ///< [m^2/s]
constexpr double g = 10;    ///< [m/s^2]
constexpr auto sections = {Section::channel, Section::pipe};

Drive drive_of(double womersley)
{
    return {g, womersley * womersley * nu / (a * a)};
}

std::string place(const Duct& duct, const Drive& drive, double r, double t)
{
    return std::string(duct.section == Section::channel ? "channel" : "pipe") + ", alpha " +
           std::to_string(analytic::womersley_number(duct, drive)) + ", r/a " + std::to_string(r / duct.a) +
           ", nu t/a^2 " + std::to_string(duct.nu * t / (duct.a * duct.a));
}

/// Compares what two oracles say, each within its own bound.
void agree(Quantity& quantity, const Estimate& one, const Estimate& other, const std::string& where)
{
    quantity.within(one.value, other.value, one.error + other.error, where);
}

void bessel_functions(Probe& probe)
{
    Quantity& integral =
        probe.quantity("J_0 and J_1, series - integral [1]", Source::rounding,
                       "rounding of both sums, u times the sum of their terms' magnitudes, and the "
                       "trapezoidal rule's next term |z/2|^N/N!");
    Quantity& ode =
        probe.quantity("J_0 and J_1, series - differential equation [1]", Source::quadrature,
                       "steps of gsl_odeiv2 times the 1e-14 that each may add, along the ray on which no "
                       "other solution grows faster");
    const Complex ray = std::exp(Complex(0, 3 * pi / 4)); // i^(3/2), Womersley's
    for (const double size : {1e-3, 0.1, 1.0, 2.0, 4.0, 8.0, 12.0, 20.0}) {
        for (const int n : {0, 1}) {
            const std::string where = "J_" + std::to_string(n) + ", |z| " + std::to_string(size);
            const auto compare = [&](Quantity& quantity, const analytic::ComplexEstimate& one,
                                     const analytic::ComplexEstimate& other) {
                quantity.within(std::abs(one.value - other.value), 0, one.error + other.error, where);
            };
            const auto series = analytic::bessel_by_series(n, size * ray);
            compare(integral, series, analytic::bessel_by_integral(n, size * ray));
            compare(ode, series, analytic::bessel_by_ode(n, size * ray));
        }
    }
    Quantity& real = probe.quantity("J_0 and J_1 of real z, series - GSL [1]", Source::rounding,
                                    "rounding of the series' sum, u I_n(z), and GSL's own error");
    for (const double z : {0.5, 2.0, 5.0, 11.0}) {
        gsl_sf_result J_0;
        gsl_sf_result J_1;
        analytic::gsl_check(gsl_sf_bessel_J0_e(z, &J_0), "J_0");
        analytic::gsl_check(gsl_sf_bessel_J1_e(z, &J_1), "J_1");
        const auto compare = [&](int n, const gsl_sf_result& expected) {
            const auto series = analytic::bessel_by_series(n, z);
            real.within(series.value.real(), expected.val, series.error + expected.err, std::to_string(z));
        };
        compare(0, J_0);
        compare(1, J_1);
    }
}

void flow_from_rest(Probe& probe)
{
    Quantity& velocity =
        probe.quantity("u(r, t), modes - Laplace transform [m/s]", Source::truncation,
                       "rounding of the modes' sum; the contour integral's change by 8 points more, and the "
                       "rounding of its terms (docs/bounds.md, B20)");
    Quantity& wall =
        probe.quantity("u at the wall [m/s]", Source::rounding, "rounding of the modes' sum: it is 0 there");
    for (const Section section : sections) {
        const Duct duct{section, a, nu};
        for (const double alpha : {0.0, 2.0, 4.0, 8.0}) {
            const Drive drive = drive_of(alpha);
            for (const double t : {0.05, 0.2, 0.7}) {
                const double time = std::min(t * a * a / nu, drive.steady() ? 1e3 : 5 * t / drive.omega);
                for (const double r : {0.0, 0.4, 0.9}) {
                    agree(velocity, analytic::velocity(duct, drive, r * a, time),
                          analytic::velocity_by_laplace(duct, drive, r * a, time),
                          place(duct, drive, r * a, time));
                }
                agree(wall, analytic::velocity(duct, drive, a, time), {}, place(duct, drive, a, time));
            }
        }
    }
}

void rest_at_the_start(Probe& probe)
{
    Quantity& rest =
        probe.quantity("u, Q and wall shear at t = 0, in units of the steady flow's [1]", Source::truncation,
                       "the modes that are left out, g (a^2/(nu pi^2)) / (N - 1/2) steady, g omega (a^2/(nu "
                       "pi^2))^2 / (3 (N - 1/2)^3) pulsating (docs/bounds.md, B20)");
    for (const Section section : sections) {
        const Duct duct{section, a, nu};
        const auto compare = [&](const Estimate& value, const Estimate& unit, const std::string& where) {
            rest.within(value.value / unit.value, 0, value.error / unit.value, where);
        };
        for (const double alpha : {0.0, 4.0}) {
            const Drive drive = drive_of(alpha);
            const Drive steady = drive_of(0);
            for (const double r : {0.0, 0.4, 0.9}) {
                compare(analytic::velocity(duct, drive, r * a, 0),
                        analytic::developed_velocity(duct, steady, 0, 0), place(duct, drive, r * a, 0));
            }
            compare(analytic::flow_rate(duct, drive, 0), analytic::developed_flow_rate(duct, steady, 0), "Q");
            compare(analytic::wall_shear(duct, drive, 0), analytic::developed_wall_shear(duct, steady, 0),
                    "shear");
        }
    }
}

void balances(Probe& probe)
{
    Quantity& rate = probe.quantity("Q, closed form - quadrature of u", Source::quadrature,
                                    "GSL's error estimate, and the bound of u's own error times the section");
    Quantity& momentum =
        probe.quantity("dQ/dt against force and friction", Source::quadrature,
                       "GSL's estimate of the derivative's error, the bound of Q's own error over "
                       "the derivative's step of 1e-3 t, and that of the wall shear");
    for (const Section section : sections) {
        const bool round = section == Section::pipe;
        const Duct duct{section, a, nu};
        const double area = round ? pi * a * a : 2 * a;
        const double perimeter = round ? 2 * pi * a : 2;
        for (const double alpha : {0.0, 2.0, 4.0, 8.0}) {
            const Drive drive = drive_of(alpha);
            const double t = 0.3 * a * a / nu;
            const std::string where = place(duct, drive, 0, t);
            const Estimate Q = analytic::flow_rate(duct, drive, t);
            const Estimate integral = analytic::integrate(
                [&](double r) {
                    return analytic::velocity(duct, drive, r, t).value * (round ? 2 * pi * r : 2);
                },
                0, a);
            rate.within(Q.value, integral.value,
                        Q.error + integral.error + area * analytic::velocity(duct, drive, 0, t).error, where);

            const double h = 1e-3 * t;
            const Estimate change = analytic::differentiate(
                [&](double s) { return analytic::flow_rate(duct, drive, t + s).value; }, h);
            const Estimate shear = analytic::wall_shear(duct, drive, t);
            const double force = drive.steady() ? g : g * std::sin(drive.omega * t);
            momentum.within(change.value, area * force - perimeter * nu * shear.value,
                            change.error + 8 * Q.error / h + perimeter * nu * shear.error +
                                8 * rounding(1) * area * g,
                            where);
        }
    }
}

void slow_pulse(Probe& probe)
{
    Quantity& quantity = probe.quantity(
        "Womersley's profile - Poiseuille's of the force at the time [m/s]", Source::truncation,
        "|du/dt| acts as a force of at most omega max u, max u = the steady "
        "flow's crest: by the maximum principle omega (crest)^2/g; rounding of the cancelling bracket");
    for (const Section section : sections) {
        const Duct duct{section, a, nu};
        for (const double alpha : {1e-3, 1e-2, 0.1, 0.5}) {
            const Drive drive = drive_of(alpha);
            const double crest = analytic::developed_velocity(duct, drive_of(0), 0, 0).value;
            for (const double r : {0.0, 0.6 * a}) {
                const double t = 0.3 / drive.omega;
                const Estimate slow = analytic::developed_velocity(duct, drive, r, t);
                const Estimate steady = analytic::developed_velocity(duct, drive_of(0), r, t);
                quantity.within(slow.value, steady.value * std::sin(0.3),
                                drive.omega * crest * crest / g + slow.error + 2 * steady.error,
                                place(duct, drive, r, t));
            }
        }
    }
}

void vortices(Probe& probe)
{
    Quantity& momentum =
        probe.quantity("momentum balance of Taylor and Green's vortices [m/s^2]", Source::quadrature,
                       "GSL's estimates of the errors of all derivatives, and u times the terms");
    Quantity& volume =
        probe.quantity("their divergence [1/s]", Source::quadrature, "GSL's estimates of the errors");
    const analytic::TaylorGreen flow{0.7, 2 * pi, 1050, nu};
    const double h = 1e-3;
    const double t = 0.2;
    for (const auto& [x, y] : {std::pair(0.1, 0.2), std::pair(0.37, 0.61), std::pair(0.8, 0.05)}) {
        const auto derivative = [&, x = x, y = y](int component, const auto& move) {
            return analytic::differentiate(
                [&](double s) {
                    const auto [dx, dy, dt] = move(s);
                    return component < 2 ? flow.velocity(x + dx, y + dy, t + dt)(component)
                                         : flow.pressure(x + dx, y + dy, t + dt) / flow.rho;
                },
                h);
        };
        const auto along_x = [](double s) { return std::array{s, 0.0, 0.0}; };
        const auto along_y = [](double s) { return std::array{0.0, s, 0.0}; };
        const auto in_time = [](double s) { return std::array{0.0, 0.0, s}; };
        const Eigen::Vector2d v = flow.velocity(x, y, t);
        for (const int component : {0, 1}) {
            const Estimate v_t = derivative(component, in_time);
            const Estimate v_x = derivative(component, along_x);
            const Estimate v_y = derivative(component, along_y);
            const Estimate p = component == 0 ? derivative(2, along_x) : derivative(2, along_y);
            const double friction = -2 * nu * flow.k * flow.k * v(component); // lap of a product of sines
            momentum.within(v_t.value + v(0) * v_x.value + v(1) * v_y.value, friction - p.value,
                            v_t.error + std::abs(v(0)) * v_x.error + std::abs(v(1)) * v_y.error + p.error +
                                32 * rounding(1) * flow.U * flow.U * flow.k);
        }
        const Estimate u_x = derivative(0, along_x);
        const Estimate v_y = derivative(1, along_y);
        volume.within(u_x.value, -v_y.value, u_x.error + v_y.error);
    }
}

} // namespace

std::vector<Check> oracle_flows_checks()
{
    return {
        oracle_check("oracle_bessel", Level::scalar, {"1", "27"},
                     "three evaluations of J_0 and J_1 of complex argument agree",
                     {"power series", "Bessel's integral", "Bessel's equation by GSL", "gsl_sf_bessel"},
                     bessel_functions),
        oracle_check("oracle_flow_from_rest", Level::continuous, {"1", "27"},
                     "the exact flows from rest are those of their Laplace transforms",
                     {"series of modes", "Talbot's contour"}, flow_from_rest),
        oracle_check("oracle_flow_start", Level::continuous, {"1", "27"}, "the exact flows begin at rest",
                     {"series of modes", "rest"}, rest_at_the_start),
        oracle_check("oracle_flow_balance", Level::continuous, {"1", "27"},
                     "flow rate and wall shear are those of the velocity, and balance its momentum",
                     {"closed forms", "GSL quadrature and derivative"}, balances),
        oracle_check("oracle_flow_slow", Level::continuous, {"1", "27"}, "a slow pulse is Poiseuille's flow",
                     {"Womersley", "Poiseuille"}, slow_pulse),
        oracle_check("oracle_vortices", Level::continuous, {"1", "27"},
                     "Taylor and Green's vortices solve (1) and (3)", {"closed form", "GSL derivatives"},
                     vortices),
    };
}

} // namespace aneurysm::checks
