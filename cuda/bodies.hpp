// SPDX-License-Identifier: Apache-2.0
// The bodies of a flow step: particles in the order of cells, and the wall's ghosts, which follow the sac.
#pragma once

#include "cuda/boundary.hpp"
#include "cuda/controller.hpp"
#include "cuda/fields.hpp"

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

} // namespace aneurysm::device
