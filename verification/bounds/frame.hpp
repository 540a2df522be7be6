// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/deform.hpp"
#include "reference/simulation.hpp"
#include "verification/bounds/collision.hpp"
#include "verification/bounds/ghost.hpp"
#include "verification/bounds/opening.hpp"
#include "verification/bounds/record.hpp"

#include <optional>

namespace aneurysm::bounds
{

/// Between which values the candidate's frame must lie.
struct FrameRange {
    FrameRecord low;
    FrameRecord high;
    AneurysmState aneurysm_error; ///< absolute, of its numbers
    bool rupture_open = false;    ///< the load is within rounding of P_c
};

/// How a solve of (3) ended [1/s].
struct SolveEnd {
    double mean = 0;
    double mean_error = 0;
    double largest = 0;
    double largest_error = 0;
};

/// Watches the reference make one frame and bounds how far a candidate that makes the same frame from the
/// same bits can be from it by rounding alone.
class FrameBounds final : public reference::FlowObserver
{
public:
    FrameBounds(const Scenario& scenario, const Vessel& vessel, double dx, const Rounding& rounding);

    /// Before each frame.
    void begin(std::size_t particles);
    void see(reference::FlowStage stage, double t, const SimulationState& state, const reference::Wall& wall,
             const reference::FlowStep* step) override;
    /// After it: `start` is the state that the frame began with.
    FrameRange finish(const SimulationState& start, const SimulationState& end, const FrameRecord& record);

    const ParticleErrors& errors() const { return *errors_; }
    const std::vector<Hit>& hits() const { return record_.hits(); }
    /// By flow step and particle: what the reference took as solutions of (3) [Pa]; NaN where there is none.
    const std::vector<double>& taken_pressure() const { return taken_pressure_; }
    const std::vector<double>& taken_kappa() const { return taken_kappa_; }
    /// What the density's correction left of its residual in the last step, and how far rounding moves that
    /// [1/s].
    const SolveEnd& correction() const { return correction_; }
    /// What the pressure is not below in a step to time t [Pa].
    Inexact lowest_pressure(Phase phase, double t) const { return openings_.lowest_pressure(phase, t); }

private:
    void see_moved(const SimulationState& state, const reference::Wall& wall,
                   const reference::FlowStep& step);
    BodyForce body_force(const AneurysmState& aneurysm) const;
    StepInput step_input(const SimulationState& state, const reference::FlowStep& step) const;
    void bound_particles(const SimulationState& state, const StepBounds& bounds);
    void take_solutions(const Particles& moved, const reference::FlowStep& step, const StepBounds& bounds);
    void bound_wall(const SimulationState& start, const SimulationState& end, FrameRange& range) const;

    const Scenario* scenario_;
    Rounding rounding_;
    reference::Kernel kernel_;
    WallBounds wall_;
    GhostBounds ghosts_;
    OpeningBounds openings_;
    CollisionBounds collisions_;
    RecordBounds record_;
    reference::Deform deform_;
    std::optional<ParticleErrors> errors_;
    std::optional<InexactGhosts> frame_ghosts_;
    SimulationState driven_;
    SimulationState last_; ///< at the stage before
    std::optional<Vec3> breach_;
    double time_ = 0; ///< at the end of the step [s]
    std::vector<double> taken_pressure_;
    std::vector<double> taken_kappa_;
    SolveEnd correction_;
};

} // namespace aneurysm::bounds
