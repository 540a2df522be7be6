// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <optional>

namespace aneurysm::app
{

/// `aneurysm run`: from a scenario to a run directory, with progress on stderr and a summary on stdout. It sets
/// 0, or 130 when it was interrupted and left a checkpoint; it throws InputError before anything is written,
/// SimulationError after the last good state was saved.
void add_run(CLI::App& app, std::optional<int>& code);

} // namespace aneurysm::app
