// SPDX-License-Identifier: Apache-2.0
// The impact (16) of the blood on the sac's wall.
#pragma once

#include "cuda/blood_flow.hpp"
#include "cuda/bodies.hpp"
#include "cuda/rupture.hpp"

namespace aneurysm::device
{

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
        const Vec3T<Real> F_eos = pressure_force(f, i, lane);
        if (lane.is_first()) {
            const Real rho = f.body_velocity[i].w;
            const Vec3T<Real> g = f.gravity();
            const Vec3T<Real> F_viscosity = f.force[i].vector();
            const Vec3T<Real> F_pressure = rho * f.acceleration[i].vector();
            f.impact[i] = impact_force(f.c.mass, rho, momentum_force(rho, g, F_viscosity, F_pressure));
            f.impact_eos[i] = impact_force(f.c.mass, rho, momentum_force(rho, g, F_viscosity, F_eos));
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

} // namespace aneurysm::device
