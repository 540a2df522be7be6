// SPDX-License-Identifier: Apache-2.0
// Section 3.1: the incompressible pressure (3), by the same iteration as reference/incompressible.hpp:
// Nesterov's accelerated projected gradient with restart.
#pragma once

#include "common/guards.hpp"
#include "cuda/blood_flow.hpp"

namespace aneurysm::device
{

/// What one evaluation of (3) sums up over the free particles; of one lane, or of all eight.
template <class Number>
struct SolveSumsOf {
    Number count = 0;
    Number residual = 0; ///< |residual| where the pressure can act [kg/(m^3 s)]
    Number residual_max = 0;
    Number divergence = 0; ///< |Drho/Dt| [kg/(m^3 s)]
    Number divergence_max = 0;
    Number restart = 0; ///< positive: the momentum points uphill

    ANEURYSM_INLINE SolveSumsOf& operator+=(const SolveSumsOf& b)
    {
        count += b.count;
        residual += b.residual;
        residual_max = larger(residual_max, b.residual_max);
        divergence += b.divergence;
        divergence_max = larger(divergence_max, b.divergence_max);
        restart += b.restart;
        return *this;
    }
    void take_apart(SolveSumsOf<double>* lanes) const
    {
        for (int l = 0; l < lane_count; ++l) {
            lanes[l] = {count.v[l],      residual.v[l],       residual_max.v[l],
                        divergence.v[l], divergence_max.v[l], restart.v[l]};
        }
    }
};
using SolveSums = SolveSumsOf<double>;

/// DFSPH factor (Bender and Koschier 2015); 0 for a body without neighbors:
///
///     alpha_i = 1 / ( |sum_j m_j grad W_ij|^2 + sum_{j free} |m_j grad W_ij|^2 )               [m^8/kg^2]
template <class Real>
ANEURYSM_HD Real dfsph_factor(const Vec3T<Real>& sum, Real squares)
{
    const Real denominator = dot(sum, sum) + squares;
    return denominator > 0 ? 1 / denominator : 0;
}

/// Pressure acceleration in its momentum-conserving form; a ghost adds its neighbor's pressure once:
///
///     a_i = -sum_j m_j (p_i + p_j) / rho_0^2 grad W_ij                                        [m/s^2]
template <bool kept, class Real>
ANEURYSM_INLINE Vec3T<Real> pressure_acceleration(const Fields<Real>& f, Index i, Lane lane)
{
    const Real p_i = f.p[i];
    const Lanes<Real> own(p_i);
    Vec3T<Lanes<Real>> a;
    for (Index b = f.free.begin[i]; b < f.free.begin[i + 1]; ++b) {
        const Lanes<Index> j = neighbors(f.free, b, lane);
        a += (own + gather(f.p, j)) * gradient<kept>(f, i, b, j, lane);
    }
    const Vec3T<Real> total = sum(a, lane) + p_i * f.ghost_gradient[i].vector();
    return -1 / (f.c.rho_0 * f.c.rho_0) * total;
}

/// beta (rho_i - rho_0) / dt + Drho_i/Dt: what (3) leaves over [kg/(m^3 s)].
template <class Real>
ANEURYSM_INLINE Real residual(const Fields<Real>& f, Index i)
{
    return f.source[i] + f.rate[i];
}

/// p >= 0; what is no number stays none.
template <class Real>
ANEURYSM_INLINE Real positive(Real p)
{
    return !(p < 0) ? p : 0;
}

/// The pressure of particle i after a step along its residual.
template <class Real>
ANEURYSM_INLINE Real projected(const Fields<Real>& f, Index i)
{
    return positive(f.p[i] + f.response[i] * residual(f, i));
}

/// The smallest DFSPH factor, as the largest of its inverse.
struct LargestInverse {
    double value = 0;

    ANEURYSM_HD LargestInverse& operator+=(const LargestInverse& b)
    {
        value = value < b.value ? b.value : value;
        return *this;
    }
};
template <class Real>
struct InverseFactor {
    Fields<Real> f;

    ANEURYSM_HD LargestInverse operator()(Index i) const
    {
        return {f.alpha[i] > 0 ? 1 / static_cast<double>(f.alpha[i]) : 0};
    }
};

/// Takes spray out, and starts from the last step's pressure;
/// a particle that has none starts from its neighbors' mean.
template <class Real>
struct StartSolve {
    Fields<Real> f;
    const LargestInverse* largest;
    bool from_zero;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        Real p = from_zero ? 0 : f.pressure[f.order[i]];
        if (p < 0) {
            p = neighbors_mean(i, lane);
        }
        if (lane.is_first()) {
            const bool is_spray = !(static_cast<double>(f.alpha[i]) * largest->value <= guards::spray);
            f.p_old[i] = is_spray ? 0 : p; // the others' p is still to be read
            f.alpha[i] = is_spray ? 0 : f.alpha[i];
        }
    }

private:
    ANEURYSM_HD Real neighbors_mean(Index i, Lane lane) const
    {
        Lanes<Real> total;
        Lanes<Real> count;
        for (Index b = f.free.begin[i]; b < f.free.begin[i + 1]; ++b) {
            const Lanes<Index> j = neighbors(f.free, b, lane);
            const Lanes<Real> p = gather(f.p, j);
            const Mask known = p >= Lanes<Real>(0);
            const Mask real = j != Lanes<Index>(f.c.null_body());
            total += select(known & real, p, Lanes<Real>(0));
            count += select(known & real, Lanes<Real>(1), Lanes<Real>(0));
        }
        const Real n = sum(count, lane);
        const Real t = sum(total, lane);
        return n > 0 ? t / n : 0;
    }
};

