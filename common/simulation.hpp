// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/backend.hpp"
#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace aneurysm
{

/// The whole model of the paper, frame by frame: the flow, and the aneurysm that it makes grow and rupture.
class Simulation
{
public:
    Simulation() = default;
    virtual ~Simulation() = default;
    Simulation(const Simulation&) = delete;
    Simulation(Simulation&&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    Simulation& operator=(Simulation&&) = delete;

    /// Who computes.
    virtual Engine engine() const = 0;
    /// One frame.
    /// \throws SimulationError that names frame and particle; state() is then still that of the last good
    /// frame
    virtual FrameRecord advance() = 0;
    /// Numbers of single precision are exact in it.
    virtual const SimulationState& state() const = 0;
    /// By particle, of the last flow step; rho_0 for what isn't blood [kg/m^3]
    virtual const std::vector<double>& density() const = 0;
    /// By flow step of the last frame and particle, as each solve left it [Pa]; the pressures of state() have
    /// been through the controller since.
    virtual const std::vector<double>& solved_pressure() const = 0;
    /// The same of the potential of the density's correction [Pa]
    virtual const std::vector<double>& solved_kappa() const = 0;

    // What a benchmark shows; nothing where it isn't measured.

    /// Device memory in use [bytes]
    virtual std::size_t bytes() const { return 0; }
    /// Pairs of the last frame's largest step: places in the lists of free neighbors and of ghosts, what
    /// fills them up included.
    virtual std::pair<std::int64_t, std::int64_t> pairs() const { return {}; }
    /// Seconds that each pass took since the last call, by name.
    virtual std::vector<std::pair<std::string, double>> take_profile() { return {}; }
};

} // namespace aneurysm
