// SPDX-License-Identifier: Apache-2.0
// The calibrated scenario, and what the paper's figures change in it.
#pragma once

#include "verification/reproduction/context.hpp"

#include <string>
#include <vector>

namespace aneurysm::reproduction
{

struct Variant {
    std::string name; ///< for the reader
    Scenario scenario;
};

/// The scenario that data/calibration.json names.
Scenario calibrated_scenario();
/// Table 2, in its order; 3000 frames.
std::vector<Variant> shape_variants(const Reproduction& reproduction);
/// Fig. 8, in its order; 2500 frames.
std::vector<Variant> angle_variants(const Reproduction& reproduction);

} // namespace aneurysm::reproduction
