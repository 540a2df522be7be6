// SPDX-License-Identifier: Apache-2.0
// The page's sections on single checks, and the ledger of all bounds.
#include "output/report/svg_plot.hpp"
#include "verification/suite/html.hpp"

#include <algorithm>
#include <utility>

namespace aneurysm::suite
{
namespace
{

using Results = std::vector<const CheckResult*>; ///< of one check, by subject

/// Each check with its results, in their order.
std::vector<Results> by_check(const SuiteReport& report)
{
    std::vector<Results> groups;
    for (const CheckResult& r : report.suite.results) {
        if (groups.empty() || groups.back().front()->check != r.check) {
            groups.emplace_back();
        }
        groups.back().push_back(&r);
    }
    return groups;
}

const Quantity* find(const CheckResult& r, const std::string& name)
{
    const auto found = std::ranges::find(r.quantities, name, &Quantity::name);
    return found == r.quantities.end() ? nullptr : &*found;
}

/// The quantities of all subjects, each name once.
std::vector<const Quantity*> quantities_of(const Results& results)
{
    std::vector<const Quantity*> all;
    for (const CheckResult* r : results) {
        for (const Quantity& q : r->quantities) {
            if (std::ranges::none_of(all, [&](const Quantity* p) { return p->name() == q.name(); })) {
                all.push_back(&q);
            }
        }
    }
    return all;
}

using Texts = std::vector<std::pair<std::string, std::string>>; ///< each with the subjects that say it

void collect(Texts& texts, const std::string& text, const std::string& subject)
{
    const auto known = std::ranges::find(texts, text, &Texts::value_type::first);
    if (known == texts.end()) {
        texts.emplace_back(text, subject);
    } else {
        known->second.append(", ").append(subject);
    }
}

/// How the bound follows; where subjects have different ones, each with its subjects.
report::Markup derivations(const Results& results, const Quantity& quantity)
{
    Texts texts;
    for (const CheckResult* r : results) {
        if (const Quantity* q = find(*r, quantity.name())) {
            collect(texts, q->derivation(), r->subject);
        }
    }
    if (texts.size() == 1) {
        return texts.front().first;
    }
    report::Markup result;
    for (const auto& [derivation, subjects] : texts) {
        result << report::element("div", {}, subjects, ": ", derivation);
    }
    return result;
}

report::Markup ratio_cell(const Quantity* q)
{
    if (q == nullptr || q->compared() == 0) {
        return cell(report::element("span", {{"class", "weak"}}, q == nullptr ? "–" : "nothing compared"));
    }
    report::Markup content = mark(q->passed() ? Verdict::holds : Verdict::fails, shown(q->worst().ratio));
    if (q->loose()) {
        content << report::element("span", {{"class", "warn"}}, " loose");
    }
    return number_cell(content);
}

report::Markup quantity_table(const Results& all)
{
    Results results; // of those that compared something
    std::vector<std::string> head{"quantity", "bound from", "how the bound follows"};
    for (const CheckResult* r : all) {
        if (!r->quantities.empty()) {
            results.push_back(r);
            head.push_back(r->subject);
        }
    }
    report::Markup rows;
    for (const Quantity* q : quantities_of(results)) {
        report::Markup cells;
        for (const CheckResult* r : results) {
            cells << ratio_cell(find(*r, q->name()));
        }
        rows << row(cell(q->name()), cell(name_of(q->source())),
                    report::element("td", {{"class", "long"}}, derivations(results, *q)), cells);
    }
    return rows.empty() ? report::Markup() : table(head, rows);
}

/// Subjects with the same verdict for the same reason share a line.
report::Markup verdicts(const Results& results, const SuiteReport& report)
{
    const auto is_missing = [&](const std::string& reason) {
        return std::ranges::any_of(report.suite.subjects, [&](const SuiteSubject& s) {
            return !reason.empty() && s.missing == reason;
        });
    };
    report::Markup items;
    for (auto r = results.begin(); r != results.end();) {
        const CheckResult& first = **r;
        report::Markup who;
        for (; r != results.end() && (*r)->verdict == first.verdict && (*r)->message == first.message; ++r) {
            who << (who.empty() ? "" : ", ") << (*r)->subject;
            if (first.verdict != Verdict::not_run) {
                who << report::element("span", {{"class", "weak"}}, " (", shown((*r)->seconds), " s)");
            }
        }
        const std::string why = is_missing(first.message) ? ", not there"
                                : first.message.empty()   ? ""
                                                          : ": " + first.message;
        items << report::element("li", {}, mark(first.verdict), " for ", who, why);
    }
    return report::element("ul", {}, items);
}

/// Subjects with the same note share a line.
report::Markup notes(const Results& results)
{
    Texts texts;
    for (const CheckResult* r : results) {
        for (const Note& n : r->notes) {
            const std::string remark = n.remark.empty() ? "" : "; " + n.remark;
            collect(texts, n.name + " = " + shown_value(n.value) + remark, r->subject);
        }
    }
    report::Markup items;
    for (const auto& [text, subjects] : texts) {
        items << report::element("li", {}, text,
                                 report::element("span", {{"class", "weak"}}, " (", subjects, ")"));
    }
    return items.empty() ? report::Markup()
                         : report::element("p", {}, "Worth reading, without a bound:")
                               << report::element("ul", {}, items);
}

report::Markup plots(const Results& results)
{
    report::Markup figures;
    for (const CheckResult* r : results) {
        for (const Plot& plot : r->plots) {
            figures << report::element("figure", {},
                                       report::element("figcaption", {}, plot.title, " (", r->subject, ")"),
                                       report::svg(plot))
                    << "\n";
        }
    }
    return figures;
}

report::Markup equations_of(const Check& check)
{
    report::Markup text;
    for (const Equation& e : equations) {
        if (std::ranges::find(check.equations, e.id) != check.equations.end()) {
            text << (text.empty() ? "" : ", ") << number_of(e) << " " << e.title;
        }
    }
    return text.empty() ? report::Markup("no equation by itself") : text;
}

report::Markup check_article(const Results& results, const SuiteReport& report)
{
    const Check& check = *results.front()->check;
    return report::element("article", {{"id", "check-" + std::string(check.id)}},
                           report::element("h4", {}, report::element("code", {}, check.id), " ", check.title),
                           report::element("p", {}, "Looks at ", equations_of(check),
                                           ". Compared with: ", joined(check.oracles, "; "), "."),
                           verdicts(results, report), quantity_table(results), notes(results), plots(results))
           << "\n";
}

/// A line of the ledger.
report::Markup ledger_row(const CheckResult& r, const Quantity& q)
{
    const Quantity::Worst& w = q.worst();
    const report::Markup remark =
        q.passed() ? (q.loose() ? report::element("span", {{"class", "warn"}}, "loose") : report::Markup())
                   : report::element("span", {{"class", "fails"}},
                                     std::to_string(q.failed()) + " not within the bound");
    return row(cell(r.subject), number_cell(std::to_string(q.compared())), number_cell(shown_value(w.value)),
               number_cell(shown_value(w.expected)), number_cell(shown(w.error)),
               number_cell(shown(w.allowed)), number_cell(shown(w.ratio)), cell(w.where), cell(remark));
}

report::Markup ledger_rows(const Results& results)
{
    report::Markup rows;
    for (const Quantity* q : quantities_of(results)) {
        rows << report::element(
            "tr", {{"class", "group"}},
            report::element("th", {{"colspan", "9"}}, check_link(*results.front()->check), ": ", q->name(),
                            report::element("div", {{"class", "weak"}}, "bound from ", name_of(q->source()),
                                            ": ", derivations(results, *q))));
        for (const CheckResult* r : results) {
            if (const Quantity* own = find(*r, q->name())) {
                rows << ledger_row(*r, *own);
            }
        }
        rows << "\n";
    }
    return rows;
}

} // namespace

report::Markup checks_section(const SuiteReport& report)
{
    report::Markup result = report::element("h2", {}, "Check by check");
    const Check* previous = nullptr;
    for (const Results& results : by_check(report)) {
        const Check* check = results.front()->check;
        if (previous == nullptr || previous->level != check->level) {
            result << report::element("h3", {}, level_heading(check->level))
                   << report::element("p", {}, meaning_of(check->level));
        }
        previous = check;
        result << check_article(results, report);
    }
    return report::element("section", {{"id", "checks"}}, result);
}

report::Markup ledger_section(const SuiteReport& report)
{
    report::Markup rows;
    for (const Results& results : by_check(report)) {
        rows << ledger_rows(results);
    }
    return report::element(
        "section", {{"id", "ledger"}}, report::element("h2", {}, "Every number and its bound"),
        report::element(
            "p", {},
            "For each quantity the instance that came closest to its bound, or exceeded it most: what "
            "the program computed, what was expected, the difference measured and the one allowed."),
        table({"version", "compared", "computed", "expected", "measured", "allowed", "measured/allowed",
               "where", ""},
              rows));
}

} // namespace aneurysm::suite
