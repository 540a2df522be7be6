// SPDX-License-Identifier: Apache-2.0
#include "analytic/boundary.hpp"

#include "analytic/kernel_function.hpp"

#include <gsl/gsl_interp.h>
#include <gsl/gsl_poly.h>
#include <gsl/gsl_sf_erf.h>
#include <gsl/gsl_sf_trig.h>

#include <array>
#include <complex>
#include <numbers>

namespace aneurysm::analytic
{
namespace
{

using std::numbers::pi;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

Estimate sine(double x)
{
    gsl_return_errors();
    gsl_sf_result result;
    gsl_check(gsl_sf_sin_e(x, &result), "sine");
    return {result.val, result.err};
}

/// Free oscillation around 0.
double swing(const Oscillator& wall, double offset, double t)
{
    const double w = wall.frequency();
    return offset * std::cos(w * t) + wall.v_0 / w * std::sin(w * t);
}

} // namespace

Estimate waveform_velocity(Waveform waveform, double v_0, double T, double t)
{
    const double x = 2 * pi * t / T;
    switch (waveform) {
    case Waveform::sine: {
        const Estimate s = sine(x);
        return {v_0 * s.value, std::abs(v_0) * s.error};
    }
    case Waveform::rectified_sine: {
        const Estimate s = sine(x);
        return {v_0 * std::abs(s.value), std::abs(v_0) * s.error};
    }
    case Waveform::raised_sine: {
        const Estimate s = sine(x / 2 + pi / 4);
        return {v_0 * s.value * s.value, 2 * std::abs(v_0) * s.error};
    }
    case Waveform::constant:
        return {v_0, 0};
    default:
        throw std::invalid_argument("waveform_velocity: a table has no formula");
    }
}

double interpolated_velocity(std::vector<double> time, std::vector<double> velocity, double T, double t)
{
    time.push_back(T);
    velocity.push_back(velocity.front());
    const Owned<gsl_interp, gsl_interp_free> table(gsl_interp_alloc(gsl_interp_linear, time.size()));
    gsl_check(gsl_interp_init(table.get(), time.data(), velocity.data(), time.size()), "table");
    double in_cycle = std::fmod(t, T);
    if (in_cycle < 0) {
        in_cycle += T;
    }
    return gsl_interp_eval(table.get(), time.data(), velocity.data(), in_cycle, nullptr);
}

Estimate cycle_transport(const std::function<double(double)>& velocity, const std::vector<double>& breaks)
{
    Estimate sum;
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const Estimate part = integrate(velocity, breaks[i - 1], breaks[i]);
        sum = {sum.value + part.value, sum.error + part.error};
    }
    return sum;
}

double exact_transport(Waveform waveform)
{
    switch (waveform) {
    case Waveform::sine:
        return 0;
    case Waveform::rectified_sine:
        return 2 / pi;
    case Waveform::raised_sine:
        return 0.5;
    case Waveform::constant:
        return 1;
    default:
        throw std::invalid_argument("exact_transport: a table has no formula");
    }
}

Estimate outlet_force(KernelName name, double h, double dx, double p, double z)
{
    const int reach = static_cast<int>(std::ceil(2 * h / dx)) + 1;
    double sum = 0;
    double magnitude = 0;
    const int layers = static_cast<int>(std::ceil(z / dx)) + reach;
    for (int layer = 0; layer < layers; ++layer) {
        const double below = (layer + 0.5) * dx - z;
        for (int i = -reach; i <= reach; ++i) {
            for (int j = -reach; j <= reach; ++j) {
                const double r = std::sqrt(below * below + dx * dx * (i * i + j * j));
                const double term = r > 0 ? -kernel_slope(name, h, r) * below / r : 0;
                sum += term;
                magnitude += std::abs(term);
            }
        }
    }
    const double scale = 2 * p * dx * dx * dx;
    return {scale * sum, scale * (32 + layers * (2 * reach + 1) * (2 * reach + 1)) * u * magnitude};
}

Estimate outlet_force_continuum(KernelName name, double h, double p, double z)
{
    // int W 2 pi s ds over the plane, with s ds = r dr
    const auto ring = [&](double r) { return 2 * pi * r * kernel(name, h, r); };
    Estimate sum;
    for (const auto& [a, b] : {std::pair{0.0, h}, std::pair{h, 2 * h}}) {
        if (z < b) {
            const Estimate part = integrate_polynomial(ring, std::max(a, z), b);
            sum = {sum.value + part.value, sum.error + part.error};
        }
    }
    return {2 * p * sum.value, 2 * p * sum.error};
}

double started_flow(double U, double nu, double t, double y)
{
    return U * gsl_sf_erf(y / (2 * std::sqrt(nu * t)));
}

