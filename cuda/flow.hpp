// SPDX-License-Identifier: Apache-2.0
// What moves the blood in one flow step: the passes that use section 3.1, in the order in which they run.
#pragma once

#include "cuda/boundary.hpp"
#include "cuda/controller.hpp"
#include "cuda/incompressible.hpp"

namespace aneurysm::device
{

inline constexpr Index no_particle = 0x7fffffff;

/// Density (5), the sums of gradients that (3) and (26) need, and the mean drift of the density around a particle.
template <class Real>
struct Densities {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        f.c.is_periodic ? sum_up<true>(i, lane) : sum_up<false>(i, lane);
    }

private:
    template <bool periodic>
    ANEURYSM_INLINE void sum_up(Index i, Lane lane) const
    {
        using Number = Lanes<Real>;
        const Number zero(0);
        Number rho;
        Number drift;
        Number squares;
        Number squares_of_free;
        Number flux;
        Vec3T<Number> of_blood;
        Vec3T<Number> of_driven;
        for (Index b = f.blood.begin[i]; b < f.blood.begin[i + 1]; ++b) {
            const Lanes<Index> j = neighbors(f.blood, b, lane);
            const Pairs<Real> pair = pairs<periodic>(f, i, j);
            const Vec3T<Number> G = gradient(f, pair);
            const Number mW = density(f, pair);
            rho += mW;
            drift += mW * gather(f.body_drift, j);
            of_blood += G;
            squares += dot(G, G);
            const Mask is_driven = Lanes<Index>(0) < gather(f.is_driven, j);
            const Vec3T<Number> G_driven{select(is_driven, G.x, zero), select(is_driven, G.y, zero),
                                         select(is_driven, G.z, zero)};
            squares_of_free += select(is_driven, zero, dot(G, G));
            of_driven += G_driven;
            flux += dot(G_driven, gather_rows(f.body_velocity, j).vector());
            keep(G, b, lane);
        }
        Number rho_of_walls;
        Vec3T<Number> of_walls;
        for (Index b = f.walls.begin[i]; b < f.walls.begin[i + 1]; ++b) {
            const Pairs<Real> pair = pairs<periodic>(f, i, neighbors(f.walls, b, lane));
            rho_of_walls += density(f, pair);
            of_walls += gradient(f, pair);
        }
        const Real own = f.c.mass * first(f.c.kernel.value(Number(0)));
        const Real blood = sum(rho, lane) + own;
        const Real total = blood + sum(rho_of_walls, lane);
        const Real mean_drift = (sum(drift, lane) + own * f.body_drift[i]) / blood;
        const Row<Real> blood_gradient = row(sum(of_blood, lane), sum(squares, lane));
        const Row<Real> wall_gradient = row(sum(of_walls, lane), sum(squares_of_free, lane));
        const Row<Real> driven_gradient = row(sum(of_driven, lane), sum(flux, lane));
        if (lane.is_first()) {
            f.body_velocity[i].w = total;
            f.source[i] = mean_drift;
            f.blood_gradient[i] = blood_gradient;
            f.wall_gradient[i] = wall_gradient;
            f.driven_gradient[i] = driven_gradient;
        }
    }
    ANEURYSM_INLINE void keep(const Vec3T<Lanes<Real>>& G, Index b, Lane lane) const
    {
        if (f.gradient != nullptr) {
            Real* to = f.gradient + 3 * lane_count * b;
            store(to, G.x, lane);
            store(to + lane_count, G.y, lane);
            store(to + 2 * lane_count, G.z, lane);
        }
    }
};

/// Viscosity (7), the body force and the pressure beyond the outlets (26): all but the blood's own pressure.
template <class Real>
struct Forces {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        const Vec3T<Real> F_viscosity =
            f.c.is_periodic ? viscosity_force<true>(f, i, lane) : viscosity_force<false>(f, i, lane);
        if (lane.is_first()) {
            const Vec3T<Real> v = f.body_velocity[i].vector();
            const Real rho = f.body_velocity[i].w;
            const Vec3T<Real> force = momentum_force(rho, f.gravity(), F_viscosity, outlet_force(i));
            const Vec3T<Real> moved = v + f.c.dt * acceleration(rho, force);
            f.force[i] = row(F_viscosity, Real(0));
            f.solved_velocity[i] = row(f.is_driven[i] == 1 ? v : moved, Real(0));
        }
    }

private:
    ANEURYSM_HD Vec3T<Real> outlet_force(Index i) const
    {
        const Index k = open_end(f.kind[f.order[i]]);
        if (k < 1) {
            return {};
        }
        const Vec3T<Real> gradient = f.blood_gradient[i].vector() + f.wall_gradient[i].vector();
        const auto v = static_cast<Real>(f.scene->outlet_velocity[k - 1]);
        const Real depth = static_cast<Real>(opening_layers) * f.c.dx;
        return outlet_pressure_force(gradient, f.c.rho_0, static_cast<Real>(f.level())) +
               inflow_force(f.c.rho_0, v, depth, opening(f, k).outward);
    }
};

