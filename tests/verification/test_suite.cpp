// SPDX-License-Identifier: Apache-2.0
// The suite's frame: what a quantity accepts, what a check's verdict is, which checks are chosen for whom.
#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "verification/checks/checks.hpp"
#include "verification/suite/suite.hpp"

#include <boost/test/unit_test.hpp>

#include <atomic>
#include <cmath>
#include <csignal>
#include <limits>
#include <optional>
#include <stdexcept>

using namespace aneurysm;

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

suite::Quantity length(suite::Source source = suite::Source::rounding)
{
    return {"length [m]", source, "gamma_1 |x|: one rounding"};
}

suite::Check check_of(std::string_view id, std::function<void(suite::Probe&)> run,
                      suite::Scope scope = suite::Scope::flows)
{
    return {.id = id,
            .equations = {},
            .title = "a test",
            .oracles = {"itself"},
            .scope = scope,
            .run = std::move(run)};
}

/// Compares a number with 1, of which 0.1 may be missing.
std::function<void(suite::Probe&)> compares(double x)
{
    return [x](suite::Probe& probe) {
        probe.quantity("x", suite::Source::exact, "what the test says").within(x, 1, 0.1);
    };
}

suite::CheckResult outcome(std::function<void(suite::Probe&)> run)
{
    const suite::Check check = check_of("a_test", std::move(run));
    return suite::run_check(check, suite::once());
}

std::vector<suite::Check> three_checks()
{
    suite::Check first = check_of("eq08_balance", compares(1));
    first.equations = {"8"};
    suite::Check second = check_of("poiseuille_channel", compares(1));
    second.level = suite::Level::continuous;
    second.equations = {"1", "7", "EOS"};
    suite::Check third = check_of("eq18_slow", compares(1));
    third.equations = {"18"};
    third.quick = false;
    return {first, second, third};
}

std::string selected(const std::vector<std::string>& only, bool full = true)
{
    const std::vector<suite::Check> checks = three_checks();
    std::string ids;
    for (const suite::Check* check : suite::select(checks, full, only)) {
        ids.append(check->id).append(" ");
    }
    return ids.substr(0, ids.empty() ? 0 : ids.size() - 1);
}

suite::SuiteResult suite_of(const std::vector<suite::Check>& checks,
                            std::vector<suite::SuiteSubject> subjects, int threads = 2)
{
    return suite::run_suite(suite::select(checks, true, {}), std::move(subjects), threads);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_quantity_accepts_its_bound_and_nothing_beyond)
{
    suite::Quantity q = length();
    BOOST_TEST(!q.passed()); // nothing compared
    BOOST_TEST(q.within(1.5, 1, 0.5));
    BOOST_TEST(q.passed());
    BOOST_TEST(!q.within(std::nextafter(1.5, 2), 1, 0.5));
    BOOST_TEST(!q.passed());
    BOOST_TEST(q.compared() == 2);
    BOOST_TEST(q.failed() == 1);
}

BOOST_AUTO_TEST_CASE(a_quantity_refuses_what_is_no_number)
{
    const double nan = std::nan("");
    BOOST_TEST(!length().within(nan, 1, infinite));
    BOOST_TEST(!length().within(1, nan, 1));
    BOOST_TEST(!length().within(1, 1, nan));
    BOOST_TEST(!length().within(1, 1, -1));
    BOOST_TEST(!length().within(infinite, 1, 1));
}

BOOST_AUTO_TEST_CASE(a_quantity_keeps_the_worst_instance)
{
    suite::Quantity q = length();
    q.within(1.1, 1, 1, "a");
    q.within(2, 1, 2, "b");
    q.within(1.2, 1, 1, "c");
    BOOST_TEST(q.worst().where == "b");
    BOOST_TEST(q.worst().ratio == 0.5);
    q.equal(3, 4, "d");
    BOOST_TEST(q.worst().where == "d");
    BOOST_TEST(q.worst().ratio == infinite);
    suite::Quantity empty = length();
    empty.within(std::nan(""), 1, 1, "first");
    empty.within(1, 1, 1, "second");
    BOOST_TEST(empty.worst().where == "first");
}

BOOST_AUTO_TEST_CASE(a_quantity_knows_a_loose_bound)
{
    suite::Quantity tight = length();
    tight.within(1 + 1e-10, 1, 1e-9);
    BOOST_TEST(!tight.loose());
    suite::Quantity loose = length();
    loose.within(1 + 1e-10, 1, 1e-6);
    BOOST_TEST(loose.loose());
    suite::Quantity bits = length(); // equal numbers say nothing about a bound of some roundings
    bits.within(1, 1, 0x1p-50);
    BOOST_TEST(!bits.loose());
}

BOOST_AUTO_TEST_CASE(a_quantity_needs_a_derivation)
{
    BOOST_CHECK_THROW(suite::Quantity("x", suite::Source::rounding, ""), std::logic_error);
}

