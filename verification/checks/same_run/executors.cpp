// SPDX-License-Identifier: Apache-2.0
// The optimized backend against the reference, by the comparisons of `aneurysm compare`.
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"
#include "verification/comparison/bits.hpp"
#include "verification/comparison/free_run.hpp"
#include "verification/comparison/hash_file.hpp"
#include "verification/comparison/lockstep.hpp"

#include <map>
#include <string>
#include <utility>

namespace aneurysm::checks
{
namespace
{

/// Each field of comparisons becomes a quantity, and each problem a failure.
class Findings
{
public:
    Findings(Probe& probe, Source source, std::string derivation)
        : probe_(&probe), source_(source), derivation_(std::move(derivation)),
          rest_(&probe.quantity("comparisons without problems", Source::exact,
                                "a claim: frames were compared, and few decisions lay within rounding"))
    {
    }

    void add(const comparison::ComparisonResult& result, const std::string& scenario)
    {
        for (const comparison::FieldResult& field : result.fields) {
            const comparison::FieldCheck& worst = field.worst;
            const std::string where =
                scenario + ", frame " + std::to_string(field.frame) +
                (worst.particle < 0 ? "" : ", particle " + std::to_string(worst.particle));
            quantity(worst.name).found(worst.compared, worst.failed, worst.measured, worst.allowed, where);
        }
        rest_->holds(result.problems.empty(), result.problems.empty() ? scenario : result.problems.front());
        rest_->holds(!result.frames.empty(), scenario);
    }

private:
    Quantity& quantity(const std::string& name)
    {
        Quantity*& q = quantities_[name];
        if (q == nullptr) {
            q = &probe_->quantity(name, source_, derivation_);
        }
        return *q;
    }

    Probe* probe_;
    Source source_;
    std::string derivation_;
    Quantity* rest_;
    std::map<std::string, Quantity*> quantities_;
};

constexpr const char* lockstep_bound = "running rounding errors: the reference makes the same frame from the "
                                       "candidate's bits and returns beside each sum that "
                                       "of its terms' magnitudes; verification/bounds/ carries them "
                                       "through forces, solve, motion and collisions";

const comparison::AfterFrame go_on = [](const FrameRecord&) { return true; };

/// `frames` of a shipped scenario after the first ones.
struct Stretch {
    std::string scenario;
    std::int64_t after = 0;
    std::int64_t frames = 0;
};

void lockstep(Probe& probe, const std::vector<Stretch>& stretches)
{
    Findings findings(probe, Source::rounding, lockstep_bound);
    for (const Stretch& stretch : stretches) {
        const Scenario s = shipped_scenario(stretch.scenario);
        const auto candidate = probe.simulate(s);
        for (std::int64_t n = 0; n < stretch.after; ++n) {
            candidate->advance();
        }
        findings.add(comparison::compare_lockstep(s, *candidate, stretch.frames, go_on), stretch.scenario);
    }
}

void artery(Probe& probe)
{
    lockstep(probe, {{"quick", 0, 12}, {"quick", 60, 8}, {"quick", 180, 8}});
}

void domains(Probe& probe)
{
    lockstep(probe, {{"verify_channel", 0, 3},
                     {"verify_womersley_channel", 0, 3},
                     {"verify_slip_channel", 0, 3},
                     {"verify_tube", 0, 3},
                     {"verify_duct", 0, 3},
                     {"verify_pipe", 0, 3}});
}

void long_artery(Probe& probe)
{
    lockstep(probe, {{"quick", 0, 400}, {"paper_tc1", 0, 30}});
}

void recorded(Probe& probe, const std::vector<Stretch>& stretches)
{
    Findings findings(probe, Source::exact,
                      "bits: the hash of each field of each frame is the one recorded in data/hashes");
    const backends::BackendChoice& choice = probe.subject().choice;
    for (const Stretch& stretch : stretches) {
        const Scenario s = shipped_scenario(stretch.scenario);
        const auto file =
            comparison::hash_file(data_directory() / "scenarios" / (stretch.scenario + ".json"), s, choice);
        comparison::BitsOracles oracles;
        oracles.recorded = comparison::read_hashes(file, s.name, choice.precision);
        const auto candidate = probe.simulate(s);
        findings.add(comparison::compare_bits(*candidate, oracles, stretch.frames, go_on), stretch.scenario);
    }
}

void bits(Probe& probe)
{
    recorded(probe, {{"quick", 0, 60}});
}

void long_bits(Probe& probe)
{
    recorded(probe, {{"quick", 0, 400}, {"paper_tc1", 0, 200}});
}

void free_run(Probe& probe)
{
    const Scenario s = shipped_scenario("quick");
    const auto candidate = probe.simulate(s);
    comparison::FreeRunSettings settings;
    settings.frames = 250;
    settings.members = 6;
    Findings findings(
        probe, Source::statistics,
        "Student's prediction interval of an ensemble of the reference: a correct candidate fails once in "
        "1,000 runs (docs/bounds.md, B30)");
    findings.add(comparison::compare_free(s, *candidate, settings, go_on), "quick");
}

} // namespace

std::vector<Check> executors_checks()
{
    const std::vector<std::string_view> all{"1",  "2",  "3",  "5",  "6",  "7",  "13", "15", "16",
                                            "21", "22", "23", "24", "25", "26", "27", "28", "EOS"};
    const auto check = [&all](std::string_view id, std::string_view title, std::string_view oracle,
                              bool quick, void (*run)(Probe&)) {
        return Check{.id = id,
                     .level = Level::executors,
                     .equations = all,
                     .title = title,
                     .oracles = {oracle},
                     .scope = Scope::backends,
                     .quick = quick,
                     .run = run};
    };
    return {
        check("lockstep_artery",
              "frames of the artery are the reference's within rounding: start, growth, bleeding",
              "the reference, from the same bits", true, artery),
        check("lockstep_domains", "frames of the verification domains are the reference's within rounding",
              "the reference, from the same bits", true, domains),
        check("bits_recorded", "the frames' bits are those recorded in data/hashes", "recorded hashes", true,
              bits),
        check("lockstep_long",
              "400 frames of quick and the start of paper_tc1 are the reference's within rounding",
              "the reference, from the same bits", false, long_artery),
        check("bits_long", "all recorded frames of quick and 200 of paper_tc1 have their bits",
              "recorded hashes", false, long_bits),
        check("free_run", "a whole run is a member of the reference's ensemble",
              "an ensemble of reference runs", false, free_run),
    };
}

} // namespace aneurysm::checks
