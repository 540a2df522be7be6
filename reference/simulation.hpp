// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/simulation.hpp"
#include "common/vessel/geometry.hpp"
#include "common/vessel/sampling.hpp"
#include "reference/flow.hpp"

#include <optional>
#include <span>
#include <vector>

namespace aneurysm::reference
{

/// The model as the paper writes it, on one core.
class Simulation final : public aneurysm::Simulation
{
public:
    /// Starts from frame 0: samples vessel and particles.
    /// \throws InputError when the scenario's values can't go together
    explicit Simulation(const Scenario& scenario);
    /// Continues from a state of the same scenario, to the same bits as a run without a break.
    Simulation(const Scenario& scenario, SimulationState state);

    Engine engine() const override { return {Backend::reference, Precision::double_, "one CPU core"}; }
    FrameRecord advance() override;
    /// The same, observed, and unless `solved` is empty without solves of its own; by flow step and particle.
    /// Model eos has none and ignores it.
    /// \throws Error when one has another size than solved_pressure()
    FrameRecord advance(const Solved& solved, FlowObserver& observer);

    /// Goes on from another state of the same scenario and spacing.
    /// \throws Error when it has another number of particles or another spacing
    void restart(SimulationState state);

    /// From now on (3) is solved to other tolerances than the scenario's [1/s]:
    /// an ensemble varies when the solve stops.
    void set_tolerances(double mean, double largest) { flow_.set_tolerances(mean, largest); }

    const SimulationState& state() const override { return state_; }
    const std::vector<double>& density() const override { return flow_.density(); }
    const std::vector<double>& solved_pressure() const override { return solved_pressure_; }
    const std::vector<double>& solved_kappa() const override { return solved_kappa_; }
    /// The scenario's, with the daughters of (24).
    const Vessel& vessel() const { return vessel_; }

private:
    Simulation(const Scenario& scenario, std::optional<SimulationState> state);
    SimulationState first_state() const;

    FrameRecord advance(const Solved& solved, FlowObserver* observer);
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
    std::vector<double> solved_kappa_;
};

} // namespace aneurysm::reference
