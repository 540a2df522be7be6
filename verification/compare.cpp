// SPDX-License-Identifier: Apache-2.0
#include "verification/compare.hpp"

#include "common/error.hpp"
#include "output/file.hpp"
#include "verification/inexact.hpp"
#include "verification/interrupt.hpp"
#include "verification/lockstep.hpp"
#include "verification/progress.hpp"
#include "verification/report.hpp"

#include <iostream>

namespace aneurysm::verification
{
namespace
{

constexpr int failed = 3;
constexpr int interrupted = 130;

void check(const CompareOptions& options)
{
    if (options.mode != "lockstep") {
        throw InputError("--mode", "unknown (" + options.mode + ")", "allowed: lockstep");
    }
    if (options.frames < 0) {
        throw InputError("--frames", "out of range (" + std::to_string(options.frames) + ")",
                         "allowed: at least 1");
    }
    if (options.from < 0) {
        throw InputError("--from", "out of range (" + std::to_string(options.from) + ")",
                         "allowed: at least 0");
    }
    unit_roundoff(options.candidate.precision);
    // Found out before hours of work.
    if (!options.report.empty()) {
        const std::filesystem::path folder = options.report.parent_path();
        if (!folder.empty() && !std::filesystem::is_directory(folder)) {
            throw InputError("--report", "no such directory (" + folder.string() + ")",
                             "needed: a file in one that exists");
        }
    }
}

} // namespace

int compare(const CompareOptions& options)
{
    check(options);
    const Scenario scenario = read_scenario(options.scenario);
    const std::unique_ptr<Backend> candidate = make_backend(options.candidate, scenario, std::nullopt);
    const std::int64_t frames = options.frames > 0 ? options.frames : scenario.time.frames - options.from;
    if (frames < 1) {
        throw InputError("--from",
                         "the scenario has no frame after it (" + std::to_string(options.from) + ")",
                         "allowed: below " + std::to_string(scenario.time.frames) + ", or --frames");
    }
    const InterruptWatch watch;
    ComparisonResult result;
    {
        Progress progress(0, options.from + frames);
        const auto after_frame = [&](const FrameRecord& record) {
            progress.show(record);
            return !InterruptWatch::interrupted();
        };
        bool go_on = true;
        while (go_on && candidate->state().frame < options.from) {
            go_on = after_frame(candidate->advance());
        }
        if (go_on) {
            result = compare_lockstep(scenario, *candidate, options.candidate.precision, frames, after_frame);
        }
    }
    if (InterruptWatch::interrupted()) {
        result.problems.emplace_back("interrupted");
    }
    const ComparisonTitle title{options.mode, scenario.name, scenario_hash(scenario), options.candidate,
                                candidate->device()};
    std::cout << report_text(title, result) << std::flush;
    if (!options.report.empty()) {
        output::write_atomically(options.report, report_json(title, result));
    }
    if (InterruptWatch::interrupted()) {
        return interrupted;
    }
    return result.passed() ? 0 : failed;
}

} // namespace aneurysm::verification
