// SPDX-License-Identifier: Apache-2.0
#include "verification/run.hpp"

#include "common/error.hpp"
#include "output/columns.hpp"
#include "output/frames.hpp"
#include "output/run_directory.hpp"
#include "verification/backend_for.hpp"
#include "verification/interrupt.hpp"
#include "verification/progress.hpp"
#include "verification/summary.hpp"

#include <iomanip>
#include <iostream>
#include <utility>

namespace aneurysm::verification
{
namespace
{

using output::RunDirectory;
using output::RunStatus;

/// What to run and from where.
struct Start {
    Scenario scenario;
    std::filesystem::path out;
    std::optional<output::Checkpoint> checkpoint;
    std::int64_t frames = 0;
};

Start fresh_start(const RunOptions& options)
{
    if (options.scenario.empty()) {
        throw InputError("SCENARIO", "no scenario file given",
                         "needed: a file such as data/scenarios/quick.json");
    }
    Start start;
    start.scenario = read_scenario(options.scenario);
    start.out = options.out.empty() ? std::filesystem::path("results") / start.scenario.name : options.out;
    if (std::filesystem::exists(start.out)) {
        throw InputError(start.out.string(), "output directory exists",
                         "needed: another --out, or --resume to go on");
    }
    return start;
}

Start resumed_start(const RunOptions& options)
{
    if (options.out.empty()) {
        throw InputError("--resume", "no directory given to go on in",
                         "needed: --out DIR of the interrupted run");
    }
    Start start;
    start.out = options.out;
    const std::filesystem::path file = RunDirectory::checkpoint_file(options.out);
    start.checkpoint = output::read_checkpoint(file);
    start.scenario = start.checkpoint->scenario;
    if (!options.scenario.empty()) {
        const std::string now = scenario_hash(read_scenario(options.scenario));
        const std::string then = scenario_hash(start.scenario);
        if (now != then) {
            throw InputError(options.scenario.string(),
                             "is another scenario (hash " + now + ") than that of " + file.string(),
                             "needed: the same (" + then + "), or none");
        }
    }
    return start;
}

Start make_start(const RunOptions& options)
{
    Start start = options.resume ? resumed_start(options) : fresh_start(options);
    start.frames = options.frames.value_or(start.scenario.time.frames);
    if (start.frames < 1) {
        throw InputError("--frames", "out of range (" + std::to_string(start.frames) + ")",
                         "allowed: at least 1");
    }
    const std::int64_t done = start.checkpoint ? start.checkpoint->state.frame : 0;
    if (done >= start.frames) {
        throw InputError("--frames", "frame " + std::to_string(start.frames) + " is done already",
                         "needed: more than " + std::to_string(done));
    }
    return start;
}

/// Frames, one after the other, with all that is written on the way.
class Loop
{
public:
    Loop(const Start& start, Backend& backend, RunDirectory& directory)
        : start_(start), backend_(backend), directory_(directory),
          progress_("frame", backend.state().frame, start.frames)
    {
    }

    /// \return whether it came to the end; not when it was interrupted
    bool run()
    {
        if (backend_.state().frame == 0) {
            write_particles(0);
        }
        while (backend_.state().frame < start_.frames && !InterruptWatch::interrupted()) {
            const FrameRecord record = backend_.advance();
            directory_.append(record, backend_.state());
            write_due(record.frame);
            progress_.show(record.frame, output::name_of(record.phase));
        }
        save_state();
        return backend_.state().frame >= start_.frames;
    }

    void save_state()
    {
        const std::int64_t frame = backend_.state().frame;
        if (saved_frame_ != frame) {
            directory_.write_checkpoint(backend_.state());
            saved_frame_ = frame;
        }
    }

    std::int64_t frame() const { return backend_.state().frame; }
    double frames_per_second() const { return progress_.per_second(backend_.state().frame); }

private:
    void write_due(std::int64_t frame)
    {
        const auto due = [frame](std::int64_t every) { return every > 0 && frame % every == 0; };
        if (due(start_.scenario.output.particles_every_frames)) {
            write_particles(frame);
        }
        if (due(start_.scenario.output.checkpoint_every_frames)) {
            save_state();
        }
    }
    void write_particles(std::int64_t frame)
    {
        if (start_.scenario.output.particles_every_frames > 0) {
            directory_.write_particles(frame, {backend_.state().particles, backend_.density()});
        }
    }

    const Start& start_;
    Backend& backend_;
    RunDirectory& directory_;
    Progress progress_;
    std::int64_t saved_frame_ = -1;
};

/// The run has failed; keep what there is and say why. A second failure (the same full disk) must not hide
/// the first. A state whose row didn't make it into frames.csv is none to go on from; the checkpoint before
/// it is.
void save_failed(Loop& loop, RunDirectory& directory, const std::string& message)
{
    try {
        if (loop.frame() == directory.frames()) {
            loop.save_state();
        }
    } catch (const Error&) { // NOLINT(bugprone-empty-catch)
    }
    try {
        directory.close(RunStatus::failed, message);
    } catch (const Error&) { // NOLINT(bugprone-empty-catch)
    }
}

void print_summary(const Start& start, double rate)
{
    std::cout << "Results in " << start.out.string() << "\n"
              << summary(start.scenario, output::read_frames(RunDirectory::frames_file(start.out)))
              << "  speed          " << std::setprecision(4) << rate << " frames/s\n"
              << "frames.csv has the numbers of every frame; ParaView opens particles.vtkhdf.series"
              << std::endl;
}

} // namespace

int run(const RunOptions& options)
{
    const Start start = make_start(options);
    const std::unique_ptr<Backend> backend =
        make_backend_for(options.scenario, options.backend, start.scenario,
                         start.checkpoint ? std::optional(start.checkpoint->state) : std::nullopt);
    const output::Engine engine{options.backend.name, options.backend.precision, backend->device()};
    const InterruptWatch watch;
    RunDirectory directory = start.checkpoint ? RunDirectory::resume(start.out, *start.checkpoint, engine)
                                              : RunDirectory::create(start.out, start.scenario, engine);
    bool complete = false;
    double rate = 0;
    {
        Loop loop(start, *backend, directory);
        try {
            complete = loop.run();
        } catch (const Error& error) {
            save_failed(loop, directory, error.what());
            throw;
        }
        rate = loop.frames_per_second();
    }
    const std::string frame = std::to_string(backend->state().frame);
    directory.close(complete ? RunStatus::finished : RunStatus::interrupted,
                    complete ? "" : "interrupted after frame " + frame);
    print_summary(start, rate);
    if (!complete) {
        std::cerr << "interrupted after frame " << frame << "; go on with: aneurysm run --resume --out "
                  << start.out.string() << "\n";
    }
    return complete ? 0 : 130;
}

} // namespace aneurysm::verification
