// SPDX-License-Identifier: Apache-2.0
// Section 3.1: incompressible blood, (3), in its two parts, the pressure and the correction of the density, by the
// same iteration as reference/incompressible.hpp: Nesterov's accelerated projected gradient with restart.
#pragma once

#include "common/guards.hpp"
#include "common/particles.hpp"
#include "cuda/blood_flow.hpp"
#include "cuda/controller.hpp"

#include <limits>

namespace aneurysm::device
{

/// The unknown of a solve of (3).
enum class Unknown {
    pressure,   ///< changes the velocity; driven blood is given
    correction, ///< kappa, moves the blood; all of it, at rest
};

/// The velocity that an unknown makes: v* + dt a(p) or dt a(kappa).
template <Unknown unknown, class Real>
ANEURYSM_INLINE Row<Real>* velocity_of(const Fields<Real>& f)
{
    return unknown == Unknown::pressure ? f.solved_velocity : f.correction;
}

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

/// DFSPH factor (Bender and Koschier 2015); 0 for a body without neighbors; `sum`: of m_j grad W_ij over all j, twice over
/// mirror images, `squares`: of its squares over free j:
///
///     alpha_i = 1 / ( |sum_j w_j m_j grad W_ij|^2 + sum_{j free} |m_j grad W_ij|^2 )           [m^8/kg^2]
template <class Real>
ANEURYSM_HD Real dfsph_factor(const Vec3T<Real>& sum, Real squares)
{
    const Real denominator = dot(sum, sum) + squares;
    return denominator > 0 ? 1 / denominator : 0;
}

/// Pressure acceleration in its momentum-conserving form; p_j = p_i for a mirror image:
///
///     a_i = -sum_j m_j (p_i + p_j) / rho_0^2 grad W_ij                                        [m/s^2]
template <bool kept, class Real>
ANEURYSM_INLINE Vec3T<Real> pressure_acceleration(const Fields<Real>& f, Index i, Lane lane)
{
    const Real p_i = f.p[i];
    const Lanes<Real> own(p_i);
    Vec3T<Lanes<Real>> a;
    for (Index b = f.blood.begin[i]; b < f.blood.begin[i + 1]; ++b) {
        const Lanes<Index> j = neighbors(f.blood, b, lane);
        a += (own + gather(f.p, j)) * gradient<kept>(f, i, b, j, lane);
    }
    const Vec3T<Real> total = sum(a, lane) + p_i * f.mirrors[i].vector();
    return -1 / (f.c.rho_0 * f.c.rho_0) * total;
}

/// source_i + Drho_i/Dt: what (3) leaves over [kg/(m^3 s)].
template <class Real>
ANEURYSM_INLINE Real residual(const Fields<Real>& f, Index i)
{
    return f.source[i] + f.rate[i];
}

/// p >= lowest; what is no number stays none.
template <class Number>
ANEURYSM_INLINE Number bounded(const Number& p, const Number& lowest)
{
    return select(p < lowest, lowest, p);
}

/// Whether blood is in the far layers of a buffer, whose neighborhoods aren't full.
template <class Real>
ANEURYSM_HD bool is_far(const Fields<Real>& f, Index i)
{
    const Vec3T<Real> x = f.body_position[i].vector();
    const Real far = static_cast<Real>(opening_layers - guards::open_layers) * f.c.dx;
    return open_end(f.kind[f.order[i]]) >= 0 && opening(f, nearest_tube(f, x)).beyond(x) > far;
}

/// The equations of the pressure: driven blood and walls are mirror images, which count twice.
template <class Real>
struct PosePressure {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const
    {
        const Row<Real> blood = f.blood_gradient[i];
        const Row<Real> walls = f.wall_gradient[i];
        const Row<Real> driven = f.driven_gradient[i];
        const Vec3T<Real> mirrors = Real(2) * walls.vector() + driven.vector();
        const bool is_given = f.is_driven[i] == 1;
        f.is_given[i] = f.is_driven[i];
        f.mirrors[i] = row(mirrors, driven.w);
        f.alpha[i] = is_given ? 0 : dfsph_factor(blood.vector() + mirrors, walls.w);
        f.source[i] = f.c.corrects_density ? (f.source[i] + missing(i)) / f.c.dt : 0;
        f.lowest[i] = static_cast<Real>(f.level() - f.c.p_const); // no absolute pressure below 0
    }

private:
    /// Where there is a void, but in a buffer's far layers, the density may rise to rho_0 [kg/m^3]
    ANEURYSM_HD Real missing(Index i) const
    {
        const Real rho = f.body_velocity[i].w;
        const bool has_void = rho < static_cast<Real>(guards::void_density) * f.c.rho_0;
        return has_void && !is_far(f, i) ? rho - f.c.rho_0 : 0;
    }
};

/// The equations of the density's correction: the part beta of the error of the density that `source` holds goes. One that
/// doesn't pull sees walls as mirror images.
template <class Real>
struct PoseCorrection {
    Fields<Real> f;
    Real beta;
    bool pulls;

