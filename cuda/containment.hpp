// SPDX-License-Identifier: Apache-2.0
// What holds blood inside the wall, and the way back of what escapes through the breach.
#pragma once

#include "common/guards.hpp"
#include "cuda/bodies.hpp"

namespace aneurysm::device
{

/// Fig. 1, and the way out through the breach.
template <class Real>
struct ContainBlood {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        if (f.kind[id] == Kind::fluid) {
            Vec3T<Real> x = f.position[id].vector();
            Vec3T<Real> v = f.velocity[id].vector();
            handle_collision(id, x, v);
            f.position[id] = row(x, Real(0));
            f.velocity[id] = row(v, Real(0));
        }
    }

private:
    ANEURYSM_HD void handle_collision(Index id, Vec3T<Real>& x, Vec3T<Real>& v) const
    {
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
            f.event[id] += bit(escaped);
            return;
        }
        f.event[id] += bit(collided);
        for (int k = 0; k < guards::collision_attempts && d.value > 0; ++k) {
            const Real slope = length(d.gradient);
            Vec3T<Real> turned = v;
            collide(x, turned, d.value / slope, d.gradient / slope);
            v = f.c.rebounds ? turned : v;
            d = f.c.vessel.wall(x, R);
        }
        f.event[id] += d.value > guards::outside<Real> * f.c.dx ? bit(outside) : 0;
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
            f.event[id] = bit(recycled);
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
                f.event[id] == bit(recycled) ? 1 : 0};
    }
};

} // namespace aneurysm::device
