// SPDX-License-Identifier: Apache-2.0
// The program `aneurysm-sensitivity`, which `aneurysm verify --sensitivity` hands over to: both backends with
// places for mutants.
#include "app/options.hpp"
#include "common/parallel.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "common/scenario/shipped.hpp"
#include "common/text.hpp"
#include "output/file.hpp"
#include "output/provenance.hpp"
#include "output/report/html.hpp"
#include "output/report/markdown.hpp"
#include "verification/checks/checks.hpp"
#include "verification/sensitivity/report.hpp"

#include <iostream>
#include <memory>
#include <set>

namespace
{

using namespace aneurysm;
using namespace aneurysm::app;

struct Options {
    std::filesystem::path out;
    std::string mutants = "all";
    std::vector<std::string> only;
    bool full = false;
    int jobs = 0;
};

/// All of them, or those in an equation that one of these checks lists.
std::vector<sensitivity::Mutant> chosen_mutants(const Options& options,
                                                const std::vector<const suite::Check*>& checks)
{
    std::vector<sensitivity::Mutant> mutants =
        options.mutants == "ci" ? sensitivity::daily_mutants() : sensitivity::all_mutants();
    if (!options.only.empty()) {
        std::set<std::string_view> listed;
        for (const suite::Check* check : checks) {
            listed.insert(check->equations.begin(), check->equations.end());
        }
        std::erase_if(mutants, [&](const sensitivity::Mutant& f) {
            return !listed.contains(sensitivity::equation_of(f.place));
        });
    }
    return mutants;
}

sensitivity::SensitivityStudy run(const std::vector<const suite::Check*>& checks,
                                  const sensitivity::StudyOptions& options)
{
    std::unique_ptr<Progress> progress;
    std::string shown;
    const InterruptWatch watch;
    return sensitivity::run_study(
        checks, suite::make_subjects({Backend::reference, Backend::cpu}), options,
        [&](const std::string& part, std::int64_t done, std::int64_t all, const std::string& last) {
            if (part != shown) {
                progress = std::make_unique<Progress>(part, 0, all);
                shown = part;
            }
            progress->show(done, last);
        });
}

void write(const std::filesystem::path& directory, const sensitivity::SensitivityReport& report)
{
    output::write_atomically(directory / "sensitivity.json", sensitivity::sensitivity_json(report));
    output::write_atomically(directory / "sensitivity.md",
                             report::markdown(sensitivity::sensitivity_document(report, false)));
    output::write_atomically(directory / "sensitivity.html",
                             report::html(sensitivity::sensitivity_document(report, true)));
}

int run_study(const Options& options)
{
    const std::vector<const suite::Check*> checks =
        suite::select(checks::all_checks(), options.full, options.only);
    const sensitivity::StudyOptions study{.mutants = chosen_mutants(options, checks),
                                          .daily = options.mutants == "ci",
                                          .jobs = thread_count(options.jobs)};
    require_data();
    const ReportDirectory directory(options.out);
    const std::string only = options.only.empty() ? "" : " --only " + joined(options.only, ",");
    const sensitivity::SensitivityReport report{
        .study = run(checks, study),
        .selection = std::string(study.daily ? "The 24 faults of every day, " : "All faults, ") +
                     std::to_string(checks.size()) + " of the suite's " +
                     std::to_string(checks::all_checks().size()) + " checks",
        .command = std::string("aneurysm verify --sensitivity") + (options.full ? " --full" : "") +
                   (study.daily ? " --faults ci" : "") + only + " --out DIR",
        .date = output::now_utc(),
        .machine = output::machine(),
        .jobs = study.jobs};
    write(options.out, report);
    std::cout << sensitivity::sensitivity_text(report) << "Reports in " << options.out.string()
              << ": sensitivity.html, sensitivity.md, sensitivity.json" << std::endl;
    return !report.study.complete              ? exit_interrupted
           : sensitivity::passed(report.study) ? exit_done
                                               : exit_differs;
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Plants faults in the equations, one at a time, to see which check notices.",
                 "aneurysm-sensitivity");
    Options options;
    add_directory(app, "--out", options.out, "directory for the reports; must not exist, or be empty")
        ->required();
    app.add_option("--faults", options.mutants, "all; ci: 24 that take a minute")
        ->check(CLI::IsMember({"all", "ci"}))
        ->capture_default_str();
    add_words(app, "--only", options.only, "as of aneurysm verify");
    app.add_flag("--full", options.full, "with the checks that take minutes");
    add_count(app, "--jobs", options.jobs, "processes at once; 0: as many as pay", 0, most_at_once)
        ->default_str("0");
    add_progress(app);
    std::optional<int> code;
    app.callback([&] { code = run_study(options); });
    return run_program(app, code, argc, argv);
}
