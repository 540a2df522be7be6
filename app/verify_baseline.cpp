// SPDX-License-Identifier: Apache-2.0
#include "app/verify_baseline.hpp"

#include "app/options.hpp"
#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "common/scenario/shipped.hpp"
#include "common/text.hpp"
#include "output/build_info.hpp"
#include "output/columns.hpp"
#include "output/file.hpp"
#include "output/json.hpp"
#include "output/provenance.hpp"
#include "verification/comparison/baseline.hpp"
#include "verification/suite/suite.hpp"

#include <algorithm>
#include <iostream>

namespace aneurysm::app
{
namespace
{

namespace fs = std::filesystem;

/// One run to make again, or to record.
struct Task {
    const comparison::BaselineScenario* scenario = nullptr;
    const comparison::BaselineRun* recorded = nullptr;
    backends::BackendChoice choice;
    std::string missing; ///< why the backend isn't here
};

/// What came of it.
struct Outcome {
    const Task* task = nullptr;
    suite::Verdict verdict = suite::Verdict::not_run; ///< holds: identical
    std::string text{};                               ///< how it differs, or why it wasn't run
    std::optional<comparison::BaselineRun> now{};
};

/// The chosen scenarios. \throws InputError for a name that isn't there
std::vector<comparison::BaselineScenario> chosen(const comparison::Baseline& baseline,
                                                 const std::vector<std::string>& only)
{
    std::vector<comparison::BaselineScenario> scenarios;
    std::vector<std::string> names;
    for (const comparison::BaselineScenario& s : baseline.scenarios) {
        names.push_back(s.name);
        if (only.empty() || std::ranges::find(only, s.name) != only.end()) {
            scenarios.push_back(s);
        }
    }
    for (const std::string& name : only) {
        if (std::ranges::none_of(scenarios, [&](const auto& s) { return s.name == name; })) {
            throw InputError("--only", "no such scenario in the baseline (" + name + ")",
                             "allowed: " + joined(names));
        }
    }
    return scenarios;
}

/// Each recorded run with each backend that has its bits.
std::vector<Task> tasks_of(const std::vector<comparison::BaselineScenario>& scenarios,
                           const std::vector<suite::SuiteSubject>& subjects)
{
    std::vector<Task> tasks;
    for (const comparison::BaselineScenario& scenario : scenarios) {
        for (const suite::SuiteSubject& s : subjects) {
            backends::BackendChoice choice = s.subject.choice;
            choice.threads = 0; // the runs are made one after the other
            for (const comparison::BaselineRun& run : scenario.runs) {
                if (run.recorded_as == comparison::recorded_as(choice)) {
                    tasks.push_back({&scenario, &run, choice, s.missing});
                }
            }
        }
    }
    return tasks;
}

void make(Outcome& outcome, const comparison::AfterFrame& after_frame)
{
    const Task& task = *outcome.task;
    if (InterruptWatch::interrupted()) {
        outcome.text = suite::interruption;
        return;
    }
    try {
        outcome.now = comparison::run_again(read_scenario(task.scenario->file), task.choice,
                                            task.recorded->frames, after_frame);
    } catch (const SimulationError& error) {
        outcome.verdict = suite::Verdict::fails;
        outcome.text = std::string("stopped: ") + error.what();
        return;
    }
    outcome.text = outcome.now ? comparison::difference(*task.recorded, *outcome.now) : suite::interruption;
    outcome.verdict = !outcome.now           ? suite::Verdict::not_run
                      : outcome.text.empty() ? suite::Verdict::holds
                                             : suite::Verdict::fails;
}

/// One after the other, until interrupted.
std::vector<Outcome> run(const std::vector<Task>& tasks)
{
    std::int64_t all = 0;
    for (const Task& task : tasks) {
        all += task.missing.empty() ? task.recorded->frames : 0;
    }
    Progress progress("frame", 0, std::max<std::int64_t>(all, 1));
    std::int64_t done = 0;
    std::vector<Outcome> outcomes;
    for (const Task& task : tasks) {
        Outcome outcome{.task = &task, .text = task.missing};
        if (task.missing.empty()) {
            make(outcome, [&](const FrameRecord&) {
                progress.show(++done, task.scenario->name + ", " + name_of(task.choice));
                return !InterruptWatch::interrupted();
            });
        }
        outcomes.push_back(std::move(outcome));
    }
    return outcomes;
}

std::string line(const Outcome& outcome, const comparison::Baseline& baseline)
{
    const Task& task = *outcome.task;
    std::string text = task.scenario->name + ", " + name_of(task.choice) + ": ";
    if (outcome.verdict == suite::Verdict::not_run) {
        return text + "not run: " + outcome.text;
    }
    const bool same = outcome.verdict == suite::Verdict::holds;
    text += same ? "identical to" : "DIFFERS from";
    text += " the baseline of " + baseline.version + (same ? "" : ": " + outcome.text);
    if (outcome.now) {
        const bool same_text = outcome.now->hashes.scenario_hash == task.recorded->hashes.scenario_hash;
        text += " (" + std::to_string(task.recorded->frames) + " frames, digest " + outcome.now->digest +
                (same_text ? ")" : "; the scenario's text has changed since)");
    }
    return text;
}

void write(const fs::path& directory, const comparison::Baseline& baseline,
           const std::vector<Outcome>& outcomes, const std::string& lines)
{
    output::Json json = output::provenance();
    json["report"] = "baseline 1";
    json["date"] = output::now_utc();
    json["machine"] = output::machine();
    json["baseline"] = {{"version", baseline.version}, {"commit", baseline.commit}};
    json["runs"] = output::Json::array();
    for (const Outcome& outcome : outcomes) {
        const Task& task = *outcome.task;
        json["runs"].push_back({{"scenario", task.scenario->name},
                                {"backend", name_of(task.choice.backend)},
                                {"precision", name_of(task.choice.precision)},
                                {"frames", task.recorded->frames},
                                {"verdict", outcome.verdict == suite::Verdict::holds   ? "identical"
                                            : outcome.verdict == suite::Verdict::fails ? "differs"
                                                                                       : "not run"},
                                {"remark", outcome.text},
                                {"digest", outcome.now ? outcome.now->digest : ""},
                                {"recorded_digest", task.recorded->digest}});
    }
    output::write_atomically(directory / "baseline.json", output::json_text(json));
    output::write_atomically(directory / "baseline.txt", lines);
}

int compare(const VerifyOptions& options, const fs::path& data, const comparison::Baseline& baseline)
{
    const std::vector<comparison::BaselineScenario> scenarios = chosen(baseline, options.only);
    for (const comparison::BaselineScenario& s : scenarios) {
        for (const comparison::BaselineRun& r : s.runs) {
            if (r.digest.empty()) {
                throw InputError((data / "baseline.json").string(), s.name + " was never recorded",
                                 "needed: aneurysm verify --baseline --record");
            }
        }
    }
    for (const comparison::BaselineScenario& s : scenarios) {
        read_scenario(s.file); // before the first run, which may take minutes
    }
    const std::vector<Task> tasks =
        tasks_of(scenarios, suite::make_subjects(options.backends, options.precisions));
    const ReportDirectory directory(options.out);
    const InterruptWatch watch;
    const std::vector<Outcome> outcomes = run(tasks);
    std::string lines;
    for (const Outcome& outcome : outcomes) {
        lines += line(outcome, baseline) + "\n";
    }
    const auto any = [&](suite::Verdict v) {
        return std::ranges::find(outcomes, v, &Outcome::verdict) != outcomes.end();
    };
    const bool identical = any(suite::Verdict::holds) && !any(suite::Verdict::fails);
    const bool complete = !InterruptWatch::interrupted();
    lines += !complete ? "INCOMPLETE\n" : identical ? "PASS\n" : "FAIL\n";
    write(options.out, baseline, outcomes, lines);
    std::cout << lines << std::flush;
    return !complete ? exit_interrupted : identical ? exit_done : exit_differs;
}

int record(const fs::path& data, comparison::Baseline baseline)
{
    const fs::path file = data / "baseline.json";
    if (const std::string why = output::why_not_writable(file); !why.empty()) {
        throw InputError(file.string(), "cannot be written (" + why + ")",
                         "needed: a data folder of one's own");
    }
    const std::vector<comparison::BaselineScenario> scenarios = baseline.scenarios;
    const std::vector<Task> tasks =
        tasks_of(scenarios, suite::make_subjects({Backend::reference, Backend::cpu}));
    const InterruptWatch watch;
    const std::vector<Outcome> outcomes = run(tasks);
    if (InterruptWatch::interrupted()) {
        std::cerr << "interrupted; the baseline is as it was\n";
        return exit_interrupted;
    }
    for (comparison::BaselineScenario& scenario : baseline.scenarios) {
        for (comparison::BaselineRun& run : scenario.runs) {
            const auto made = std::ranges::find_if(outcomes, [&](const Outcome& o) {
                return o.task->scenario->name == scenario.name &&
                       o.task->recorded->recorded_as == run.recorded_as;
            });
            if (!made->now) {
                throw Error(scenario.name + ", " + run.recorded_as, made->text, "the baseline is as it was");
            }
            std::cout << scenario.name << ", " << run.recorded_as << ": "
                      << (run.digest.empty()                       ? "new"
                          : made->verdict == suite::Verdict::holds ? "identical"
                                                                   : made->text)
                      << "\n";
            run = *made->now;
        }
    }
    const output::BuildInfo build = output::build_info();
    baseline.version = build.version;
    baseline.commit = build.commit;
    comparison::write_baseline(data, baseline);
    std::cout << "recorded in " << file.string() << " and " << (data / "hashes").string() << std::endl;
    return 0;
}

} // namespace

int verify_baseline(const VerifyOptions& options)
{
    const fs::path data = options.data.empty() ? data_directory() : options.data;
    comparison::Baseline baseline = comparison::read_baseline(data);
    return options.record ? record(data, std::move(baseline)) : compare(options, data, baseline);
}

} // namespace aneurysm::app
