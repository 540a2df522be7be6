// SPDX-License-Identifier: Apache-2.0
// The bodies of a flow step: particles in the order of cells, and the wall's ghosts, which follow the sac.
#pragma once

#include "cuda/boundary.hpp"
#include "cuda/controller.hpp"
#include "cuda/fields.hpp"
#include "cuda/neighbors.hpp"

namespace aneurysm::device
{

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
    }
};

/// Particles in sorted order.
template <class Real>
struct SortBodies {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index s) const
    {
        const Index id = f.order[s];
        place(f, s, f.position[id].vector(), f.c.mass);
        f.body_velocity[s] = row(f.velocity[id].vector(), Real(0));
        f.is_driven[s] = f.kind[id] == Kind::inlet ? 1 : 0;
        f.body_drift[s] = f.drift[id];
    }
};

/// The velocity (27) of each ghost of a wall near blood, over all blood that it sees.
template <class Real>
struct ExtrapolateVelocity {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index w, Lane lane) const
    {
        f.c.is_periodic ? extrapolate<true>(w, lane) : extrapolate<false>(w, lane);
    }

private:
    template <bool periodic>
    ANEURYSM_INLINE void extrapolate(Index w, Lane lane) const
    {
        using Number = Lanes<Real>;
        const Index body = f.c.first_wall() + w;
        const Row<Real> own = f.body_position[body];
        if (!(own.w > 0)) {
            return;
        }
        Number weights;
        Vec3T<Number> weighted;
        for_each_row<periodic>(f.c.grid, own.vector(), f.start, [&](Range range) {
            for (Index k = range.begin; k < range.end; k += lane_count) {
                Vec3T<Number> x{Number(own.x) - load(f.body_x + k, lane),
                                Number(own.y) - load(f.body_y + k, lane),
                                Number(own.z) - load(f.body_z + k, lane)};
                if constexpr (periodic) {
                    x = shortest(x, f.c.vessel.period());
                }
                const Mask is_there = Lanes<Index>(k) + numbers(lane) < Lanes<Index>(range.end);
                const Number W = f.c.kernel.value(sqrt(dot(x, x)));
                const Vec3T<Number> v = load_rows(f.body_velocity + k, lane).vector();
                const Number zero(0); // what is behind the range may be no number
                weights += select(is_there, W, zero);
                weighted += {select(is_there, W * v.x, zero), select(is_there, W * v.y, zero),
                             select(is_there, W * v.z, zero)};
            }
        });
        const Real total = sum(weights, lane);
        const Vec3T<Real> mean = sum(weighted, lane) / total;
        if (lane.is_first() && total > 0) {
            f.body_velocity[body] = row(no_slip_velocity(wall_velocity<Real>(), mean), Real(0));
        }
    }
};

} // namespace aneurysm::device
