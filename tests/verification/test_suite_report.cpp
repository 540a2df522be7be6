// SPDX-License-Identifier: Apache-2.0
// What a run of the suite says as a whole: equations, tallies, and the reports of a run in which everything
// happens that can. The reports stay in sample_report/ for check_report.py, which reads them as others do.
#include "output/file.hpp"
#include "output/report/html.hpp"
#include "output/report/markdown.hpp"
#include "output/report/svg_plot.hpp"
#include "verification/suite/report.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

using namespace aneurysm;

namespace
{

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

suite::Plot convergence()
{
    return {.title = "Error <of> the \"slope\" & its order",
            .x_label = "spacing [m]",
            .y_label = "error [1]",
            .log_x = true,
            .log_y = true,
            .series = {{"measured", {0.4, 0.2, 0.1, 0.05}, {1.6e-2, 4.1e-3, 1e-3, 0}},
                       {"predicted", {0.4, 0.05}, {1.6e-2, 2.5e-4}, true}}};
}

std::function<void(suite::Probe&)> compares(double x)
{
    return [x](suite::Probe& probe) {
        const bool single = probe.subject().choice.precision == Precision::float_;
        const std::string bound = single ? "gamma_9 |x|, & <more> in float" : "gamma_3 |x|: three roundings";
        probe.quantity("x [m]", suite::Source::rounding, bound).within(x, 1, 0.5, "a < b & c");
        probe.note("order", 1.98, "predicted 2");
        probe.plot(convergence());
    };
}

void compares_loosely(suite::Probe& probe)
{
    probe.quantity("bits", suite::Source::exact, "whole numbers: nothing is allowed").equal(3, 3);
    probe.quantity("slope", suite::Source::truncation, "next term of the series, twice")
        .within(1, 1 + 1e-9, 1e-3);
}

const std::vector<suite::Check>& checks()
{
    const auto check = [](std::string_view id, suite::Level level, std::vector<std::string_view> equations,
                          suite::Scope scope, std::function<void(suite::Probe&)> run) {
        return suite::Check{.id = id,
                            .level = level,
                            .equations = std::move(equations),
                            .title = "the title of <it>",
                            .oracles = {"closed form", "GSL root"},
                            .scope = scope,
                            .run = std::move(run)};
    };
    static const std::vector<suite::Check> all = [&] {
        std::vector<suite::Check> list{
            check("eq08_holds", suite::Level::scalar, {"8", "9"}, suite::Scope::equations, compares(1.25)),
            check("eq09_fails", suite::Level::scalar, {"9"}, suite::Scope::equations, compares(2)),
            check("eq04_nan", suite::Level::lattice, {"4"}, suite::Scope::flows, compares(not_a_number)),
            check("eq05_empty", suite::Level::lattice, {"5"}, suite::Scope::flows, [](suite::Probe&) {}),
            check("eq06_throws", suite::Level::transient, {"6"}, suite::Scope::flows,
                  [](suite::Probe&) { throw std::runtime_error("no <flow> & nothing else"); }),
            check("eq07_here_not", suite::Level::continuous, {"7"}, suite::Scope::flows,
                  [](suite::Probe& probe) { probe.not_run("needs \"a\" | b"); }),
            check("eq01_holds", suite::Level::continuous, {"1", "EOS"}, suite::Scope::flows,
                  compares_loosely),
            check("eq28_slow", suite::Level::continuous, {"28"}, suite::Scope::flows, compares(1)),
            check("eq02_units", suite::Level::metamorphic, {"2", "8"}, suite::Scope::flows, compares(1)),
            check("eq03_once", suite::Level::executors, {"3", "8"}, suite::Scope::once, compares(1)),
            check("rest", suite::Level::nature, {}, suite::Scope::model, [](suite::Probe& probe) {
                probe.accuracy(
                    {"speed of <rest> [m/s]", 0.5, 0.1, suite::KnownLimit{0.5, "a test & no more"}});
                probe.accuracy({"force at rest [N]", 0.5, 1});
            })};
        std::ranges::find(list, "eq28_slow", &suite::Check::id)->quick = false;
        return list;
    }();
    return all;
}

/// The quick ones, for the reference, cpu and a cuda that isn't there.
const suite::SuiteReport& sample()
{
    static const suite::SuiteReport report = [] {
        std::vector<suite::SuiteSubject> subjects = suite::make_subjects({Backend::reference, Backend::cpu});
        subjects.push_back(subjects.back());
        subjects.back().subject.choice.backend = Backend::cuda;
        subjects.back().missing = "no GPU: <none>";
        suite::SuiteReport r;
        r.suite = suite::run_suite(suite::select(checks(), false, {}), std::move(subjects), 2);
        r.equations = suite::by_equation(r.suite, checks());
        r.selection = "A test";
        r.command = "aneurysm verify --only \"<this>\" --out DIR";
        r.date = "2025-07-24T13:05:00Z";
        r.machine = "a test's";
        return r;
    }();
    return report;
}

const suite::EquationSummary& equation(std::string_view id)
{
    return *std::ranges::find(sample().equations, id,
                              [](const suite::EquationSummary& e) { return e.equation->id; });
}

using State = suite::EquationCell::State;

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++n;
    }
    return n;
}

