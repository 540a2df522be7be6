// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/backends/make_simulation.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace aneurysm::app
{

struct ViewOptions {
    std::filesystem::path scenario;
    backends::BackendChoice backend{Backend::cpu, Precision::float_};
    std::optional<std::int64_t> frames; ///< where to stop; without: the scenario's last
    std::string size = "1400x900";      ///< of the window
    bool paused = false;                ///< at the start
    std::string keys;                   ///< pressed one by one, each when the one before has had its effect
    std::filesystem::path picture;      ///< of the window when it closes; empty: none
};

/// `aneurysm view`: simulates a scenario and shows it in a window until that is closed.
/// \return 0, or 1 when the simulation failed
/// \throws InputError, also when there is no display
int view(const ViewOptions& options);

} // namespace aneurysm::app
