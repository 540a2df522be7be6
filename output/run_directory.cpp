// SPDX-License-Identifier: Apache-2.0
#include "output/run_directory.hpp"

#include "common/error.hpp"
#include "output/frames.hpp"
#include "output/json.hpp"
#include "output/provenance.hpp"

#include <algorithm>
#include <array>

namespace aneurysm::output
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* hashes_name = "hashes.csv";
constexpr const char* series_name = "particles.vtkhdf.series";
constexpr std::array status_names{"running", "finished", "interrupted", "failed"};
constexpr const char* undamaged = "needed: an undamaged run directory";

std::string particle_file(std::int64_t frame)
{
    constexpr std::size_t width = 6;
    const std::string number = std::to_string(frame);
    return "particles/frame_" + std::string(width - std::min(width, number.size()), '0') + number + ".vtkhdf";
}

/// Makes the directory and its parents; it must not exist.
fs::path make_directory(const fs::path& directory)
{
    const auto fail = [&directory](const std::string& reason) {
        throw InputError(directory.string(), "output directory cannot be made (" + reason + ")",
                         "needed: a name that doesn't exist yet, in a writable place, or --resume");
    };
    if (directory.empty()) {
        fail("empty name");
    }
    std::error_code error;
    if (directory.has_parent_path()) {
        fs::create_directories(directory.parent_path(), error);
    }
    const bool made = !error && fs::create_directory(directory, error);
    if (error || !made) {
        fail(error ? error.message() : "it exists");
    }
    return directory;
}

void refuse_other_engine(const Json& manifest, const Engine& engine, const fs::path& file)
{
    const auto check = [&](const char* key, const std::string& now) {
        const std::string then = manifest.value(key, "");
        if (then != now) {
            throw InputError(file.string() + ": " + key, "the run cannot go on with another (" + now + ")",
                             "needed: " + then);
        }
    };
    check("backend", name_of(engine.backend));
    check("precision", name_of(engine.precision));
}

} // namespace

Engine RunDirectory::engine(const fs::path& directory)
{
    const fs::path file = manifest_file(directory);
    const Json manifest = read_json(file, undamaged);
    const auto backend = value_of<Backend>(manifest.value("backend", ""), backend_names);
    const auto precision = value_of<Precision>(manifest.value("precision", ""), precision_names);
    if (!backend || !precision) {
        throw InputError(file.string(), "names no backend and precision of this version", undamaged);
    }
    return {*backend, *precision, manifest.value("device", "")};
}

fs::path RunDirectory::checkpoint_file(const fs::path& directory)
{
    return directory / "checkpoint.h5";
}
fs::path RunDirectory::frames_file(const fs::path& directory)
{
    return directory / "frames.csv";
}
fs::path RunDirectory::manifest_file(const fs::path& directory)
{
    return directory / "manifest.json";
}
fs::path RunDirectory::particles_file(const fs::path& directory, std::int64_t frame)
{
    return directory / particle_file(frame);
}

std::vector<std::int64_t> RunDirectory::particle_frames(const fs::path& directory)
{
    std::vector<std::int64_t> frames;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(directory / "particles", error)) {
        const std::string stem = entry.path().stem().string();
        const std::int64_t frame = stem.starts_with("frame_") ? std::atoll(stem.c_str() + 6) : -1;
        if (frame >= 0 && entry.path().filename() == particles_file(directory, frame).filename()) {
            frames.push_back(frame);
        }
    }
    std::sort(frames.begin(), frames.end());
    return frames;
}

RunDirectory::RunDirectory(fs::path directory, Scenario scenario, Engine engine, LineFile::Mode mode)
    : directory_(std::move(directory)), scenario_(std::move(scenario)), engine_(std::move(engine)),
      frames_(frames_file(directory_), mode), hashes_(directory_ / hashes_name, mode), started_(now_utc())
{
}

