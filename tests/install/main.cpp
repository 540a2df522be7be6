// SPDX-License-Identifier: Apache-2.0
// usage: first_frames SCENARIO FRAMES      impact force F_b [N] of each frame, by the reference and by the CPU executor;
// then W(0) of the kernel [1/m^3] by the reference and by the oracle.
#include "analytic/kernel_function.hpp"
#include "cuda/simulation.hpp"
#include "reference/kernel_function.hpp"
#include "reference/simulation.hpp"

#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv)
{
    if (argc != 3) {
        return 2;
    }
    const aneurysm::Scenario scenario = aneurysm::read_scenario(argv[1]);
    aneurysm::reference::Simulation reference(scenario);
    const auto cpu = aneurysm::device::make_cpu_simulation(scenario, aneurysm::Precision::float_, {}, {});
    for (int n = std::atoi(argv[2]); n > 0; --n) {
        std::printf("%.17g %.17g\n", reference.advance().impact_force, cpu->advance().impact_force);
    }
    const auto name = scenario.kernel.function;
    std::printf("%.17g %.17g\n", aneurysm::reference::Kernel(name, 1).value(0),
                aneurysm::analytic::kernel(name, 1, 0));
    return 0;
}
