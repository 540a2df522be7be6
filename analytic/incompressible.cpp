// SPDX-License-Identifier: Apache-2.0
#include "analytic/incompressible.hpp"

#include <gsl/gsl_multimin.h>

#include <numbers>

namespace aneurysm::analytic
{
namespace
{

using Eigen::Vector3d;
using std::numbers::pi;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

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

Estimate jacobi_factor(const Lattice& lattice, double omega, const Vector3d& k)
{
    const Estimate squares = gradient_square_sum(lattice);
    const VectorEstimate G = gradient_sum(lattice, k);
    const double part = omega * G.value.squaredNorm() / squares.value;
    const double of_G = 2 * omega * G.value.cwiseAbs().sum() * G.error / squares.value;
    return {1 - part, of_G + part * (squares.error / squares.value + 8 * u) + u};
}

Estimate jacobi_pressure(const Medium& medium, double omega, double dt, const Vector3d& k, double r_0, int n)
{
    const Estimate g = jacobi_factor(medium.lattice, omega, k);
    const Estimate alpha = dfsph_factor(medium);
    double sum = 0;   // 1 + g + ... + g^(n - 1), also for g = 1
    double slope = 0; // of that sum in g
    for (int i = 0; i < n; ++i) {
        slope = slope * std::abs(g.value) + std::abs(sum);
        sum = sum * g.value + 1;
    }
    const double factor = omega * medium.density * medium.density / dt * r_0;
    return {factor * alpha.value * sum,
            std::abs(factor) *
                (alpha.error * std::abs(sum) +
                 alpha.value * (slope * g.error + 2 * n * u * std::abs(sum) + 8 * u * std::abs(sum)))};
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
    const double limit = 2 * squares.value / largest;
    // the search ends 1e-8 from the maximum, where |G|^2 is flat; rounding of both sums remains
    const VectorEstimate G = gradient_sum(lattice, start / lattice.dx);
    return {limit, limit * (squares.error / squares.value + 6 * G.error / std::sqrt(largest) + 8 * u)};
}

} // namespace aneurysm::analytic
