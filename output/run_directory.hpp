// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/backend.hpp"
#include "output/checkpoint.hpp"
#include "output/file.hpp"
#include "output/frame_files.hpp"
#include "output/vtk.hpp"
#include "output/wall_mesh.hpp"

#include <nlohmann/json_fwd.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aneurysm::output
{

enum class RunStatus { running, finished, interrupted, failed };

/// The directory that a run leaves:
///
///     manifest.json            what ran, with which program and scenario, and how it ended
///     frames.csv               one row a frame
///     hashes.csv               a hash of each field, one row a frame
///     checkpoint.h5            the last good state
///     particles/frame_*.hdf    for ParaView; particles.hdf.series opens them with their times
///     wall/frame_*.hdf         likewise, of the same frames: wall, breach and open ends of an artery
///     show_in_paraview.py      shows both, where there are any: paraview --script=DIR/show_in_paraview.py
///
/// Every file is written in one step or grows by whole lines, so a killed run leaves nothing broken.
class RunDirectory
{
public:
    /// \throws InputError when the directory exists or cannot be made
    static RunDirectory create(const std::filesystem::path& directory, const Scenario& scenario,
                               const Engine& engine);

    /// Goes back to the checkpoint: later rows and particle files are dropped.
    /// \throws InputError when the directory, its engine or the checkpoint don't fit
    static RunDirectory resume(const std::filesystem::path& directory, const Checkpoint& checkpoint,
                               const Engine& engine);

    /// What a run simulates. \throws InputError for a manifest that isn't as it was written
    static Scenario scenario(const std::filesystem::path& directory);
    /// Who computed a run. \throws InputError for a manifest that isn't as it was written
    static Engine engine(const std::filesystem::path& directory);

    static std::filesystem::path checkpoint_file(const std::filesystem::path& directory);
    static std::filesystem::path frames_file(const std::filesystem::path& directory);
    static std::filesystem::path manifest_file(const std::filesystem::path& directory);
    static std::filesystem::path particles_file(const std::filesystem::path& directory, std::int64_t frame);
    /// Frames that particles were written for, rising.
    static std::vector<std::int64_t> particle_frames(const std::filesystem::path& directory);

    /// Frames whose rows are complete.
    std::int64_t frames() const { return frame_; }
    /// Who else made frames of this run, when that was another program than this one; else empty.
    const std::string& others() const { return others_; }

    /// A row of frames.csv and of hashes.csv; `state` is that after the frame.
    void append(const FrameRecord& record, const SimulationState& state);
    void write_particles(std::int64_t frame, const ParticleFields& fields);
    /// \pre the vessel is an artery
    void write_wall(std::int64_t frame, const Vessel& vessel, const WallShape& shape);
    void write_checkpoint(const SimulationState& state);
    /// How the run ended; `message` says why when it didn't finish.
    void close(RunStatus status, const std::string& message);

private:
    RunDirectory(std::filesystem::path directory, Scenario scenario, Engine engine, LineFile::Mode mode);

    void write_manifest(RunStatus status, const std::string& message) const;
    void take_makers(const nlohmann::ordered_json& manifest, std::int64_t frame);

    std::filesystem::path directory_;
    Scenario scenario_;
    Engine engine_;
    LineFile frames_;
    LineFile hashes_;
    FrameFiles particles_;
    FrameFiles walls_;
    std::string started_;
    std::vector<std::int64_t> resumed_at_; ///< frames
    std::int64_t frame_ = 0;
    std::string state_hash_; ///< of the last checkpoint
    std::shared_ptr<nlohmann::ordered_json>
        makers_; ///< one entry for each program that made frames, see docs/output.md
    std::string others_;
};

} // namespace aneurysm::output
