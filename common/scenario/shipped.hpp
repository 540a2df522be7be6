// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario/scenario.hpp"

#include <filesystem>
#include <string>

namespace aneurysm
{

/// data/ of the project: that of the working directory, else that of the sources this was built from.
/// \throws InputError when neither is there
std::filesystem::path data_directory();

/// data/scenarios/NAME.json. \throws InputError
Scenario shipped_scenario(const std::string& name);

} // namespace aneurysm
