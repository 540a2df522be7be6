// SPDX-License-Identifier: Apache-2.0
// The vortices of Taylor and Green in the periodic box.
#pragma once

#include "analytic/taylor_green.hpp"
#include "verification/checks/box.hpp"

#include <cstdint>

namespace aneurysm::checks
{

inline constexpr std::int64_t vortex_cells = 24; ///< along the edges x and y of the box; 6 along z

Scenario vortex_scenario();
/// The first crest of these vortices is U [m/s].
analytic::TaylorGreen flow_of(const Scenario& s, double U);
/// The start at rest, then given the vortices' velocity.
SimulationState vortices(const Probe& probe, const Scenario& s, const analytic::TaylorGreen& flow);

} // namespace aneurysm::checks
