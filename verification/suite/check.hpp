// SPDX-License-Identifier: Apache-2.0
// A check of the verification suite: what it is, and what it may do while it runs.
#pragma once

#include "analytic/gsl.hpp"
#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "output/report/plot.hpp"
#include "verification/backends/formulas.hpp"
#include "verification/backends/make_simulation.hpp"

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace aneurysm::suite
{

using report::Plot;
using report::Series;

/// gamma_n = n u / (1 - n u): largest relative error of n roundings in a row, each at most u (Higham,
/// Accuracy and Stability of Numerical Algorithms, lemma 3.1).
constexpr double rounding(double n, double u = 0x1p-53)
{
    return n * u / (1 - n * u);
}

/// What an answer is checked against.
enum class Level {
    scalar,      ///< L0: single equations against closed forms and GSL
    lattice,     ///< L1: SPH sums where the discrete answer is known
    transient,   ///< L2: flows in time where the discrete answer is known
    continuous,  ///< L3: continuous solutions, which L6 measures the model by
    metamorphic, ///< L4: the same run in other words, to the same bits
    executors,   ///< L5: the backends against the reference
    nature,      ///< L6: the model itself against nature
};

/// Where the bound of an error comes from.
enum class Source {
    exact,      ///< bits or integers: nothing is allowed
    rounding,   ///< of the operations behind the number
    truncation, ///< terms of a known expansion
    quadrature, ///< GSL's own error estimate
    solver,     ///< the tolerance that an iteration stops at
    statistics, ///< a confidence interval
    nature,     ///< what is asked of the model
};

/// Ends a check at its first comparison that fails, see Quantity::first_failure_ends.
class FirstFailure : public std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/// One thing that a check compares, many times if need be: one line of the tolerance ledger.
class Quantity
{
public:
    /// Whether a comparison that fails throws FirstFailure: where a mutant is planted, all that is asked is
    /// whether any fails. Set it while no check runs.
    static inline bool first_failure_ends = false;

    /// `derivation`: how the bound follows, as a formula with its reason; never empty.
    Quantity(std::string name, Source source, std::string derivation);

    /// |value - expected| <= allowed; false for a NaN. `where` names the instance, for the report.
    bool within(double value, double expected, double allowed, std::string_view where = {});
    /// The same against an oracle that bounds its own error; `relative` is the candidate's.
    bool within(double value, const analytic::Estimate& expected, double relative,
                std::string_view where = {});
    /// The components of vectors.
    bool within(const Vec3& value, const Vec3& expected, double allowed, std::string_view where = {});
    /// Whole numbers, and bits: nothing is allowed.
    bool equal(std::int64_t value, std::int64_t expected, std::string_view where = {});
    /// What a comparison of its own found: how many numbers, and the worst.
    bool found(std::int64_t compared, std::int64_t failed, double error, double allowed,
               std::string_view where);
    /// A claim without a number.
    bool holds(bool claim, std::string_view where = {});

    /// The instance with the largest measured / allowed.
    struct Worst {
        double value = 0;
        double expected = 0;
        double error = 0;
        double allowed = 0;
        double ratio =
            -1; ///< infinite where nothing is allowed and something was found; -1: nothing compared
        std::string where;
    };

    const std::string& name() const { return name_; }
    Source source() const { return source_; }
    const std::string& derivation() const { return derivation_; }
    std::int64_t compared() const { return compared_; }
    std::int64_t failed() const { return failed_; }
    const Worst& worst() const { return worst_; }
    bool passed() const { return compared_ > 0 && failed_ == 0; }
    /// Whether the bound is more than 1,000 times what was measured, and than one rounding of the number: it
    /// may be looser than it need be.
    bool loose() const;

private:
    /// `good`, unless the check ends here.
    bool judged(bool good) const;

    std::string name_;
    Source source_;
    std::string derivation_;
    std::int64_t compared_ = 0;
    std::int64_t failed_ = 0;
    Worst worst_;
};

/// What a number that the model doesn't meet yet was when that was recorded.
struct KnownLimit {
    double value = 0;   ///< a larger one fails
    std::string source; ///< of the record: when, by whom
};

/// How far the model is from nature in one respect.
struct Accuracy {
    std::string name; ///< with its unit
    double value = 0; ///< found
    double asked = 0; ///< at most
    std::optional<KnownLimit> known{};

    bool met() const { return value <= asked; } ///< false for a NaN
    /// What passes: a known limit that isn't met yet must not get worse.
    double allowed() const { return known && known->value > asked ? known->value : asked; }
};

/// A number that is worth reading and has no bound.
struct Note {
    std::string name; ///< with its unit
    double value = 0;
    std::string remark;
};

/// Whose equations and frames a check looks at.
struct Subject {
    backends::BackendChoice choice;
    const backends::Equations* equations = nullptr; ///< null: none of its own in this precision
    double roundoff = 0x1p-53;                      ///< largest relative error of one rounding of its flow

    /// "reference", "cpu double", ...
    std::string name() const;
};

enum class Verdict {
    holds,   ///< something was compared, and all of it lies within its bounds
    fails,   ///< something doesn't, nothing was compared, or the check threw
    not_run, ///< the message says why
    limit,   ///< nothing fails, but the model doesn't meet what is asked of it yet; the message says where
};

struct Check;

/// What came of one check for one subject.
struct CheckResult {
    const Check* check = nullptr;
    std::string subject; ///< Subject::name, or "once"
    Verdict verdict = Verdict::not_run;
    std::string message{}; ///< why it fails or was not run; empty when it holds
    std::deque<Quantity> quantities{};
    std::vector<Accuracy> accuracies{};
    std::vector<Note> notes{};
    std::vector<Plot> plots{};
    double seconds = 0;
};

/// What a check gets to do its work with.
class Probe
{
public:
    /// \param result  where the check's findings go
    Probe(const Subject& subject, CheckResult& result) : subject_(&subject), result_(&result) {}

    const Subject& subject() const { return *subject_; }
    const backends::Equations& equations() const { return *subject_->equations; }
    double roundoff() const { return subject_->roundoff; }
    /// gamma_n of the subject's flow.
    double gamma(double n) const { return rounding(n, subject_->roundoff); }

    /// A flow of the subject's. \throws InputError as make_simulation does
    std::unique_ptr<Simulation> simulate(const Scenario& scenario,
                                         std::optional<SimulationState> state = {}) const;

    /// A new line of the ledger; it stays valid as long as the result.
    Quantity& quantity(std::string name, Source source, std::string derivation);
    /// A number of the model's own accuracy, with its line in the ledger.
    void accuracy(Accuracy accuracy);
    void note(std::string name, double value, std::string remark = {});
    void plot(Plot plot);
    /// The check can't be done here; that is neither pass nor failure.
    void not_run(std::string reason);

private:
    const Subject* subject_;
    CheckResult* result_;
};

/// Who a check is run for.
enum class Scope {
    equations, ///< each subject with equations of its own: they are the same in both precisions
    flows,     ///< each subject
    backends,  ///< each but the reference, which they are compared with
    once,      ///< whoever: it checks oracles, or compares subjects itself
    model,     ///< one in single precision: it judges the model, which is the same for all
};

/// One row of the suite.
struct Check {
    std::string_view id; ///< eq13_pole, poiseuille_channel; words joined by _
    Level level = Level::scalar;
    std::vector<std::string_view> equations; ///< "1" to "28", "EOS"
    std::string_view title;                  ///< what is true when it passes
    std::vector<std::string_view> oracles;   ///< what it is compared with, independent ones apart
    Scope scope = Scope::equations;
    bool quick = true; ///< belongs to --quick, too
    std::function<void(Probe&)> run;
};

} // namespace aneurysm::suite