/// The pressure that the last step left, in sorted order.
template <class Real>
struct SortPressure {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const { f.p[i] = f.pressure[f.order[i]]; }
};

/// What stays the same through a solve: the density's part of the residual, and how much pressure an
/// iteration answers it with.
template <class Real>
struct PrepareSolve {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const
    {
        const Real beta = static_cast<Real>(f.scene->density_correction);
        f.source[i] = beta * (f.body_velocity[i].w - f.c.rho_0) / f.c.dt;
        f.response[i] = f.c.omega * f.c.rho_0 * f.c.rho_0 / f.c.dt * f.alpha[i];
        f.p[i] = f.p_old[i];
    }
};

/// a(p) and v = v* + dt a.
template <class Real, bool kept>
struct AccelerateByPressure {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        const Vec3T<Real> a = pressure_acceleration<kept>(f, i, lane);
        if (lane.is_first()) {
            f.acceleration[i] = row(a, Real(0));
            f.solved_velocity[i] = row(f.body_velocity[i].vector() + f.c.dt * a, Real(0));
        }
    }
};

template <class Real, bool kept>
struct Rates {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        const Real rate = density_rate<kept>(f, f.solved_velocity, i, lane);
        if (lane.is_first()) {
            f.rate[i] = rate;
        }
    }
};

template <class Real>
struct Residuals {
    Fields<Real> f;

    ANEURYSM_HD SolveSums operator()(Index i) const
    {
        return terms(residual(f, i), f.rate[i], f.p[i], f.p_old[i], f.alpha[i], f.response[i]);
    }
    ANEURYSM_INLINE SolveSumsOf<Lanes<double>> eight(Index i, Lane lane) const
    {
        const Lanes<Real> rate = load(f.rate + i, lane);
        return terms(load(f.source + i, lane) + rate, rate, load(f.p + i, lane), load(f.p_old + i, lane),
                     load(f.alpha + i, lane), load(f.response + i, lane));
    }

private:
    /// Of a particle or of eight; `r`: residual.
    template <class Number>
    ANEURYSM_INLINE static auto terms(const Number& r, const Number& rate, const Number& p,
                                      const Number& p_old, const Number& alpha, const Number& response)
    {
        using Wide = decltype(widen(r));
        const Number zero = 0;
        const auto acts = (zero < alpha) & ((zero < p) | (zero < r));
        const Wide residual = widen(select(acts, larger(r, zero - r), zero));
        const Wide divergence = widen(larger(rate, zero - rate));
        const Number next = larger(p + response * r, zero);
        // weighed by 1/alpha, up to a constant
        const Wide uphill = widen(p - next) * widen(next - p_old) / widen(alpha);
        const Wide restart = select(zero < alpha, uphill, Wide(0));
        return SolveSumsOf<Wide>{Wide(1), residual, residual, divergence, divergence, restart};
    }
};

/// Before the first evaluation of a solve.
struct BeginSolve {
    Scene* scene;
    double density_correction;
    Index max_iterations;

    ANEURYSM_HD void operator()() const
    {
        scene->solving = 1;
        scene->solve_iterations = 0;
        scene->max_iterations = max_iterations;
        scene->solve_t = 1;
        scene->density_correction = density_correction;
    }
};

/// Whether (3) is met, and if not, the momentum of the next iteration.
struct CheckSolve {
    Scene* scene;
    const SolveSums* sums;
    double rho_0;
    double tolerance;
    double max_tolerance;

    ANEURYSM_HD void operator()() const
    {
        Scene& s = *scene;
        const double mass = rho_0 * (sums->count > 0 ? sums->count : 1);
        s.record.residual_mean = sums->residual / mass;
        s.record.residual_max = sums->residual_max / rho_0;
        s.record.divergence_mean = sums->divergence / mass;
        s.record.divergence_max = sums->divergence_max / rho_0;
        const bool met = s.record.residual_mean <= tolerance && s.record.residual_max <= max_tolerance;
        s.solving = !met && s.solve_iterations < s.max_iterations ? 1 : 0;
        if (s.solving == 0) {
            s.record.iterations += s.solve_iterations;
            return;
        }
        ++s.solve_iterations;
        const double t = sums->restart > 0 ? 1 : s.solve_t;
        s.solve_t = (1 + std::sqrt(1 + 4 * t * t)) / 2;
        s.solve_theta = (t - 1) / s.solve_t;
    }
};

/// One iteration: a step along the residual, then the momentum.
template <class Real>
struct IteratePressure {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const
    {
        const Real p = projected(f, i);
        const Real next = p + static_cast<Real>(f.scene->solve_theta) * (p - f.p_old[i]);
        f.p[i] = positive(next);
        f.p_old[i] = p;
    }
};

} // namespace aneurysm::device
