// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aneurysm::backends
{

/// Who computes. Neither threads nor blocks change a bit of the result.
struct BackendChoice {
    std::string name = "reference";   ///< reference, cpu, cuda
    std::string precision = "double"; ///< double, float
    int threads = 0;                  ///< of the cpu backend; 0: as many as pay
    int block_size = 0;               ///< GPU threads in a block, a multiple of 32; 0: the default
};

/// Something that computes the model frame by frame.
class Backend
{
public:
    Backend() = default;
    virtual ~Backend() = default;
    Backend(const Backend&) = delete;
    Backend(Backend&&) = delete;
    Backend& operator=(const Backend&) = delete;
    Backend& operator=(Backend&&) = delete;

    /// What and where it computes, in words.
    virtual std::string device() const = 0;
    /// One frame.
    /// \throws SimulationError; state() is then still that of the last good frame
    virtual FrameRecord advance() = 0;
    virtual const SimulationState& state() const = 0;
    /// By particle, of the last frame [kg/m^3].
    virtual const std::vector<double>& density() const = 0;
    /// The pressures that the solves of the last frame ended with, by flow step and particle [Pa]; those of
    /// state() have been through the controller since.
    virtual const std::vector<double>& solved_pressure() const = 0;
};

/// From frame 0, or from a state of the same scenario.
/// \throws InputError when this build has no such backend or precision, or the scenario contradicts itself
std::unique_ptr<Backend> make_backend(const BackendChoice& choice, const Scenario& scenario,
                                      std::optional<SimulationState> state);

} // namespace aneurysm::backends
