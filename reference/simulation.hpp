// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "common/vessel/geometry.hpp"
#include "common/vessel/sampling.hpp"
#include "reference/flow.hpp"

#include <optional>
#include <span>
#include <vector>

namespace aneurysm::reference
{

/// The whole model of the paper, frame by frame: the flow, and the aneurysm that it makes grow and rupture.
class Simulation
{
public:
    /// Starts from frame 0: samples vessel and particles.
    /// \throws InputError when the scenario's values can't go together
    explicit Simulation(const Scenario& scenario);
    /// Continues from a state of the same scenario, to the same bits as a run without a break.
    Simulation(const Scenario& scenario, SimulationState state);

    Simulation(const Simulation&) = delete; // its parts refer to one another
    Simulation& operator=(const Simulation&) = delete;

    /// One frame.
    /// \throws SimulationError that names frame and particle;
    /// state() is then still that of the last good frame
    FrameRecord advance();
    /// The same, observed, and unless `solved_pressure` is empty without a solve of its own: by flow step and
    /// particle [Pa], it is taken as the solution of (3). Model eos has none and ignores it.
    /// \throws Error when it has another size than solved_pressure()
    FrameRecord advance(std::span<const double> solved_pressure, FlowObserver& observer);

    /// Goes on from another state of the same scenario and spacing.
    /// \throws Error when it has another number of particles or another spacing
    void restart(SimulationState state);

    /// From now on (3) is solved to other tolerances than the scenario's [1/s]:
    /// an ensemble varies when the solve stops.
    void set_tolerances(double mean, double largest) { flow_.set_tolerances(mean, largest); }

    const SimulationState& state() const { return state_; }
    /// By particle, of the last flow step; rho_0 for what isn't blood [kg/m^3]
    const std::vector<double>& density() const { return flow_.density(); }
    /// By flow step of the last frame and particle, as each solve left it [Pa]
    const std::vector<double>& solved_pressure() const { return solved_pressure_; }
    const Vessel& vessel() const { return vessel_; }

private:
    Simulation(const Scenario& scenario, std::optional<SimulationState> state);
    SimulationState first_state() const;

    FrameRecord advance(std::span<const double> solved_pressure, FlowObserver* observer);
    Wall wall(const AneurysmState& aneurysm) const;
    void deform(SimulationState& state, FrameRecord& record) const;
    void recycle_escaped(SimulationState& state, const Wall& wall) const;

    Scenario scenario_;
    Vessel vessel_;
    Lattice lattice_; ///< as sampled for frame 0
    Flow flow_;
    GhostLattice ghosts_;
    SimulationState state_;
    std::vector<double> solved_pressure_;
};

} // namespace aneurysm::reference
