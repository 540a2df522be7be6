// SPDX-License-Identifier: Apache-2.0
// What a frame asks of a GPU, counted on an emulated one that computes nothing:
//
//     gpu_launches SCENARIO.json ITERATIONS PARTICLES...
#include "common/error.hpp"
#include "common/scenario/limits.hpp"
#include "common/vessel/initial_state.hpp"
#include "cuda/bifurcation.hpp"
#include "tests/emulated_gpu/simulation.hpp"

#include <cuda_runtime.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iomanip>
#include <iostream>
#include <string>

namespace
{

using namespace aneurysm;

/// Frame 0 before the blood has settled: nothing here depends on where it is.
SimulationState unsettled(const Scenario& scenario)
{
    const double r_1 = device::daughter_radius(scenario.vessel.radius_m);
    return initial_state(scenario, sample(scenario, Vessel(scenario, r_1), r_1, {}), 1);
}

void show(Scenario scenario, Precision precision, int iterations)
{
    // One step a frame at every resolution.
    scenario.time.frame_s =
        std::min(scenario.time.frame_s, 0.9 * step_limits(scenario, estimated_spacing(scenario)).smallest());
    const SimulationState start = unsettled(scenario);
    const auto gpu = emulated_gpu::simulate(scenario, {precision}, start);
    gpu->advance();
    emulated_gpu::last_asked();
    gpu->advance(); // as a graph
    const emulated_gpu::Asked asked = emulated_gpu::last_asked();
    const int reset = asked.loops.front();
    const int iteration = asked.loops.back();
    std::cout << std::setw(9) << scenario.particles.count << std::setw(10) << name_of(precision)
              << std::setw(9) << asked.kernels << std::setw(9) << asked.copies << std::setw(9) << reset
              << std::setw(11) << iteration << std::setw(12) << asked.kernels + iterations * iteration
              << std::setw(11) << static_cast<double>(gpu->bytes()) / 1e6 << std::setw(16)
              << static_cast<double>(gpu->bytes()) / static_cast<double>(scenario.particles.count)
              << std::setw(11) << asked.to_device << std::setw(9) << asked.to_host << "\n";
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4) {
        std::cerr << "usage: gpu_launches SCENARIO.json ITERATIONS PARTICLES...\n";
        return 2;
    }
    try {
        Scenario scenario = read_scenario(argv[1]);
        const int iterations = std::atoi(argv[2]);
        emulated_gpu::execute(false);
        std::cout << "Kernels of a frame, those of sorting (for 8 bits a pass) and scanning included\n"
                  << "particles precision  kernels   copies  a reset  iteration  in " << std::setw(4)
                  << iterations << " it.  memory/MB  bytes/particle  B to GPU  to host\n"
                  << std::fixed << std::setprecision(1);
        for (int k = 3; k < argc; ++k) {
            scenario.particles.count = std::atoi(argv[k]);
            show(scenario, Precision::float_, iterations);
            show(scenario, Precision::double_, iterations);
        }
    } catch (const std::exception& error) {
        std::cerr << "gpu_launches: " << error.what() << "\n";
        return 1;
    }
    return 0;
}
