// SPDX-License-Identifier: Apache-2.0
#include "output/run_directory.hpp"

#include "common/error.hpp"
#include "output/frames.hpp"
#include "output/json.hpp"
#include "output/paraview_script.hpp"
#include "output/provenance.hpp"

#include <array>

namespace aneurysm::output
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* hashes_name = "hashes.csv";
constexpr const char* particles = "particles";
constexpr std::array status_names{"running", "finished", "interrupted", "failed"};
constexpr const char* undamaged = "needed: an undamaged run directory";

void refuse_other_engine(const Json& manifest, const Engine& engine, const fs::path& file)
{
    const auto check = [&](const char* key, const std::string& now) {
        const auto then = manifest.value(key, std::string());
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
    return read_json_as(file, undamaged, [&file](const Json& manifest) -> Engine {
        const auto word = [&manifest](const char* key) { return manifest.value(key, std::string()); };
        const auto backend = value_of<Backend>(word("backend"), backend_names);
        const auto precision = value_of<Precision>(word("precision"), precision_names);
        if (!backend || !precision) {
            throw InputError(file.string(), "names no backend and precision of this version", undamaged);
        }
        return {*backend, *precision, word("device")};
    });
}

Scenario RunDirectory::scenario(const fs::path& directory)
{
    const fs::path file = manifest_file(directory);
    return read_json_as(file, undamaged, [&file](const Json& manifest) {
        if (!manifest.is_object() || !manifest.contains("scenario")) {
            throw InputError(file.string(), "not as it was written (no scenario)", undamaged);
        }
        return parse_scenario(manifest["scenario"].dump(), file.string() + ": scenario");
    });
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
    return FrameFiles::file(directory, particles, frame);
}

std::vector<std::int64_t> RunDirectory::particle_frames(const fs::path& directory)
{
    return FrameFiles::frames(directory, particles);
}

RunDirectory::RunDirectory(fs::path directory, Scenario scenario, Engine engine, LineFile::Mode mode)
    : directory_(std::move(directory)), scenario_(std::move(scenario)), engine_(std::move(engine)),
      frames_(frames_file(directory_), mode), hashes_(directory_ / hashes_name, mode),
      particles_(directory_, particles, scenario_.time.frame_s),
      walls_(directory_, "wall", scenario_.time.frame_s), started_(now_utc())
{
}

RunDirectory RunDirectory::create(const fs::path& directory, const Scenario& scenario, const Engine& engine)
{
    const fs::path place = plain(directory);
    NewDirectory made(place, NewDirectory::Allowed::nothing);
    try {
        RunDirectory run(place, scenario, engine, LineFile::Mode::create);
        run.frames_.append(frames_header());
        run.hashes_.append(hashes_header());
        if (scenario.output.particles_every_frames > 0) {
            write_atomically(place / "show_in_paraview.py", paraview_script());
        }
        run.take_makers(Json::object(), 0);
        run.write_manifest(RunStatus::running, "");
        made.keep();
        return run;
    } catch (const Error&) {
        std::error_code unused;
        fs::remove_all(place, unused); // nothing was in it yet
        throw;
    }
}

RunDirectory RunDirectory::resume(const fs::path& directory, const Checkpoint& checkpoint,
                                  const Engine& engine)
{
    const fs::path file = manifest_file(directory);
    RunDirectory run = read_json_as(file, undamaged, [&](const Json& manifest) {
        refuse_other_engine(manifest, engine, file);
        RunDirectory gone_on(directory, checkpoint.scenario, engine, LineFile::Mode::append);
        gone_on.started_ = manifest.value("started", gone_on.started_);
        gone_on.resumed_at_ = manifest.value("resumed_at_frames", gone_on.resumed_at_);
        gone_on.take_makers(manifest, checkpoint.state.frame);
        return gone_on;
    });
    const auto rows = static_cast<std::size_t>(checkpoint.state.frame);
    run.frames_.keep(1 + rows);
    run.hashes_.keep(1 + rows);
    run.particles_.go_back(checkpoint.state.frame);
    run.walls_.go_back(checkpoint.state.frame);
    run.resumed_at_.push_back(checkpoint.state.frame);
    run.frame_ = checkpoint.state.frame;
    run.state_hash_ = state_hash(checkpoint.state);
    run.write_manifest(RunStatus::running, "");
    return run;
}

/// Who made the frames up to `frame`, by the manifest, and this program for those after it.
void RunDirectory::take_makers(const Json& manifest, std::int64_t frame)
{
    Json then = manifest.value("made_by", Json::array());
    if (then.empty() && frame > 0) { // of a version that kept no list
        then.push_back({{"after_frame", 0}});
        for (const char* key : {"version", "commit", "compiler", "flags", "device"}) {
            then.back()[key] = manifest.value(key, std::string());
        }
    }
    const Json now = provenance();
    makers_ = std::make_shared<Json>(Json::array());
    for (const Json& maker : then) {
        if (maker.value("after_frame", std::int64_t{0}) >= frame) {
            continue; // it made none of these frames
        }
        makers_->push_back(maker);
        const auto word = [&maker](const char* key) { return maker.value(key, std::string()); };
        if (word("version") != now["version"] || word("commit") != now["commit"] ||
            word("compiler") != now["compiler"]) {
            others_ += (others_.empty() ? "" : "; ") +
                       ("frames after " + std::to_string(maker.value("after_frame", std::int64_t{0}))) +
                       " by version " + word("version") + ", commit " + word("commit") + ", " +
                       word("compiler");
        }
    }
    Json mine{{"after_frame", frame}};
    mine.update(now);
    mine["device"] = engine_.device;
    mine.update(surroundings());
    makers_->push_back(mine);
}

void RunDirectory::append(const FrameRecord& record, const SimulationState& state)
{
    hashes_.append(hashes_row(state));
    frames_.append(frames_row(record));
    frame_ = state.frame;
}

void RunDirectory::write_particles(std::int64_t frame, const ParticleFields& fields)
{
    write_vtk(particles_.place(frame), fields);
    particles_.add(frame);
}

void RunDirectory::write_wall(std::int64_t frame, const Vessel& vessel, const WallShape& shape)
{
    output::write_wall(walls_.place(frame), vessel, shape);
    walls_.add(frame);
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
    json["made_by"] = *makers_;
    json["frames"] = frame_;
    json["state_hash"] = state_hash_;
    json["frame_hashes"] = hashes_name;
    json["scenario_hash"] = scenario_hash(scenario_);
    json["scenario"] = Json::parse(to_json(scenario_));
    write_atomically(manifest_file(directory_), json_text(json));
}

} // namespace aneurysm::output
