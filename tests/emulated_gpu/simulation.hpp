// SPDX-License-Identifier: Apache-2.0
// The simulation for the GPU on an emulated one.
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

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
/// What the executor for the GPU makes of it; of `actual` values, a number that is in device memory.
double sum(const std::vector<double>& values, int actual, int block_size);
std::vector<int> scan(const std::vector<int>& values, int actual);
struct Sorted {
    std::vector<int> keys;
    std::vector<int> order;
    std::vector<int> starts; ///< of each key
};
Sorted sort(const std::vector<int>& keys, int end);

std::unique_ptr<Simulation> simulate(const aneurysm::Scenario& scenario, const Options& options,
                                     const aneurysm::SimulationState& state);

} // namespace emulated_gpu