std::string svg_of(const suite::Series& series, bool logarithmic = false)
{
    return report::svg({"t", "x", "y", logarithmic, logarithmic, {series}}).text();
}

} // namespace

BOOST_AUTO_TEST_CASE(an_equation_holds_where_its_checks_do)
{
    const suite::EquationSummary& laplace = equation("8");
    BOOST_TEST((laplace.verdict == suite::EquationVerdict::holds));
    BOOST_TEST((laplace.cells[0].state == State::holds));
    BOOST_TEST(laplace.cells[0].tally.ratio == 0.5);
    BOOST_TEST((laplace.cells[1].state == State::holds));
    BOOST_TEST((laplace.cells[2].state == State::shared)); // the formulas are double in either precision
    BOOST_TEST(laplace.cells[2].remark == "as cpu double");
    BOOST_TEST((laplace.cells[3].state == State::not_run));
    BOOST_TEST(laplace.cells[3].remark == "no GPU: <none>");
    BOOST_TEST((equation("EOS").cells[2].state == State::holds));
}

BOOST_AUTO_TEST_CASE(one_failure_is_enough_and_what_was_not_checked_never_holds)
{
    using Says = suite::EquationVerdict;
    BOOST_TEST((equation("9").verdict == Says::fails)); // although eq08_holds looks at it, too
    const char* not_chosen = "no check that could show that it holds was run";
    for (const char* id : {"7", "28"}) {
        BOOST_TEST((equation(id).verdict == Says::not_checked));
        BOOST_TEST(equation(id).remark == not_chosen);
    }
    BOOST_TEST((equation("2").verdict == Says::no_check)); // equal to something, which may be wrong
    BOOST_TEST((equation("2").cells[0].state == State::equal));
    BOOST_TEST((equation("3").verdict == Says::no_check)); // a check of the oracle alone
    BOOST_TEST(
        headline(sample().equations)
            .starts_with("3 of 29 equations hold; FAILS: (4) (5) (6) (9); not checked: (7) (28); NO CHECK: "
                         "(2) (3) (10)"));
    suite::SuiteResult cut_short = sample().suite;
    for (suite::CheckResult& r : cut_short.results) {
        if (r.check->id == "eq08_holds" && r.subject == "cpu double") {
            r = {.check = r.check, .subject = r.subject, .message = suite::interruption};
        }
    }
    BOOST_TEST((suite::by_equation(cut_short, checks())[8].verdict == Says::not_checked));
}

BOOST_AUTO_TEST_CASE(what_fails_begins_at_the_lowest_level)
{
    const std::vector<suite::Failure> failures = suite::what_fails(sample().suite);
    BOOST_REQUIRE(failures.size() == 4U);
    BOOST_TEST(failures[0].where->check->id == "eq09_fails");
    BOOST_TEST(failures[0].quantity->worst().ratio == 2);
    BOOST_TEST(failures[0].subjects == "reference, cpu double");
    BOOST_TEST(failures[2].where->message == "nothing compared");
    BOOST_TEST(failures[3].where->check->id == "eq06_throws");
}

BOOST_AUTO_TEST_CASE(an_equation_that_fails_by_checks_of_others_alone_says_so)
{
    BOOST_TEST(!equation("9").only_shared); // by eq09_fails
    suite::SuiteResult suite = sample().suite;
    for (suite::CheckResult& r : suite.results) {
        const bool shared = r.check->id == "eq01_holds"; // of (1) and the equation of state
        r.verdict = shared ? suite::Verdict::fails : suite::Verdict::holds;
    }
    const std::vector<suite::EquationSummary> summaries = suite::by_equation(suite, checks());
    const auto& eos = *std::ranges::find(summaries, "EOS", [](const auto& e) { return e.equation->id; });
    BOOST_TEST((eos.verdict == suite::EquationVerdict::fails));
    BOOST_TEST(eos.only_shared);
    BOOST_TEST(!summaries[0].only_shared); // (1) is in its name
}

BOOST_AUTO_TEST_CASE(a_suite_passes_when_something_holds_and_nothing_fails)
{
    BOOST_TEST(!passed(sample().suite));
    suite::SuiteResult suite = sample().suite;
    std::erase_if(suite.results,
                  [](const suite::CheckResult& r) { return r.verdict == suite::Verdict::fails; });
    BOOST_TEST(passed(suite));
    suite.complete = false;
    BOOST_TEST(!passed(suite));
    suite.complete = true;
    std::erase_if(suite.results,
                  [](const suite::CheckResult& r) { return r.verdict != suite::Verdict::not_run; });
    BOOST_TEST(!passed(suite)); // nothing was compared
}

