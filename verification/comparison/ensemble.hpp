// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/backend.hpp"
#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace aneurysm::comparison
{

/// What is kept of a frame of a free run.
struct FreeFrame {
    FrameRecord record;
    Vec3 momentum; ///< of the fluid [kg m/s]
};

/// A free run, and where its particles were at the end of each window.
struct FreeRun {
    std::vector<FreeFrame> frames;
    std::vector<Particles> particles;
    std::vector<FreeFrame> rounding; ///< of an undisturbed run: bounds of one frame's rounding [units of the
                                     ///< numbers]; only those of compared numbers are set
};

Vec3 momentum(const Particles& p);

/// Called after each frame, from several threads; returns whether to go on.
using FrameDone = std::function<bool(const FrameRecord&)>;

/// Runs of the reference from one state: the first is undisturbed, the others are disturbed at the start by
/// an ulp and after each frame within the bound of the candidate's rounding, deterministically.
/// \param window  frames between two kept sets of particles
/// \throws SimulationError of the first run that fails
std::vector<FreeRun> run_ensemble(const Scenario& scenario, const SimulationState& start, Precision precision,
                                  std::int64_t frames, std::int64_t window, int members,
                                  const FrameDone& done);

} // namespace aneurysm::comparison