RunDirectory RunDirectory::create(const fs::path& directory, const Scenario& scenario, const Engine& engine)
{
    const fs::path made = make_directory(directory);
    try {
        RunDirectory run(made, scenario, engine, LineFile::Mode::create);
        run.frames_.append(frames_header());
        run.hashes_.append(hashes_header());
        run.write_manifest(RunStatus::running, "");
        return run;
    } catch (const Error&) {
        std::error_code unused;
        fs::remove_all(made, unused); // nothing was in it yet
        throw;
    }
}

RunDirectory RunDirectory::resume(const fs::path& directory, const Checkpoint& checkpoint,
                                  const Engine& engine)
{
    const fs::path file = manifest_file(directory);
    const Json manifest = read_json(file, undamaged);
    refuse_other_engine(manifest, engine, file);
    RunDirectory run(directory, checkpoint.scenario, engine, LineFile::Mode::append);
    const auto rows = static_cast<std::size_t>(checkpoint.state.frame);
    run.frames_.keep(1 + rows);
    run.hashes_.keep(1 + rows);
    run.read_series(checkpoint.state.frame);
    run.started_ = manifest.value("started", run.started_);
    run.resumed_at_ = manifest.value("resumed_at_frames", run.resumed_at_);
    run.resumed_at_.push_back(checkpoint.state.frame);
    run.frame_ = checkpoint.state.frame;
    run.state_hash_ = state_hash(checkpoint.state);
    run.write_manifest(RunStatus::running, "");
    return run;
}

void RunDirectory::append(const FrameRecord& record, const SimulationState& state)
{
    hashes_.append(hashes_row(state));
    frames_.append(frames_row(record));
    frame_ = state.frame;
}

void RunDirectory::write_particles(std::int64_t frame, const ParticleFields& fields)
{
    const fs::path file = directory_ / particle_file(frame);
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    write_vtk(file, fields);
    if (std::find(particle_frames_.begin(), particle_frames_.end(), frame) == particle_frames_.end()) {
        particle_frames_.push_back(frame);
    }
    write_series();
}

void RunDirectory::write_checkpoint(const SimulationState& state)
{
    // The rows reach the disk before the checkpoint that counts on them.
    frames_.sync();
    hashes_.sync();
    output::write_checkpoint(checkpoint_file(directory_), scenario_, state);
    state_hash_ = state_hash(state);
}

void RunDirectory::close(RunStatus status, const std::string& message)
{
    write_manifest(status, message);
}

void RunDirectory::write_manifest(RunStatus status, const std::string& message) const
{
    Json json = provenance();
    json["backend"] = name_of(engine_.backend);
    json["precision"] = name_of(engine_.precision);
    json["device"] = engine_.device;
    json["started"] = started_;
    json["written"] = now_utc();
    json["resumed_at_frames"] = resumed_at_;
    json["status"] = status_names.at(static_cast<std::size_t>(status));
    json["message"] = message;
    json["frames"] = frame_;
    json["state_hash"] = state_hash_;
    json["frame_hashes"] = hashes_name;
    json["scenario_hash"] = scenario_hash(scenario_);
    json["scenario"] = Json::parse(to_json(scenario_));
    write_atomically(manifest_file(directory_), json_text(json));
}

void RunDirectory::write_series() const
{
    Json files = Json::array();
    for (const std::int64_t frame : particle_frames_) {
        files.push_back(
            {{"name", particle_file(frame)}, {"time", static_cast<double>(frame) * scenario_.time.frame_s}});
    }
    const Json series{{"file-series-version", "1.0"}, {"files", files}};
    write_atomically(directory_ / series_name, series.dump(2) + "\n");
}

/// Finds the particle files up to a frame again and removes the later ones.
void RunDirectory::read_series(std::int64_t last_frame)
{
    for (const std::int64_t frame : particle_frames(directory_)) {
        if (frame <= last_frame) {
            particle_frames_.push_back(frame);
        } else {
            std::error_code unused;
            fs::remove(particles_file(directory_, frame), unused);
        }
    }
    if (!particle_frames_.empty()) {
        write_series();
    }
}

} // namespace aneurysm::output
