// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace aneurysm
{

/// The folder of this program and the project's others; empty where the system has no /proc.
std::filesystem::path program_folder();

/// The path of another of the project's programs, which lie in one folder.
std::string own_program(const std::string& name);

/// Runs a program to its end; what it prints goes where ours goes.
/// \throws Error with `advice` when it can't be started or fails
void run_program(const std::vector<std::string>& words, const std::string& advice);

/// Goes on as another of the project's programs.
/// \param asked_by  what on the command line asks for it
/// \param needed    what makes it, for the message
/// \throws InputError when it isn't there
[[noreturn]] void become_program(const std::string& name, const std::vector<std::string>& arguments,
                                 const std::string& asked_by, const std::string& needed);

} // namespace aneurysm