/// The velocity with all forces but the pressure's, which neighbors now no longer need as it was.
template <class Real>
struct TakeVelocity {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const
    {
        f.body_velocity[i] = row(f.solved_velocity[i].vector(), f.body_velocity[i].w);
    }
};

/// The pressure of the equation of state, and (6).
template <class Real>
struct AccelerateByState {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        const Vec3T<Real> F = pressure_force(f, i, lane);
        if (lane.is_first()) {
            const Real rho = f.body_velocity[i].w;
            const Vec3T<Real> a = f.is_driven[i] == 1 ? Vec3T<Real>{} : acceleration(rho, F);
            f.p[i] = equation_of_state(f.c.kappa, rho, f.c.rho_0);
            f.acceleration[i] = row(a, Real(0));
            f.solved_velocity[i] = row(f.body_velocity[i].vector() + f.c.dt * a, Real(0));
        }
    }
};

/// Nothing answers a residual in model `eos`.
template <class Real>
struct NoResponse {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const
    {
        f.alpha[i] = 0;
        f.response[i] = 0;
        f.p_old[i] = f.p[i];
    }
};

/// Model `eos` solves nothing: only the divergence is recorded.
struct RecordDivergence {
    Scene* scene;
    const SolveSums* sums;
    double rho_0;

    ANEURYSM_HD void operator()() const
    {
        scene->record.divergence_mean = sums->divergence / (rho_0 * (sums->count > 0 ? sums->count : 1));
        scene->record.divergence_max = sums->divergence_max / rho_0;
    }
};

/// The pressure of what is free goes back to where it is kept by id.
template <class Real>
struct KeepPressure {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index s) const
    {
        if (f.is_driven[s] == 0) {
            f.pressure[f.order[s]] = f.p[s];
        }
    }
};

/// Eq. (5) after all have gone their ways x' - x, over the neighbors that they had before, and what they have
/// added to it beyond dt Drho/Dt, the drift c_i; for the correction their shifts are ways, too:
///
///     rho*_i = sum_j m_j W(|r_ij + x'_i - x_i - (x'_j - x_j)|)                                 [kg/m^3]
template <class Real>
struct PredictDensities {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        f.c.is_periodic ? sum_up<true>(i, lane) : sum_up<false>(i, lane);
    }

private:
    template <bool periodic>
    ANEURYSM_INLINE void sum_up(Index i, Lane lane) const
    {
        using Number = Lanes<Real>;
        const Number dt(f.c.dt);
        const Vec3T<Number> own_way = dt * all_lanes(f.solved_velocity[i].vector());
        const Vec3T<Number> own_shift = all_lanes(f.shift[i].vector());
        Number rho;
        Number rho_shifted;
        const auto add = [&](const Number& m, const Vec3T<Number>& x, const Vec3T<Number>& shift) {
            const Vec3T<Number> shifted = x + shift;
            rho += m * f.c.kernel.value(sqrt(dot(x, x)));
            rho_shifted += m * f.c.kernel.value(sqrt(dot(shifted, shifted)));
        };
        for (Index b = f.blood.begin[i]; b < f.blood.begin[i + 1]; ++b) {
            const Lanes<Index> j = neighbors(f.blood, b, lane);
            const Pairs<Real> pair = pairs<periodic>(f, i, j);
            const Vec3T<Number> way = dt * gather_rows(f.solved_velocity, j).vector();
            add(pair.m, pair.x + own_way - way, own_shift - gather_rows(f.shift, j).vector());
        }
        for (Index b = f.walls.begin[i]; b < f.walls.begin[i + 1]; ++b) {
            const Pairs<Real> pair = pairs<periodic>(f, i, neighbors(f.walls, b, lane));
            add(pair.m, pair.x + own_way, own_shift);
        }
        const Real own = f.c.mass * first(f.c.kernel.value(Number(0)));
        const Real predicted = sum(rho, lane) + own;
        const Real shifted = sum(rho_shifted, lane) + own;
        if (lane.is_first()) {
            const Real drift = predicted - f.body_velocity[i].w - f.c.dt * f.rate[i];
            f.drift[f.order[i]] = f.is_driven[i] == 1 ? 0 : drift;
            f.source[i] = shifted;
        }
    }
};

/// The way of sorted particle s in this step [m]
template <class Real>
ANEURYSM_HD Vec3T<Real> moved_by(const Fields<Real>& f, Index s)
{
    const Vec3T<Real> way = f.c.dt * f.solved_velocity[s].vector();
    return f.c.corrects_density ? way + f.shift[s].vector() + f.c.dt * f.correction[s].vector() : way;
}

