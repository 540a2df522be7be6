// SPDX-License-Identifier: Apache-2.0
#include "cuda/executor/executor_gpu.hpp"
#include "cuda/model.hpp"

namespace aneurysm::device
{

std::string gpu_device()
{
    const GpuExecutor executor(0); // finds out whether it can be used
    return GpuExecutor::device();
}

std::unique_ptr<Simulation> make_gpu_simulation(const Scenario& scenario, Precision precision,
                                                const Tuning& tuning, std::optional<SimulationState> state)
{
    GpuExecutor executor(tuning.block_size);
    if (precision == Precision::float_) {
        return std::make_unique<Model<GpuExecutor, float>>(std::move(executor), scenario, tuning, state);
    }
    return std::make_unique<Model<GpuExecutor, double>>(std::move(executor), scenario, tuning, state);
}

} // namespace aneurysm::device
