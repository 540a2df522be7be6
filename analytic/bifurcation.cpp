// SPDX-License-Identifier: Apache-2.0
#include "analytic/bifurcation.hpp"

#include <gsl/gsl_multimin.h>

#include <numbers>

namespace aneurysm::analytic
{
namespace
{

using std::numbers::pi;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// A radius of the right order: both costs are alike there.
double scale_radius(const VesselCost& cost, double Q)
{
    return std::pow(cost.mu * Q * Q / cost.b, 1.0 / 6);
}

} // namespace

double vessel_cost(const VesselCost& cost, double Q, double r)
{
    return 8 * cost.mu * Q * Q / (pi * std::pow(r, 4)) + cost.b * pi * r * r;
}

Estimate cheapest_radius(const VesselCost& cost, double Q)
{
    const auto slope = [&](double r) {
        return -32 * cost.mu * Q * Q / (pi * std::pow(r, 5)) + 2 * cost.b * pi * r;
    };
    const double guess = scale_radius(cost, Q);
    Estimate r = find_root(slope, guess / 10, guess * 10);
    // the two terms cancel at the root: 8 roundings each against the slope's own slope, 6 times a term over r
    r.error += 16 * u * r.value / 6;
    return r;
}

Estimate cheapest_radius_by_search(const VesselCost& cost, double Q)
{
    const double scale = scale_radius(cost, Q);
    auto f = [&](double x) { return vessel_cost(cost, Q, scale * std::exp(x)); };
    gsl_multimin_function wrapped{[](const gsl_vector* x, void* self) {
                                      return (*static_cast<decltype(f)*>(self))(gsl_vector_get(x, 0));
                                  },
                                  1, &f};
    gsl_return_errors();
    const Owned<gsl_multimin_fminimizer, gsl_multimin_fminimizer_free> search(
        gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 1));
    const Owned<gsl_vector, gsl_vector_free> start(gsl_vector_calloc(1));
    const Owned<gsl_vector, gsl_vector_free> step(gsl_vector_calloc(1));
    gsl_vector_set(step.get(), 0, 0.5);
    gsl_check(gsl_multimin_fminimizer_set(search.get(), &wrapped, start.get(), step.get()),
              "search of a minimum");
    for (int k = 0; k < 200 && gsl_multimin_fminimizer_size(search.get()) > 1e-9; ++k) {
        gsl_check(gsl_multimin_fminimizer_iterate(search.get()), "search of a minimum");
    }
    const double r = scale * std::exp(gsl_vector_get(gsl_multimin_fminimizer_x(search.get()), 0));
    // C = C_min (1 + 4 x^2) in x = ln r: C's 16 roundings hide |x| < sqrt(16 u/4); the simplex adds its size
    return {r, r * (2 * std::sqrt(u) + gsl_multimin_fminimizer_size(search.get()))};
}

double branch_radius(double r_0, int n, double gamma)
{
    return r_0 * std::pow(n, -1 / gamma);
}

} // namespace aneurysm::analytic
