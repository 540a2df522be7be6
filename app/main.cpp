// SPDX-License-Identifier: Apache-2.0
// The program `aneurysm`.
#include "app/compare.hpp"
#include "app/info.hpp"
#include "app/launch.hpp"
#include "app/options.hpp"
#include "app/reproduce.hpp"
#include "app/run.hpp"
#include "app/verify.hpp"
#include "common/error.hpp"
#include "output/build_info.hpp"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace
{

using namespace aneurysm;
using app::add_choice;
using app::add_choices;
using app::CompareOptions;
using app::ReproduceOptions;
using app::RunOptions;
using app::VerifyOptions;

struct InfoOptions {
    std::string scenario;
    bool schema = false;
};

constexpr int bad_input = 2;

void add_tuning(CLI::App& app, backends::BackendChoice& backend)
{
    app.add_option("--threads", backend.threads, "of backend cpu; 0: as many as pay")->capture_default_str();
    app.add_option("--block-size", backend.block_size,
                   "of backend cuda: GPU threads in a block, a multiple of 32; 0: the default")
        ->capture_default_str();
}

CLI::App* add_run(CLI::App& app, RunOptions& options)
{
    CLI::App* run = app.add_subcommand("run", "Simulate a scenario");
    run->add_option("SCENARIO", options.scenario, "scenario file; with --resume it may be left out");
    run->add_option("--out", options.out,
                    "directory for the results; must not exist (default: results/NAME)");
    add_choice(*run, "--backend", options.backend.backend, backend_names, "who computes");
    add_choice(*run, "--precision", options.backend.precision, precision_names, "of its flow");
    add_tuning(*run, options.backend);
    run->add_option("--frames", options.frames, "run up to this frame instead of the scenario's last");
    run->add_flag("--resume", options.resume, "go on from the checkpoint in --out, to the same bits");
    run->footer("Examples:\n"
                "  aneurysm run data/scenarios/quick.json --out results/quick\n"
                "  aneurysm run --resume --out results/quick\n"
                "Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted (a checkpoint was written).");
    return run;
}

CLI::App* add_compare(CLI::App& app, CompareOptions& options)
{
    CLI::App* compare = app.add_subcommand("compare", "Compare a backend with the reference");
    compare->add_option("SCENARIO", options.scenario, "scenario file")->required();
    add_choice(*compare, "--candidate", options.candidate.backend, backend_names, "who is compared");
    add_choice(*compare, "--precision", options.candidate.precision, precision_names, "of its flow");
    add_tuning(*compare, options.candidate);
    compare
        ->add_option("--mode", options.mode,
                     "lockstep: each frame starts from the candidate's own state, bounds are rounding's")
        ->capture_default_str();
    compare->add_option("--frames", options.frames,
                        "how many to compare (default: up to the scenario's last)");
    compare->add_option("--from", options.from, "let the candidate come to this frame first")
        ->capture_default_str();
    compare->add_option("--ensemble", options.ensemble, "members of the ensemble in mode free")
        ->capture_default_str();
    compare->add_option("--record", options.record, "in mode bits: CSV file for the candidate's hashes");
    compare->add_option("--report", options.report, "JSON file for the result");
    compare->footer(
        "Examples:\n"
        "  aneurysm compare data/scenarios/quick.json --candidate cpu --precision float --frames 300\n"
        "  aneurysm compare data/scenarios/quick.json --candidate cpu --precision float --mode bits\n"
        "Exit codes: 0 all within its bounds, 1 failed, 2 bad input, 3 something is not within its bounds,\n"
        "130 interrupted.");
    return compare;
}

CLI::App* add_verify(CLI::App& app, VerifyOptions& options)
{
    CLI::App* verify = app.add_subcommand("verify", "Check every equation, and write a report");
    verify->add_option("--out", options.out, "directory for the reports; must not exist, or be empty");
    CLI::Option* quick = verify->add_flag("--quick", options.quick, "the checks that take seconds (default)");
    verify->add_flag("--full", options.full, "all checks, minutes")->excludes(quick);
    verify->add_option("--only", options.only, "words of checks, equations (13) and levels (L2), by commas")
        ->delimiter(',');
    add_choices(*verify, "--backend", options.backends, backend_names, "only these (default: all)");
    add_choices(*verify, "--precision", options.precisions, precision_names,
                "of cpu and cuda (default: both)");
    verify->add_option("--jobs", options.jobs, "checks at once; 0: as many as there are cores")
        ->capture_default_str();
    verify->add_flag("--baseline", options.baseline,
                     "make the runs recorded in --data again instead; --only then names scenarios");
    verify->add_flag("--record", options.record, "with --baseline: record them anew");
    verify->add_option("--data", options.data, "folder of the baseline (default: the project's data/)");
    CLI::Option* sensitivity =
        verify->add_flag("--sensitivity", options.sensitivity,
                         "plant faults in the equations instead, and show which check finds which");
    verify->add_option("--faults", options.faults, "which: all; ci: 24 that take a minute")
        ->needs(sensitivity)
        ->capture_default_str();
    verify->footer(
        "Examples:\n"
        "  aneurysm verify --out results/verify\n"
        "  aneurysm verify --baseline --out results/baseline\n"
        "  aneurysm verify --sensitivity --out results/sensitivity\n"
        "  aneurysm verify --full --only eq13,L2 --backend cpu --precision float --out results/verify\n"
        "Exit codes: 0 all hold, 1 failed, 2 bad input, 3 something doesn't hold, 130 interrupted\n"
        "(the reports say what there was).");
    return verify;
}

CLI::App* add_reproduce(CLI::App& app, ReproduceOptions& options)
{
    CLI::App* reproduce = app.add_subcommand("reproduce", "Reproduce the paper's tables and figures");
    reproduce->add_option("ITEM", options.items, "table1 ... table4, fig4 ... fig10, errata, all (default)");
    reproduce->add_option("--out", options.out,
                          "directory for data, pictures and reproduction.html; its runs are used again");
    add_choice(*reproduce, "--backend", options.backend.backend, backend_names, "who computes");
    add_choice(*reproduce, "--precision", options.backend.precision, precision_names, "of its flow");
    reproduce->add_option("--seeds", options.seeds, "members of the ensembles")->capture_default_str();
    reproduce->add_option("--first-seed", options.first_seed,
                          "of the ensembles (default: 1); with --calibrate of the calibration");
    reproduce->add_option("--jobs", options.jobs, "runs at once; 0: as many as there are cores")
        ->capture_default_str();
    reproduce->add_flag("--calibrate", options.calibrate,
                        "fit what the paper doesn't give, as data/calibration.json says, instead");
    reproduce->footer(
        "Examples:\n"
        "  aneurysm reproduce all --out results/paper\n"
        "  aneurysm reproduce table4 fig9 --seeds 2 --out results/paper\n"
        "  aneurysm reproduce --calibrate --out results/calibration\n"
        "Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted (the same command goes on).");
    return reproduce;
}

CLI::App* add_info(CLI::App& app, InfoOptions& options)
{
    CLI::App* info =
        app.add_subcommand("info", "Show version and equations, or what follows from a scenario");
    info->add_option("SCENARIO", options.scenario, "scenario file");
    info->add_flag("--schema", options.schema, "print the JSON Schema of scenario files");
    info->footer("Examples:\n"
                 "  aneurysm info\n"
                 "  aneurysm info data/scenarios/paper_tc1.json");
    return info;
}

/// A subcommand of the program aneurysm-pictures, which gets all that stands behind its name.
CLI::App* add_handed_over(CLI::App& app, const std::string& name, const std::string& description)
{
    CLI::App* command = app.add_subcommand(name, description);
    command->set_help_flag();
    command->prefix_command();
    return command;
}

[[noreturn]] void hand_over(const CLI::App& command)
{
    std::vector<std::string> words = command.remaining();
    words.insert(words.begin(), command.get_name());
    app::launch("aneurysm-pictures", words, command.get_name(),
                "it is built (target aneurysm-pictures) where VTK is: Debian's libvtk9-dev");
}

void show(const InfoOptions& options)
{
    if (options.schema) {
        std::cout << scenario_schema();
    } else if (options.scenario.empty()) {
        std::cout << app::program_info() << "Equations of the paper: number, section, status, title\n"
                  << app::equation_table();
    } else {
        std::cout << app::scenario_info(read_scenario(options.scenario));
    }
}

int parse_and_run(int argc, char** argv)
{
    CLI::App app("Aneurysms by smoothed particle hydrodynamics: flow, growth and rupture.", "aneurysm");
    app.set_version_flag("--version", std::string("aneurysm ") + output::build_info().version);
    app.footer("Example:\n  aneurysm run data/scenarios/quick.json --out results/quick\n"
               "aneurysm SUBCOMMAND --help says more.");
    RunOptions run_options;
    InfoOptions info_options;
    CompareOptions compare_options;
    VerifyOptions verify_options;
    ReproduceOptions reproduce_options;
    const CLI::App* run = add_run(app, run_options);
    const CLI::App* compare = add_compare(app, compare_options);
    const CLI::App* verify = add_verify(app, verify_options);
    const CLI::App* reproduce = add_reproduce(app, reproduce_options);
    const CLI::App* info = add_info(app, info_options);
    const CLI::App* render = add_handed_over(app, "render", "Draw frames of a run, or make a video of them");
    const CLI::App* view = add_handed_over(app, "view", "Simulate a scenario in a window");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            return app.exit(error); // --help, --version
        }
        throw InputError("command line", error.what(), "see aneurysm --help");
    }
    if (run->parsed()) {
        return app::run(run_options);
    }
    if (compare->parsed()) {
        return app::compare(compare_options);
    }
    if (verify->parsed()) {
        return app::verify(verify_options);
    }
    if (reproduce->parsed()) {
        return app::reproduce(reproduce_options);
    }
    if (render->parsed() || view->parsed()) {
        hand_over(render->parsed() ? *render : *view);
    }
    if (!info->parsed()) {
        throw InputError("command line", "no subcommand given", "see aneurysm --help");
    }
    show(info_options);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        const int code = parse_and_run(argc, argv);
        if (!std::cout.flush()) {
            throw Error("standard output", "cannot be written", "needed: a place with enough space");
        }
        return code;
    } catch (const InputError& error) {
        std::cerr << "aneurysm: " << error.what() << "\n";
        return bad_input;
    } catch (const std::exception& error) {
        std::cerr << "aneurysm: " << error.what() << "\n";
        return 1;
    }
}
