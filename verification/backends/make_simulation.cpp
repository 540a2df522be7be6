// SPDX-License-Identifier: Apache-2.0
#include "verification/backends/make_simulation.hpp"

#include "common/error.hpp"
#include "cuda/simulation.hpp"
#include "reference/simulation.hpp"

#include <utility>

namespace aneurysm::backends
{
namespace
{

std::unique_ptr<Simulation> make(const BackendChoice& choice, const Scenario& scenario,
                                 std::optional<SimulationState> state)
{
    const device::Tuning tuning{.threads = choice.threads, .block_size = choice.block_size};
    switch (choice.backend) {
    case Backend::cpu:
        return device::make_cpu_simulation(scenario, choice.precision, tuning, std::move(state));
    case Backend::cuda:
        return device::make_gpu_simulation(scenario, choice.precision, tuning, std::move(state));
    case Backend::reference:
        break;
    }
    if (choice.precision != Precision::double_) {
        throw InputError("--precision", "the reference has no other than double (float)", "allowed: double");
    }
    return state ? std::make_unique<reference::Simulation>(scenario, std::move(*state))
                 : std::make_unique<reference::Simulation>(scenario);
}

} // namespace

std::string name_of(const BackendChoice& choice)
{
    const std::string backend = name_of(choice.backend);
    return choice.backend == Backend::reference ? backend : backend + " " + name_of(choice.precision);
}

std::unique_ptr<Simulation> make_simulation(const BackendChoice& choice, const Scenario& scenario,
                                            std::optional<SimulationState> state,
                                            const std::filesystem::path& file)
{
    try {
        return make(choice, scenario, std::move(state));
    } catch (const InputError& error) {
        if (file.empty() || error.where().starts_with("--")) {
            throw;
        }
        throw InputError(file.string(), error.where() + ": " + error.fault(), error.advice());
    }
}

} // namespace aneurysm::backends
