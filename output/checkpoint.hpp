// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"

#include <filesystem>

namespace aneurysm::output
{

struct Checkpoint {
    Scenario scenario;
    SimulationState state;
};

/// Replaces the file in one step, so that the last good checkpoint is never lost.
/// \throws Error
void write_checkpoint(const std::filesystem::path& file, const Scenario& scenario,
                      const SimulationState& state);

/// \throws InputError when the file is truncated, damaged, foreign or of another version
Checkpoint read_checkpoint(const std::filesystem::path& file);

} // namespace aneurysm::output
