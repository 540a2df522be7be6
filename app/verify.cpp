// SPDX-License-Identifier: Apache-2.0
#include "app/verify.hpp"

#include "app/options.hpp"
#include "app/verify_baseline.hpp"
#include "app/verify_options.hpp"
#include "common/error.hpp"
#include "common/parallel.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "common/process/subprocess.hpp"
#include "common/scenario/shipped.hpp"
#include "common/text.hpp"
#include "output/file.hpp"
#include "output/provenance.hpp"
#include "output/report/html.hpp"
#include "output/report/markdown.hpp"
#include "verification/checks/checks.hpp"
#include "verification/suite/report.hpp"

#include <algorithm>
#include <iostream>
#include <optional>

namespace aneurysm::app
{
namespace
{

namespace fs = std::filesystem;

/// That makes the same reports again.
std::string command_of(const VerifyOptions& options)
{
    std::string command = std::string("aneurysm verify ") + (options.full ? "--full" : "--quick");
    const auto add = [&](const char* name, const std::vector<std::string>& words) {
        if (!words.empty()) {
            command.append(" ").append(name).append(" ").append(joined(words, ","));
        }
    };
    add("--only", options.only);
    const auto words = [](const auto& values) {
        std::vector<std::string> names;
        std::ranges::transform(values, std::back_inserter(names), [](auto value) { return name_of(value); });
        return names;
    };
    add("--backend", words(options.backends));
    add("--precision", words(options.precisions));
    return command + " --out DIR";
}

std::string selection_of(const VerifyOptions& options, std::size_t chosen)
{
    const std::string all = std::to_string(checks::all_checks().size());
    return (options.full ? "All levels, slow checks included: " : "Quick checks only: ") +
           std::to_string(chosen) + " of the " + all + " checks" +
           (options.only.empty() ? "" : ", chosen by --only " + joined(options.only, ","));
}

suite::SuiteResult run(const std::vector<const suite::Check*>& checks,
                       std::vector<suite::SuiteSubject> subjects, int threads)
{
    std::optional<Progress> progress; // how many there are is known with the first result
    return suite::run_suite(checks, std::move(subjects), threads,
                            [&](std::int64_t done, std::int64_t all, const std::string& doing) {
                                if (!progress) {
                                    progress.emplace("check", 0, all);
                                }
                                progress->show(done, doing);
                            });
}

void write(const fs::path& directory, const suite::SuiteReport& report)
{
    output::write_atomically(directory / "report.json", suite::suite_json(report));
    output::write_atomically(directory / "junit.xml", suite::suite_junit(report));
    const report::Document document = suite::suite_document(report);
    output::write_atomically(directory / "report.md", report::markdown(document));
    output::write_atomically(directory / "report.html", report::html(document));
}

int verify_suite(const VerifyOptions& options)
{
    const int threads = thread_count(options.jobs);
    const std::vector<const suite::Check*> checks =
        suite::select(checks::all_checks(), options.full, options.only);
    std::vector<suite::SuiteSubject> subjects = suite::make_subjects(options.backends, options.precisions);
    require_data();
    const ReportDirectory directory(options.out);

    suite::SuiteReport report;
    {
        const InterruptWatch watch;
        report.suite = run(checks, std::move(subjects), threads);
    }
    report.equations = suite::by_equation(report.suite, checks::all_checks());
    report.selection = selection_of(options, checks.size());
    report.command = command_of(options);
    report.date = output::now_utc();
    report.machine = output::machine();
    report.threads = threads;
    write(options.out, report);
    std::cout << suite::suite_text(report) << "Reports in " << options.out.string()
              << ": report.html, report.md, report.json, junit.xml" << std::endl;
    if (!report.suite.complete) {
        return exit_interrupted;
    }
    return passed(report.suite) ? exit_done : exit_differs;
}

/// The study needs both backends with places for mutants, which another program has.
[[noreturn]] void become_sensitivity(const VerifyOptions& options)
{
    std::vector<std::string> words{"--out",  options.out.string(),        "--faults", options.mutants,
                                   "--jobs", std::to_string(options.jobs)};
    for (const std::string& word : options.only) {
        words.insert(words.end(), {"--only", word});
    }
    if (options.full) {
        words.emplace_back("--full");
    }
    if (options.progress->quiet) {
        words.emplace_back("--quiet");
    }
    if (options.progress->seconds) {
        words.insert(words.end(), {"--progress", std::to_string(*options.progress->seconds)});
    }
    become_program("aneurysm-sensitivity", words, "--sensitivity",
                   "cmake --build --preset release --target aneurysm-sensitivity builds it");
}

int verify(VerifyOptions options)
{
    if (options.out.empty()) {
        options.out = options.baseline      ? "results/baseline"
                      : options.sensitivity ? "results/sensitivity"
                                            : "results/verify";
    }
    if (!options.data.empty()) {
        use_data_directory(options.data);
    }
    if (options.sensitivity) {
        become_sensitivity(options);
    }
    return options.baseline ? verify_baseline(options) : verify_suite(options);
}

} // namespace

void add_verify(CLI::App& app, std::optional<int>& code)
{
    const auto options = std::make_shared<VerifyOptions>();
    CLI::App* verify_app = app.add_subcommand("verify", "Check every equation, and write a report");
    CLI::Option* out = add_directory(*verify_app, "--out", options->out,
                                     "directory for the reports; must not exist, or be empty (default: "
                                     "results/verify, results/baseline, results/sensitivity)");
    CLI::Option* quick =
        verify_app->add_flag("--quick", options->quick, "the checks that take seconds (default)");
    CLI::Option* full = verify_app->add_flag("--full", options->full, "all checks, minutes")->excludes(quick);
    CLI::Option* only = add_words(*verify_app, "--only", options->only,
                                  "words of checks, equations (13) and levels (L2), by commas");
    CLI::Option* backend =
        add_choices(*verify_app, "--backend", options->backends, backend_names, "only these (default: all)");
    CLI::Option* precision = add_choices(*verify_app, "--precision", options->precisions, precision_names,
                                         "of cpu and cuda (default: both)");
    CLI::Option* jobs =
        add_count(*verify_app, "--jobs", options->jobs, "checks at once; 0: as many as pay", 0, most_at_once)
            ->default_str("0");
    options->progress = add_progress(*verify_app);
    CLI::Option* baseline =
        verify_app
            ->add_flag("--baseline", options->baseline,
                       "make the runs recorded in the data again instead; --only then names scenarios")
            ->excludes(quick)
            ->excludes(full)
            ->excludes(jobs);
    verify_app->add_flag("--record", options->record, "with --baseline: record all of them anew, in the data")
        ->needs(baseline)
        ->excludes(out)
        ->excludes(only)
        ->excludes(backend)
        ->excludes(precision);
    add_input(*verify_app, "--data", options->data,
              "folder of the project's data (default: the shipped one)");
    CLI::Option* sensitivity =
        verify_app
            ->add_flag("--sensitivity", options->sensitivity,
                       "plant faults in the equations instead, and show which check finds which")
            ->excludes(baseline)
            ->excludes(backend)
            ->excludes(precision);
    verify_app->add_option("--faults", options->mutants, "which: all; ci: 24 that take a minute")
        ->needs(sensitivity)
        ->check(CLI::IsMember({"all", "ci"}))
        ->capture_default_str();
    verify_app->footer(
        "Examples:\n"
        "  aneurysm verify\n"
        "  aneurysm verify --baseline\n"
        "  aneurysm verify --sensitivity\n"
        "  aneurysm verify --full --only eq13,L2 --backend cpu --precision float --out results/eq13\n"
        "Exit codes: 0 all hold, 1 failed, 2 bad input, 3 something doesn't hold, 130 interrupted\n"
        "(the reports say what there was).");
    verify_app->callback([options, &code] { code = verify(*options); });
}

} // namespace aneurysm::app
