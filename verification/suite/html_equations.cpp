// SPDX-License-Identifier: Apache-2.0
// The page's table of equations, and what its words mean.
#include "output/build_info.hpp"
#include "verification/suite/html.hpp"

#include <algorithm>

namespace aneurysm::suite
{
namespace
{

report::Markup subject_cell(const EquationCell& c)
{
    using State = EquationCell::State;
    switch (c.state) {
    case State::holds:
        return number_cell(mark(Verdict::holds, shown(c.tally.ratio)));
    case State::fails:
        return number_cell(mark(Verdict::fails, c.tally.ratio > 1 ? shown(c.tally.ratio) : ""));
    case State::not_run:
        return report::element("td", {{"class", "weak"}, {"title", c.remark}}, "not run");
    case State::shared:
        return report::element("td", {{"class", "weak"}}, c.remark);
    case State::equal:
        return number_cell(report::Markup("equal, ") << shown(c.tally.ratio));
    case State::none:
        break;
    }
    return report::element("td", {{"class", "weak"}}, "–");
}

report::Markup verdict_cell(const EquationSummary& e)
{
    switch (e.verdict) {
    case EquationVerdict::holds:
        return cell(mark(Verdict::holds));
    case EquationVerdict::fails:
        return cell(mark(Verdict::fails));
    case EquationVerdict::not_checked:
    case EquationVerdict::no_check:
        break;
    }
    return cell(report::element("span", {{"class", "fails"}}, name_of(e.verdict)) << ": " << e.remark);
}

bool was_chosen(const SuiteReport& report, const Check* check)
{
    return std::ranges::any_of(report.suite.results, [&](const CheckResult& r) { return r.check == check; });
}

/// The checks that can show that it holds, with what they compare with; the others in a line each.
report::Markup checks_cell(const SuiteReport& report, const EquationSummary& e)
{
    report::Markup evidence;
    report::Markup others;
    report::Markup left_out;
    for (const Check* check : e.checks) {
        if (!was_chosen(report, check)) {
            left_out << (left_out.empty() ? "not chosen: " : ", ") << check->id;
        } else if (!is_evidence(*check)) {
            others << (others.empty() ? "also: " : ", ") << check_link(*check);
        } else {
            evidence << report::element("div", {}, check_link(*check), ": ", joined(check->oracles, "; "));
        }
    }
    return report::element("td", {{"class", "long"}}, evidence, report::element("div", {}, others),
                           report::element("div", {{"class", "weak"}}, left_out));
}

template <class Enum>
report::Markup definitions(Enum last)
{
    report::Markup list;
    for (int n = 0; n <= static_cast<int>(last); ++n) {
        const auto item = static_cast<Enum>(n);
        report::Markup term = name_of(item);
        if constexpr (std::is_same_v<Enum, Level>) {
            term = level_heading(item);
        }
        list << report::element("dt", {}, term) << report::element("dd", {}, meaning_of(item));
    }
    return report::element("dl", {}, list);
}

} // namespace

report::Markup equations_section(const SuiteReport& report)
{
    std::vector<std::string> head{"", "equation", "verdict"};
    for (const SuiteSubject& s : report.suite.subjects) {
        head.push_back(s.subject.name());
    }
    head.insert(head.end(), {"how the printed formula is read", "checks: what they compare with"});
    report::Markup rows;
    for (const EquationSummary& e : report.equations) {
        report::Markup cells;
        for (const EquationCell& c : e.cells) {
            cells << subject_cell(c);
        }
        const std::string deviation(e.equation->deviation);
        rows << row(cell(number_of(*e.equation)), cell(e.equation->title), verdict_cell(e), cells,
                    report::element("td", {{"class", "long"}},
                                    report::element("b", {}, name_of(e.equation->status)),
                                    deviation.empty() ? "" : ": " + deviation),
                    checks_cell(report, e))
             << "\n";
    }
    return report::element(
        "section", {{"id", "equations"}}, report::element("h2", {}, "Equation by equation"),
        report::element(
            "p", {},
            "The numbers under the versions are the largest measured/allowed of all checks of the "
            "equation: 0.3 says that the difference found was 30 % of what is allowed. The "
            "formulas of the fast version are the same functions in 16 and in 7 digits and are "
            "checked once by themselves; its flows are checked in both. “Equal” has no "
            "independent answer of its own, but was compared with the reference. A formula is "
            "read as printed, or reconstructed where signs and fractions are lost in print, or "
            "assumed where the paper leaves a rule open."),
        table(head, rows));
}

report::Markup about_section(const SuiteReport& report)
{
    const output::BuildInfo build = output::build_info();
    return report::element(
        "section", {{"id", "about"}}, report::element("h2", {}, "How to read and repeat this"),
        report::element("h3", {}, "The six levels"), definitions(Level::executors),
        report::element("h3", {}, "What “holds” means"),
        report::element(
            "p", {},
            "A check holds when it compared at least one number for each of its quantities and every "
            "difference is at most the allowed one. A check that compared nothing, met a value that is no "
            "number, or stopped with an error fails."),
        report::element(
            "p", {},
            "An equation holds when no check of it fails and at least one of the levels L0 to L3, which "
            "compare the program with answers found without it, holds for at least one version of the "
            "program; the table says for which. Levels L4 and L5, and checks of the answers against one "
            "another (“once”), can make an equation fail but not hold. What was not run is neither."),
        report::element("h3", {}, "Where allowed differences come from"), definitions(Source::statistics),
        report::element(
            "p", {}, "A bound is marked ", report::element("span", {{"class", "warn"}}, "loose"),
            " when it is more than 1,000 times what was found, and more than one rounding of the number: it "
            "may be larger than it need be, and hide a small fault."),
        report::element("h3", {}, "How to repeat it"),
        report::element("p", {}, report::element("code", {}, report.command)),
        report::element(
            "p", {},
            "The same build on the same kind of processor gives the same numbers. The files beside this one "
            "are report.json (everything, for programs), report.md and junit.xml."),
        report::element("p", {{"class", "weak"}}, "Commit ", build.commit, "; ", build.compiler, " ",
                        report::element("code", {}, build.flags), "; ", report.machine, "; ",
                        std::to_string(report.threads), " checks at once; ", report.date, "."));
}

} // namespace aneurysm::suite
