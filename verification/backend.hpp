// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario.hpp"
#include "output/run_directory.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace aneurysm::verification
{

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
};

/// From frame 0, or from a state of the same scenario.
/// \throws InputError when this build has no such backend or precision, or the scenario contradicts itself
std::unique_ptr<Backend> make_backend(const std::string& backend, const std::string& precision,
                                      const Scenario& scenario, std::optional<SimulationState> state);

} // namespace aneurysm::verification
