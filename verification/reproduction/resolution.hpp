// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/reproduction/context.hpp"

#include <string>
#include <vector>

namespace aneurysm::reproduction
{

/// How the impact force (16) depends on the particle spacing, in an artery whose sac doesn't grow: literally,
/// and per area of a particle. What follows from it is added to `text`.
ResultTable resolution_study(Reproduction& reproduction, std::vector<std::string>& text);

} // namespace aneurysm::reproduction
