// SPDX-License-Identifier: Apache-2.0
// In the place of simulation_gpu.cu where there is no CUDA compiler.
#include "common/error.hpp"
#include "cuda/simulation.hpp"

namespace aneurysm::device
{
namespace
{

[[noreturn]] void refuse()
{
    throw InputError("--backend cuda", "this program was built without CUDA (CMake found no nvcc)",
                     "needed: build with the CUDA Toolkit, or use --backend cpu");
}

} // namespace

std::string gpu_device()
{
    refuse();
}

std::unique_ptr<Simulation> make_gpu_simulation(const Scenario&, Precision, const Tuning&,
                                                std::optional<SimulationState>)
{
    refuse();
}

} // namespace aneurysm::device
