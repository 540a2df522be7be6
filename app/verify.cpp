// SPDX-License-Identifier: Apache-2.0
#include "app/verify.hpp"

#include "app/launch_sensitivity.hpp"
#include "app/verify_baseline.hpp"
#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "output/file.hpp"
#include "output/provenance.hpp"
#include "output/report/html.hpp"
#include "output/report/markdown.hpp"
#include "verification/checks/checks.hpp"
#include "verification/suite/report.hpp"

#include <algorithm>
#include <iostream>
#include <optional>
#include <thread>

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
            command.append(" ").append(name).append(" ").append(joined(words));
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
           (options.only.empty() ? "" : ", chosen by --only " + joined(options.only));
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

void check(const VerifyOptions& options)
{
    const auto refuse = [](bool bad, const char* option, const char* what, const char* advice) {
        if (bad) {
            throw InputError(option, what, advice);
        }
    };
    refuse(options.out.empty() && !options.record, "--out", "no directory given for the reports",
           "needed: --out DIR");
    refuse(options.record && !options.baseline, "--record", "only a baseline is recorded",
           "needed: --baseline, too");
    refuse(options.record && !(options.out.empty() && options.only.empty() && options.backends.empty() &&
                               options.precisions.empty()),
           "--record", "the whole baseline is recorded, in data/", "allowed beside it: --data");
    refuse(options.baseline && (options.quick || options.full), "--baseline", "compares runs, not checks",
           "needed: no --quick or --full");
    refuse(options.sensitivity &&
               (options.baseline || !options.backends.empty() || !options.precisions.empty()),
           "--sensitivity", "doesn't go with --baseline, --backend or --precision",
           "it plants faults in the reference and in cpu");
}

int verify_suite(const VerifyOptions& options)
{
    const int threads = threads_of(options.jobs);
    const std::vector<const suite::Check*> checks =
        suite::select(checks::all_checks(), options.full, options.only);
    std::vector<suite::SuiteSubject> subjects = suite::make_subjects(options.backends, options.precisions);
    make_report_directory(options.out);

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
    return passed(report.suite) ? 0 : exit_failed;
}

} // namespace

int threads_of(int jobs)
{
    if (jobs < 0) {
        throw InputError("--jobs", "out of range (" + std::to_string(jobs) + ")", "allowed: at least 0");
    }
    return jobs > 0 ? jobs : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

std::string joined(const std::vector<std::string>& words)
{
    std::string text;
    for (const std::string& word : words) {
        text.append(text.empty() ? "" : ",").append(word);
    }
    return text;
}

void make_report_directory(const fs::path& directory)
{
    std::error_code error;
    const bool exists = fs::exists(directory, error);
    if (exists && !(fs::is_directory(directory, error) && fs::is_empty(directory, error))) {
        throw InputError(directory.string(), "output directory exists and isn't empty",
                         "needed: another --out");
    }
    fs::create_directories(directory, error);
    if (error) {
        throw InputError(directory.string(), "output directory cannot be made (" + error.message() + ")",
                         "needed: a writable place");
    }
}

int verify(const VerifyOptions& options)
{
    check(options);
    if (options.baseline) {
        return verify_baseline(options);
    }
    if (options.sensitivity) {
        launch_sensitivity(options);
    }
    return verify_suite(options);
}

} // namespace aneurysm::app
