// SPDX-License-Identifier: Apache-2.0
// One flow step: sections 3.1, 3.4 and 3.5, and the impact (16). The passes, in the order in which they run.
#pragma once

#include "common/sampling.hpp"
#include "cuda/boundary.hpp"
#include "cuda/controller.hpp"
#include "cuda/incompressible.hpp"
#include "cuda/rupture.hpp"

namespace aneurysm::device
{

inline constexpr Index no_particle = 0x7fffffff;

/// Radius of the sac, displacement included [m]
template <class Real>
ANEURYSM_HD Real sac_radius(const Scene& s)
{
    return static_cast<Real>(s.aneurysm.radius + s.aneurysm.displacement);
}
template <class Real>
ANEURYSM_HD Vec3T<Real> breach_center(const Fields<Real>& f)
{
    return f.c.vessel.dome(sac_radius<Real>(*f.scene));
}
/// Whether x lies in the hole that the rupture left.
template <class Real>
ANEURYSM_HD bool in_breach(const Fields<Real>& f, const Vec3T<Real>& x)
{
    const Vec3T<Real> d = x - breach_center(f);
    const Real radius = f.c.breach_radius;
    return f.scene->aneurysm.phase == Phase::ruptured && d.y > -radius &&
           d.x * d.x + d.z * d.z < radius * radius;
}

/// Where a body is; one without mass is found by no search.
template <class Real>
ANEURYSM_HD void place(const Fields<Real>& f, Index body, const Vec3T<Real>& x, Real mass)
{
    f.body_position[body] = row(x, mass);
    f.body_x[body] = mass > 0 ? x.x : f.c.far_away;
    f.body_y[body] = x.y;
    f.body_z[body] = x.z;
}

/// The wall's ghosts: volume fractions that follow the sac (see GhostLattice), none inside the breach.
template <class Real>
struct PlaceWalls {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index w) const
    {
        const Vec3T<Real> x = f.wall_position[w].vector();
        Real mass = f.wall_position[w].w;
        if (mass < 0) {
            const Real distance = f.c.vessel.wall(x, sac_radius<Real>(*f.scene)).value;
            const Real part = Real(0.5) + distance / f.c.dx;
            const bool there = distance < f.c.kernel.support() && !in_breach(f, x);
            mass = there && part > 0 ? f.c.mass * (part < 1 ? part : Real(1)) : 0;
        }
        const Index body = f.c.first_wall() + w;
        place(f, body, x, mass);
        f.body_velocity[body] = row(wall_velocity<Real>(), Real(0));
        f.is_mirror[body] = 1;
    }
};

/// Particles in sorted order. Ghosts of the outlets carry the pressure of (26).
template <class Real>
struct SortBodies {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index s) const
    {
        const Index id = f.order[s];
        const Index k = open_end(f.kind[id]);
        Real w = 0;
        if (k > 0) {
            const double v = f.scene->outlet_velocity[k - 1];
            w = static_cast<Real>(outlet_pressure(f.c.p_outlet, static_cast<double>(f.c.rho_0), v));
        }
        place(f, s, f.position[id].vector(), f.c.mass);
        f.body_velocity[s] = row(f.velocity[id].vector(), w);
        f.is_mirror[s] = k == 0 ? 1 : 0;
    }
};

/// Density (5), the DFSPH factor, and what ghosts add to (2), to the pressure's acceleration and by (26).
template <class Real>
struct Densities {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        using Number = Lanes<Real>;
        Number rho;
        Number squares;
        Vec3T<Number> of_free;
        for (Index b = f.free.begin[i]; b < f.free.begin[i + 1]; ++b) {
            const Pairs<Real> pair = pairs(f, i, neighbors(f.free, b, lane));
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
            const Pairs<Real> pair = pairs(f, i, j);
            const Vec3T<Number> G = gradient(f, pair);
            const RowLanes<Real> other = gather_rows(f.body_velocity, j); // w: the outlet's pressure
            rho += density(f, pair);
            of_ghosts += G;
            flux += dot(G, other.vector());
            outlets += outlet_pressure_force(rho_0, other.w, G);
        }
        const Real total = sum(rho, lane) + f.c.mass * first(f.c.kernel.value(Number(0)));
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

private:
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
        const Vec3T<Real> F_viscosity = viscosity_force(f, i, lane);
        if (lane.is_first()) {
            const Real rho = f.body_velocity[i].w;
            const bool outlets = f.c.model == PressureModel::dfsph; // else they take part in (6)
            const Vec3T<Real> F_outlets = outlets ? f.force[i].vector() : Vec3T<Real>{};
            const Vec3T<Real> force = momentum_force(rho, f.c.g, F_viscosity, F_outlets);
            f.force[i] = row(F_viscosity, Real(0));
            f.solved_velocity[i] =
                row(f.body_velocity[i].vector() + f.c.dt * acceleration(rho, force), Real(0));
        }
    }
};

/// The velocity with all forces but the pressure's, which neighbours now no longer need as it was.
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

