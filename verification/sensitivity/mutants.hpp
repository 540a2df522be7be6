// SPDX-License-Identifier: Apache-2.0
// Which mutants `aneurysm verify --sensitivity` plants.
#pragma once

#include "verification/sensitivity/hook.hpp"

#include <string>
#include <vector>

namespace aneurysm::sensitivity
{

/// Relative size of a mutant in a coefficient or an exponent: 1 %. Larger ones are easier to find.
inline constexpr double mutant_size = 0.01;

/// Each kind of mutant that makes sense at a place, at each place of each backend.
std::vector<Mutant> all_mutants();

/// 24 of them, for every day: both backends and all kinds, and each equation is hit, be it through another
/// that uses it.
std::vector<Mutant> daily_mutants();

/// "22", "EOS", "Fig. 1" or "3.4".
std::string equation_of(Place place);

/// "eq22_radius/power/reference"
std::string name_of(const Mutant& mutant);

/// "R, to the power 1.01"
std::string words_of(const Mutant& mutant);

/// "reference" or "cpu": what the backend is called on the command line.
std::string name_of(Side side);

} // namespace aneurysm::sensitivity
