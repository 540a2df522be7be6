// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace aneurysm::device
{

enum class Precision { single_, double_ };

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

/// The whole model of the paper in device memory, frame by frame; the same physics as reference::Simulation.
class Simulation
{
public:
    Simulation() = default;
    virtual ~Simulation() = default;
    Simulation(const Simulation&) = delete;
    Simulation(Simulation&&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    Simulation& operator=(Simulation&&) = delete;

    /// Where it runs, in words.
    virtual std::string device() const = 0;
    /// One frame. \throws SimulationError that names frame and particle; state() is then still that of the
    /// last good frame
    virtual FrameRecord advance() = 0;
    /// Downloaded when asked for; numbers of single precision are exact in it.
    virtual const SimulationState& state() = 0;
    /// By particle, of the last flow step; rho_0 for what isn't blood [kg/m^3]
    virtual const std::vector<double>& density() = 0;
    /// By flow step of the last frame and particle, as each solve left it [Pa]
    virtual const std::vector<double>& solved_pressure() = 0;

    /// Device memory in use [bytes]
    virtual std::size_t bytes() const = 0;
    /// Pairs of the last frame's largest step: places in the lists of free neighbors and of ghosts, what
    /// fills them up included.
    virtual std::pair<std::int64_t, std::int64_t> pairs() = 0;
    /// Seconds that each pass took since the last call, by name; empty where passes can't be told apart.
    virtual std::vector<std::pair<std::string, double>> take_profile() = 0;
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
