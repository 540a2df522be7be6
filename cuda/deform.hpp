// SPDX-License-Identifier: Apache-2.0
// What a frame's impact does to the sac: growth, the elastic wall (28) and, when the load exceeds P_c, rupture.
#pragma once

#include "cuda/boundary.hpp"
#include "cuda/containment.hpp"
#include "cuda/fields.hpp"
#include "cuda/growth.hpp"
#include "cuda/rupture.hpp"

namespace aneurysm::device
{

/// Ends a frame; by one thread, in double.
struct Deform {
    Scene* scene;
    const KindCounts* kinds;
    WallTissue tissue;
    bool has_sac;
    double largest_radius; ///< [m]
    double spacing;        ///< [m]
    double dt;             ///< of the frame [s]
    Index particles;
    std::int64_t warm_up_frames;
    double poisson_ratio;
    double porosity;
    double yield_limit;        ///< [Pa]
    double impact_mass;        ///< [kg]
    double particle_mass;      ///< [kg]
    double conversion_area;    ///< [m^2]
    double thinning_intensity; ///< [1/m]
    double largest_increment;  ///< [m]
    double wall_stiffness;     ///< [N/m]
    double wall_mass;          ///< [kg]

    Deform(const Scenario& s, Scene* on_device, const KindCounts* counted, double largest, double dx,
           double mass)
        : scene(on_device), kinds(counted), tissue(wall_tissue(s)),
          has_sac(s.aneurysm.shape != SacShape::none), largest_radius(largest), spacing(dx),
          dt(s.time.frame_s), particles(static_cast<Index>(s.particles.count)),
          warm_up_frames(s.growth.warm_up_frames), poisson_ratio(s.rupture.poisson_ratio),
          porosity(s.rupture.porosity), yield_limit(s.rupture.yield_limit_pa),
          impact_mass(s.rupture.impact_mass_kg), particle_mass(mass),
          conversion_area(s.rupture.conversion_area_m2),
          thinning_intensity(s.growth.thinning_intensity_per_m),
          largest_increment(s.growth.largest_increment_m), wall_stiffness(s.elastic_wall.stiffness_n_m),
          wall_mass(s.elastic_wall.mass_kg)
    {
    }

    ANEURYSM_HD void operator()() const
    {
        AneurysmState& a = scene->aneurysm;
        FrameRecord& r = scene->record;
        const bool alive = has_sac && a.phase != Phase::ruptured && r.frame > warm_up_frames;
        if (has_sac) {
            r.wall_load = wall_load(r.impact_force, impact_mass, particle_mass);
        }
        if (alive) {
            grow(a, r.wall_load);
            move_wall(a, r.wall_load);
        }
        if (has_sac) {
            r.critical_pressure =
                critical_pressure(a.thickness, a.radius, yield_limit, poisson_ratio, porosity);
        }
        if (alive && ruptures(r.wall_load, conversion_area, r.critical_pressure)) {
            a.phase = Phase::ruptured;
            a.rupture_frame = r.frame;
        }
        r.phase = a.phase;
        r.radius = a.radius;
        r.thickness = a.thickness;
        r.displacement = a.displacement;
        count();
    }

private:
    /// (21), then (22) or (23).
    ANEURYSM_HD void grow(AneurysmState& a, double F) const
    {
        const double dR = radius_increment(tissue, F, a.radius, dt);
        const double room = largest_radius - a.radius;
        if (room > 0) {
            const double taken = dR < room ? dR : room;
            a.phase = Phase::growing;
            a.thickness = thickness_growing(a.thickness, a.radius, poisson_ratio, taken);
            a.radius = taken < dR ? largest_radius : a.radius + dR;
        } else {
            a.phase = Phase::fully_developed;
            a.thickness = thickness_developed(a.thickness, thinning_intensity, dR, largest_increment);
        }
    }
    ANEURYSM_HD void move_wall(AneurysmState& a, double F) const
    {
        const ElasticWall w =
            advance_elastic_wall({a.displacement, a.wall_velocity}, F, wall_stiffness, wall_mass, dt);
        a.displacement = w.u;
        a.wall_velocity = w.v;
        const double size = w.u < 0 ? -w.u : w.u;
        if (!(size < spacing) && scene->fault == Fault::none) {
            scene->fault = Fault::displacement;
        }
    }
    ANEURYSM_HD void count() const
    {
        FrameRecord& r = scene->record;
        scene->ledger.recycled += kinds->recycled_now;
        r.ledger = scene->ledger;
        r.total = particles;
        r.active = kinds->active;
        r.fluid = kinds->fluid;
    }
};

} // namespace aneurysm::device