    ANEURYSM_HD void operator()(Index i) const
    {
        const Row<Real> blood = f.blood_gradient[i];
        const Vec3T<Real> walls = (pulls ? Real(1) : Real(2)) * f.wall_gradient[i].vector();
        f.is_given[i] = 0;
        f.mirrors[i] = row(walls, Real(0));
        f.alpha[i] = dfsph_factor(blood.vector() + walls, blood.w);
        f.source[i] = beta * (f.source[i] - f.c.rho_0) / f.c.dt;
        f.lowest[i] = pulls && !is_open(i) ? std::numeric_limits<Real>::lowest() : 0;
    }

private:
    /// Beside a void, outside of the wall, or in the far layers of a buffer: nothing pulls there.
    ANEURYSM_HD bool is_open(Index i) const
    {
        const Real rho = f.body_velocity[i].w;
        return f.kind[f.order[i]] == Kind::escaped || is_far(f, i) ||
               rho < static_cast<Real>(guards::void_density) * f.c.rho_0;
    }
};

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

/// What the last step left, in sorted order; nothing of what is given now.
template <Unknown unknown, class Real>
struct SortPotential {
    Fields<Real> f;
    bool from_zero;

    ANEURYSM_HD void operator()(Index i) const
    {
        const Index id = f.order[i];
        const Real last = unknown == Unknown::pressure ? f.pressure[id] : f.kappa[id];
        f.p[i] = f.is_given[i] == 1 ? static_cast<Real>(unset_pressure) : from_zero ? 0 : last;
    }
};

/// Takes spray out, and starts from the last step's potential;
/// a particle that has none starts from its neighbors' mean.
template <class Real>
struct StartSolve {
    Fields<Real> f;
    const LargestInverse* largest;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        constexpr auto unset = static_cast<Real>(unset_pressure);
        Real p = f.p[i];
        if (p == unset && f.alpha[i] > 0) {
            p = neighbors_mean(unset, i, lane);
        }
        if (lane.is_first()) {
            const Real alpha = f.alpha[i];
            const bool is_spray = !(static_cast<double>(alpha) * largest->value <= guards::spray);
            f.p_old[i] =
                is_spray || !(alpha > 0) ? 0 : bounded(p, f.lowest[i]); // the others' p is still to be read
            f.response[i] = is_spray ? 0 : f.c.omega * f.c.rho_0 * f.c.rho_0 / f.c.dt * alpha;
            f.alpha[i] = is_spray ? 0 : alpha;
        }
    }

private:
    ANEURYSM_HD Real neighbors_mean(Real unset, Index i, Lane lane) const
    {
        Lanes<Real> total;
        Lanes<Real> count;
        for (Index b = f.blood.begin[i]; b < f.blood.begin[i + 1]; ++b) {
            const Lanes<Index> j = neighbors(f.blood, b, lane);
            const Lanes<Real> p = gather(f.p, j);
            const Mask known = (p != Lanes<Real>(unset)) & (j != Lanes<Index>(f.c.null_body()));
            total += select(known, p, Lanes<Real>(0));
            count += select(known, Lanes<Real>(1), Lanes<Real>(0));
        }
        const Real n = sum(count, lane);
        const Real t = sum(total, lane);
        return n > 0 ? t / n : 0;
    }
};

/// The first y of the iteration is p_old.
template <class Real>
struct TakeStart {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const { f.p[i] = f.p_old[i]; }
};

/// a of the unknown, and the velocity that it makes.
template <Unknown unknown, bool kept, class Real>
struct Accelerate {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        const Vec3T<Real> of_potential = pressure_acceleration<kept>(f, i, lane);
        if (lane.is_first()) {
            const Vec3T<Real> a = f.is_given[i] == 1 ? Vec3T<Real>{} : of_potential;
            if constexpr (unknown == Unknown::pressure) {
                f.acceleration[i] = row(a, Real(0));
                f.solved_velocity[i] = row(f.body_velocity[i].vector() + f.c.dt * a, Real(0));
            } else {
                f.correction[i] = row(f.c.dt * a, Real(0));
            }
        }
    }
};

