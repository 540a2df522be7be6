// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/simulation.hpp"
#include "output/run_directory.hpp"

#include <cstdint>
#include <functional>

namespace aneurysm::output
{

/// Called after each frame.
using OnFrame = std::function<void(const FrameRecord& record)>;

/// Frames up to the given one, with all that is written on the way, and what says how it ended. `vessel`: the
/// scenario's, whose wall is written beside the particles.
/// \return whether it came to the end; not when it was interrupted, then a checkpoint was written
/// \throws Error what the simulation or a full disk throws; the last good state was saved as far as possible
bool run_frames(const Scenario& scenario, const Vessel& vessel, std::int64_t frames, Simulation& simulation,
                RunDirectory& directory, const OnFrame& on_frame);

} // namespace aneurysm::output
