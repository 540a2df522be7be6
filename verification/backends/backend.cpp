// SPDX-License-Identifier: Apache-2.0
#include "verification/backends/backend.hpp"

#include "common/error.hpp"
#include "cuda/simulation.hpp"
#include "reference/simulation.hpp"

#include <utility>

namespace aneurysm::backends
{
namespace
{

class ReferenceBackend final : public Backend
{
public:
    ReferenceBackend(const Scenario& scenario, std::optional<SimulationState> state)
        : simulation_(state ? reference::Simulation(scenario, std::move(*state))
                            : reference::Simulation(scenario))
    {
    }

    std::string device() const override { return "one CPU core"; }
    FrameRecord advance() override { return simulation_.advance(); }
    const SimulationState& state() const override { return simulation_.state(); }
    const std::vector<double>& density() const override { return simulation_.density(); }
    const std::vector<double>& solved_pressure() const override { return simulation_.solved_pressure(); }

private:
    reference::Simulation simulation_;
};

class DeviceBackend final : public Backend
{
public:
    explicit DeviceBackend(std::unique_ptr<device::Simulation> simulation)
        : simulation_(std::move(simulation))
    {
    }

    std::string device() const override { return simulation_->device(); }
    FrameRecord advance() override { return simulation_->advance(); }
    const SimulationState& state() const override { return simulation_->state(); }
    const std::vector<double>& density() const override { return simulation_->density(); }
    const std::vector<double>& solved_pressure() const override { return simulation_->solved_pressure(); }

private:
    std::unique_ptr<device::Simulation> simulation_;
};

device::Precision precision_of(const std::string& name)
{
    if (name == "float") {
        return device::Precision::single_;
    }
    if (name == "double") {
        return device::Precision::double_;
    }
    throw InputError("--precision", "unknown (" + name + ")", "allowed: float, double");
}

} // namespace

std::unique_ptr<Backend> make_backend(const BackendChoice& choice, const Scenario& scenario,
                                      std::optional<SimulationState> state)
{
    const device::Precision precision = precision_of(choice.precision);
    const device::Tuning tuning{choice.threads, choice.block_size, device::Tuning::Gradients::automatic};
    if (choice.name == "cpu") {
        return std::make_unique<DeviceBackend>(
            device::make_cpu_simulation(scenario, precision, tuning, std::move(state)));
    }
    if (choice.name == "cuda") {
        return std::make_unique<DeviceBackend>(
            device::make_gpu_simulation(scenario, precision, tuning, std::move(state)));
    }
    if (choice.name != "reference") {
        throw InputError("--backend", "unknown (" + choice.name + ")", "allowed: reference, cpu, cuda");
    }
    if (precision != device::Precision::double_) {
        throw InputError("--precision", "the reference has no other than double (float)", "allowed: double");
    }
    return std::make_unique<ReferenceBackend>(scenario, std::move(state));
}

} // namespace aneurysm::backends
