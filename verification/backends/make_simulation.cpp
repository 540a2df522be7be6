// SPDX-License-Identifier: Apache-2.0
#include "verification/backends/make_simulation.hpp"

#include "common/error.hpp"
#include "cuda/simulation.hpp"
#include "reference/simulation.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>
#include <sys/resource.h>
#include <utility>

namespace aneurysm::backends
{
namespace
{

/// What the process may still take [bytes]; huge where the system doesn't say.
double free_memory()
{
    double free = std::numeric_limits<double>::max();
    std::ifstream file("/proc/meminfo");
    double kibibytes = 0;
    for (std::string name; file >> name;) {
        if (name == "MemAvailable:" && file >> kibibytes) {
            free = 1024 * kibibytes;
        }
    }
    rlimit limit{};
    return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY
               ? std::min(free, static_cast<double>(limit.rlim_cur))
               : free;
}

/// Before memory is taken that isn't there: a system that gives it all the same ends the program later without a word.
void refuse_too_many(const Scenario& scenario)
{
    constexpr double bytes_each = 500; // of a particle, at least, by every backend
    constexpr double giga = 1e9;
    const double needed = bytes_each * static_cast<double>(scenario.particles.count);
    const double free = free_memory();
    if (needed > free) {
        std::ostringstream text;
        text.precision(3);
        text << "needed: " << needed / giga << " GB of memory at least, and " << free / giga
             << " GB are free";
        throw InputError("particles.count",
                         "more particles than fit (" + std::to_string(scenario.particles.count) + ")",
                         text.str());
    }
}

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
        refuse_too_many(scenario);
        return make(choice, scenario, std::move(state));
    } catch (const InputError& error) {
        if (file.empty() || error.where().starts_with("--")) {
            throw;
        }
        throw InputError(file.string(), error.where() + ": " + error.fault(), error.advice());
    }
}

} // namespace aneurysm::backends
