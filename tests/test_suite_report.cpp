// SPDX-License-Identifier: Apache-2.0
// What a run of the suite says as a whole: equations, tallies, and the reports of a run in which everything
// happens that can. The reports stay in sample_report/ for check_report.py, which reads them as others do.
#include "output/file.hpp"
#include "verification/suite_report.hpp"
#include "verification/svg_plot.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

using namespace aneurysm;
using namespace aneurysm::verification;

namespace
{

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Plot convergence()
{
    return {.title = "Error <of> the \"slope\" & its order",
            .x_label = "spacing [m]",
            .y_label = "error [1]",
            .log_x = true,
            .log_y = true,
            .series = {{"measured", {0.4, 0.2, 0.1, 0.05}, {1.6e-2, 4.1e-3, 1e-3, 0}},
                       {"predicted", {0.4, 0.05}, {1.6e-2, 2.5e-4}, true}}};
}

std::function<void(Probe&)> compares(double x)
{
    return [x](Probe& probe) {
        const bool single = probe.subject().choice.precision == "float";
        const std::string bound = single ? "gamma_9 |x|, & <more> in float" : "gamma_3 |x|: three roundings";
        probe.quantity("x [m]", Source::rounding, bound).within(x, 1, 0.5, "a < b & c");
        probe.note("order", 1.98, "predicted 2");
        probe.plot(convergence());
    };
}

void compares_loosely(Probe& probe)
{
    probe.quantity("bits", Source::exact, "whole numbers: nothing is allowed").equal(3, 3);
    probe.quantity("slope", Source::truncation, "next term of the series, twice").within(1, 1 + 1e-9, 1e-3);
}

const std::vector<Check>& checks()
{
    const auto check = [](std::string_view id, Level level, std::vector<std::string_view> equations,
                          Scope scope, std::function<void(Probe&)> run) {
        return Check{.id = id,
                     .level = level,
                     .equations = std::move(equations),
                     .title = "the title of <it>",
                     .oracles = {"closed form", "GSL root"},
                     .scope = scope,
                     .run = std::move(run)};
    };
    static const std::vector<Check> all = [&] {
        std::vector<Check> list{
            check("eq08_holds", Level::scalar, {"8", "9"}, Scope::equations, compares(1.25)),
            check("eq09_fails", Level::scalar, {"9"}, Scope::equations, compares(2)),
            check("eq04_nan", Level::lattice, {"4"}, Scope::flows, compares(not_a_number)),
            check("eq05_empty", Level::lattice, {"5"}, Scope::flows, [](Probe&) {}),
            check("eq06_throws", Level::transient, {"6"}, Scope::flows,
                  [](Probe&) { throw std::runtime_error("no <flow> & nothing else"); }),
            check("eq07_here_not", Level::continuous, {"7"}, Scope::flows,
                  [](Probe& probe) { probe.not_run("needs \"a\" | b"); }),
            check("eq01_holds", Level::continuous, {"1", "EOS"}, Scope::flows, compares_loosely),
            check("eq28_slow", Level::continuous, {"28"}, Scope::flows, compares(1)),
            check("eq02_units", Level::metamorphic, {"2", "8"}, Scope::flows, compares(1)),
            check("eq03_once", Level::executors, {"3", "8"}, Scope::once, compares(1))};
        std::ranges::find(list, "eq28_slow", &Check::id)->quick = false;
        return list;
    }();
    return all;
}

/// The quick ones, for the reference, cpu and a cuda that isn't there.
const SuiteReport& sample()
{
    static const SuiteReport report = [] {
        std::vector<SuiteSubject> subjects = make_subjects({"reference", "cpu"});
        subjects.push_back(subjects.back());
        subjects.back().subject.choice.name = "cuda";
        subjects.back().missing = "no GPU: <none>";
        SuiteReport r;
        r.suite = run_suite(select(checks(), false, {}), std::move(subjects), 2);
        r.equations = by_equation(r.suite, checks());
        r.selection = "A test";
        r.command = "aneurysm verify --only \"<this>\" --out DIR";
        r.date = "2025-07-24T13:05:00Z";
        r.machine = "a test's";
        return r;
    }();
    return report;
}

const EquationSummary& equation(std::string_view id)
{
    return *std::ranges::find(sample().equations, id,
                              [](const EquationSummary& e) { return e.equation->id; });
}

using State = EquationCell::State;

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
        ++n;
    }
    return n;
}

std::string svg_of(const Series& series, bool logarithmic = false)
{
    return svg({"t", "x", "y", logarithmic, logarithmic, {series}}).text();
}

} // namespace

