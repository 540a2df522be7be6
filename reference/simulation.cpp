// SPDX-License-Identifier: Apache-2.0
#include "reference/simulation.hpp"

#include "common/error.hpp"
#include "common/vessel/initial_state.hpp"
#include "reference/bifurcation.hpp"
#include "reference/deform.hpp"
#include "reference/rupture.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::reference
{
Simulation::Simulation(const Scenario& scenario) : Simulation(scenario, std::nullopt) {}

Simulation::Simulation(const Scenario& scenario, SimulationState state)
    : Simulation(scenario, std::optional<SimulationState>(std::move(state)))
{
}

Simulation::Simulation(const Scenario& scenario, std::optional<SimulationState> state)
    : scenario_(scenario), vessel_(scenario, daughter_radius(scenario.vessel.radius_m)),
      lattice_(sample(scenario, vessel_, daughter_radius(scenario.vessel.radius_m),
                      state ? std::optional(state->spacing) : std::nullopt)),
      flow_(scenario_, vessel_, lattice_.spacing, lattice_.openings),
      ghosts_(ghost_lattice(scenario, vessel_, lattice_.spacing, flow_.kernel().support(),
                            flow_.particle_mass())),
      state_(state ? std::move(*state) : first_state())
{
}

SimulationState Simulation::first_state() const
{
    SimulationState state = initial_state(scenario_, lattice_, flow_.particle_mass());
    flow_.settle(state, wall(state.aneurysm));
    return state;
}

Wall Simulation::wall(const AneurysmState& aneurysm) const
{
    Wall wall;
    wall.radius = aneurysm.radius + aneurysm.displacement;
    if (aneurysm.phase == Phase::ruptured) {
        wall.breach = Breach{vessel_.dome(wall.radius),
                             scenario_.rupture.breach_radius_radii * scenario_.vessel.radius_m};
    }
    wall.ghosts = ghosts_.at(wall.radius, wall.breach);
    return wall;
}

FrameRecord Simulation::advance()
{
    return advance({}, nullptr);
}

FrameRecord Simulation::advance(const Solved& solved, FlowObserver& observer)
{
    if (scenario_.pressure.model == PressureModel::eos || (solved.pressure.empty() && solved.kappa.empty())) {
        return advance({}, &observer);
    }
    const std::size_t needed = static_cast<std::size_t>(scenario_.time.substeps) * state_.particles.size();
    for (const std::span<const double>& potential : {solved.pressure, solved.kappa}) {
        if (potential.size() != needed) {
            throw Error("frame " + std::to_string(state_.frame + 1),
                        std::to_string(potential.size()) + " solved pressures were given",
                        "needed: " + std::to_string(needed) + ", one for each flow step and particle");
        }
    }
    return advance(solved, &observer);
}

void Simulation::restart(SimulationState state)
{
    if (state.particles.size() != state_.particles.size() || state.spacing != state_.spacing) {
        throw Error("restart",
                    std::to_string(state.particles.size()) + " particles at a spacing of " +
                        std::to_string(state.spacing) + " m",
                    "needed: " + std::to_string(state_.particles.size()) + " at " +
                        std::to_string(state_.spacing) + " m");
    }
    state_ = std::move(state);
}

FrameRecord Simulation::advance(const Solved& solved, FlowObserver* observer)
{
    SimulationState next = state_;
    FrameRecord record;
    record.frame = next.frame + 1;
    const double dt = scenario_.time.frame_s;
    record.time = static_cast<double>(record.frame) * dt;
    const Wall w = wall(next.aneurysm);
    solved_pressure_.clear();
    solved_kappa_.clear();
    const std::size_t n = next.particles.size();
    for (std::int64_t s = 1; s <= scenario_.time.substeps; ++s) {
        const double part = static_cast<double>(s) / static_cast<double>(scenario_.time.substeps);
        const std::size_t first = static_cast<std::size_t>(s - 1) * n;
        const Solved now = solved.pressure.empty()
                               ? Solved{}
                               : Solved{solved.pressure.subspan(first, n), solved.kappa.subspan(first, n)};
        flow_.step(next, w, (static_cast<double>(next.frame) + part) * dt, record, {now, observer});
        const auto keep = [](std::vector<double>& all, const std::vector<double>& of_step) {
            all.insert(all.end(), of_step.begin(), of_step.end());
        };
        keep(solved_pressure_, flow_.solved_pressure());
        keep(solved_kappa_, flow_.solved_kappa());
    }
    recycle_escaped(next, w);
    deform(next, record);
    next.frame = record.frame;
    record.ledger = next.ledger;
    record.total = static_cast<std::int64_t>(next.particles.size());
    record.active = record.total - std::ranges::count(next.particles.kind, Kind::reserve);
    record.fluid = std::ranges::count(next.particles.kind, Kind::fluid);
    state_ = std::move(next);
    return record;
}

/// Blood that is far from the breach, or comes within sight of an open end, returns to the reserve.
void Simulation::recycle_escaped(SimulationState& state, const Wall& wall) const
{
    const double far = scenario_.rupture.recycle_distance_radii * scenario_.vessel.radius_m;
    Particles& p = state.particles;
    for (std::size_t i = 0; wall.breach && i < p.size(); ++i) {
        const Vec3& x = p.position[i];
        const bool at_an_end =
            vessel_.openings()[vessel_.nearest_tube(x)].beyond(x) > -flow_.kernel().support();
        if (p.kind[i] == Kind::escaped && (at_an_end || length(x - wall.breach->center) > far)) {
            p.kind[i] = Kind::reserve;
            ++state.ledger.recycled;
        }
    }
}

/// The end of a frame for the sac, and what its record says of it.
void Simulation::deform(SimulationState& state, FrameRecord& record) const
{
    if (vessel_.has_sac()) {
        const Deform deform_sac(scenario_, vessel_.largest_radius(), state.spacing);
        record.wall_load =
            wall_load(record.impact_force, scenario_.rupture.impact_mass_kg, state.particles.mass);
        record.critical_pressure = deform_sac(state.aneurysm, record.frame, record.wall_load);
    }
    record.phase = state.aneurysm.phase;
    record.radius = state.aneurysm.radius;
    record.thickness = state.aneurysm.thickness;
    record.displacement = state.aneurysm.displacement;
}

} // namespace aneurysm::reference