/// Drho/Dt of the velocity that an unknown makes; none of what is given.
template <Unknown unknown, bool kept, class Real>
struct Rates {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        const Real rate = density_rate<kept>(f, velocity_of<unknown>(f), i, lane);
        if (lane.is_first()) {
            f.rate[i] = f.is_given[i] == 1 ? 0 : rate;
        }
    }
};

template <class Real>
struct Residuals {
    Fields<Real> f;

    ANEURYSM_HD SolveSums operator()(Index i) const
    {
        return terms(residual(f, i), f.rate[i], f.p[i], f.p_old[i], f.lowest[i], f.alpha[i], f.response[i],
                     f.is_given[i] < 1);
    }
    ANEURYSM_INLINE SolveSumsOf<Lanes<double>> eight(Index i, Lane lane) const
    {
        const Lanes<Real> rate = load(f.rate + i, lane);
        return terms(load(f.source + i, lane) + rate, rate, load(f.p + i, lane), load(f.p_old + i, lane),
                     load(f.lowest + i, lane), load(f.alpha + i, lane), load(f.response + i, lane),
                     load(f.is_given + i, lane) < Lanes<Index>(1));
    }

private:
    /// Of a particle or of eight; `r`: residual.
    template <class Number, class Truth>
    ANEURYSM_INLINE static auto terms(const Number& r, const Number& rate, const Number& p,
                                      const Number& p_old, const Number& lowest, const Number& alpha,
                                      const Number& response, const Truth& is_unknown)
    {
        using Wide = decltype(widen(r));
        const Number zero = 0;
        const auto acts = (zero < alpha) & ((lowest < p) | (zero < r));
        const Wide residual = widen(select(acts, larger(r, zero - r), zero));
        const Wide divergence = widen(larger(rate, zero - rate));
        const Number next = bounded(p + response * r, lowest);
        // weighed by 1/alpha, up to a constant
        const Wide uphill = widen(p - next) * widen(next - p_old) / widen(alpha);
        const Wide restart = select(zero < alpha, uphill, Wide(0));
        const Wide count = widen(select(is_unknown, Number(1), zero));
        return SolveSumsOf<Wide>{count, residual, residual, divergence, divergence, restart};
    }
};

/// When a solve ends.
struct SolveLimits {
    Index iterations = 0;     ///< at most
    double tolerance = 0;     ///< for the mean |residual| / rho_0 [1/s]
    double max_tolerance = 0; ///< for the largest [1/s]
};

/// Before the first evaluation of a solve.
struct BeginSolve {
    Scene* scene;

    ANEURYSM_HD void operator()() const
    {
        scene->solving = 1;
        scene->slicing = 0;
        scene->solve_iterations = 0;
        scene->solve_t = 1;
    }
};

/// Whether (3) is met, and if not, the momentum of the next iteration.
template <Unknown unknown>
struct CheckSolve {
    Scene* scene;
    const SolveSums* sums;
    double rho_0;
    SolveLimits limits;

    ANEURYSM_HD void operator()() const
    {
        Scene& s = *scene;
        const double mass = rho_0 * (sums->count > 0 ? sums->count : 1);
        const double mean = sums->residual / mass;
        const double largest = sums->residual_max / rho_0;
        const bool met = mean <= limits.tolerance && largest <= limits.max_tolerance;
        s.solving = !met && s.solve_iterations < limits.iterations ? 1 : 0;
        if (s.solving == 0) {
            keep(mean, largest, mass);
            return;
        }
        ++s.solve_iterations;
        const double t = sums->restart > 0 ? 1 : s.solve_t;
        s.solve_t = (1 + std::sqrt(1 + 4 * t * t)) / 2;
        s.solve_theta = (t - 1) / s.solve_t;
    }

private:
    ANEURYSM_HD void keep(double mean, double largest, double mass) const
    {
        FrameRecord& r = scene->record;
        if constexpr (unknown == Unknown::correction) {
            r.corrections += scene->solve_iterations;
        } else {
            r.iterations += scene->solve_iterations;
            r.residual_mean = mean;
            r.residual_max = largest;
            r.divergence_mean = sums->divergence / mass;
            r.divergence_max = sums->divergence_max / rho_0;
        }
    }
};

/// One iteration: a step along the residual, then the momentum.
template <class Real>
struct IteratePressure {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const
    {
        const Real lowest = f.lowest[i];
        const Real p = bounded(f.p[i] + f.response[i] * residual(f, i), lowest);
        const Real next = p + static_cast<Real>(f.scene->solve_theta) * (p - f.p_old[i]);
        f.p[i] = bounded(next, lowest);
        f.p_old[i] = p;
    }
};

} // namespace aneurysm::device
