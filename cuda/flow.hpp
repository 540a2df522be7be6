// SPDX-License-Identifier: Apache-2.0
// What moves the blood in one flow step: the passes that use section 3.1, in the order in which they run.
#pragma once

#include "cuda/boundary.hpp"
#include "cuda/controller.hpp"
#include "cuda/incompressible.hpp"

namespace aneurysm::device
{

inline constexpr Index no_particle = 0x7fffffff;

/// Density (5), the DFSPH factor, and what ghosts add to (2), to the pressure's acceleration and by (26).
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
        Number rho;
        Number squares;
        Vec3T<Number> of_free;
        for (Index b = f.free.begin[i]; b < f.free.begin[i + 1]; ++b) {
            const Pairs<Real> pair = pairs<periodic>(f, i, neighbors(f.free, b, lane));
            const Vec3T<Number> G = gradient(f, pair);
            rho += density(f, pair);
            of_free += G;
            squares += dot(G, G);
            keep(G, b, lane);
        }
        Number flux;
        Vec3T<Number> of_ghosts;
        Vec3T<Number> outlets;
        const Number rho_0(f.c.rho_0);
        for (Index b = f.ghosts.begin[i]; b < f.ghosts.begin[i + 1]; ++b) {
            const Lanes<Index> j = neighbors(f.ghosts, b, lane);
            const Pairs<Real> pair = pairs<periodic>(f, i, j);
            const Vec3T<Number> G = gradient(f, pair);
            const RowLanes<Real> other = gather_rows(f.body_velocity, j); // w: the outlet's pressure
            rho += density(f, pair);
            of_ghosts += G;
            flux += dot(G, other.vector());
            outlets += outlet_pressure_force(rho_0, other.w, G);
        }
        const Real own = f.c.mass * first(f.c.kernel.value(Number(0)));
        const Real total = sum(rho, lane) + own;
        const Vec3T<Real> ghosts = sum(of_ghosts, lane);
        const Real alpha = dfsph_factor(sum(of_free, lane) + ghosts, sum(squares, lane));
        const Real ghost_flux = sum(flux, lane);
        const Vec3T<Real> F_outlets = sum(outlets, lane);
        if (lane.is_first()) {
            f.body_velocity[i].w = total;
            f.alpha[i] = alpha;
            f.ghost_gradient[i] = row(ghosts, ghost_flux);
            f.force[i] = row(F_outlets, Real(0));
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

/// Viscosity (7), gravity and, in model dfsph, the outlets' pressure (26): all but the blood's own pressure.
template <class Real>
struct Forces {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        const Vec3T<Real> F_viscosity =
            f.c.is_periodic ? viscosity_force<true>(f, i, lane) : viscosity_force<false>(f, i, lane);
        if (lane.is_first()) {
            const Real rho = f.body_velocity[i].w;
            const bool outlets = f.c.model == PressureModel::dfsph; // else they take part in (6)
            const Vec3T<Real> F_outlets = outlets ? f.force[i].vector() : Vec3T<Real>{};
            const Vec3T<Real> force = momentum_force(rho, f.gravity(), F_viscosity, F_outlets);
            f.force[i] = row(F_viscosity, Real(0));
            f.solved_velocity[i] =
                row(f.body_velocity[i].vector() + f.c.dt * acceleration(rho, force), Real(0));
        }
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
        const Vec3T<Real> F = pressure_force(f, i, Real(1), lane);
        if (lane.is_first()) {
            const Real rho = f.body_velocity[i].w;
            const Vec3T<Real> a = acceleration(rho, F);
            f.p_old[i] = equation_of_state(f.c.kappa, rho, f.c.rho_0);
            f.acceleration[i] = row(a, Real(0));
            f.solved_velocity[i] = row(f.body_velocity[i].vector() + f.c.dt * a, Real(0));
        }
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

/// Moves all that is not in the reserve, and writes the step's results back by id.
template <class Real>
struct MoveParticles {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index s) const
    {
        const Index id = f.order[s];
        Vec3T<Real> v = f.velocity[id].vector();
        f.density[id] = f.c.rho_0;
        if (s < f.free_count()) {
            v = f.solved_velocity[s].vector();
            f.velocity[id] = row(v, Real(0));
            f.pressure[id] = f.p[s];
            f.density[id] = f.body_velocity[s].w;
        }
        f.solved_pressure[static_cast<std::size_t>(f.step) * static_cast<std::size_t>(f.c.particles) +
                          static_cast<std::size_t>(id)] = f.pressure[id];
        if (s < f.active_count()) {
            const Vec3T<Real> way = f.c.dt * v;
            f.position[id] = row(f.c.vessel.wrapped(f.position[id].vector() + way), Real(0));
        }
        f.event[id] = 0;
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
    Index too_fast = no_particle;

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
        too_fast = b.too_fast < too_fast ? b.too_fast : too_fast;
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
        const Real speed = length(f.velocity[id].vector());
        if (!(f.c.dt * speed < f.c.kernel.support())) {
            sums.too_fast = id;
        }
        if (s >= f.free_count()) {
            return sums;
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
        if (scene->fault == Fault::none && s.too_fast != no_particle) {
            scene->fault = Fault::moved_too_far;
            scene->fault_particle = s.too_fast;
        }
    }
};

} // namespace aneurysm::device
