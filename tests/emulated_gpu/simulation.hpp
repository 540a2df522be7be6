// SPDX-License-Identifier: Apache-2.0
// The simulation for the GPU on an emulated one.
#pragma once

#include "common/simulation.hpp"

#include <memory>
#include <vector>

namespace emulated_gpu
{

struct Options {
    aneurysm::Precision precision;
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

std::unique_ptr<aneurysm::Simulation> simulate(const aneurysm::Scenario& scenario, const Options& options,
                                               const aneurysm::SimulationState& state);

} // namespace emulated_gpu
