// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario/scenario.hpp"

#include <string>

namespace aneurysm::app
{

/// What to know of an allowed scenario before its run, in a sentence: that its particles are of another size than those
/// for which the values of base.json were chosen. Empty where there is nothing.
std::string note_before_run(const Scenario& scenario);

} // namespace aneurysm::app
