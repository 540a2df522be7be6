// SPDX-License-Identifier: Apache-2.0
// The impact (16) of the blood on the sac's wall.
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "common/vessel/geometry.hpp"
#include "reference/flow_step.hpp"

namespace aneurysm::reference
{

/// F_b of (16), with the pressure that drives the flow and, as a diagnostic, with (6) and the equation of state; the
/// record keeps a frame's hardest.
void record_impact(const Scenario& scenario, const Vessel& vessel, double dx, const FlowStep& step,
                   const Particles& p, const Wall& wall, const Vec3& g, FrameRecord& record);

} // namespace aneurysm::reference
