// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/backends/make_simulation.hpp"
#include "verification/comparison/comparison.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace aneurysm::comparison
{

/// Called after each frame; returns whether to go on.
using AfterFrame = std::function<bool(const FrameRecord&)>;

/// Frame by frame: the reference starts from the candidate's own state, takes its pressures and the
/// potentials of its correction as the solutions of (3), makes the frame, and the candidate's must be within
/// the bound of rounding in every field. Errors cannot add up, so a fault shows in the frame that makes it.
///
/// What the candidate solved is checked by the reference's residuals of (3) for it: within the scenario's
/// tolerances plus the residual's rounding, and nothing below its lowest value. In double precision the
/// reference solves too, and must take as many iterations.
///
/// Where a decision (whom the controller places where, whether the correction may pull, rupture) lies within
/// its rounding and the two decide otherwise, the frame or what depends on the decision is left out and
/// counted; more than 1 % of such frames, or of particles with such decisions about them, fail.
///
/// \param candidate  in the state that the comparison begins with; advanced by `frames`
ComparisonResult compare_lockstep(const Scenario& scenario, Simulation& candidate, std::int64_t frames,
                                  const AfterFrame& after_frame);

} // namespace aneurysm::comparison
