// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace aneurysm::reproduction
{

/// The wall of one frame along a run's impacts.
struct WallFrame {
    double radius = 0;            ///< R [m]
    double thickness = 0;         ///< h [m]
    double critical_pressure = 0; ///< P_c [Pa]
    Phase phase = Phase::warm_up;
};

/// What a wall does under recorded impacts, up to its rupture.
struct WallHistory {
    std::vector<WallFrame> frames;             ///< from frame 1
    std::optional<std::int64_t> rupture_frame; ///< none: it holds to the end of the record
    std::optional<std::int64_t> developed;     ///< first frame with the largest R; none: not reached
};

/// Until the wall ruptures neither sigma, phi nor Y act on the flow: (21) has none of them. So the impacts of
/// one run that doesn't rupture, with (22), (23) and (13) along them, say in which frame each other wall
/// would have ruptured: exactly, since this calls what ends a frame of the reference.
///
/// `records`: all frames of a run from 1 on, of a scenario that differs from `scenario` in `rupture` alone.
/// \throws Error when R isn't the recorded one to the bit, as where the run itself ruptured
WallHistory wall_along(const Scenario& scenario, std::span<const FrameRecord> records);

/// The wall under the same impact [N] in each frame, from frame 1 on. No run is needed for it.
std::vector<WallFrame> wall_under(const Scenario& scenario, double impact, std::int64_t frames);

} // namespace aneurysm::reproduction