/// Moves all that is not in the reserve, and writes the step's results back by id.
template <class Real>
struct MoveParticles {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index s) const
    {
        const Index id = f.order[s];
        f.event[id] = 0;
        f.density[id] = f.c.rho_0;
        if (s < f.blood_count()) {
            const Vec3T<Real> x = f.position[id].vector() + moved_by(f, s);
            f.kappa[id] = f.c.corrects_density ? f.p[s] : f.kappa[id];
            f.velocity[id] = row(f.solved_velocity[s].vector(), Real(0));
            f.density[id] = f.body_velocity[s].w;
            f.position[id] = row(f.c.vessel.wrapped(x), Real(0));
        } else if (f.c.corrects_density) {
            f.kappa[id] = 0;
            f.drift[id] = 0;
        }
        const std::size_t at = static_cast<std::size_t>(f.step) * static_cast<std::size_t>(f.c.particles) +
                               static_cast<std::size_t>(id);
        f.solved_pressure[at] = f.pressure[id];
        f.solved_kappa[at] = f.kappa[id];
    }
};

/// What a step says of the flow, and what has gone wrong.
struct FlowSums {
    double count = 0;
    double excess = 0; ///< of max(rho/rho_0 - 1, 0)
    double error_max = -1;
    double error_min = 1e30;
    double error_max_ends = -1;
    double kinetic_energy = 0; ///< [J]
    double speed_max = 0;      ///< [m/s]
    Index too_dense = no_particle;
    Index too_far = no_particle;
    double distance = 0; ///< that the latter moved [m]

    ANEURYSM_HD FlowSums& operator+=(const FlowSums& b)
    {
        count += b.count;
        excess += b.excess;
        error_max = error_max < b.error_max ? b.error_max : error_max;
        error_min = b.error_min < error_min ? b.error_min : error_min;
        error_max_ends = error_max_ends < b.error_max_ends ? b.error_max_ends : error_max_ends;
        kinetic_energy += b.kinetic_energy;
        speed_max = speed_max < b.speed_max ? b.speed_max : speed_max;
        too_dense = b.too_dense < too_dense ? b.too_dense : too_dense;
        distance = b.too_far < too_far ? b.distance : distance;
        too_far = b.too_far < too_far ? b.too_far : too_far;
        return *this;
    }
};
template <class Real>
struct SumUpFlow {
    Fields<Real> f;

    ANEURYSM_HD FlowSums operator()(Index s) const
    {
        FlowSums sums;
        const Index id = f.order[s];
        const Real speed = length(f.solved_velocity[s].vector());
        const Real distance = length(moved_by(f, s));
        if (!(distance < f.c.kernel.support())) {
            sums.too_far = id;
            sums.distance = static_cast<double>(distance);
        }
        const Real rho = f.body_velocity[s].w;
        if (!(rho < f.c.blow_up_ratio * f.c.rho_0)) {
            sums.too_dense = id;
        }
        if (f.kind[id] != Kind::fluid) {
            return sums;
        }
        const auto error = static_cast<double>(rho) / static_cast<double>(f.c.rho_0) - 1;
        const Vec3T<Real> x = f.body_position[s].vector(); // before the move
        if (is_beyond(f, x, -f.c.open_end)) {
            sums.error_max_ends = error;
        } else {
            sums.error_max = error;
            sums.error_min = error;
        }
        const auto v = static_cast<double>(speed);
        sums.count = 1;
        sums.excess = error > 0 ? error : 0;
        sums.kinetic_energy = 0.5 * static_cast<double>(f.c.mass) * v * v;
        sums.speed_max = v;
        return sums;
    }
};
struct RecordFlow {
    Scene* scene;
    const FlowSums* sums;
    double blow_up_ratio;

    ANEURYSM_HD void operator()() const
    {
        FrameRecord& r = scene->record;
        const FlowSums& s = *sums;
        r.density_error_mean = s.excess / (s.count > 0 ? s.count : 1);
        r.density_error_max = s.error_max;
        r.density_error_min = s.error_min < blow_up_ratio ? s.error_min : blow_up_ratio;
        r.density_error_max_ends = s.error_max_ends;
        r.kinetic_energy = s.kinetic_energy;
        r.speed_max = r.speed_max < s.speed_max ? s.speed_max : r.speed_max;
        if (scene->fault == Fault::none && s.too_dense != no_particle) {
            scene->fault = Fault::density;
            scene->fault_particle = s.too_dense;
        }
        if (scene->fault == Fault::none && s.too_far != no_particle) {
            scene->fault = Fault::moved_too_far;
            scene->fault_particle = s.too_far;
            scene->fault_value = s.distance;
        }
    }
};

} // namespace aneurysm::device
