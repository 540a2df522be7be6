// SPDX-License-Identifier: Apache-2.0
// All of the CUDA code, compiled for the emulated GPU. In a namespace of its own (see CMakeLists.txt): its
// lanes are single threads, and mustn't be mixed up with the CPU's.
#include "tests/emulated_gpu/simulation.hpp"

#include "cuda/setup.cpp"         // NOLINT
#include "cuda/simulation_gpu.cu" // NOLINT

namespace emulated_gpu
{
namespace
{

class Emulated final : public Simulation
{
public:
    explicit Emulated(std::unique_ptr<aneurysm::device::Simulation> simulation)
        : simulation_(std::move(simulation))
    {
    }
    aneurysm::FrameRecord advance() override { return simulation_->advance(); }
    const aneurysm::SimulationState& state() override { return simulation_->state(); }
    std::size_t bytes() const override { return simulation_->bytes(); }

private:
    std::unique_ptr<aneurysm::device::Simulation> simulation_;
};

} // namespace

std::unique_ptr<Simulation> simulate(const aneurysm::Scenario& scenario, const Options& options,
                                     const aneurysm::SimulationState& state)
{
    using aneurysm::device::Precision;
    using aneurysm::device::Tuning;
    Tuning tuning;
    tuning.block_size = options.block_size;
    tuning.gradients =
        options.computes_gradients ? Tuning::Gradients::computed : Tuning::Gradients::automatic;
    const auto precision = options.precision == "float" ? Precision::single_ : Precision::double_;
    return std::make_unique<Emulated>(
        aneurysm::device::make_gpu_simulation(scenario, precision, tuning, state));
}

} // namespace emulated_gpu