BOOST_AUTO_TEST_CASE(verdicts)
{
    using suite::Verdict;
    const auto idle = [](suite::Probe& probe) {
        compares(1)(probe);
        probe.quantity("y", suite::Source::exact, "what the test says");
    };
    const auto throwing = [](suite::Probe& probe) {
        compares(1)(probe);
        throw SimulationError("frame 3", "NaN", "look at it");
    };
    const auto excused = [](suite::Probe& probe) { probe.not_run("no such data"); };
    const auto no_excuse = [](suite::Probe& probe) {
        compares(2)(probe);
        probe.not_run("it fails");
    };
    struct Case {
        std::function<void(suite::Probe&)> run;
        Verdict verdict;
        const char* message;
    };
    for (const auto& [run, verdict, message] :
         {Case{compares(1), Verdict::holds, ""}, Case{compares(2), Verdict::fails, "not within its bound: x"},
          Case{throwing, Verdict::fails, "stopped: frame 3: NaN; look at it"},
          Case{[](suite::Probe&) { throw 1; }, Verdict::fails,
               "stopped: something that is no std::exception"},
          Case{[](suite::Probe&) {}, Verdict::fails, "nothing compared"},
          Case{idle, Verdict::fails, "nothing compared: y"}, Case{excused, Verdict::not_run, "no such data"},
          Case{no_excuse, Verdict::fails, "not within its bound: x"}}) {
        const suite::CheckResult result = outcome(run);
        BOOST_TEST((result.verdict == verdict), message);
        BOOST_TEST(result.message == message);
    }
    BOOST_TEST(outcome(throwing).quantities.size() == 1); // what there was stays
}

BOOST_AUTO_TEST_CASE(a_known_limit_is_no_failure_until_it_gets_worse)
{
    using suite::Verdict;
    const auto finds = [](double value, std::optional<suite::KnownLimit> known) {
        return outcome([value, known](suite::Probe& probe) {
            probe.accuracy({"error", value, 0.05, known});
        });
    };
    const suite::KnownLimit known{0.1, "a test"};
    BOOST_TEST((finds(0.05, {}).verdict == Verdict::holds));
    BOOST_TEST((finds(0.06, {}).verdict == Verdict::fails));
    BOOST_TEST((finds(0.05, known).verdict == Verdict::holds));
    const suite::CheckResult limit = finds(0.1, known);
    BOOST_TEST((limit.verdict == Verdict::limit));
    BOOST_TEST(limit.message == "not met yet: error");
    BOOST_TEST(limit.quantities.front().derivation().ends_with("not to exceed what it was: a test"));
    BOOST_TEST((finds(0.11, known).verdict == Verdict::fails));
    BOOST_TEST((finds(std::nan(""), known).verdict == Verdict::fails));
    BOOST_TEST((finds(0.06, suite::KnownLimit{0.01, "met since"}).verdict == Verdict::fails));
}

BOOST_AUTO_TEST_CASE(the_model_is_measured_once_in_single_precision)
{
    const std::vector<suite::Check> checks{check_of("model", compares(1), suite::Scope::model)};
    const suite::SuiteResult both =
        suite_of(checks, suite::make_subjects({Backend::reference, Backend::cpu}));
    BOOST_REQUIRE(both.results.size() == 1U);
    BOOST_TEST(both.results[0].subject == "cpu float");
    BOOST_TEST((both.results[0].verdict == suite::Verdict::holds));
    const suite::SuiteResult none = suite_of(checks, suite::make_subjects({Backend::reference}));
    BOOST_REQUIRE(none.results.size() == 1U);
    BOOST_TEST((none.results[0].verdict == suite::Verdict::not_run));
    BOOST_TEST(none.results[0].message == "the model is measured in single precision only");
}

BOOST_AUTO_TEST_CASE(the_first_failure_ends_a_check_where_that_is_asked_for)
{
    int compared = 0;
    const auto run = [&compared](suite::Probe& probe) {
        suite::Quantity& x = probe.quantity("x", suite::Source::exact, "what the test says");
        for (const double value : {1.0, 2.0, 1.0}) {
            x.within(value, 1, 0);
            ++compared;
        }
    };

    const suite::CheckResult whole = outcome(run);
    BOOST_TEST(compared == 3);
    compared = 0;
    suite::Quantity::first_failure_ends = true;
    const suite::CheckResult ended = outcome(run);
    suite::Quantity::first_failure_ends = false;

    BOOST_TEST(compared == 1);
    BOOST_TEST((ended.verdict == suite::Verdict::fails));
    BOOST_TEST(ended.message == whole.message);
}

