// SPDX-License-Identifier: Apache-2.0
#include "verification/backends/backend_for.hpp"

#include "common/error.hpp"

#include <utility>

namespace aneurysm::backends
{

std::unique_ptr<Backend> make_backend_for(const std::filesystem::path& file, const BackendChoice& choice,
                                          const Scenario& scenario, std::optional<SimulationState> state)
{
    try {
        return make_backend(choice, scenario, std::move(state));
    } catch (const InputError& error) {
        const std::string text = error.what();
        const auto end = text.find("; ");
        if (text.starts_with("--") || end == std::string::npos) {
            throw;
        }
        throw InputError(file.string(), text.substr(0, end), text.substr(end + 2));
    }
}

} // namespace aneurysm::backends
