// SPDX-License-Identifier: Apache-2.0
// The first screen of the page, for readers who don't know the code.
#include "verification/suite/html.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace aneurysm::suite
{
namespace
{

/// 12345 -> "12,345"
std::string grouped(std::int64_t n)
{
    std::string text = std::to_string(n);
    for (auto place = static_cast<std::int64_t>(text.size()) - 3; place > 0; place -= 3) {
        text.insert(static_cast<std::size_t>(place), ",");
    }
    return text;
}

std::string percent(double ratio)
{
    return ratio < 0 ? "-" : std::isinf(ratio) ? "more than it all" : shown(100 * ratio).append(" %");
}

/// Which versions that is about.
std::string who(const SuiteResult& suite)
{
    std::string here;
    std::string missing;
    for (const SuiteSubject& s : suite.subjects) {
        std::string& list = s.missing.empty() ? here : missing;
        list.append(list.empty() ? "" : ", ").append(s.subject.name());
    }
    return "Checked: " + here + (missing.empty() ? "." : "; not checked: " + missing + ".");
}

report::Markup banner(const SuiteReport& report)
{
    const SuiteResult& suite = report.suite;
    const bool good = passed(suite);
    const std::string text = !suite.complete           ? "Interrupted: this report is incomplete. "
                             : good                    ? "Everything that was checked holds. "
                             : tally(suite).holds == 0 ? "Nothing holds. "
                                                       : "Something fails. ";
    return report::element("p", {{"class", good ? "verdict holds" : "verdict fails"}}, good ? "✓ " : "✗ ",
                           text, headline(report.equations), ".",
                           report::element("div", {{"class", "who"}}, who(suite)))
           << report::element("p", {{"class", "weak"}}, report.selection, ". ", report.date, ", ",
                              shown(suite.seconds), " s on ", report.machine, ".")
           << "\n";
}

report::Markup figures(const SuiteReport& report)
{
    const auto hold = std::ranges::count(report.equations, EquationVerdict::holds, &EquationSummary::verdict);
    std::int64_t independent = 0;
    for (const Level level : {Level::scalar, Level::lattice, Level::transient, Level::continuous}) {
        independent += tally(report.suite, level).compared;
    }
    const Tally all = tally(report.suite);
    const auto item = [](const std::string& number, const std::string& what) {
        return report::element("li", {}, report::element("b", {}, number), what);
    };
    return report::element("ul", {{"class", "figures"}},
                           item(std::to_string(hold) + " of " + std::to_string(report.equations.size()),
                                "equations hold"),
                           item(grouped(independent), "numbers compared with an answer found independently"),
                           item(grouped(all.compared - independent),
                                "numbers compared between versions or runs of the program"),
                           item(std::to_string(all.fails), "checks fail"))
           << "\n";
}

std::string described(const SuiteSubject& s)
{
    const std::string& name = s.subject.choice.name;
    const std::string& precision = s.subject.choice.precision;
    if (name == "reference") {
        return "the plain version, which reads like the paper; 16 digits";
    }
    return std::string("the fast version on ") + (name == "cpu" ? "a processor" : "a graphics card (GPU)") +
           (precision == "double" ? "; 16 digits" : "; 7 digits");
}

report::Markup subject_row(const SuiteReport& report, const std::string& name, const std::string& what,
                           const std::string& device)
{
    Tally t;
    for (const CheckResult& r : report.suite.results) {
        if (r.subject == name) {
            t.add(r);
        }
    }
    return row(cell(name), cell(what), number_cell(std::to_string(t.holds)),
               number_cell(std::to_string(t.fails)), number_cell(std::to_string(t.not_run)), cell(device));
}

report::Markup subjects_table(const SuiteReport& report)
{
    report::Markup rows;
    for (const SuiteSubject& s : report.suite.subjects) {
        rows << subject_row(report, s.subject.name(), described(s),
                            s.missing.empty() ? s.device : "not there, see below");
    }
    rows << subject_row(report, "once", "the independent answers, against one another", "one CPU core");
    return table({"version", "what it is", "checks hold", "fail", "not run", "where it ran"}, rows);
}

report::Markup levels_table(const SuiteReport& report)
{
    report::Markup rows;
    for (int n = 0; n <= static_cast<int>(Level::executors); ++n) {
        const auto level = static_cast<Level>(n);
        const Tally t = tally(report.suite, level);
        report::Markup closest = "nothing compared";
        if (t.closest != nullptr) {
            const Quantity::Worst& w = t.closest->worst();
            closest = report::Markup()
                      << t.closest->name() << ": " << shown(w.error) << " off, " << shown(w.allowed)
                      << " allowed (" << check_link(*t.where->check) << ", " << t.where->subject << ")";
        }
        rows << row(
            cell(level_heading(level) << report::element("div", {{"class", "weak"}}, meaning_of(level))),
            number_cell(grouped(t.compared)), number_cell(std::to_string(t.fails)),
            number_cell(percent(median_ratio(report.suite, level))), number_cell(percent(t.ratio)),
            cell(closest));
    }
    return table({"level", "numbers compared", "checks that fail", "half of the quantities used at most",
                  "all used at most", "the number that came closest to its bound"},
                 rows);
}

/// Equations that are not known to hold or to fail, those for the same reason together.
report::Markup unchecked_equations(const SuiteReport& report)
{
    std::map<std::string, std::string> by_reason;
    for (const EquationSummary& e : report.equations) {
        if (e.verdict == EquationVerdict::not_checked || e.verdict == EquationVerdict::no_check) {
            by_reason[e.remark].append(" ").append(number_of(*e.equation));
        }
    }
    report::Markup items;
    for (const auto& [reason, numbers] : by_reason) {
        items << report::element("li", {}, "Equations", numbers, ": ", reason, ".");
    }
    return items;
}

report::Markup unchecked(const SuiteReport& report)
{
    report::Markup items = unchecked_equations(report);
    for (const Reason& reason : not_run(report.suite)) {
        items << report::element("li", {}, reason.who, ": ", reason.why, ".");
    }
    items << report::element(
        "li", {},
        "Whether the paper's model describes an aneurysm in a patient. This report is about the "
        "program: does it compute what the paper's equations say?");
    return report::element("ul", {}, items) << "\n";
}

} // namespace

report::Markup summary_section(const SuiteReport& report)
{
    return report::element(
        "section", {{"id", "summary"}}, banner(report),
        report::element(
            "p", {},
            "The program simulates how an aneurysm, a bulge in an artery, grows and bursts. Blood is many "
            "small particles that push one another (smoothed particle hydrodynamics). The model is that of "
            "one paper (Wu et al., Mathematics 2025, 13(15), 2439, doi 10.3390/math13152439): 28 numbered "
            "equations and an equation of state. For each, this report compares what the program computes "
            "with answers found independently of it: formulas derived by hand, and numbers from the GNU "
            "Scientific Library."),
        figures(report),
        report::element(
            "p", {},
            "No computer meets an answer to the last digit, so a difference is allowed for every number. How "
            "large it may be is never chosen by feel: it follows from a stated reason, such as the number of "
            "roundings behind the number, which is printed beside it. A number that used 30 % of its allowed "
            "difference is well inside; above 100 % is a failure. Some come close because their bounds are "
            "sharp: a solve stops just below its tolerance."),
        report::element("h3", {}, "Which versions of the program"), subjects_table(report),
        report::element("h3", {}, "How exactly"), levels_table(report),
        report::element("h3", {}, "What was not checked"), unchecked(report));
}

} // namespace aneurysm::suite
