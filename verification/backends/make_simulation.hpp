// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/simulation.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace aneurysm::backends
{

/// Who computes, and how. Neither threads nor blocks change a bit of the result.
struct BackendChoice {
    Backend backend = Backend::reference;
    Precision precision = Precision::double_;
    int threads = 0;    ///< of the cpu backend; 0: as many as pay
    int block_size = 0; ///< GPU threads in a block, a multiple of 32; 0: the default
};

/// "reference", "cpu double", ...
std::string name_of(const BackendChoice& choice);

/// From frame 0, or from a state of the same scenario.
/// \param file  the scenario's, for messages about what only sampling finds out; empty: they go without
/// \throws InputError when this build has no such backend or precision, or the scenario contradicts itself
std::unique_ptr<Simulation> make_simulation(const BackendChoice& choice, const Scenario& scenario,
                                            std::optional<SimulationState> state,
                                            const std::filesystem::path& file = {});

} // namespace aneurysm::backends
