// SPDX-License-Identifier: Apache-2.0
// The report's summary, its table of equations, what its words mean, and what a terminal shows.
#include "verification/suite/report.hpp"

#include "output/build_info.hpp"
#include "output/report/markdown.hpp"
#include "output/report/numbers.hpp"
#include "verification/suite/report_checks.hpp"

#include <algorithm>

namespace aneurysm::suite
{
namespace
{

using report::Document;
using report::grouped;
using report::Heading;
using report::joined;
using report::Look;
using report::number;
using report::percent;
using report::prose;
using report::Row;
using report::shown;
using report::Table;
using report::Text;

/// In a word and in a sentence.
struct Outcome {
    const char* word;
    const char* sentence;
};
Outcome outcome_of(const SuiteResult& suite)
{
    return !suite.complete           ? Outcome{"INCOMPLETE", "Interrupted: this report is incomplete."}
           : passed(suite)           ? Outcome{"PASS", "Everything that was checked holds."}
           : tally(suite).holds == 0 ? Outcome{"NOTHING HOLDS", "Nothing holds."}
                                     : Outcome{"FAIL", "Something fails."};
}

/// With which versions it is about.
report::Verdict banner(const SuiteReport& report)
{
    const SuiteResult& suite = report.suite;
    std::string here;
    std::string missing;
    for (const SuiteSubject& s : suite.subjects) {
        std::string& list = s.missing.empty() ? here : missing;
        list.append(list.empty() ? "" : ", ").append(s.subject.name());
    }
    return {{std::string(outcome_of(suite).sentence) + " " + headline(report.equations) + ".",
             passed(suite) ? Look::holds : Look::fails},
            "Checked: " + here + (missing.empty() ? "" : "; not checked: " + missing) + ". " +
                report.selection + ". " + report.date + ", " + shown(suite.seconds) + " s on " +
                report.machine + "."};
}

/// Numbers of those that fail by a check of their own, and of the others.
Text failing_equations(const SuiteReport& report)
{
    std::vector<std::string> own;
    std::vector<std::string> shared;
    for (const EquationSummary& e : report.equations) {
        if (e.verdict == EquationVerdict::fails) {
            (e.only_shared ? shared : own).push_back(number_of(*e.equation));
        }
    }
    Text text;
    if (!own.empty()) {
        text += Text("Equations that fail by a check of their own: ") + joined(own, " ") + ". ";
    }
    if (!shared.empty()) {
        text +=
            Text("Equations that fail only in runs which several equations share, so that another may be the "
                 "reason: ") +
            joined(shared, " ") + ".";
    }
    return text;
}

void add_failures(Document& document, const SuiteReport& report)
{
    const std::vector<Failure> failures = what_fails(report.suite);
    if (failures.empty()) {
        return;
    }
    Table table{{"level", "check", "quantity", number("found"), number("allowed"), number("found/allowed"),
                 "versions"}};
    for (const Failure& f : failures) {
        Row row{
            number_of(f.where->check->level), check_link(*f.where->check), f.what, "", "", "", f.subjects};
        if (f.quantity != nullptr) {
            const Quantity::Worst& w = f.quantity->worst();
            row[3] = shown(w.error);
            row[4] = shown(w.allowed);
            row[5] = Text(shown(w.ratio), Look::fails);
        }
        table.rows.push_back(std::move(row));
    }
    document << Heading{2, "What fails", "failures"}
             << Text("The lowest level comes first: it computes with the least, so look there first.")
             << table << failing_equations(report);
}

void add_introduction(Document& document, const SuiteReport& report)
{
    const auto hold = std::ranges::count(report.equations, EquationVerdict::holds, &EquationSummary::verdict);
    std::int64_t independent = 0;
    std::int64_t between_runs = 0;
    for (const Level level : levels) {
        const std::int64_t compared = tally(report.suite, level).compared;
        independent += level < Level::metamorphic ? compared : 0;
        between_runs += level == Level::metamorphic || level == Level::executors ? compared : 0;
    }
    const Tally all = tally(report.suite);
    document
        << Text(
               "The program simulates how an aneurysm, a bulge in an artery, grows and bursts. Blood is many small "
               "particles that push one another (smoothed particle hydrodynamics). The model is that of one paper "
               "(Wu et al., Mathematics 2025, 13(15), 2439, doi 10.3390/math13152439): 28 numbered equations and "
               "an equation of state. For each, this report compares what the program computes with answers found "
               "independently of it: formulas derived by hand, and numbers from the GNU Scientific Library.")
        << report::List{{Text(std::to_string(hold) + " of " + std::to_string(report.equations.size()),
                              Look::strong) +
                             " equations hold",
                         Text(grouped(independent), Look::strong) +
                             " numbers compared with an answer found independently",
                         Text(grouped(between_runs), Look::strong) +
                             " numbers compared between versions or runs of the program",
                         Text(std::to_string(all.fails), Look::strong) + " checks fail, " +
                             std::to_string(all.holds) + " hold, " + std::to_string(all.limits) +
                             " say what the model doesn't meet yet, " + std::to_string(all.not_run) +
                             " were not run"},
                        true}
        << Text(
               "No computer meets an answer to the last digit, so a difference is allowed for every number. How "
               "large it may be is never chosen by feel: it follows from a stated reason, such as the number of "
               "roundings behind the number, which is printed beside it. A number that used 30 % of its allowed "
               "difference is well inside; above 100 % is a failure. Some come close because their bounds are "
               "sharp: a solve stops just below its tolerance.");
}

Text met_cell(const Accuracy& a)
{
    const bool passes = a.value <= a.allowed();
    return a.met()  ? Text("met", Look::holds)
           : passes ? Text("not met yet", Look::warn)
                    : Text(a.known ? "worse than recorded" : "not met", Look::fails);
}

/// How far the model is from nature, beside what "holds" means.
void add_accuracy(Document& document, const SuiteReport& report)
{
    document
        << Heading{3, "How accurate is the model itself"}
        << Text("An equation that ") + Text("holds", Look::strong) +
               " is implemented as derived. That says nothing of how well all of them together, as particles "
               "of finite size, do what blood does. These numbers say it; smaller is better:";
    Table table{{"the model", number("found"), number("asked: at most"), "", "check"}};
    for (const CheckResult& r : report.suite.results) {
        for (const Accuracy& a : r.accuracies) {
            table.rows.push_back({a.name, shown(a.value), shown(a.asked), met_cell(a), check_link(*r.check)});
        }
    }
    if (table.rows.empty()) {
        document << Text("None of them was measured in this run; aneurysm verify --full measures all.");
        return;
    }
    document
        << table
        << Text(
               "What isn't met yet is a known limit of the model with its recorded number; it fails when it gets "
               "worse.");
}

std::string described(const SuiteSubject& s)
{
    const backends::BackendChoice& choice = s.subject.choice;
    if (choice.backend == Backend::reference) {
        return "the plain version, which reads like the paper; 16 digits";
    }
    return std::string("the fast version on ") +
           (choice.backend == Backend::cpu ? "a processor" : "a graphics card (GPU)") +
           (choice.precision == Precision::double_ ? "; 16 digits" : "; 7 digits");
}

/// The number of a tally that used most of its bound.
Text closest(const Tally& t)
{
    if (t.closest == nullptr) {
        return "nothing compared";
    }
    const Quantity::Worst& w = t.closest->worst();
    return check_link(*t.where->check) + ", " + t.closest->name() + ": " + shown(w.error) + " off, " +
           shown(w.allowed) + " allowed (" + t.where->subject + ")";
}

Table subjects_table(const SuiteReport& report)
{
    Table table{{"version", "what it is", number("checks hold"), number("fail"), number("not met yet"),
                 number("not run"), "where it ran"}};
    const auto add = [&](const std::string& name, const std::string& what, const std::string& device) {
        Tally t;
        for (const CheckResult& r : report.suite.results) {
            if (r.subject == name) {
                t.add(r);
            }
        }
        table.rows.push_back({name, what, std::to_string(t.holds), std::to_string(t.fails),
                              std::to_string(t.limits), std::to_string(t.not_run), device});
    };
    for (const SuiteSubject& s : report.suite.subjects) {
        add(s.subject.name(), described(s), s.missing.empty() ? s.device : "not there, see below");
    }
    add("once", "the independent answers, against one another", "one CPU core");
    return table;
}

Table levels_table(const SuiteReport& report)
{
    Table table{{"level", prose("what it compares"), number("hold"), number("fail"), number("not met yet"),
                 number("not run"), number("compared"), number("half used at most"),
                 number("all used at most"),
                 "the number that came closest to its bound, or exceeded it most"}};
    for (const Level level : levels) {
        const Tally t = tally(report.suite, level);
        table.rows.push_back({heading_of(level), meaning_of(level), std::to_string(t.holds),
                              std::to_string(t.fails), std::to_string(t.limits), std::to_string(t.not_run),
                              grouped(t.compared), percent(t.median()), percent(t.ratio), closest(t)});
    }
    return table;
}

/// Equations that are not known to hold or to fail, those for the same reason together; and what was not run.
report::List unchecked(const SuiteReport& report)
{
    std::vector<Reason> of_equations;
    for (const EquationSummary& e : report.equations) {
        if (e.verdict == EquationVerdict::not_checked || e.verdict == EquationVerdict::no_check) {
            add(of_equations, number_of(*e.equation), e.remark);
        }
    }
    report::List list;
    for (const auto& [numbers, why] : of_equations) {
        list.items.emplace_back("Equations " + numbers + ": " + why + ".");
    }
    for (const auto& [who, why] : not_run(report.suite)) {
        list.items.emplace_back(who + ": " + why + ".");
    }
    list.items.emplace_back(
        "Whether the paper's model describes an aneurysm in a patient. This report is about the "
        "program: does it compute what the paper's equations say?");
    return list;
}

/// What the checks say of an equation for one version.
Text subject_cell(const EquationCell& c)
{
    const std::string remark = c.tally.closest == nullptr ? "" : report::text(closest(c.tally));
    using State = EquationCell::State;
    switch (c.state) {
    case State::holds:
        return report::Span{shown(c.tally.ratio), Look::holds, {}, remark};
    case State::fails:
        return report::Span{c.tally.ratio > 1 ? shown(c.tally.ratio) : "FAILS", Look::fails, {}, remark};
    case State::not_run:
        return report::Span{"not run", Look::weak, {}, c.remark};
    case State::shared:
        return {c.remark, Look::weak};
    case State::equal:
        return report::Span{"equal, " + shown(c.tally.ratio), Look::plain, {}, remark};
    case State::none:
        break;
    }
    return {"–", Look::weak};
}

/// The reason of what was not checked is in the list of that name, too.
Text verdict_cell(const EquationSummary& e)
{
    const Look look = e.verdict == EquationVerdict::holds         ? Look::holds
                      : e.verdict == EquationVerdict::not_checked ? Look::warn
                                                                  : Look::fails;
    const Text verdict = report::Span{std::string(name_of(e.verdict)), look, {}, e.remark};
    return e.only_shared ? verdict + Text(" only in shared runs", Look::weak) : verdict;
}

/// The checks that can show that it holds, with what they compare with; the others in a line each.
Text checks_cell(const SuiteReport& report, const EquationSummary& e)
{
    std::vector<Text> lines;
    std::vector<Text> others;
    std::vector<std::string_view> left_out;
    for (const Check* check : e.checks) {
        if (std::ranges::find(report.suite.results, check, &CheckResult::check) ==
            report.suite.results.end()) {
            left_out.push_back(check->id);
        } else if (is_evidence(*check)) {
            lines.push_back(check_link(*check) + ": " + joined(check->oracles, "; "));
        } else {
            others.push_back(check_link(*check));
        }
    }
    if (!others.empty()) {
        lines.push_back("also: " + joined(others, ", "));
    }
    if (!left_out.empty()) {
        lines.push_back(Text("not chosen: ", Look::weak) + joined(left_out, ", "));
    }
    return joined(lines, "\n");
}

void add_equations(Document& document, const SuiteReport& report)
{
    Table table{{"equation", "title", "verdict"}};
    for (const SuiteSubject& s : report.suite.subjects) {
        table.columns.push_back(number(s.subject.name()));
    }
    table.columns.insert(table.columns.end(), {prose("how the printed formula is read; its use in runs"),
                                               prose("checks: what they compare with")});
    for (const EquationSummary& e : report.equations) {
        Row row{number_of(*e.equation), e.equation->title, verdict_cell(e)};
        std::ranges::transform(e.cells, std::back_inserter(row), subject_cell);
        row.insert(row.end(),
                   {Text(name_of(e.equation->status), Look::strong) + ", " + name_of(e.equation->use) +
                        (e.equation->deviation.empty() ? "" : ": ") + e.equation->deviation,
                    checks_cell(report, e)});
        table.rows.push_back(std::move(row));
    }
    document
        << Heading{2, "Equation by equation", "equations"}
        << Text(
               "The numbers under the versions are the largest measured/allowed of all checks of the equation: "
               "0.3 says that the difference found was 30 % of what is allowed, above 1 is a failure. The "
               "formulas of the fast version are the same functions in 16 and in 7 digits and are checked once "
               "by themselves; its flows are checked in both. “Equal” has no independent answer of its own, "
               "but was compared with the reference. A formula is read as printed, or reconstructed where "
               "signs and fractions are lost in print, or assumed where the paper leaves a rule open. Runs call "
               "the function of an equation that is “used”. No run depends on one that is “nominal”: it leads "
               "to others, or to nothing, and only checks call its function.")
        << table;
}

void add_about(Document& document, const SuiteReport& report)
{
    report::List sources;
    for (const Word& source : words<Source>) {
        sources.items.push_back(Text(source.name, Look::strong) + ": " + source.meaning);
    }
    const output::BuildInfo build = output::build_info();
    document
        << Heading{2, "How to read and repeat this", "about"} << Heading{3, "What “holds” means"}
        << Text(
               "A check holds when it compared at least one number for each of its quantities and every difference "
               "is at most the allowed one. A check that compared nothing, met a value that is no number, or "
               "stopped with an error fails.")
        << Text(
               "An equation holds when no check of it fails and at least one of the levels L0 to L3 that compares "
               "the program with answers found without it holds for at least one version of the program; the "
               "table says for which. Levels L4 and L5, and checks of the answers against one another (“once”), "
               "can make an equation fail but not hold. What was not run is neither. Level L6 is about the model, not about an "
               "equation: what it doesn't meet yet doesn't make this report fail.")
        << Heading{3, "Where allowed differences come from"} << sources
        << Text(
               "In the reasons, u is the largest relative error of one rounding: 2^-53 in double precision, 2^-24 in "
               "single. gamma_n = n u / (1 - n u) is the largest relative error of n roundings in a row (N. J. "
               "Higham, Accuracy and Stability of Numerical Algorithms, lemma 3.1).")
        << Text("A bound is marked ") + Text("loose", Look::warn) +
               " when it is more than 1,000 times what was found, and more than one rounding of the number: it may "
               "be larger than it need be, and hide a small fault."
        << Heading{3, "How to repeat it"} << Text(report.command, Look::code)
        << Text(
               "The same build on the same kind of processor gives the same numbers. The report is written four "
               "times: report.html, report.md, report.json (everything, for programs) and junit.xml.")
        << Text(std::string("Commit ") + build.commit + "; " + build.compiler + " ", Look::weak) +
               Text(build.flags, Look::code) +
               Text("; " + report.machine + "; " + std::to_string(report.threads) + " checks at once; " +
                        report.date + ".",
                    Look::weak);
}

} // namespace

report::Document suite_document(const SuiteReport& report)
{
    Document document{std::string("Verification of aneurysm ") + output::build_info().version};
    document << banner(report);
    add_failures(document, report);
    document << report::Contents{};
    add_introduction(document, report);
    add_accuracy(document, report);
    document << Heading{3, "Which versions of the program"} << subjects_table(report)
             << Heading{3, "How exactly"} << levels_table(report) << Heading{3, "What was not checked"}
             << unchecked(report);
    add_equations(document, report);
    add_checks(document, report);
    add_about(document, report);
    return document;
}

std::string suite_text(const SuiteReport& report)
{
    std::string text = report::text(levels_table(report));
    for (const Failure& f : what_fails(report.suite)) {
        text += "FAILS      " + report::text(check_link(*f.where->check)) + " (" + f.subjects +
                "): " + f.what + "\n";
    }
    for (const CheckResult& r : report.suite.results) {
        if (r.verdict == Verdict::limit) {
            text += "not met    " + report::text(check_link(*r.check)) + ": " + r.message + "\n";
        }
    }
    for (const auto& [who, why] : not_run(report.suite)) {
        text += "not run    " + who + ": " + why + "\n";
    }
    return text + headline(report.equations) + "\n" + outcome_of(report.suite).word + "\n";
}

} // namespace aneurysm::suite
