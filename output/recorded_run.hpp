// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "output/vtk.hpp"

#include <cstdint>
#include <filesystem>
#include <vector>

namespace aneurysm::output
{

/// A run directory, read back: its scenario, its frames and the frames that particles were written for.
class RecordedRun
{
public:
    /// \throws InputError that names the file, also when no particles were written
    explicit RecordedRun(std::filesystem::path directory);

    const std::filesystem::path& directory() const { return directory_; }
    const Scenario& scenario() const { return scenario_; }
    const std::vector<FrameRecord>& records() const { return records_; } ///< of frames 1, 2, ...
    /// Rising; 0 is the state that the run began with.
    const std::vector<std::int64_t>& particle_frames() const { return particle_frames_; }

    /// The row of a frame; for frame 0, what the scenario begins with.
    /// \throws InputError when frames.csv ends before it
    FrameRecord record(std::int64_t frame) const;
    /// \throws InputError when none were written for the frame, with those that there are, or the file is bad
    ShownParticles particles(std::int64_t frame) const;

private:
    std::filesystem::path directory_;
    Scenario scenario_;
    std::vector<FrameRecord> records_;
    std::vector<std::int64_t> particle_frames_;
};

/// Before the first frame of a scenario: its sac, and no flow yet.
FrameRecord first_record(const Scenario& scenario);

} // namespace aneurysm::output
