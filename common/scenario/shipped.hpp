// SPDX-License-Identifier: Apache-2.0
// What is shipped with the programs: data/ and a few scripts.
#pragma once

#include "common/scenario/scenario.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace aneurysm
{

/// data/ of the project: the folder that the variable ANEURYSM_DATA names; else that beside this program, in its
/// installation or its project; else that of the sources it was built from; else that of the working directory.
/// \throws InputError when the named one, or all others, are not there
std::filesystem::path data_directory();

/// Makes `directory` the data of this program and of those that it starts; the same as ANEURYSM_DATA.
void use_data_directory(const std::filesystem::path& directory);

/// Looks for all that is shipped and reads the scenarios, so that what is missing is known before anything is computed.
/// \throws InputError
void require_data();

/// A script of the project, such as output/plot_run.py, in the same places but the first.
/// \throws InputError when it isn't there
std::filesystem::path shipped_script(const std::string& name);

/// Where an installation has it, relative to its programs' folder.
const char* installed_share();
/// The folder of the sources that this was built from.
const char* project_sources();
/// What is in data/, as it was when this was built.
std::vector<std::string> shipped_files();

/// data/scenarios/NAME.json. \throws InputError
Scenario shipped_scenario(const std::string& name);

} // namespace aneurysm
