// SPDX-License-Identifier: Apache-2.0
#include "app/run.hpp"

#include "app/options.hpp"
#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "output/columns.hpp"
#include "output/frames.hpp"
#include "output/run_directory.hpp"
#include "output/run_frames.hpp"
#include "output/summary.hpp"
#include "reference/bifurcation.hpp"
#include "verification/backends/make_simulation.hpp"

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
};

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
    const std::int64_t done = start.checkpoint ? start.checkpoint->state.frame : 0;
    if (done >= start.frames) {
        throw InputError("--frames", "frame " + std::to_string(start.frames) + " is done already",
                         "needed: more than " + std::to_string(done));
    }
    return start;
}

/// As a shell takes it for one word.
std::string quoted(const std::string& word)
{
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
        return word;
    }
    std::string text = "'";
    for (const char c : word) {
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return text + "'";
}

void print_summary(const Start& start, double rate)
{
    std::cout << "Results in " << start.out.string() << "\n"
              << output::summary(start.scenario, output::read_frames(RunDirectory::frames_file(start.out)))
              << "  speed          " << std::setprecision(4) << rate
              << " frames/s, without the settling at the start\n"
              << "frames.csv has the numbers of every frame; ParaView shows it all by: paraview --script="
              << quoted((start.out / "show_in_paraview.py").string()) << std::endl;
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

int run(const RunOptions& options)
{
    const Start start = make_start(options);
    const std::unique_ptr<Simulation> simulation = backends::make_simulation(
        backend_of(options), start.scenario,
        start.checkpoint ? std::optional(start.checkpoint->state) : std::nullopt, options.scenario);
    const InterruptWatch watch;
    RunDirectory directory = start.checkpoint
                                 ? RunDirectory::resume(start.out, *start.checkpoint, simulation->engine())
                                 : RunDirectory::create(start.out, start.scenario, simulation->engine());
    const Vessel vessel(start.scenario, reference::daughter_radius(start.scenario.vessel.radius_m));
    bool complete = false;
    double rate = 0;
    {
        Progress progress("frame", simulation->state().frame, start.frames);
        complete = output::run_frames(
            start.scenario, vessel, start.frames, *simulation, directory,
            [&](const FrameRecord& record) { progress.show(record.frame, output::name_of(record.phase)); });
        rate = progress.per_second(simulation->state().frame);
    }
    print_summary(start, rate);
    if (!complete) {
        std::cerr << "interrupted after frame " << simulation->state().frame
                  << "; go on with: aneurysm run --resume --out " << quoted(start.out.string()) << "\n";
    }
    return complete ? exit_done : exit_interrupted;
}

} // namespace

void add_run(CLI::App& app, std::optional<int>& code)
{
    const auto options = std::make_shared<RunOptions>();
    CLI::App* run_app = app.add_subcommand("run", "Simulate a scenario");
    run_app->add_option("SCENARIO", options->scenario, "scenario file; with --resume it may be left out");
    run_app->add_option("--out", options->out,
                        "directory for the results; must not exist (default: results/NAME)");
    add_backend(*run_app, options->backend);
    add_tuning(*run_app, options->backend);
    run_app->add_option("--frames", options->frames, "run up to this frame instead of the scenario's last")
        ->check(at_least(1));
    run_app->add_flag("--resume", options->resume,
                      "go on from the checkpoint in --out, with the run's backend, to the same bits");
    run_app->footer("Examples:\n"
                    "  aneurysm run data/scenarios/quick.json --out results/quick\n"
                    "  aneurysm run --resume --out results/quick\n"
                    "Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted (a checkpoint was written).");
    run_app->callback([run_app, options, &code] {
        options->has_backend = run_app->count("--backend") > 0;
        options->has_precision = run_app->count("--precision") > 0;
        code = run(*options);
    });
}

} // namespace aneurysm::app
