// SPDX-License-Identifier: Apache-2.0
#include "app/compare.hpp"

#include "app/options.hpp"
#include "common/error.hpp"
#include "common/file.hpp"
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

struct CompareOptions {
    std::filesystem::path scenario;
    backends::BackendChoice candidate;
    std::string mode = "lockstep";      ///< lockstep, free, bits
    std::optional<std::int64_t> frames; ///< to compare, instead of up to the scenario's last
    std::int64_t from = 0;              ///< the candidate makes this many frames first
    int ensemble = 8;                   ///< members, in mode free
    std::filesystem::path record;       ///< file for the candidate's hashes, in mode bits; empty: none
    std::filesystem::path report;       ///< JSON; empty: none
};

void require(bool good, const std::string& option, const std::string& what, const std::string& allowed)
{
    if (!good) {
        throw InputError(option, what, allowed);
    }
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
    if (options_.record.empty() && is_there(file)) {
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

int compare(const CompareOptions& options)
{
    require(options.record.empty() || options.mode == "bits", "--record",
            "mode " + options.mode + " has no hashes", "needed: --mode bits");
    for (const std::filesystem::path& file : {options.record, options.report}) {
        require(!same_file(file, options.scenario), file.string(), "is the scenario itself",
                "needed: another file");
    }
    Comparison comparison(options);
    const InterruptWatch watch;
    const comparison::ComparisonResult result = comparison.run();
    if (comparison.only_records() && result.problems.empty()) {
        std::cout << result.notes.back() << std::endl;
        return exit_done;
    }
    const comparison::ComparisonTitle title = comparison.title();
    std::cout << comparison::report_text(title, result) << std::flush;
    if (!options.report.empty()) {
        output::write_atomically(options.report, comparison::report_json(title, result));
    }
    if (InterruptWatch::interrupted()) {
        return exit_interrupted;
    }
    return result.passed() ? exit_done : exit_differs;
}

} // namespace

void add_compare(CLI::App& app, std::optional<int>& code)
{
    const auto options = std::make_shared<CompareOptions>();
    CLI::App* compare_app = app.add_subcommand("compare", "Compare a backend with the reference");
    add_input(*compare_app, "SCENARIO", options->scenario, "scenario file")->required();
    add_backend(*compare_app, options->candidate, "--candidate", "who is compared");
    compare_app->get_option("--candidate")->required();
    add_tuning(*compare_app, options->candidate);
    compare_app
        ->add_option(
            "--mode", options->mode,
            "lockstep: each frame starts from the candidate's own state, bounds are rounding's; free: "
            "runs of their own, against the spread of an ensemble; bits: hashes of each frame, against "
            "one thread and recorded ones")
        ->check(CLI::IsMember({"lockstep", "free", "bits"}))
        ->capture_default_str();
    add_count(*compare_app, "--frames", options->frames,
              "how many to compare (default: up to the scenario's last)", 1, most_frames);
    CLI::Option* from = add_count(*compare_app, "--from", options->from,
                                  "let the candidate come to this frame first", 0, most_frames)
                            ->default_str("0");
    add_count(*compare_app, "--ensemble", options->ensemble, "members of the ensemble in mode free", 3,
              most_at_once)
        ->default_str("8");
    add_output_file(*compare_app, "--record", options->record,
                    "in mode bits: CSV file for the candidate's hashes")
        ->excludes(from);
    add_output_file(*compare_app, "--report", options->report, "JSON file for the result");
    add_progress(*compare_app);
    compare_app->footer(
        "Examples:\n"
        "  aneurysm compare data/scenarios/quick.json --candidate cpu --precision float --frames 300\n"
        "  aneurysm compare data/scenarios/quick.json --candidate cpu --precision float --mode bits\n"
        "Exit codes: 0 all within its bounds, 1 failed, 2 bad input, 3 something is not within its bounds,\n"
        "130 interrupted.");
    compare_app->callback([compare_app, options, &code] {
        require(options->mode == "free" || compare_app->count("--ensemble") == 0, "--ensemble",
                "means nothing to mode " + options->mode, "allowed: with --mode free");
        settle_tuning(*compare_app, options->candidate);
        code = compare(*options);
    });
}

} // namespace aneurysm::app
