// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"

#include <string>
#include <vector>

namespace aneurysm::output
{

/// Whether the frame's last solve of (3) met the scenario's tolerances, rather than ended by pressure.max_iterations.
bool is_solved(const Scenario& scenario, const FrameRecord& record);

/// What all frames of a run say, in a few lines of text.
std::string summary(const Scenario& scenario, const std::vector<FrameRecord>& records);

} // namespace aneurysm::output
