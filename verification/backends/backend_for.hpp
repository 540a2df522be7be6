// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/backends/backend.hpp"

#include <filesystem>

namespace aneurysm::backends
{

/// make_backend for a scenario that was read from a file: sampling finds contradictions that need the
/// geometry, and doesn't know the file's name. \throws InputError that names it
std::unique_ptr<Backend> make_backend_for(const std::filesystem::path& file, const BackendChoice& choice,
                                          const Scenario& scenario, std::optional<SimulationState> state);

} // namespace aneurysm::backends