BOOST_AUTO_TEST_CASE(an_equation_holds_where_its_checks_do)
{
    const EquationSummary& laplace = equation("8");
    BOOST_TEST((laplace.verdict == EquationVerdict::holds));
    BOOST_TEST((laplace.cells[0].state == State::holds));
    BOOST_TEST(laplace.cells[0].tally.ratio == 0.5);
    BOOST_TEST((laplace.cells[1].state == State::holds));
    BOOST_TEST((laplace.cells[2].state == State::shared)); // the formulas are double in either precision
    BOOST_TEST(laplace.cells[2].remark == "as cpu double");
    BOOST_TEST((laplace.cells[3].state == State::not_run));
    BOOST_TEST(laplace.cells[3].remark == "no GPU: <none>");
    BOOST_TEST((equation("EOS").cells[2].state == State::holds));
}

BOOST_AUTO_TEST_CASE(one_failure_is_enough)
{
    BOOST_TEST((equation("9").verdict == EquationVerdict::fails)); // although eq08_holds looks at it, too
    for (const char* id : {"4", "5", "6"}) {
        BOOST_TEST((equation(id).verdict == EquationVerdict::fails));
    }
}

BOOST_AUTO_TEST_CASE(what_was_not_checked_never_holds)
{
    BOOST_TEST((equation("7").verdict == EquationVerdict::not_checked));
    BOOST_TEST(equation("7").remark == "none of its checks was run");
    BOOST_TEST((equation("28").verdict == EquationVerdict::not_checked));
    BOOST_TEST(equation("28").remark == "none of its checks was chosen");
    BOOST_TEST(
        (equation("2").verdict == EquationVerdict::no_check)); // equal to something, which may be wrong
    BOOST_TEST((equation("2").cells[0].state == State::equal));
    BOOST_TEST((equation("10").verdict == EquationVerdict::no_check));
    BOOST_TEST((equation("3").verdict == EquationVerdict::no_check)); // a check of the oracle alone
    BOOST_TEST(
        headline(sample().equations)
            .starts_with("3 of 29 equations hold; FAILS: (4) (5) (6) (9); not checked: (7) (28); NO CHECK: "
                         "(2) (3) (10)"));
    SuiteResult cut_short = sample().suite;
    for (CheckResult& r : cut_short.results) {
        if (r.check->id == "eq08_holds" && r.subject == "cpu double") {
            r = {.check = r.check, .subject = r.subject, .message = interruption};
        }
    }
    BOOST_TEST((by_equation(cut_short, checks())[8].verdict == EquationVerdict::not_checked));
}

BOOST_AUTO_TEST_CASE(a_suite_passes_when_something_holds_and_nothing_fails)
{
    BOOST_TEST(!passed(sample().suite));
    SuiteResult suite = sample().suite;
    std::erase_if(suite.results, [](const CheckResult& r) { return r.verdict == Verdict::fails; });
    BOOST_TEST(passed(suite));
    suite.complete = false;
    BOOST_TEST(!passed(suite));
    suite.complete = true;
    std::erase_if(suite.results, [](const CheckResult& r) { return r.verdict == Verdict::holds; });
    BOOST_TEST(!passed(suite)); // nothing was compared
}

BOOST_AUTO_TEST_CASE(what_was_not_run_is_said_once_with_its_reason)
{
    const std::vector<Reason> reasons = not_run(sample().suite);
    BOOST_TEST(reasons.size() == 2);
    BOOST_TEST(reasons[0].who == "cuda float");
    BOOST_TEST(reasons[0].why == "no GPU: <none>");
    BOOST_TEST(reasons[1].who == "eq07_here_not (reference, cpu double, cpu float)");
}

BOOST_AUTO_TEST_CASE(reports_of_all_that_can_happen)
{
    const std::filesystem::path directory = "sample_report";
    std::filesystem::create_directories(directory);
    output::write_atomically(directory / "report.json", suite_json(sample()));
    output::write_atomically(directory / "report.md", suite_markdown(sample()));
    output::write_atomically(directory / "junit.xml", suite_junit(sample()));
    const std::string html = suite_html(sample());
    output::write_atomically(directory / "report.html", html);
    BOOST_TEST(count(html, "a &lt; b &amp; c") > 0);
    BOOST_TEST(count(html, "<of>") + count(html, "<none>") + count(html, "<flow>") == 0);
    const std::string text = suite_text(sample());
    BOOST_TEST(text.ends_with("\nFAIL\n"));
    BOOST_TEST(
        count(text, "FAILS      eq06_throws (reference, cpu double, cpu float): stopped: no <flow> & nothing "
                    "else\n") == 1);
}

BOOST_AUTO_TEST_CASE(a_plot_shows_every_point_that_its_axes_have_a_place_for)
{
    const Series points{"p", {1, 2, 3, not_a_number, 4}, {1, 4, 9, 1, infinite}};
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
    for (const Series& s : {Series{"none", {}, {}}, Series{"one", {2}, {0}}, Series{"short", {1, 2}, {1}},
                            Series{"nothing", {not_a_number}, {not_a_number}}}) {
        for (const bool logarithmic : {false, true}) {
            const std::string text = svg_of(s, logarithmic);
            BOOST_TEST(count(text, "class=\"grid\"") > 2);
            BOOST_TEST(count(text, "nan") + count(text, "inf") == 0);
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
}
