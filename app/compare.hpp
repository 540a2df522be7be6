// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <optional>

namespace aneurysm::app
{

/// `aneurysm compare`: a candidate against the reference. Prints a table and the verdict; sets 0 when all is
/// within its bounds, 3 when not, 130 when interrupted.
void add_compare(CLI::App& app, std::optional<int>& code);

} // namespace aneurysm::app
