// SPDX-License-Identifier: Apache-2.0
#include "app/run.hpp"

#include "app/notes.hpp"
#include "app/options.hpp"
#include "common/error.hpp"
#include "common/file.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "common/text.hpp"
#include "output/columns.hpp"
#include "output/frames.hpp"
#include "output/run_directory.hpp"
#include "output/run_frames.hpp"
#include "output/summary.hpp"
#include "reference/bifurcation.hpp"
#include "verification/backends/make_simulation.hpp"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <utility>

namespace aneurysm::app
{
namespace
{

using output::RunDirectory;

struct RunOptions {
    std::filesystem::path scenario; ///< may be empty with `resume`
    std::filesystem::path out;      ///< empty: results/NAME, by the scenario's name
    backends::BackendChoice backend;
    bool has_backend = false;           ///< it was chosen; else a resumed run goes on with its own
    bool has_precision = false;         ///< likewise
    std::optional<std::int64_t> frames; ///< instead of the scenario's
    bool resume = false;
    bool strict = false; ///< an unconverged solve is an error
};

/// What to run and from where.
struct Start {
    Scenario scenario;
    std::filesystem::path out;
    std::optional<SimulationState> state; ///< to go on from
    std::int64_t frames = 0;
};

/// results/NAME, where the scenario's name is one of a directory.
std::filesystem::path default_out(const RunOptions& options, const std::string& name)
{
    const bool printable =
        std::ranges::none_of(name, [](unsigned char c) { return c < ' ' || c == '/' || c == 0x7F; });
    if (name.empty() || name == "." || name == ".." || !printable) {
        throw InputError(options.scenario.string() + ": name", "no name for a directory (" + name + ")",
                         "needed: --out DIR, or another name");
    }
    return std::filesystem::path("results") / name;
}

Start fresh_start(const RunOptions& options)
{
    if (options.scenario.empty()) {
        throw InputError("SCENARIO", "no scenario file given",
                         "needed: a file such as data/scenarios/quick.json");
    }
    Start start;
    start.scenario = read_scenario(options.scenario);
    start.out = options.out.empty() ? default_out(options, start.scenario.name) : options.out;
    if (is_there(start.out)) {
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
    if (!is_there(file) && is_there(RunDirectory::manifest_file(options.out))) {
        start.scenario =
            RunDirectory::scenario(options.out); // killed before the first: once more from frame 0
    } else {
        output::Checkpoint checkpoint = output::read_checkpoint(file);
        start.scenario = std::move(checkpoint.scenario);
        start.state = std::move(checkpoint.state);
    }
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
    const std::int64_t done = start.state ? start.state->frame : 0;
    if (done >= start.frames) {
        throw InputError("--frames", "frame " + std::to_string(start.frames) + " is done already",
                         "needed: more than " + std::to_string(done));
    }
    return start;
}

void print_summary(const Start& start, double rate)
{
    std::cout << "Results in " << start.out.string() << "\n"
              << output::summary(start.scenario, output::read_frames(RunDirectory::frames_file(start.out)))
              << "  speed          " << std::setprecision(4) << rate
              << " frames/s, without the settling at the start\n"
              << "frames.csv has the numbers of every frame";
    if (start.scenario.output.particles_every_frames > 0) {
        std::cout << "; ParaView shows it all by: paraview --script="
                  << shell_word((start.out / "show_in_paraview.py").string());
    }
    std::cout << std::endl;
}

/// Whose the run is, unless the command line says otherwise.
backends::BackendChoice backend_of(const RunOptions& options)
{
    backends::BackendChoice choice = options.backend;
    if (options.resume) {
        const Engine engine = RunDirectory::engine(options.out);
        choice.backend = options.has_backend ? choice.backend : engine.backend;
        choice.precision = options.has_precision ? choice.precision : engine.precision;
    }
    return choice;
}

/// What goes on with an interrupted run as it was meant.
std::string command_to_go_on(const RunOptions& options, const Start& start)
{
    return "aneurysm run --resume --out " + shell_word(start.out.string()) +
           (options.frames ? " --frames " + std::to_string(*options.frames) : "") +
           (options.backend.threads > 0 ? " --threads " + std::to_string(options.backend.threads) : "") +
           (options.backend.block_size > 0 ? " --block-size " + std::to_string(options.backend.block_size)
                                           : "") +
           (options.strict ? " --strict" : "");
}

RunDirectory open_directory(const RunOptions& options, const Start& start, const Simulation& simulation)
{
    if (!options.resume) {
        return RunDirectory::create(start.out, start.scenario, simulation.engine());
    }
    RunDirectory directory = RunDirectory::resume(
        start.out, {start.scenario, start.state ? *start.state : simulation.state()}, simulation.engine());
    if (!directory.others().empty()) {
        std::cerr << "aneurysm: note: other programs than this one made " << directory.others()
                  << "; made_by in manifest.json says which frames are whose\n";
    }
    return directory;
}

/// With --strict, a solve that was given up ends the run.
void refuse_unsolved(const Scenario& scenario, const FrameRecord& record)
{
    if (!output::is_solved(scenario, record)) {
        throw SimulationError("frame " + std::to_string(record.frame),
                              "pressure.max_iterations (" + std::to_string(scenario.pressure.max_iterations) +
                                  ") ended the solve of (3) before its tolerances were met (--strict)",
                              "needed: a larger pressure.max_iterations, or a smaller time.frame_s");
    }
}

int run(const CLI::App& app, RunOptions& options)
{
    const Start start = make_start(options);
    options.backend = backend_of(options);
    settle_tuning(app, options.backend);
    const std::unique_ptr<Simulation> simulation =
        backends::make_simulation(options.backend, start.scenario, start.state, options.scenario);
    if (const std::string note = note_before_run(start.scenario); !note.empty()) {
        std::cerr << "aneurysm: note: " << note << "\n";
    }
    bool complete = false;
    double rate = 0;
    {
        const InterruptWatch watch;
        RunDirectory directory = open_directory(options, start, *simulation);
        const Vessel vessel = reference::vessel_of(start.scenario);
        Progress progress("frame", simulation->state().frame, start.frames);
        complete = output::run_frames(start.scenario, vessel, start.frames, *simulation, directory,
                                      [&](const FrameRecord& record) {
                                          progress.show(record.frame, output::name_of(record.phase));
                                          if (options.strict) {
                                              refuse_unsolved(start.scenario, record);
                                          }
                                      });
        rate = progress.per_second(simulation->state().frame);
    }
    print_summary(start, rate);
    if (!complete) {
        std::cerr << "interrupted after frame " << simulation->state().frame
                  << "; go on with: " << command_to_go_on(options, start) << "\n";
    }
    return complete ? exit_done : exit_interrupted;
}

} // namespace

void add_run(CLI::App& app, std::optional<int>& code)
{
    const auto options = std::make_shared<RunOptions>();
    CLI::App* run_app = app.add_subcommand("run", "Simulate a scenario");
    add_input(*run_app, "SCENARIO", options->scenario, "scenario file; with --resume it may be left out");
    add_directory(*run_app, "--out", options->out,
                  "directory for the results; must not exist (default: results/NAME)");
    add_backend(*run_app, options->backend);
    add_tuning(*run_app, options->backend);
    add_count(*run_app, "--frames", options->frames, "run up to this frame instead of the scenario's last", 1,
              most_frames);
    run_app->add_flag("--resume", options->resume,
                      "go on from the checkpoint in --out, with the run's backend, to the same bits");
    run_app->add_flag("--strict", options->strict,
                      "stop at a frame whose solve of (3) didn't converge; else the summary says so");
    add_progress(*run_app);
    run_app->footer(
        "Examples:\n"
        "  aneurysm run data/scenarios/quick.json --out results/quick\n"
        "  aneurysm run --resume --out results/quick\n"
        "Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted by Ctrl-C, SIGTERM, SIGHUP or SIGUSR1 (a\n"
        "checkpoint was written).");
    run_app->callback([run_app, options, &code] {
        options->has_backend = run_app->count("--backend") > 0;
        options->has_precision = run_app->count("--precision") > 0;
        code = run(*run_app, *options);
    });
}

} // namespace aneurysm::app
