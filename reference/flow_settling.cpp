// SPDX-License-Identifier: Apache-2.0
// How a fresh lattice finds its place between the walls before frame 1.
#include "common/guards.hpp"
#include "reference/containment.hpp"
#include "reference/flow.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace aneurysm::reference
{

void Flow::settle(SimulationState& state, const Wall& wall) const
{
    // What never corrects the density doesn't at the start.
    const std::int64_t rounds = scenario_->pressure.density_correction > 0 ? scenario_->settling.rounds : 0;
    // At rest a step finds nothing to correct once the mean excess is this.
    const double allowed =
        guards::settling_slack * solver_.tolerance * dt_ / scenario_->settling.density_correction;
    Particles& p = state.particles;
    for (std::int64_t round = 0; round < rounds; ++round) {
        push_apart(state, wall);
        const FlowStep step = make_step(state, wall);
        std::vector<std::size_t> blood;
        double excess = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (p.kind[i] == Kind::fluid) {
                blood.push_back(i);
                excess += std::max(step.rho[i] / scenario_->fluid.density_kg_m3 - 1, 0.0);
            }
        }
        if (excess <= allowed * static_cast<double>(blood.size())) {
            break;
        }
        const auto surplus = std::min(blood.size(), static_cast<std::size_t>(std::ceil(excess)));
        std::ranges::stable_sort(blood, std::greater<>(), [&step](std::size_t i) { return step.rho[i]; });
        for (std::size_t k = 0; k < surplus; ++k) {
            p.kind[blood[k]] = Kind::reserve;
        }
    }
    state.ledger = {};
    std::ranges::fill(p.pressure, scenario_->outlet.pressure_pa);
}

void Flow::push_apart(SimulationState& state, const Wall& wall) const
{
    Particles& p = state.particles;
    IncompressibleSettings settings = solver_;
    settings.density_correction = scenario_->settling.density_correction;
    settings.max_iterations = std::min(settings.max_iterations, scenario_->settling.max_iterations);
    FrameRecord record;
    for (std::int64_t k = 0; k < scenario_->settling.steps; ++k) {
        const FlowStep step = make_step(state, wall);
        std::vector<double> pressure(step.bodies.size(), 0);
        std::vector<Vec3> a(step.bodies.size());
        solve_incompressibility(step.bodies, step.neighbors, step.rho, dt_, settings, pressure, a);
        for (std::size_t i = 0; i < p.size(); ++i) {
            p.position[i] = vessel_->wrapped(p.position[i] + dt_ * dt_ * a[i]);
        }
        controller_.push_as_piston(p, 0);
        handle_collisions(*vessel_, dx_, state, wall, record);
        controller_.exchange(p, state.ledger);
        p.velocity.assign(p.size(), {});
    }
}

} // namespace aneurysm::reference