double displacement(const Oscillator& wall, double F, double t)
{
    return F / wall.k + swing(wall, wall.u_0 - F / wall.k, t);
}

double displacement_driven(const Oscillator& wall, double F, double O, double t)
{
    const double w = wall.frequency();
    const double free = swing(wall, wall.u_0, t);
    if (O == w) {
        return free + F / (2 * wall.k) * (std::sin(w * t) - w * t * std::cos(w * t));
    }
    return free + F / (wall.k - wall.m * O * O) * (std::sin(O * t) - O / w * std::sin(w * t));
}

Estimate driven_response(const Oscillator& wall, const std::function<double(double)>& force, double t)
{
    const double w = wall.frequency();
    return integrate([&](double s) { return force(s) * std::sin(w * (t - s)) / (wall.m * w); }, 0, t);
}

Estimate displacement_after_steps(const Oscillator& wall, double F, double G, double O, double dt, int n)
{
    const double w_dt = wall.frequency() * dt;
    const double theta = 2 * std::asin(w_dt / 2);
    const double half = 2 * std::sin(O * dt / 2);
    const double driven = G / wall.m * dt * dt / (w_dt * w_dt - half * half);
    const double rest = F / wall.k;
    const double A = wall.u_0 - rest;
    const double u_1 = wall.u_0 + dt * (wall.v_0 + dt * (F - wall.k * wall.u_0) / wall.m);
    const double B = (u_1 - driven * std::sin(O * dt) - rest - A * std::cos(theta)) / std::sin(theta);
    const double value =
        rest + A * std::cos(n * theta) + B * std::sin(n * theta) + driven * std::sin(O * n * dt);
    const double size = std::abs(A) + std::abs(B) + std::abs(driven) + std::abs(rest);
    const double angle = 2 * n * (theta + O * dt) * u; // two roundings of each angle
    const double start =
        10 * u * (std::abs(A) + std::abs(wall.u_0) + std::abs(driven)) / std::sin(theta); // of B
    return {value, size * (angle + 10 * u) + start};
}

double step_invariant(const Oscillator& wall, double F, double dt, double displaced, double v)
{
    const double x = displaced - F / wall.k;
    const double w2 = wall.k / wall.m;
    return (v * v + w2 * x * x - dt * w2 * x * v) / 2;
}

Estimate wall_with_column(const Oscillator& wall, double M, double F, double dt, int n)
{
    using Long = long double;
    using Complex = std::complex<Long>;
    const Long mu = static_cast<Long>(M) / wall.m;
    const Long stiffness = static_cast<Long>(wall.k) * dt * dt / wall.m;
    std::array<gsl_complex, 3> root{};
    gsl_poly_complex_solve_cubic(static_cast<double>(mu - 2 + stiffness), static_cast<double>(1 - 2 * mu),
                                 M / wall.m, root.data(), &root[1], &root[2]);
    std::array<Complex, 3> z;
    for (std::size_t j = 0; j < 3; ++j) {
        z.at(j) = {GSL_REAL(root.at(j)), GSL_IMAG(root.at(j))};
        for (int newton = 0; newton < 4; ++newton) {
            const Complex w = z.at(j);
            const Complex off = w - Long(1);
            const Complex p = off * off * (w + mu) + stiffness * w * w;
            z.at(j) -= p / (Long(2) * off * (w + mu) + off * off + Long(2) * stiffness * w);
        }
    }
    Complex sum = 0;
    Long size = 0;
    for (std::size_t j = 0; j < 3; ++j) {
        Complex term = std::pow(z.at(j), n + 2);
        for (std::size_t other = 0; other < 3; ++other) {
            term *= other == j ? Complex(1) : (Long(1) - z.at(other)) / (z.at(j) - z.at(other));
        }
        sum += term;
        size += std::abs(term);
    }
    const Long rest = static_cast<Long>(F) / wall.k;
    // a root is off by 32 long u over its distance to the others, theta; z^n by n times that, each quotient
    // by 2/theta times
    const double theta = std::sqrt(wall.k / (wall.m + M)) * dt;
    const double of_roots = 32 * u / 2048 / theta * (n + 8 / theta);
    return {static_cast<double>(rest * (1 - sum.real())),
            static_cast<double>(std::abs(rest) * size) * (of_roots + (n + 16) * u / 2048) +
                2 * u * static_cast<double>(std::abs(rest) * (1 + size))};
}

Eigen::Vector3d mirrored(const Eigen::Vector3d& v, const Eigen::Vector3d& n)
{
    const Eigen::Matrix3d reflection = Eigen::Matrix3d::Identity() - 2 * n * n.transpose();
    return reflection * v;
}

} // namespace aneurysm::analytic
