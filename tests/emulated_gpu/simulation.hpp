// SPDX-License-Identifier: Apache-2.0
// The simulation for the GPU on an emulated one.
#pragma once

#include "common/frame.hpp"
#include "common/scenario.hpp"

#include <cstddef>
#include <memory>
#include <string>

namespace emulated_gpu
{

class Simulation
{
public:
    Simulation() = default;
    virtual ~Simulation() = default;
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    virtual aneurysm::FrameRecord advance() = 0;
    virtual const aneurysm::SimulationState& state() = 0;
    virtual std::size_t bytes() const = 0;
};

struct Options {
    std::string precision; ///< float, double
    int block_size = 0;
    bool computes_gradients = false; ///< else as the executor likes it
};
std::unique_ptr<Simulation> simulate(const aneurysm::Scenario& scenario, const Options& options,
                                     const aneurysm::SimulationState& state);

} // namespace emulated_gpu
