// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"

#include <string>
#include <vector>

namespace aneurysm::output
{

/// What all frames of a run say, in a few lines of text.
std::string summary(const Scenario& scenario, const std::vector<FrameRecord>& records);

} // namespace aneurysm::output
