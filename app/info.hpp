// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario/scenario.hpp"

#include <string>

namespace aneurysm::app
{

/// The program's version and how it was built.
std::string program_info();
/// Every equation of the paper with its status and deviation.
std::string equation_table();
/// What follows from a scenario's values, and which of them are assumed.
std::string scenario_info(const Scenario& scenario);

} // namespace aneurysm::app
