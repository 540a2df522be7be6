// SPDX-License-Identifier: Apache-2.0
// The oracles of section 3.1 on the lattice, (3)-(7), against one another: direct sums, Poisson's formula with the
// kernels' transforms, the transforms against quadrature, and numbers recorded from other programs.
#include "analytic/lattice/lattice.hpp"
#include "analytic/incompressible.hpp"
#include "analytic/kernel_function.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/formulas/kernel_rounding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace aneurysm::checks
{
namespace
{

using analytic::Estimate;
using analytic::Lattice;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double dx = 1.0 / 64;
constexpr auto cubic = KernelName::cubic_spline;
constexpr auto wendland = KernelName::wendland_c2;

Lattice lattice(KernelName kernel, double ratio)
{
    return {kernel, ratio * dx, dx};
}

/// Times 1/dx.
const std::array waves{Vector3d(0.5, 0, 0), Vector3d(0.4, -0.9, 1.3), Vector3d(2.1, 2.9, 0.3)};

/// A number that another program gave with these many digits: it is off by half a unit of the last.
struct Recorded {
    KernelName kernel;
    double ratio;
    double value;
    double unit;
};

void eq04_transforms(Probe& probe)
{
    Quantity& kernels = probe.quantity(
        "transform of W against its sine integral [1]", Source::quadrature,
        "the transform's own bound of its rounding; GSL's estimate and 16 u of both pieces; gamma_32 of the "
        "integrand's magnitude, whose integral is 1/(k h) times int W r dr at most");
    for (const KernelName name : both_kernels) {
        for (const double kh : {0.3, 0.99, 1.01, 2.5, 7.0, 20.0}) {
            const auto magnitude = [&](double r) { return 4 * pi * r * analytic::kernel(name, 1, r) / kh; };
            const auto wave = [&](double r) { return magnitude(r) * std::sin(kh * r); };
            const Estimate inner = analytic::integrate(wave, 0, 1);
            const Estimate outer = analytic::integrate(wave, 1, 2);
            const Estimate size = analytic::integrate(magnitude, 0, 2);
            const Estimate transform = analytic::kernel_transform(name, 1, kh);
            const double allowed = transform.error + inner.error + outer.error +
                                   rounding(32 + 2 * kh) * std::min(1.0, kh) * size.value;
            kernels.within(transform.value, inner.value + outer.value, allowed,
                           kernel_text(name) + at({{"k h", kh}}));
        }
    }
}

void eq07_transform(Probe& probe)
{
    Quantity& laplacian =
        probe.quantity("transform of lap W against its sine integral [1/m^2]", Source::quadrature,
                       "the transform's own bound of its rounding; GSL's estimate and 16 u; gamma_32 of int "
                       "lap W dV = 15/H^2");
    const double H = 2;
    for (const double kH : {0.3, 0.99, 1.01, 2.5, 7.0, 20.0}) {
        const double k = kH / H;
        const auto wave = [&](double r) {
            return 4 * pi * r * analytic::viscosity_kernel_laplacian(H, r) * std::sin(k * r) / k;
        };
        const Estimate integral = analytic::integrate(wave, 0, H);
        const Estimate transform = analytic::viscosity_transform(H, k);
        laplacian.within(transform.value, integral.value,
                         transform.error + integral.error + rounding(32) * 15 / (H * H), at({{"k H", kH}}));
    }
}

void eq05_poisson(Probe& probe)
{
    Quantity& sums =
        probe.quantity("density of a lattice, direct and by Poisson's formula [1/m^3]", Source::truncation,
                       "rounding of the direct sum; rounding of the transforms, and the shells beyond |m| = "
                       "200 by an integral over a bound of the transform");
    Quantity& continuum = probe.quantity(
        "bound of Poisson's sum [1/m^3]", Source::truncation,
        "a tenth of the lattice's distance from a continuum, so that the sums tell the two apart");
    for (const KernelName kernel : both_kernels) {
        for (const double ratio : {1.0, 1.2, 1.3, 1.5, 2.0}) {
            const Lattice l = lattice(kernel, ratio);
            const Estimate direct = analytic::kernel_sum(l);
            const Estimate poisson = analytic::kernel_sum_by_poisson(l);
            const std::string where = kernel_text(kernel) + at({{"h/dx", ratio}});
            sums.within(direct.value, poisson.value, direct.error + poisson.error, where);
            continuum.within(poisson.error, 0, std::abs(direct.value - 1 / l.cell()) / 10, where);
        }
    }
}

void eq05_recorded(Probe& probe)
{
    Quantity& offsets = probe.quantity("rho/rho_0 - 1 of a lattice of masses rho_0 dx^3 [1]",
                                       Source::rounding, "half a unit of the last digit recorded");
    for (const Recorded& r : {Recorded{cubic, 1.0, -2.75e-5, 1e-7},
                              {cubic, 1.2, 8.10e-4, 1e-6},
                              {cubic, 1.3, -2.74e-3, 1e-5},
                              {cubic, 2.0, 7.92e-5, 1e-7},
                              {wendland, 1.0, 3.4e-2, 1e-3},
                              {wendland, 1.2, 1.7e-2, 1e-3},
                              {wendland, 1.3, 9.5e-3, 1e-4},
                              {wendland, 1.5, 3.1e-3, 1e-4},
                              {wendland, 2.0, 5.5e-4, 1e-5}}) {
        const Lattice l = lattice(r.kernel, r.ratio);
        offsets.within(analytic::kernel_sum(l).value * l.cell() - 1, r.value, r.unit / 2,
                       kernel_text(r.kernel) + at({{"h/dx", r.ratio}}));
    }
}

void eq06_poisson(Probe& probe)
{
    Quantity& sums =
        probe.quantity("gradient's symbol, direct and by Poisson's formula [1/m^4]", Source::truncation,
                       "rounding of the direct sum; rounding of the transforms, and the points beyond |m| = "
                       "40 by an integral over a bound of the transform");
    Quantity& floors = probe.quantity("what a linear field's gradient is off by [1]", Source::rounding,
                                      "half a unit of the last digit recorded");
    for (const KernelName kernel : both_kernels) {
        const Lattice l = lattice(kernel, 1.3);
        for (std::size_t n = 0; n < waves.size(); ++n) {
            const Vector3d k = waves.at(n) / dx;
            const auto direct = analytic::gradient_sum(l, k);
            const auto poisson = analytic::gradient_sum_by_poisson(l, k);
            sums.within(to_vec3(direct.value), to_vec3(poisson.value), direct.error + poisson.error,
                        kernel_text(kernel) + at({{"wave", double(n)}}));
        }
    }
    for (const Recorded& r : {Recorded{cubic, 1.2, -1.831e-2, 1e-5},
                              {cubic, 1.3, -0.652e-2, 1e-5},
                              {cubic, 2.0, -4.9e-5, 1e-6}}) {
        floors.within(analytic::gradient_floor(lattice(r.kernel, r.ratio)).value, r.value, r.unit / 2,
                      at({{"h/dx", r.ratio}}));
    }
}

void eq07_poisson(Probe& probe)
{
    Quantity& sums =
        probe.quantity("viscosity's symbol, direct and by Poisson's formula [1/m^5]", Source::truncation,
                       "rounding of the direct sum; 1e-13 for the tails of the Gaussians that smooth it, "
                       "rounding of the transform's sum");
    for (const double ratio : {1.0, 1.32}) { // with and without lattice points at the support's end
        const Lattice l = lattice(cubic, ratio);
        for (std::size_t n = 0; n < waves.size(); ++n) {
            const Vector3d k = waves.at(n) / dx;
            const Estimate direct = analytic::viscosity_sum(l, k);
            const Estimate poisson = analytic::viscosity_sum_by_poisson(l, k);
            sums.within(direct.value, poisson.value, direct.error + poisson.error,
                        at({{"h/dx", ratio}, {"wave", double(n)}}));
        }
    }
}

void eq03_limits(Probe& probe)
{
    Quantity& limits =
        probe.quantity("largest relaxation without momentum, 3/2 of that with it [1]", Source::truncation,
                       "recorded from a grid of wave vectors, which misses the largest eigenvalue: up to 0.2 "
                       "% above; half a unit of the last digit");
    Quantity& damped = probe.quantity(
        "largest root of the iteration with momentum [1]", Source::exact,
        "below 1 for all modes down to -1/3, not for -1/3 - 0.001; without momentum down to -1");
    for (const Recorded& r : {Recorded{cubic, 1.0, 0.710, 1e-3},
                              {cubic, 1.2, 0.507, 1e-3},
                              {cubic, 1.3, 0.408, 1e-3},
                              {cubic, 2.0, 0.114, 1e-3},
                              {wendland, 1.0, 0.768, 1e-3},
                              {wendland, 1.3, 0.476, 1e-3}}) {
        const double limit = 1.5 * analytic::relaxation_limit(lattice(r.kernel, r.ratio)).value;
        limits.within(limit, 0.999 * r.value, 0.001 * r.value + r.unit / 2,
                      kernel_text(r.kernel) + at({{"h/dx", r.ratio}}));
    }
    const auto largest = [](double lowest) { // theta up to 0.999, modes from `lowest` to 1
        double root = 0;
        for (int i = 0; i < 1000; ++i) {
            for (int j = 0; j < 100; ++j) {
                root = std::max(root, analytic::largest_root(0.001 * i, lowest + (1 - lowest) * 0.01 * j));
            }
        }
        return root;
    };
    damped.holds(largest(-1.0 / 3) < 1, "down to -1/3");
    damped.holds(largest(-1.0 / 3 - 0.001) >= 1, "down to -1/3 - 0.001");
    damped.holds(analytic::largest_root(0, -0.999) < 1, "without momentum, -0.999");
    damped.holds(analytic::largest_root(0, -1.001) > 1, "without momentum, -1.001");
}

/// The wave of a periodic box with `cells` along each edge that a relaxation of 1 damps most, and by how much.
std::pair<Vector3d, double> most_damped_wave(const Lattice& l, int cells)
{
    std::pair<Vector3d, double> most{Vector3d::Zero(), 0};
    for (int i = 1; i <= cells / 2; ++i) {
        for (int j = 0; j <= i; ++j) {
            for (int m = 0; m <= j; ++m) {
                const Vector3d k = 2 * pi / (cells * l.dx) * Vector3d(i, j, m);
                const double damped = 1 - analytic::step_factor(l, 1, k).value;
                most = damped > most.second ? std::pair{k, damped} : most;
            }
        }
    }
    return most;
}

void eq03_stability(Probe& probe)
{
    constexpr int iterations = 400;
    Quantity& below = probe.quantity(
        "what 400 iterations leave of the most damped wave's residual, at and below the limit [1]",
        Source::truncation,
        "10 times the larger root for theta = 1 to the power 400, since a smaller theta damps more and the two roots' "
        "shares of the start are below 5; + the recurrence's own error");
    Quantity& above =
        probe.quantity("growth 1 % above the limit", Source::exact,
                       "claims: the lattice's limit is not above the box's, and more is left after 400 "
                       "iterations than after 200: the root beyond -1 grows like 1.03 an iteration");
    const double rho_0 = 1050;
    for (const KernelName kernel : both_kernels) {
        const Lattice l = lattice(kernel, 1);
        const analytic::Medium medium{l, rho_0 / analytic::kernel_sum(l).value, rho_0};
        const auto [k, damped] = most_damped_wave(l, 8);
        const std::array<analytic::ResidualWave, 1> wave{{{k, 1, 1}}};
        const auto left = [&](double omega, int n) {
            return analytic::accelerated_waves(medium, omega, 1e-3, wave, n).residual.back()[0];
        };
        const double of_lattice = analytic::relaxation_limit(l).value;
        const double of_box = 4.0 / 3 / damped;
        for (const double omega : {of_lattice, 0.99 * of_box}) {
            const Estimate rest = left(omega, iterations);
            const double root = analytic::largest_root(1, 1 - omega * damped);
            below.within(rest.value, 0, rest.error + 10 * std::pow(root, iterations),
                         kernel_text(kernel) + at({{"omega", omega}}));
        }
        above.holds(of_lattice <= of_box, kernel_text(kernel) + "limits");
        const double early = std::abs(left(1.01 * of_box, iterations / 2).value);
        const double late = std::abs(left(1.01 * of_box, iterations).value);
        above.holds(late > early, kernel_text(kernel) + "residual");
    }
}

} // namespace

std::vector<Check> oracle_lattice_checks()
{
    return {
        oracle_check(
            "eq03_limits", Level::lattice, {"3"},
            "the largest relaxation of a lattice is the recorded one; momentum needs modes above -1/3",
            {"search over the Brillouin zone", "a grid of wave vectors, recorded"}, eq03_limits),
        oracle_check("eq03_stability", Level::lattice, {"3"},
                     "the iteration diverges above the largest relaxation and not below",
                     {"two-term recurrence with the symbol g(k)", "search over the Brillouin zone"},
                     eq03_stability),
        oracle_check("eq04_transforms", Level::lattice, {"4"},
                     "the kernels' Fourier transforms are their sine integrals",
                     {"closed form and series", "GSL quadrature"}, eq04_transforms),
        oracle_check("eq05_poisson", Level::lattice, {"5"},
                     "a lattice's density is the same in space and in Fourier space",
                     {"direct sum", "Poisson's formula"}, eq05_poisson),
        oracle_check("eq05_recorded", Level::lattice, {"5"}, "a lattice's density is the recorded one",
                     {"direct sum", "recorded"}, eq05_recorded),
        oracle_check("eq06_poisson", Level::lattice, {"6"},
                     "a lattice's gradient is the same in space and in Fourier space",
                     {"direct sum", "Poisson's formula", "recorded"}, eq06_poisson, false),
        oracle_check("eq07_transform", Level::lattice, {"7"},
                     "the Fourier transform of the viscosity Laplacian is its sine integral",
                     {"closed form and series", "GSL quadrature"}, eq07_transform),
        oracle_check("eq07_poisson", Level::lattice, {"7"},
                     "a lattice's viscosity is the same in space and in Fourier space",
                     {"direct sum", "Poisson's formula"}, eq07_poisson, false),
    };
}

} // namespace aneurysm::checks
