// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace aneurysm
{

/// The path of another of the project's programs, which lie in one folder.
std::string own_program(const std::string& name);

/// Runs a program to its end; what it prints goes where ours goes.
/// \throws Error with `advice` when it can't be started or fails
void run_program(const std::vector<std::string>& words, const std::string& advice);

} // namespace aneurysm