BOOST_AUTO_TEST_CASE(what_was_not_run_is_said_once_with_its_reason)
{
    const std::vector<suite::Reason> reasons = suite::not_run(sample().suite);
    BOOST_TEST(reasons.size() == 2);
    BOOST_TEST(reasons[0].who == "cuda float");
    BOOST_TEST(reasons[0].why == "no GPU: <none>");
    BOOST_TEST(reasons[1].who == "eq07_here_not (reference, cpu double, cpu float)");
}

BOOST_AUTO_TEST_CASE(a_limit_of_the_model_is_said_and_no_failure)
{
    suite::SuiteResult suite = sample().suite;
    std::erase_if(suite.results,
                  [](const suite::CheckResult& r) { return r.verdict != suite::Verdict::limit; });
    BOOST_REQUIRE(suite.results.size() == 1U);
    BOOST_TEST(passed(suite));
    BOOST_TEST(count(suite::suite_text(sample()), "not met    rest: not met yet: speed of <rest> [m/s]\n") ==
               1);
    const std::string page = report::markdown(suite::suite_document(sample()));
    BOOST_TEST(count(page, "How accurate is the model itself") == 1);
    BOOST_TEST(page.find("How accurate is the model itself") < page.find("Which versions of the program"));
}

BOOST_AUTO_TEST_CASE(reports_of_all_that_can_happen)
{
    const std::filesystem::path directory = "sample_report";
    std::filesystem::create_directories(directory);
    output::write_atomically(directory / "report.json", suite::suite_json(sample()));
    output::write_atomically(directory / "report.md", report::markdown(suite::suite_document(sample())));
    output::write_atomically(directory / "junit.xml", suite::suite_junit(sample()));
    const std::string html = report::html(suite::suite_document(sample()));
    output::write_atomically(directory / "report.html", html);
    BOOST_TEST(count(html, "a &lt; b &amp; c") > 0);
    BOOST_TEST(count(html, "<of>") + count(html, "<none>") + count(html, "<flow>") == 0);
    const std::string text = suite::suite_text(sample());
    BOOST_TEST(text.ends_with("\nFAIL\n"));
    BOOST_TEST(
        count(text, "FAILS      eq06_throws (reference, cpu double, cpu float): stopped: no <flow> & nothing "
                    "else\n") == 1);
}

BOOST_AUTO_TEST_CASE(a_plot_shows_every_point_that_its_axes_have_a_place_for)
{
    const suite::Series points{"p", {1, 2, 3, not_a_number, 4}, {1, 4, 9, 1, infinite}};
    BOOST_TEST(count(svg_of(points), "class=\"s0\"") == 3 + 1); // and one in the legend
    BOOST_TEST(count(svg_of(points), "p (2 points have no place here)") == 1);
    BOOST_TEST(count(svg_of({"p", {0, 1, 10}, {1, -1, 5}}, true), "class=\"s0\"") == 1 + 1);
    BOOST_TEST(count(svg_of({"p", {1, 2, 3}, {1, not_a_number, 3}, true}), "class=\"curve s0\"") == 2);
    BOOST_TEST(count(svg_of({"p", {1, 2, 3, 4, 5}, {1, 2, not_a_number, 4, 5}, true}), "M") ==
               2 + 1); // a gap
}

BOOST_AUTO_TEST_CASE(a_plot_has_ticks_at_any_range)
{
    for (const double scale : {1e-300, 1e-12, 1.0, 7.0, 1e15}) {
        for (const bool logarithmic : {false, true}) {
            const std::string text = svg_of({"p", {scale, 3 * scale}, {scale, 1e4 * scale}}, logarithmic);
            BOOST_TEST(count(text, "class=\"grid\"") >= 4 + 2);
            BOOST_TEST(count(text, "class=\"grid\"") <= 2 * 12);
            BOOST_TEST(count(text, "nan") + count(text, "inf") == 0);
        }
    }
    for (const suite::Series& s :
         {suite::Series{"none", {}, {}}, suite::Series{"one", {2}, {0}}, suite::Series{"short", {1, 2}, {1}},
          suite::Series{"nothing", {not_a_number}, {not_a_number}}}) {
        for (const bool logarithmic : {false, true}) {
            BOOST_TEST(count(svg_of(s, logarithmic), "class=\"grid\"") > 2);
            BOOST_TEST(count(svg_of(s, logarithmic), "nan") + count(svg_of(s, logarithmic), "inf") == 0);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_point_lies_where_the_axes_say)
{
    // Marks of s0 are circles that start 3.5 px left of their middle. Two decades with 4 % of air on both
    // sides: 10 is in the middle of 78 and 624.
    const std::string text = svg_of({"p", {1, 10, 100}, {1, 10, 100}}, true);
    BOOST_TEST(count(text, "d=\"M347.5 152.0a") == 1);
    BOOST_TEST(count(text, "x=\"351.0\" y=\"310.0\" text-anchor=\"middle\">10<") == 1);
    BOOST_TEST(count(svg_of({"p", {-1, 1}, {-3, 3}}), ">0<") == 2); // not -0
}
