// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/flow.hpp"
#include "verification/bounds/collision.hpp"
#include "verification/bounds/particle_errors.hpp"
#include "verification/bounds/step.hpp"

#include <vector>

namespace aneurysm::bounds
{

/// A particle that may be in S of (16), and its force.
struct Hit {
    std::int64_t particle = -1;
    Inexact force; ///< [N]
};

/// The numbers between which the candidate's record of a frame must lie, given the
/// reference's (docs/bounds.md, B28).
class RecordBounds
{
public:
    RecordBounds(const Scenario& scenario, const WallBounds& wall, double dx, const Rounding& rounding);

    void begin();
    /// `state`: at stage `moved`, with `errors`; `before`: the errors with which the step began.
    void add_step(const SimulationState& state, const reference::FlowStep& step, const reference::Wall& wall,
                  const StepBounds& bounds, const ParticleErrors& errors, const ParticleErrors& before);
    void add_collisions(const CollisionCounts& counts);

    /// The bounds, once the reference has made its record; what the wall makes of F_b is not in it yet.
    void finish(const FrameRecord& record, const ParticleErrors& errors, const Inexact& inlet_velocity,
                FrameRecord& low, FrameRecord& high) const;
    /// Who may have made F_b, of all steps of the frame.
    const std::vector<Hit>& hits() const { return hits_; }

private:
    void bound_density(const SimulationState& state, const reference::FlowStep& step,
                       const StepBounds& bounds, const ParticleErrors& errors);
    void bound_motion(const SimulationState& state, const ParticleErrors& errors);
    void bound_solve(const reference::FlowStep& step, const StepBounds& bounds);
    void bound_impact(const SimulationState& state, const reference::Wall& wall, const StepBounds& bounds,
                      const ParticleErrors& errors);

    const Scenario* scenario_;
    const WallBounds* wall_;
    double dx_;
    Rounding rounding_;
    FrameRecord error_; ///< absolute, of the numbers that lie around the reference's
    FrameRecord low_;   ///< of the numbers that have a range of their own
    FrameRecord high_;
    bool impact_found_ = false;
    std::vector<Hit> hits_;
};

} // namespace aneurysm::bounds
