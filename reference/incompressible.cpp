// SPDX-License-Identifier: Apache-2.0
#include "reference/incompressible.hpp"

#include "common/guards.hpp"
#include "reference/slices.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace aneurysm::reference
{
namespace
{

struct Statistics {
    double sum = 0;
    double largest = 0;
    double count = 0;

    void add(double value)
    {
        sum += value;
        largest = std::max(largest, value);
        ++count;
    }
    double mean() const { return count > 0 ? sum / count : 0; }
};

/// The state of one solve.
class AcceleratedSolve
{
public:
    AcceleratedSolve(const IncompressibleProblem& problem, const IncompressibleSettings& settings,
                     std::span<double> p, std::span<Vec3> a)
        : problem_(problem), b_(*problem.bodies), settings_(settings), y_(p), a_(a), v_(b_.velocity),
          alpha_(b_.size(), 0), residual_(b_.size(), 0)
    {
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < b_.size(); ++i) {
            alpha_[i] = b_.free(i) ? dfsph_factor(problem, i) : 0;
            smallest = alpha_[i] > 0 ? std::min(smallest, alpha_[i]) : smallest;
        }
        for (std::size_t i = 0; i < b_.size(); ++i) {
            if (!(alpha_[i] <= guards::spray * smallest)) {
                alpha_[i] = 0;
            }
            y_[i] = alpha_[i] > 0 ? bounded(y_[i], i) : 0;
        }
        p_old_.assign(y_.begin(), y_.end());
        p_new_ = p_old_;
    }

    /// a(y), v = v* + dt a, and the residual of (3) with it.
    IncompressibleReport evaluate()
    {
        for (std::size_t i = 0; i < b_.size(); ++i) {
            if (b_.free(i)) {
                a_[i] = pressure_acceleration(problem_, y_, i);
                v_[i] = b_.velocity[i] + problem_.dt * a_[i];
            }
        }
        Statistics residuals;
        Statistics divergences;
        for (std::size_t i = 0; i < b_.size(); ++i) {
            if (b_.free(i)) {
                const double rate = density_rate(problem_, v_, i);
                residual_[i] = problem_.source[i] + rate;
                residuals.add(acts(i) ? std::abs(residual_[i]) / problem_.rho_0 : 0);
                divergences.add(std::abs(rate) / problem_.rho_0);
            }
        }
        return {0, residuals.mean(), residuals.largest, divergences.mean(), divergences.largest};
    }

    /// Adds a constant in each slice.
    void start_in_slices()
    {
        std::vector<bool> member(b_.size(), false);
        for (std::size_t i = 0; i < b_.size(); ++i) {
            member[i] = acts(i);
        }
        const std::vector<double> e = slice_potentials(problem_, member, residual_);
        for (std::size_t i = 0; i < b_.size(); ++i) {
            y_[i] = member[i] ? bounded(y_[i] + e[slice_of(problem_, i)], i) : y_[i];
        }
        p_old_.assign(y_.begin(), y_.end());
    }

    void iterate()
    {
        step();
        if (goes_back()) {
            t_ = 1;
        }
        add_momentum();
    }

private:
    /// Whether the potential of i can still take something off its residual.
    bool acts(std::size_t i) const
    {
        return alpha_[i] > 0 && (y_[i] > problem_.lowest[i] || residual_[i] > 0);
    }
    double bounded(double p, std::size_t i) const { return std::max(p, problem_.lowest[i]); }

    /// p_new = max(lowest, y + omega rho_0^2 alpha residual / dt).
    void step()
    {
        const double factor = settings_.relaxation * problem_.rho_0 * problem_.rho_0 / problem_.dt;
        for (std::size_t i = 0; i < b_.size(); ++i) {
            if (alpha_[i] > 0) {
                p_new_[i] = bounded(y_[i] + factor * alpha_[i] * residual_[i], i);
            }
        }
    }

    /// Whether the step from y to p_new turns back from the way that p_old to p_new went. Over alpha, as the
    /// step is one along the gradient in the variables p / sqrt(alpha).
    bool goes_back() const
    {
        double sum = 0;
        for (std::size_t i = 0; i < b_.size(); ++i) {
            if (alpha_[i] > 0) {
                sum += (y_[i] - p_new_[i]) * (p_new_[i] - p_old_[i]) / alpha_[i];
            }
        }
        return sum > 0;
    }

    /// y = max(lowest, p_new + theta (p_new - p_old)).
    void add_momentum()
    {
        const double t = (1 + std::sqrt(1 + 4 * t_ * t_)) / 2;
        const double theta = (t_ - 1) / t;
        for (std::size_t i = 0; i < b_.size(); ++i) {
            if (alpha_[i] > 0) {
                y_[i] = bounded(p_new_[i] + theta * (p_new_[i] - p_old_[i]), i);
            }
        }
        std::swap(p_old_, p_new_);
        t_ = t;
    }

    const IncompressibleProblem& problem_;
    const Bodies& b_;
    const IncompressibleSettings& settings_;
    std::span<double> y_;
    std::span<Vec3> a_;
    std::vector<Vec3> v_;
    std::vector<double> alpha_;
    std::vector<double> residual_;
    std::vector<double> p_old_;
    std::vector<double> p_new_;
    double t_ = 1;
};

} // namespace

