// SPDX-License-Identifier: Apache-2.0
// How a fresh lattice finds its place between the walls before frame 1.
#include "common/guards.hpp"
#include "reference/containment.hpp"
#include "reference/flow.hpp"

#include <algorithm>

namespace aneurysm::reference
{

void Flow::settle(SimulationState& state, const Wall& wall) const
{
    if (!corrects_density()) {
        return; // what never corrects the density doesn't at the start
    }
    const auto& settling = scenario_->settling;
    Correction how{settling.density_correction, false, correction_};
    how.settings.max_iterations = std::min(how.settings.max_iterations, settling.max_iterations);
    for (std::int64_t round = 0; round < settling.pushing_rounds; ++round) {
        settle_once(state, wall, how);
    }
    how.pulls = true;
    for (std::int64_t round = 0; round < settling.rounds; ++round) {
        if (settle_once(state, wall, how).iterations == 0) {
            break;
        }
    }
    state.ledger = {};
}

IncompressibleReport Flow::settle_once(SimulationState& state, const Wall& wall, const Correction& how) const
{
    const double farthest = guards::settling_move * dx_;
    Particles& p = state.particles;
    const FlowStep step = make_step(state, wall);
    std::vector<double> kappa(step.bodies.size(), 0);
    std::vector<Vec3> way(p.size());
    const IncompressibleReport report = solve_correction(step, p, step.rho, how, kappa, way);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const double l = length(way[i]);
        p.position[i] = vessel_->wrapped(p.position[i] + (l > farthest ? farthest / l : 1) * way[i]);
    }
    FrameRecord record;
    handle_collisions(*vessel_, dx_, scenario_->collision.rebound, state, wall, record);
    p.velocity.assign(p.size(), {});
    return report;
}

} // namespace aneurysm::reference
