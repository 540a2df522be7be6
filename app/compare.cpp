// SPDX-License-Identifier: Apache-2.0
#include "app/compare.hpp"

#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "output/columns.hpp"
#include "output/file.hpp"
#include "verification/backends/make_simulation.hpp"
#include "verification/comparison/bits.hpp"
#include "verification/comparison/free_run.hpp"
#include "verification/comparison/hash_file.hpp"
#include "verification/comparison/lockstep.hpp"
#include "verification/comparison/report.hpp"

#include <iostream>
#include <memory>
#include <optional>

namespace aneurysm::app
{
namespace
{

constexpr int failed = 3;
constexpr int interrupted = 130;

void require(bool good, const std::string& option, const std::string& what, const std::string& allowed)
{
    if (!good) {
        throw InputError(option, what, allowed);
    }
}

/// Found out before hours of work.
void require_folder(const std::string& option, const std::filesystem::path& file)
{
    const std::filesystem::path folder = file.parent_path();
    require(folder.empty() || std::filesystem::is_directory(folder), option,
            "no such directory (" + folder.string() + ")", "needed: a file in one that exists");
}

void check(const CompareOptions& options)
{
    const std::string& mode = options.mode;
    require(mode == "lockstep" || mode == "free" || mode == "bits", "--mode", "unknown (" + mode + ")",
            "allowed: lockstep, free, bits");
    require(options.frames.value_or(1) >= 1, "--frames",
            "out of range (" + std::to_string(options.frames.value_or(1)) + ")", "allowed: at least 1");
    require(options.from >= 0, "--from", "out of range (" + std::to_string(options.from) + ")",
            "allowed: at least 0");
    require(options.ensemble >= 3, "--ensemble", "out of range (" + std::to_string(options.ensemble) + ")",
            "allowed: at least 3");
    require(options.record.empty() || mode == "bits", "--record", "mode " + mode + " has no hashes",
            "needed: --mode bits");
    require(options.record.empty() || options.from == 0, "--record", "hashes are recorded from frame 1 on",
            "needed: no --from");
    require_folder("--report", options.report);
    require_folder("--record", options.record);
}

/// One comparison from the command line to its result.
class Comparison
{
public:
    explicit Comparison(const CompareOptions& options)
        : options_(options), scenario_(read_scenario(options.scenario)), hash_(scenario_hash(scenario_)),
          frames_(options.frames.value_or(scenario_.time.frames - options.from))
    {
        require(frames_ >= 1, "--from",
                "the scenario has no frame after it (" + std::to_string(options.from) + ")",
                "allowed: below " + std::to_string(scenario_.time.frames) + ", or --frames");
        if (options.mode == "bits") {
            find_oracles();
        }
        candidate_ = backends::make_simulation(options.candidate, scenario_, std::nullopt, options.scenario);
    }

    comparison::ComparisonResult run();
    comparison::ComparisonTitle title() const
    {
        return {options_.mode, scenario_.name, hash_, options_.candidate, candidate_->engine().device};
    }
    /// There was nothing to compare with, only something to record.
    bool only_records() const { return options_.mode == "bits" && !twin_ && !recorded_; }

private:
    void find_oracles();
    bool advance_to_start(const comparison::AfterFrame& after_frame);
    comparison::ComparisonResult bits(const comparison::AfterFrame& after_frame);

    const CompareOptions& options_;
    Scenario scenario_;
    std::string hash_;
    std::int64_t frames_;
    std::unique_ptr<Simulation> candidate_;
    std::unique_ptr<Simulation> twin_;
    std::optional<comparison::RecordedHashes> recorded_;
};

/// The same source on one thread, unless that is the candidate itself, and the file of an earlier run.
void Comparison::find_oracles()
{
    const backends::BackendChoice& candidate = options_.candidate;
    const bool is_twin = candidate.backend == Backend::cpu && candidate.threads == 1;
    if (candidate.backend != Backend::reference && !is_twin) {
        twin_ = backends::make_simulation({Backend::cpu, candidate.precision, 1}, scenario_, std::nullopt,
                                          options_.scenario);
    }
    const std::filesystem::path file = comparison::hash_file(options_.scenario, scenario_, candidate);
    if (options_.record.empty() && std::filesystem::exists(file)) {
        recorded_ = comparison::read_hashes(file, scenario_.name, candidate.precision);
    }
    require(!only_records() || !options_.record.empty(), "--mode bits", "there is nothing to compare with",
            "needed: another candidate, recorded hashes (" + file.string() + "), or --record");
}

bool Comparison::advance_to_start(const comparison::AfterFrame& after_frame)
{
    bool go_on = true;
    while (go_on && candidate_->state().frame < options_.from) {
        go_on = after_frame(candidate_->advance());
        if (twin_) {
            twin_->advance();
        }
    }
    return go_on;
}

comparison::ComparisonResult Comparison::bits(const comparison::AfterFrame& after_frame)
{
    comparison::RecordedHashes recording{scenario_.name, hash_, options_.candidate.precision, {}};
    comparison::ComparisonResult result =
        comparison::compare_bits(*candidate_, {twin_.get(), recorded_}, frames_, after_frame, &recording);
    if (recorded_ && recorded_->scenario_hash != hash_) {
        result.notes.push_back("the scenario's text has changed since its hashes were recorded (" +
                               recorded_->scenario_hash + " then)");
    }
    if (!options_.record.empty() && result.problems.empty() && !InterruptWatch::interrupted()) {
        output::write_atomically(options_.record, comparison::to_csv(recording));
        result.notes.push_back("hashes recorded in " + options_.record.string());
    }
    return result;
}

comparison::ComparisonResult Comparison::run()
{
    const bool free = options_.mode == "free";
    const std::int64_t runs = free ? options_.ensemble + 2 : 1; // candidate, reference, ensemble
    Progress progress("frame", 0, options_.from + runs * frames_);
    std::int64_t shown = 0;
    const comparison::AfterFrame after_frame = [&](const FrameRecord& record) {
        progress.show(++shown, output::name_of(record.phase));
        return !InterruptWatch::interrupted();
    };
    comparison::ComparisonResult result;
    if (advance_to_start(after_frame)) {
        if (free) {
            comparison::FreeRunSettings settings;
            settings.frames = frames_;
            settings.members = options_.ensemble;
            result = comparison::compare_free(scenario_, *candidate_, settings, after_frame);
        } else {
            result = options_.mode == "bits"
                         ? bits(after_frame)
                         : comparison::compare_lockstep(scenario_, *candidate_, frames_, after_frame);
        }
    }
    if (InterruptWatch::interrupted()) {
        result.problems.emplace_back("interrupted");
    }
    return result;
}

} // namespace

int compare(const CompareOptions& options)
{
    check(options);
    Comparison comparison(options);
    const InterruptWatch watch;
    const comparison::ComparisonResult result = comparison.run();
    if (comparison.only_records() && result.problems.empty()) {
        std::cout << result.notes.back() << std::endl;
        return 0;
    }
    const comparison::ComparisonTitle title = comparison.title();
    std::cout << comparison::report_text(title, result) << std::flush;
    if (!options.report.empty()) {
        output::write_atomically(options.report, comparison::report_json(title, result));
    }
    if (InterruptWatch::interrupted()) {
        return interrupted;
    }
    return result.passed() ? 0 : failed;
}

} // namespace aneurysm::app
