// SPDX-License-Identifier: Apache-2.0
#include "reference/deform.hpp"

#include "common/error.hpp"
#include "reference/boundary.hpp"
#include "reference/rupture.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::reference
{
Deform::Deform(const Scenario& scenario, double largest_radius, double spacing)
    : scenario_(scenario), tissue_(wall_tissue(scenario)), largest_radius_(largest_radius), spacing_(spacing)
{
}

/// Growth and thinning of one frame: (21), then (22) or (23).
void Deform::grow(AneurysmState& aneurysm, double F) const
{
    AneurysmState& s = aneurysm;
    const double dR = radius_increment(tissue_, F, s.radius, scenario_.time.frame_s);
    if (s.radius < largest_radius_) {
        s.phase = Phase::growing;
        const double taken = std::min(dR, largest_radius_ - s.radius);
        s.thickness = thickness_growing(s.thickness, s.radius, scenario_.rupture.poisson_ratio, taken);
        s.radius = taken < dR ? largest_radius_ : s.radius + dR;
    } else {
        s.phase = Phase::fully_developed;
        s.thickness = thickness_developed(s.thickness, scenario_.growth.thinning_intensity_per_m, dR,
                                          scenario_.growth.largest_increment_m);
    }
}

void Deform::move_wall(AneurysmState& aneurysm, std::int64_t frame, double F) const
{
    const ElasticWall w = advance_elastic_wall({aneurysm.displacement, aneurysm.wall_velocity}, F,
                                               scenario_.elastic_wall.stiffness_n_m,
                                               scenario_.elastic_wall.mass_kg, scenario_.time.frame_s);
    aneurysm.displacement = w.u;
    aneurysm.wall_velocity = w.v;
    if (!(std::abs(w.u) < spacing_)) {
        throw SimulationError("frame " + std::to_string(frame),
                              "the elastic wall is displaced by " + std::to_string(w.u) +
                                  " m, more than a particle spacing",
                              "a larger elastic_wall.stiffness_n_m");
    }
}

double Deform::operator()(AneurysmState& aneurysm, std::int64_t frame, double F) const
{
    const auto& material = scenario_.rupture;
    const bool alive = aneurysm.phase != Phase::ruptured && frame > scenario_.growth.warm_up_frames;
    if (alive) {
        grow(aneurysm, F);
        move_wall(aneurysm, frame, F);
    }
    const double P_c = critical_pressure(aneurysm.thickness, aneurysm.radius, material.yield_limit_pa,
                                         material.poisson_ratio, material.porosity);
    if (alive && ruptures(F, material.conversion_area_m2, P_c)) {
        aneurysm.phase = Phase::ruptured;
        aneurysm.rupture_frame = frame;
    }
    return P_c;
}

} // namespace aneurysm::reference
