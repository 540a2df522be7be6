// SPDX-License-Identifier: Apache-2.0
#include "analytic/incompressible.hpp"

#include "analytic/kernel_function.hpp"

#include <gsl/gsl_multimin.h>
#include <gsl/gsl_poly.h>

#include <numbers>

namespace aneurysm::analytic
{
namespace
{

using Eigen::Vector3d;
using std::numbers::pi;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// What errors of 1 in each p and in each y become.
class ErrorGrowth
{
public:
    void iterate(double g, double theta)
    {
        for (Error& e : errors_) {
            const double p = g * e.y;
            e.y = p + theta * (p - e.p);
            e.p = p;
        }
        errors_.push_back({1, 1 + theta});
        errors_.push_back({0, 1});
    }
    double sum() const
    {
        double total = 0;
        for (const Error& e : errors_) {
            total += std::abs(e.y);
        }
        return total;
    }

private:
    struct Error {
        double p;
        double y;
    };
    std::vector<Error> errors_;
};

/// A number that the iteration takes from y to p = g y + source.
struct Amplitude {
    Estimate g;
    Estimate source;
    double per_residual = 0; ///< source / r_0
    double mean_square = 1;
    double y = 0;
    double p = 0;
    double p_old = 0;
    double once = 0; ///< the largest error of one iteration
    ErrorGrowth growth;

    void step(double floor)
    {
        p_old = p;
        p = std::max(floor, g.value * y + source.value);
        once = std::max(once, g.error * std::abs(y) + source.error +
                                  2 * u * (std::abs(g.value * y) + std::abs(source.value)));
    }
    void add_momentum(double theta, double floor)
    {
        y = std::max(floor, p + theta * (p - p_old));
        once = std::max(once, 12 * u * (std::abs(p) + std::abs(p_old)));
        growth.iterate(std::isinf(floor) ? g.value : -std::abs(g.value), theta);
    }
    Estimate pressure() const { return {y, once * growth.sum()}; }
    Estimate residual() const
    {
        const double loss = 1 - g.value;
        const double size = std::abs(source.value) + std::abs(loss * y);
        return {(source.value - loss * y) / per_residual,
                (source.error + g.error * std::abs(y) + std::abs(loss) * pressure().error + 8 * u * size) /
                    per_residual};
    }
};

/// The iteration of (3); pressures don't go below `floor`.
Iteration accelerate(std::vector<Amplitude> amplitudes, int n, double floor)
{
    Iteration result;
    result.margin = std::numeric_limits<double>::infinity();
    const auto record = [&] {
        result.pressure.emplace_back();
        result.residual.emplace_back();
        for (const Amplitude& a : amplitudes) {
            result.pressure.back().push_back(a.pressure());
            result.residual.back().push_back(a.residual());
        }
    };
    record();
    double t = 1;
    for (int iteration = 0; iteration < n; ++iteration) {
        double test = 0;
        double back = 0;  // mean squares of y - p and
        double forth = 0; // of p - p_old
        for (Amplitude& a : amplitudes) {
            a.step(floor);
            test += a.mean_square * (a.y - a.p) * (a.p - a.p_old);
            back += a.mean_square * (a.y - a.p) * (a.y - a.p);
            forth += a.mean_square * (a.p - a.p_old) * (a.p - a.p_old);
        }
        if (t > 1) { // else a restart changes nothing
            // errors e of both change the mean product by up to e (back + forth) + e^2,
            // with e = this by less than itself
            result.margin =
                std::min(result.margin, std::abs(test) / (2 * (std::sqrt(back) + std::sqrt(forth))));
        }
        if (test > 0 && t > 1) {
            t = 1;
            ++result.restarts;
        }
        const double next = (1 + std::sqrt(1 + 4 * t * t)) / 2;
        result.theta.push_back((t - 1) / next);
        t = next;
        double p = 0;
        double y = 0;
        for (Amplitude& a : amplitudes) {
            a.add_momentum(result.theta.back(), floor);
            p += std::abs(a.p);
            y += std::abs(a.y);
        }
        result.reach = std::max({result.reach, p, y});
        record();
    }
    return result;
}

/// |G(k)|^2, k in units of 1/dx, with the sign that a search for a minimum wants.
double negative_symbol(const gsl_vector* k, void* lattice)
{
    const auto& l = *static_cast<const Lattice*>(lattice);
    const Vector3d wave(gsl_vector_get(k, 0), gsl_vector_get(k, 1), gsl_vector_get(k, 2));
    return -gradient_sum(l, wave / l.dx).value.squaredNorm();
}

/// The largest |G|^2 that a simplex search finds from k, in units of 1/dx.
double climb(const Lattice& lattice, const Vector3d& k)
{
    Lattice l = lattice;
    gsl_multimin_function f{negative_symbol, 3, &l};
    const Owned<gsl_multimin_fminimizer, gsl_multimin_fminimizer_free> search(
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 3));
    const Owned<gsl_vector, gsl_vector_free> start(gsl_vector_alloc(3));
    const Owned<gsl_vector, gsl_vector_free> step(gsl_vector_alloc(3));
    for (std::size_t a = 0; a < 3; ++a) {
        gsl_vector_set(start.get(), a, k(static_cast<Eigen::Index>(a)));
        gsl_vector_set(step.get(), a, 0.2);
    }
    gsl_check(gsl_multimin_fminimizer_set(search.get(), &f, start.get(), step.get()), "search of a maximum");
    for (int n = 0; n < 300 && gsl_multimin_fminimizer_size(search.get()) > 1e-8; ++n) {
        gsl_check(gsl_multimin_fminimizer_iterate(search.get()), "search of a maximum");
    }
    return -gsl_multimin_fminimizer_minimum(search.get());
}

} // namespace

