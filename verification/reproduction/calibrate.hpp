// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/reproduction/context.hpp"

#include <optional>

namespace aneurysm::reproduction
{

/// What data/calibration.json asks for: the values that the paper doesn't give, on the rows of Table 4 and
/// the seeds that it names. Each candidate is run with each seed; Y then follows along the recorded impacts,
/// so that it costs no runs.
/// `first_seed`: instead of the file's.
/// \return every candidate with its best Y and its error, and which is the best
Section calibrate(Reproduction& reproduction, const nlohmann::json& plan, std::optional<int> first_seed);

} // namespace aneurysm::reproduction
