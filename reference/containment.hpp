// SPDX-License-Identifier: Apache-2.0
// What keeps blood inside the wall.
#pragma once

#include "common/frame.hpp"
#include "common/vessel/geometry.hpp"
#include "reference/flow_step.hpp"

namespace aneurysm::reference
{

/// Fig. 1, and the way out through the breach.
void handle_collisions(const Vessel& vessel, double dx, Rebound rebound, SimulationState& state,
                       const Wall& wall, FrameRecord& record);

} // namespace aneurysm::reference
