// SPDX-License-Identifier: Apache-2.0
#include "output/recorded_run.hpp"

#include "common/error.hpp"
#include "output/frames.hpp"
#include "output/run_directory.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace aneurysm::output
{
namespace
{

namespace fs = std::filesystem;

/// "0, 100, 200, ..., 3000": all of a few, the first and the last of many.
std::string list_of(const std::vector<std::int64_t>& frames)
{
    constexpr std::size_t most = 40;
    std::string text;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (frames.size() > most && i == most - 1) {
            text += ", ...";
            i = frames.size() - 1;
        }
        text += (text.empty() ? "" : ", ") + std::to_string(frames[i]);
    }
    return text;
}

} // namespace

RecordedRun::RecordedRun(fs::path directory)
    : directory_(std::move(directory)), scenario_(RunDirectory::scenario(directory_)),
      records_(read_frames(RunDirectory::frames_file(directory_))),
      particle_frames_(RunDirectory::particle_frames(directory_))
{
    for (std::size_t i = 0; i < records_.size(); ++i) {
        if (records_[i].frame != static_cast<std::int64_t>(i) + 1) {
            throw InputError(
                RunDirectory::frames_file(directory_).string() + ": line " + std::to_string(i + 2),
                "frame " + std::to_string(records_[i].frame) + " in place of " + std::to_string(i + 1),
                "needed: the file as it was written");
        }
    }
    if (particle_frames_.empty()) {
        throw InputError((directory_ / "particles").string(), "no particle files",
                         "needed: a run whose scenario has output.particles_every_frames above 0");
    }
}

FrameRecord RecordedRun::record(std::int64_t frame) const
{
    if (frame == 0) {
        return first_record(scenario_);
    }
    if (frame < 0 || static_cast<std::size_t>(frame) > records_.size()) {
        throw InputError(RunDirectory::frames_file(directory_).string(),
                         "no row for frame " + std::to_string(frame),
                         "needed: a frame up to " + std::to_string(records_.size()));
    }
    return records_[static_cast<std::size_t>(frame) - 1];
}

ShownParticles RecordedRun::particles(std::int64_t frame) const
{
    if (!std::binary_search(particle_frames_.begin(), particle_frames_.end(), frame)) {
        throw InputError(RunDirectory::particles_file(directory_, frame).string(),
                         "no particles were written for frame " + std::to_string(frame),
                         "there are: " + list_of(particle_frames_));
    }
    return read_vtk(RunDirectory::particles_file(directory_, frame));
}

FrameRecord first_record(const Scenario& scenario)
{
    FrameRecord record;
    const double r_0 = scenario.vessel.radius_m;
    record.radius = scenario.aneurysm.initial_radius_radii * r_0;
    record.thickness = scenario.rupture.thickness_ratio * r_0;
    record.total = scenario.particles.count;
    return record;
}

} // namespace aneurysm::output
