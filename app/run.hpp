// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/backends/make_simulation.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>

namespace aneurysm::app
{

struct RunOptions {
    std::filesystem::path scenario; ///< may be empty with `resume`
    std::filesystem::path out;      ///< empty: results/NAME, by the scenario's name
    backends::BackendChoice backend;
    std::optional<std::int64_t> frames; ///< instead of the scenario's
    bool resume = false;
};

/// `aneurysm run`: from a scenario to a run directory, with progress on stderr and a summary on stdout.
/// \return 0, or 130 when it was interrupted and left a checkpoint
/// \throws InputError before anything is written; SimulationError after the last good state was saved
int run(const RunOptions& options);

} // namespace aneurysm::app
