// SPDX-License-Identifier: Apache-2.0
#include "cuda/executor/executor_cpu.hpp"
#include "cuda/model.hpp"

namespace aneurysm::device
{

std::unique_ptr<Simulation> make_cpu_simulation(const Scenario& scenario, Precision precision,
                                                const Tuning& tuning, std::optional<SimulationState> state)
{
    CpuExecutor executor(tuning.threads);
    if (precision == Precision::float_) {
        return std::make_unique<Model<CpuExecutor, float>>(std::move(executor), scenario, tuning, state);
    }
    return std::make_unique<Model<CpuExecutor, double>>(std::move(executor), scenario, tuning, state);
}

} // namespace aneurysm::device