BOOST_AUTO_TEST_CASE(checks_are_chosen_by_words_equations_and_levels)
{
    BOOST_TEST(selected({}, false) == "eq08_balance poiseuille_channel");
    BOOST_TEST(selected({}) == "eq08_balance poiseuille_channel eq18_slow");
    for (const char* word : {"eq08", "8", "08", "eq8", "EQ8", "balance", "eq08_balance"}) {
        BOOST_TEST(selected({word}) == "eq08_balance");
    }
    BOOST_TEST(selected({"L3"}) == "poiseuille_channel");
    BOOST_TEST(selected({"eos"}) == "poiseuille_channel");
    BOOST_TEST(selected({"18", "7"}) == "poiseuille_channel eq18_slow"); // in the suite's order
    for (const char* word : {"", "0", "eq", "eq0", "28", "L1", "bal", "poiseuille_", "balance_eq08"}) {
        BOOST_CHECK_THROW(selected({word}), InputError);
    }
    BOOST_CHECK_THROW(selected({"eq18"}, false), InputError);
    const auto says = [](const std::string& words) {
        return [words](const InputError& error) {
            return std::string(error.what()).find(words) != std::string::npos;
        };
    };
    BOOST_CHECK_EXCEPTION(selected({"8", "x"}), InputError, says("matches no check (x)"));
    BOOST_CHECK_EXCEPTION(selected({"poiseuille_tube"}), InputError,
                          says("poiseuille_channel"));                               // the same letters
    BOOST_CHECK_EXCEPTION(selected({"eq18"}, false), InputError, says("eq18_slow")); // only --full makes it
}

BOOST_AUTO_TEST_CASE(every_subject_has_its_turn_in_a_fixed_order)
{
    std::vector<suite::Check> checks{check_of("flows", compares(1)),
                                     check_of("equations", compares(1), suite::Scope::equations),
                                     check_of("once", compares(1), suite::Scope::once)};
    std::vector<suite::SuiteSubject> subjects = suite::make_subjects({Backend::reference, Backend::cpu});
    for (const int threads : {1, 3}) {
        const suite::SuiteResult suite = suite_of(checks, subjects, threads);
        std::string order;
        for (const suite::CheckResult& r : suite.results) {
            BOOST_TEST((r.verdict == suite::Verdict::holds));
            order.append(r.check->id).append("/").append(r.subject).append(" ");
        }
        BOOST_TEST(order == "flows/reference flows/cpu double flows/cpu float "
                            "equations/reference equations/cpu double once/once ");
        BOOST_TEST(suite.complete);
    }
}

BOOST_AUTO_TEST_CASE(a_missing_subject_is_not_run_and_says_why)
{
    const suite::SuiteSubject missing{{{Backend::cuda, Precision::float_, 1, 0}}, "", "no GPU: none"};
    const suite::SuiteResult suite = suite_of(
        {check_of("flows", compares(1)), check_of("equations", compares(1), suite::Scope::equations)},
        {{suite::once(), "", ""}, missing});
    BOOST_TEST(suite.results.size() == 3);
    BOOST_TEST(suite.results[1].subject == "cuda float");
    BOOST_TEST((suite.results[1].verdict == suite::Verdict::not_run));
    BOOST_TEST(suite.results[1].message == "no GPU: none");
    BOOST_TEST(suite.complete);
}

BOOST_AUTO_TEST_CASE(an_interrupted_suite_keeps_what_there_is)
{
    const InterruptWatch watch;
    std::atomic<int> shown = 0;
    const auto interrupted = [](suite::Probe& probe) {
        probe.quantity("x", suite::Source::exact, "what the test says");
        std::raise(SIGINT);
        throw Interrupted();
    };
    const std::vector<suite::Check> checks{
        check_of("done", compares(1)), check_of("interrupted", interrupted), check_of("later", compares(1))};
    const suite::SuiteResult suite =
        suite::run_suite(suite::select(checks, true, {}), {{suite::once(), "", ""}}, 1,
                         [&](std::int64_t, std::int64_t, const std::string&) { ++shown; });
    BOOST_TEST((suite.results[0].verdict == suite::Verdict::holds));
    for (const std::size_t k : {1U, 2U}) {
        BOOST_TEST((suite.results[k].verdict == suite::Verdict::not_run));
        BOOST_TEST(suite.results[k].message == "interrupted");
    }
    BOOST_TEST(!suite.complete);
    BOOST_TEST(shown > 0);
}

BOOST_AUTO_TEST_CASE(subjects_are_chosen_by_backend_and_precision)
{
    const auto names = [](const std::vector<suite::SuiteSubject>& subjects) {
        std::string text;
        for (const suite::SuiteSubject& s : subjects) {
            text += s.subject.name() + (s.subject.equations != nullptr ? "* " : " ");
        }
        return text;
    };
    BOOST_TEST(names(suite::make_subjects()) == "reference* cpu double* cpu float cuda double cuda float ");
    BOOST_TEST(names(suite::make_subjects({Backend::cpu}, {Precision::float_})) == "cpu float* ");
    BOOST_TEST(names(suite::make_subjects({Backend::cpu, Backend::reference})) ==
               "reference* cpu double* cpu float ");
    BOOST_CHECK_THROW(suite::make_subjects({Backend::reference}, {Precision::float_}), InputError);
}

BOOST_AUTO_TEST_CASE(all_checks_are_told_apart)
{
    for (const suite::Check& check : checks::all_checks()) {
        BOOST_TEST(suite::select(checks::all_checks(), true, {std::string(check.id)}).front()->id ==
                   check.id);
    }
}