/// Moves all that is not in the reserve, and writes the step's results back by id.
template <class Real>
struct Move {
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
            f.position[id] = row(f.position[id].vector() + f.c.dt * v, Real(0));
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

/// The impact of each particle of S: blood beyond the sac's wall, or within the impact band before it, that
/// has not been put back yet.
template <class Real>
struct Impacts {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        const Index id = f.order[i];
        if (!touches_sac(id)) {
            if (lane.is_first()) {
                f.impact[i] = -1;
            }
            return;
        }
        const Vec3T<Real> F_eos = pressure_force(f, i, Real(0), lane);
        if (lane.is_first()) {
            const Real rho = f.body_velocity[i].w;
            const Vec3T<Real> F_viscosity = f.force[i].vector();
            const Vec3T<Real> F_pressure = rho * f.acceleration[i].vector();
            f.impact[i] = impact_force(f.c.mass, rho, momentum_force(rho, f.c.g, F_viscosity, F_pressure));
            f.impact_eos[i] = impact_force(f.c.mass, rho, momentum_force(rho, f.c.g, F_viscosity, F_eos));
        }
    }

private:
    ANEURYSM_HD bool touches_sac(Index id) const
    {
        if (!f.c.vessel.has_sac() || f.kind[id] != Kind::fluid) {
            return false;
        }
        const Vec3T<Real> x = f.position[id].vector();
        if (f.has(x, deep_inside)) {
            return false;
        }
        const Real R = sac_radius<Real>(*f.scene);
        const Real to_sac = f.c.vessel.sac(x, R).value;
        const Real to_tubes = f.c.vessel.tubes(x).value;
        return to_sac < to_tubes && f.c.vessel.wall(x, R).value > -f.c.impact_band;
    }
};
template <class Real>
struct HardestImpact {
    Fields<Real> f;

    ANEURYSM_HD Impact operator()(Index i) const
    {
        if (f.impact[i] == -1) {
            return {};
        }
        return {static_cast<double>(f.impact[i]), static_cast<double>(f.impact_eos[i]), f.order[i], 1};
    }
};
struct RecordImpact {
    Scene* scene;
    const Impact* impact;

    ANEURYSM_HD void operator()() const
    {
        FrameRecord& r = scene->record;
        r.impact_count = impact->count;
        if (r.impact_particle < 0 || impact->force > r.impact_force) {
            r.impact_force = impact->force;
            r.impact_particle = impact->particle;
            r.impact_force_eos = impact->force_eos;
        }
    }
};

/// The piston, held-back outlets, Fig. 1, and the way out through the breach.
template <class Real>
struct Contain {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        if (f.kind[id] != Kind::fluid) {
            return;
        }
        const Scene& s = *f.scene;
        Vec3T<Real> x = f.position[id].vector();
        Vec3T<Real> v = f.velocity[id].vector();
        push_as_piston(f, static_cast<Real>(s.inlet_velocity), x, v);
        for (Index k = 1; k <= 2; ++k) {
            if (s.outlet_velocity[k - 1] < 0) {
                hold_back(f, k, x, v);
            }
        }
        handle_collision(id, x, v);
        f.position[id] = row(x, Real(0));
        f.velocity[id] = row(v, Real(0));
    }

private:
    ANEURYSM_HD void handle_collision(Index id, Vec3T<Real>& x, Vec3T<Real>& v) const
    {
        constexpr int attempts = 8; // where surfaces are blended one step along the gradient may fall short
        if (f.has(x, deep_inside) || is_beyond(f, x, Real(0))) {
            return;
        }
        const Real R = sac_radius<Real>(*f.scene);
        DistanceT<Real> d = f.c.vessel.wall(x, R);
        if (d.value <= 0) {
            return;
        }
        if (in_breach(f, x)) {
            f.kind[id] = Kind::escaped;
            f.event[id] += escaped;
            return;
        }
        f.event[id] += collided;
        for (int k = 0; k < attempts && d.value > 0; ++k) {
            const Real slope = length(d.gradient);
            collide(x, v, d.value / slope, d.gradient / slope);
            d = f.c.vessel.wall(x, R);
        }
        // beyond what rounding leaves
        constexpr Real slack = sizeof(Real) == sizeof(float) ? Real(1e-4) : Real(1e-9);
        f.event[id] += d.value > slack * f.c.dx ? outside : 0;
    }
};

/// Escaped blood that is far from the breach, or comes within sight of an open end, returns to the reserve.
template <class Real>
struct RecycleEscaped {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        f.event[id] = 0;
        if (f.kind[id] != Kind::escaped || f.scene->aneurysm.phase != Phase::ruptured) {
            return;
        }
        const Vec3T<Real> x = f.position[id].vector();
        if (is_beyond(f, x, -f.c.kernel.support()) || length(x - breach_center(f)) > f.c.recycle_distance) {
            f.kind[id] = Kind::reserve;
            f.event[id] = recycled;
        }
    }
};

/// How many particles do what.
struct KindCounts {
    Index fluid = 0;
    Index active = 0;
    Index recycled_now = 0;

    ANEURYSM_HD KindCounts& operator+=(const KindCounts& b)
    {
        fluid += b.fluid;
        active += b.active;
        recycled_now += b.recycled_now;
        return *this;
    }
};
template <class Real>
struct CountKinds {
    Fields<Real> f;

    ANEURYSM_HD KindCounts operator()(Index id) const
    {
        return {f.kind[id] == Kind::fluid ? 1 : 0, f.kind[id] != Kind::reserve ? 1 : 0,
                f.event[id] == recycled ? 1 : 0};
    }
};

/// Settling: particles are displaced by what the pressure would do to them at rest.
template <class Real>
struct Displaced {
    Fields<Real> f;
    bool moves; ///< else only the densities are kept

    ANEURYSM_HD void operator()(Index s) const
    {
        const Index id = f.order[s];
        const bool free = s < f.free_count();
        f.event[id] = 0;
        f.density[id] = free ? f.body_velocity[s].w : f.c.rho_0;
        if (free && moves) {
            const Vec3T<Real> way = f.c.dt * f.c.dt * f.acceleration[s].vector();
            f.position[id] = row(f.position[id].vector() + way, Real(0));
        }
    }
};
template <class Real>
struct Rest {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const { f.velocity[id] = {0, 0, 0, 0}; }
};

} // namespace aneurysm::device
