// SPDX-License-Identifier: Apache-2.0
#include "reference/simulation.hpp"

#include "common/error.hpp"
#include "common/fault.hpp"
#include "common/initial_state.hpp"
#include "reference/bifurcation.hpp"
#include "reference/boundary.hpp"
#include "reference/growth.hpp"
#include "reference/rupture.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::reference
{
namespace
{

WallTissue wall_tissue(const Scenario& s)
{
    const auto& g = s.growth;
    return {.rho_F = g.tissue_density_kg_m3,
            .a = g.tissue_area_m2,
            .c = g.wave_speed_m_s,
            .K_E = g.elastin_stiffness_n_m,
            .A_E = g.elastin_area_m2,
            .K_C = g.collagen_stiffness_n_m,
            .A_C = g.collagen_area_m2,
            .m = g.wall_mass_kg};
}

} // namespace

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

FrameRecord Simulation::advance(std::span<const double> solved_pressure, FlowObserver& observer)
{
    if (scenario_.pressure.model == PressureModel::eos || solved_pressure.empty()) {
        return advance({}, &observer);
    }
    const std::size_t needed = static_cast<std::size_t>(scenario_.time.substeps) * state_.particles.size();
    if (solved_pressure.size() != needed) {
        throw Error("frame " + std::to_string(state_.frame + 1),
                    std::to_string(solved_pressure.size()) + " solved pressures were given",
                    "needed: " + std::to_string(needed) + ", one for each flow step and particle");
    }
    return advance(solved_pressure, &observer);
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

FrameRecord Simulation::advance(std::span<const double> solved_pressure, FlowObserver* observer)
{
    SimulationState next = state_;
    FrameRecord record;
    record.frame = next.frame + 1;
    const double dt = scenario_.time.frame_s;
    record.time = static_cast<double>(record.frame) * dt;
    const Wall w = wall(next.aneurysm);
    solved_pressure_.clear();
    for (std::int64_t s = 1; s <= scenario_.time.substeps; ++s) {
        const double part = static_cast<double>(s) / static_cast<double>(scenario_.time.substeps);
        const std::size_t first = static_cast<std::size_t>(s - 1) * next.particles.size();
        const auto solved =
            solved_pressure.empty() ? solved_pressure : solved_pressure.subspan(first, next.particles.size());
        flow_.step(next, w, (static_cast<double>(next.frame) + part) * dt, record, {solved, observer});
        solved_pressure_.insert(solved_pressure_.end(), flow_.solved_pressure().begin(),
                                flow_.solved_pressure().end());
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

/// Blood that is far from the breach, or comes within sight of an open end's ghosts, returns to the reserve.
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

/// Growth and thinning of one frame: (21), then (22) or (23).
void Simulation::grow(AneurysmState& aneurysm, double F_b) const
{
    AneurysmState& s = aneurysm;
    const double dR = radius_increment(wall_tissue(scenario_), F_b, s.radius, scenario_.time.frame_s);
    const double largest = fault(eq23_developed, vessel_.largest_radius());
    if (s.radius < largest) {
        s.phase = Phase::growing;
        const double taken = std::min(dR, largest - s.radius);
        s.thickness = thickness_growing(s.thickness, s.radius, scenario_.rupture.poisson_ratio, taken);
        s.radius = taken < dR ? largest : s.radius + fault(eq21_growth, dR);
    } else {
        s.phase = Phase::fully_developed;
        s.thickness = thickness_developed(s.thickness, scenario_.growth.thinning_intensity_per_m, dR,
                                          scenario_.growth.largest_increment_m);
    }
}

/// What the frame's impact does to the sac: growth, the elastic wall (28) and, when F_b > P_c, rupture.
void Simulation::deform(SimulationState& state, FrameRecord& record) const
{
    AneurysmState& s = state.aneurysm;
    const auto& material = scenario_.rupture;
    const bool alive = vessel_.has_sac() && s.phase != Phase::ruptured &&
                       record.frame > fault(eq21_warm_up, scenario_.growth.warm_up_frames);
    if (alive) {
        grow(s, record.impact_force);
        const ElasticWall w = advance_elastic_wall({s.displacement, s.wall_velocity}, record.impact_force,
                                                   scenario_.elastic_wall.stiffness_n_m,
                                                   scenario_.elastic_wall.mass_kg, scenario_.time.frame_s);
        s.displacement = w.u;
        s.wall_velocity = w.v;
        if (!(std::abs(s.displacement) < state.spacing)) {
            throw SimulationError("frame " + std::to_string(record.frame),
                                  "the elastic wall is displaced by " + std::to_string(s.displacement) +
                                      " m, more than a particle spacing",
                                  "a larger elastic_wall.stiffness_n_m");
        }
    }
    if (vessel_.has_sac()) {
        record.critical_pressure = critical_pressure(s.thickness, s.radius, material.yield_limit_pa,
                                                     material.poisson_ratio, material.porosity);
    }
    if (alive && ruptures(record.impact_force, material.conversion_area_m2, record.critical_pressure)) {
        s.phase = Phase::ruptured;
        s.rupture_frame = record.frame;
    }
    record.phase = s.phase;
    record.radius = s.radius;
    record.thickness = s.thickness;
    record.displacement = s.displacement;
}

} // namespace aneurysm::reference
