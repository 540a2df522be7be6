// SPDX-License-Identifier: Apache-2.0
#include "verification/suite/report_checks.hpp"

#include "output/report/numbers.hpp"

#include <algorithm>

namespace aneurysm::suite
{
namespace
{

using report::Heading;
using report::joined;
using report::Look;
using report::number;
using report::Row;
using report::shown;
using report::shown_value;
using report::Table;
using report::Text;

const Quantity* find(const CheckResult& r, const std::string& name)
{
    const auto found = std::ranges::find(r.quantities, name, &Quantity::name);
    return found == r.quantities.end() ? nullptr : &*found;
}

/// The quantities of all subjects, each name once.
std::vector<const Quantity*> quantities_of(Results results)
{
    std::vector<const Quantity*> all;
    for (const CheckResult& r : results) {
        for (const Quantity& q : r.quantities) {
            if (std::ranges::none_of(all, [&](const Quantity* p) { return p->name() == q.name(); })) {
                all.push_back(&q);
            }
        }
    }
    return all;
}

/// What a quantity is, and how its bound follows; where subjects have different ones, each with its subjects.
Text quantity_heading(Results results, const Quantity& quantity)
{
    std::vector<Reason> derivations;
    for (const CheckResult& r : results) {
        if (const Quantity* q = find(r, quantity.name())) {
            add(derivations, r.subject, q->derivation());
        }
    }
    std::string why;
    for (const Reason& d : derivations) {
        why += (why.empty() ? "" : "\n") + (derivations.size() > 1 ? d.who + ": " : "") + d.why;
    }
    return Text(quantity.name() + "\n") +
           Text("bound from " + std::string(name_of(quantity.source())) + ": " + why, Look::weak);
}

/// The instance that came closest to its bound, or exceeded it most.
Row quantity_row(const CheckResult& r, const Quantity& q)
{
    if (q.compared() == 0) {
        return {r.subject, Text("nothing compared", Look::fails), "0", "", "", "", "", ""};
    }
    const Quantity::Worst& w = q.worst();
    Text ratio(shown(w.ratio), q.passed() ? Look::holds : Look::fails);
    if (!q.passed()) {
        ratio += " (" + std::to_string(q.failed()) + " not within the bound)";
    } else if (q.loose()) {
        ratio += Text(" loose", Look::warn);
    }
    return {r.subject,
            ratio,
            std::to_string(q.compared()),
            shown_value(w.value),
            shown_value(w.expected),
            shown(w.error),
            shown(w.allowed),
            w.where};
}

Table quantity_table(Results results)
{
    Table table{{"version", number("measured/allowed"), number("compared"), number("computed"),
                 number("expected"), number("measured"), number("allowed"), "where"}};
    for (const Quantity* quantity : quantities_of(results)) {
        table.rows.push_back({quantity_heading(results, *quantity)});
        for (const CheckResult& r : results) {
            if (const Quantity* q = find(r, quantity->name())) {
                table.rows.push_back(quantity_row(r, *q));
            }
        }
    }
    return table;
}

/// Subjects with the same verdict for the same reason share a line.
report::List verdicts(Results results, const SuiteReport& report)
{
    report::List list;
    for (const auto& [verdict, look] : {std::pair(Verdict::holds, Look::holds),
                                        {Verdict::fails, Look::fails},
                                        {Verdict::limit, Look::warn},
                                        {Verdict::not_run, Look::weak}}) {
        std::vector<Reason> reasons;
        for (const CheckResult& r : results) {
            if (r.verdict == verdict) {
                const std::string time = verdict == Verdict::not_run ? "" : " (" + shown(r.seconds) + " s)";
                add(reasons, r.subject + time, r.message);
            }
        }
        for (const auto& [who, why] : reasons) {
            const bool missing =
                !why.empty() && std::ranges::find(report.suite.subjects, why, &SuiteSubject::missing) !=
                                    report.suite.subjects.end();
            const std::string reason = missing ? ", not there" : why.empty() ? "" : ": " + why;
            list.items.push_back(Text(name_of(verdict), look) + " for " + who + reason);
        }
    }
    return list;
}

/// Subjects with the same note share a line.
report::List notes(Results results)
{
    std::vector<Reason> all;
    for (const CheckResult& r : results) {
        for (const Note& n : r.notes) {
            add(all, r.subject,
                n.name + " = " + shown_value(n.value) + (n.remark.empty() ? "" : "; " + n.remark));
        }
    }
    report::List list;
    for (const auto& [who, note] : all) {
        list.items.push_back(Text(note) + Text(" (" + who + ")", Look::weak));
    }
    return list;
}

std::string equations_of(const Check& check)
{
    std::string text;
    for (const Equation& e : equations) {
        if (std::ranges::find(check.equations, e.id) != check.equations.end()) {
            text += (text.empty() ? "" : ", ") + number_of(e) + " " + std::string(e.title);
        }
    }
    return text.empty() ? "no equation by itself" : text;
}

void add_check(report::Document& document, Results results, const SuiteReport& report)
{
    const Check& check = *results.front().check;
    document << Heading{4, Text(check.id, Look::code) + " " + check.title, "check-" + std::string(check.id)}
             << Text("Looks at " + equations_of(check) + ". Compared with: ") + joined(check.oracles, "; ") +
                    "."
             << verdicts(results, report);
    if (const Table table = quantity_table(results); !table.rows.empty()) {
        document << table;
    }
    if (const report::List list = notes(results); !list.items.empty()) {
        document << Text("Worth reading, without a bound:") << list;
    }
    for (const CheckResult& r : results) {
        for (Plot plot : r.plots) {
            plot.title += " (" + r.subject + ")";
            document << plot;
        }
    }
}

} // namespace

report::Text check_link(const Check& check)
{
    return report::Span{std::string(check.id), Look::plain, "check-" + std::string(check.id)};
}

std::string heading_of(Level level)
{
    return number_of(level) + ": " + std::string(name_of(level));
}

void add_checks(report::Document& document, const SuiteReport& report)
{
    document
        << Heading{2, "Check by check, every number and its bound", "checks"}
        << Text(
               "For each quantity and version the instance that came closest to its bound, or exceeded it most: "
               "what the program computed, what was expected, the difference measured and the one allowed. What "
               "u and gamma_n are stands under the last heading.");
    std::optional<Level> previous;
    for (const Results& results : by_check(report.suite)) {
        const Level level = results[0].check->level;
        if (level != previous) {
            document << Heading{3, heading_of(level)} << Text(meaning_of(level));
            previous = level;
        }
        add_check(document, results, report);
    }
}

} // namespace aneurysm::suite
