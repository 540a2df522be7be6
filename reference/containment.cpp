// SPDX-License-Identifier: Apache-2.0
#include "reference/containment.hpp"

#include "common/guards.hpp"
#include "reference/boundary.hpp"

namespace aneurysm::reference
{

void handle_collisions(const Vessel& vessel, double dx, Rebound rebound, SimulationState& state,
                       const Wall& wall, FrameRecord& record)
{
    Particles& p = state.particles;
    record.outside = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] != Kind::fluid || !vessel.between_openings(p.position[i])) {
            continue;
        }
        Distance d = vessel.wall(p.position[i], wall.radius);
        if (d.value <= 0) {
            continue;
        }
        if (wall.breach && wall.breach->contains(p.position[i])) {
            p.kind[i] = Kind::escaped;
            ++state.ledger.escaped;
            continue;
        }
        ++record.collisions;
        for (int k = 0; k < guards::collision_attempts && d.value > 0; ++k) {
            const double slope = length(d.gradient);
            const Collision after =
                collide(p.position[i], p.velocity[i], d.value / slope, d.gradient / slope);
            p.position[i] = after.position;
            p.velocity[i] = rebound == Rebound::elastic ? after.velocity : p.velocity[i];
            d = vessel.wall(p.position[i], wall.radius);
        }
        record.outside += d.value > guards::outside<double> * dx ? 1 : 0;
    }
}

} // namespace aneurysm::reference
