// SPDX-License-Identifier: Apache-2.0
#include "verification/backend.hpp"

#include "common/error.hpp"
#include "reference/simulation.hpp"

#include <utility>

namespace aneurysm::verification
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

} // namespace

std::unique_ptr<Backend> make_backend(const BackendChoice& choice, const Scenario& scenario,
                                      std::optional<SimulationState> state)
{
    const auto& [backend, precision, threads, block_size] = choice;
    if (backend == "cpu" || backend == "cuda") {
        throw InputError("--backend", "not in this build (" + backend + ")", "allowed: reference");
    }
    if (backend != "reference") {
        throw InputError("--backend", "unknown (" + backend + ")", "allowed: reference");
    }
    if (precision == "float") {
        throw InputError("--precision", "the reference has no other than double (float)", "allowed: double");
    }
    if (precision != "double") {
        throw InputError("--precision", "unknown (" + precision + ")", "allowed: double");
    }
    return std::make_unique<ReferenceBackend>(scenario, std::move(state));
}

} // namespace aneurysm::verification