double density_rate(const IncompressibleProblem& problem, std::span<const Vec3> v, std::size_t i)
{
    const Bodies& b = *problem.bodies;
    double rate = 0;
    for (const Neighbor& n : problem.neighbors->of(i)) {
        rate += weight(b, problem.given, n.j) * b.mass[n.j] * dot(v[i] - v[n.j], n.grad_W);
    }
    return rate;
}

Vec3 pressure_acceleration(const IncompressibleProblem& problem, std::span<const double> p, std::size_t i)
{
    const Bodies& b = *problem.bodies;
    Vec3 a;
    for (const Neighbor& n : problem.neighbors->of(i)) {
        const double mirrored = problem.given == Given::mirrors ? p[i] : 0;
        const double p_j = b.free(n.j) ? p[n.j] : mirrored;
        a += -b.mass[n.j] * (p[i] + p_j) / (problem.rho_0 * problem.rho_0) * n.grad_W;
    }
    return a;
}

double dfsph_factor(const IncompressibleProblem& problem, std::size_t i)
{
    const Bodies& b = *problem.bodies;
    Vec3 sum;
    double squares = 0;
    for (const Neighbor& n : problem.neighbors->of(i)) {
        const Vec3 g = b.mass[n.j] * n.grad_W;
        sum += weight(b, problem.given, n.j) * g;
        if (b.free(n.j)) {
            squares += dot(g, g);
        }
    }
    const double denominator = dot(sum, sum) + squares;
    return denominator > 0 ? 1 / denominator : 0;
}

IncompressibleReport solve_incompressibility(const IncompressibleProblem& problem,
                                             const IncompressibleSettings& settings, std::span<double> p,
                                             std::span<Vec3> a)
{
    AcceleratedSolve solve(problem, settings, p, a);
    IncompressibleReport report = solve.evaluate();
    const auto is_met = [&] {
        return report.residual_mean <= settings.tolerance && report.residual_max <= settings.max_tolerance;
    };
    if (problem.slices.count > 0 && settings.max_iterations > 0 && !is_met()) {
        solve.start_in_slices();
        report = solve.evaluate();
    }
    std::int64_t iterations = 0;
    while (iterations < settings.max_iterations && !is_met()) {
        solve.iterate();
        report = solve.evaluate();
        ++iterations;
    }
    report.iterations = iterations;
    return report;
}

IncompressibleReport divergence_report(const IncompressibleProblem& problem, std::span<const Vec3> v)
{
    Statistics divergences;
    for (std::size_t i = 0; i < problem.bodies->size(); ++i) {
        if (problem.bodies->free(i)) {
            divergences.add(std::abs(density_rate(problem, v, i)) / problem.rho_0);
        }
    }
    return {0, 0, 0, divergences.mean(), divergences.largest};
}

namespace
{

/// Calls visit(x) for each point of the cubic lattice of spacing 1 within `support` of the origin.
template <class Visit>
void for_each_lattice_neighbor(double support, const Visit& visit)
{
    const int n = static_cast<int>(std::ceil(support));
    for (int x = -n; x <= n; ++x) {
        for (int y = -n; y <= n; ++y) {
            for (int z = -n; z <= n; ++z) {
                visit(Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
            }
        }
    }
}

} // namespace

double lattice_kernel_sum(const Kernel& kernel, double dx)
{
    double sum = 0;
    for_each_lattice_neighbor(kernel.support() / dx,
                              [&](const Vec3& x) { sum += kernel.value(length(dx * x)); });
    return sum;
}

double relaxation_limit(KernelName kernel, double ratio)
{
    // The symbol is largest on or near the symmetry directions of the Brillouin zone; a grid of 32 points an
    // axis over the whole octant finds it to 0.15 %, and the factor below covers what the grid misses.
    constexpr int points = 32;
    constexpr double margin = 1.002;
    struct Term {
        Vec3 x;
        Vec3 gradient;
    };
    std::vector<Term> terms;
    double squares = 0;
    const Kernel W(kernel, ratio);
    for_each_lattice_neighbor(W.support(), [&](const Vec3& x) {
        const Vec3 g = W.gradient(x);
        squares += dot(g, g);
        if (dot(g, g) > 0) {
            terms.push_back({x, g});
        }
    });
    double largest = 0;
    for (int i = 0; i <= points; ++i) {
        for (int j = 0; j <= i; ++j) {
            for (int l = 0; l <= j; ++l) {
                const Vec3 k = std::numbers::pi / points *
                               Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(l)};
                Vec3 symbol;
                for (const Term& t : terms) {
                    symbol += std::sin(dot(k, t.x)) * t.gradient;
                }
                largest = std::max(largest, dot(symbol, symbol));
            }
        }
    }
    return 4.0 / 3 * squares / (margin * largest);
}

} // namespace aneurysm::reference
