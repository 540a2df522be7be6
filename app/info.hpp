// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <optional>

namespace aneurysm::app
{

/// `aneurysm info`: version and equations, or what follows from a scenario.
void add_info(CLI::App& app, std::optional<int>& code);

} // namespace aneurysm::app
