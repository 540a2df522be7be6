// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/simulation.hpp"

#include <memory>
#include <optional>
#include <string>

namespace aneurysm::device
{

/// How the optimized backend runs; none of it changes a bit of any result.
struct Tuning {
    int threads = 0;    ///< of the CPU; 0: as many as pay
    int block_size = 0; ///< GPU threads in a block, a multiple of 32; 0: the default
    /// m_j grad W_ij of all pairs: kept in memory, computed in every pass,
    /// or what the particle count suggests.
    enum class Gradients { automatic, kept, computed } gradients = Gradients::automatic;
    /// Blocks of eight that there is room for at first, in the lists of free neighbors and in those of
    /// ghosts; they grow when a frame needs more. 0: what a lattice needs.
    int list_blocks = 0;
};

/// On the host's cores. From frame 0, or from a state of the same scenario, to the same bits.
/// \throws InputError when the scenario's values can't go together
std::unique_ptr<Simulation> make_cpu_simulation(const Scenario& scenario, Precision precision,
                                                const Tuning& tuning, std::optional<SimulationState> state);

/// The first GPU, in words. \throws Error when there is none, with the cause, or this build has no CUDA code
std::string gpu_device();

/// On the first GPU. \throws InputError when there is none, with the cause, or this build has no CUDA code
std::unique_ptr<Simulation> make_gpu_simulation(const Scenario& scenario, Precision precision,
                                                const Tuning& tuning, std::optional<SimulationState> state);

} // namespace aneurysm::device