Estimate dfsph_factor(const Medium& medium)
{
    const Estimate squares = gradient_square_sum(medium.lattice);
    const double alpha = 1 / (medium.mass * medium.mass * squares.value);
    return {alpha, alpha * (squares.error / squares.value + 4 * u)};
}

Estimate step_factor(const Lattice& lattice, double omega, const Vector3d& k)
{
    const Estimate squares = gradient_square_sum(lattice);
    const VectorEstimate G = gradient_sum(lattice, k);
    const double part = omega * G.value.squaredNorm() / squares.value;
    const double of_G = 2 * omega * G.value.cwiseAbs().sum() * G.error / squares.value;
    return {1 - part, of_G + part * (squares.error / squares.value + 8 * u) + u};
}

Iteration accelerated_waves(const Medium& medium, double omega, double dt,
                            std::span<const ResidualWave> waves, int n)
{
    const Estimate alpha = dfsph_factor(medium);
    const double factor = omega * medium.density * medium.density / dt;
    std::vector<Amplitude> amplitudes;
    for (const ResidualWave& wave : waves) {
        Amplitude a;
        a.g = step_factor(medium.lattice, omega, wave.k);
        a.per_residual = factor * alpha.value;
        a.source = {a.per_residual * wave.residual,
                    std::abs(factor * wave.residual) * (alpha.error + 8 * u * alpha.value)};
        a.mean_square = wave.mean_square;
        amplitudes.push_back(a);
    }
    return accelerate(amplitudes, n, -std::numeric_limits<double>::infinity());
}

double error_gain(std::span<const double> theta, double g)
{
    ErrorGrowth growth;
    double most = 0;
    for (const double t : theta) {
        growth.iterate(g, t);
        most = std::max(most, growth.sum());
    }
    return most;
}

Iteration accelerated_two_bodies(const TwoBodies& bodies, double omega, double dt, int n)
{
    const double slope = bodies.mass * kernel_slope(bodies.kernel, bodies.h, bodies.distance);
    const double alpha = 1 / (2 * slope * slope);
    Amplitude a;
    a.g = {1 - 2 * omega, u};
    a.per_residual = omega * bodies.rho_0 * bodies.rho_0 * alpha / dt;
    a.source.value = a.per_residual * bodies.residual;
    a.source.error = (2 * 32 + 12) * u * std::abs(a.source.value); // 32 u of the slope, squared
    a.y = a.p = bodies.pressure;
    return accelerate({a}, n, bodies.lowest);
}

double largest_root(double theta, double g)
{
    gsl_complex z_0;
    gsl_complex z_1;
    gsl_poly_complex_solve_quadratic(1, -(1 + theta) * g, theta * g, &z_0, &z_1);
    return std::max(std::hypot(GSL_REAL(z_0), GSL_IMAG(z_0)), std::hypot(GSL_REAL(z_1), GSL_IMAG(z_1)));
}

Estimate relaxation_limit(const Lattice& lattice)
{
    constexpr int points = 12;
    gsl_return_errors();
    const Estimate squares = gradient_square_sum(lattice);
    double best = 0;
    Vector3d start = Vector3d::Zero();
    for (int i = 0; i <= points; ++i) { // 0 <= k_z <= k_y <= k_x <= pi: the lattice's symmetry gives the rest
        for (int j = 0; j <= i; ++j) {
            for (int n = 0; n <= j; ++n) {
                const Vector3d k = pi / points * Vector3d(i, j, n);
                const double symbol = gradient_sum(lattice, k / lattice.dx).value.squaredNorm();
                if (symbol > best) {
                    best = symbol;
                    start = k;
                }
            }
        }
    }
    const double largest = std::max(best, climb(lattice, start));
    const double limit = 4.0 / 3 * squares.value / largest;
    // the search ends 1e-8 from the maximum, where |G|^2 is flat; rounding of both sums remains
    const VectorEstimate G = gradient_sum(lattice, start / lattice.dx);
    return {limit, limit * (squares.error / squares.value + 6 * G.error / std::sqrt(largest) + 8 * u)};
}

} // namespace aneurysm::analytic
