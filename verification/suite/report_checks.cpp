// SPDX-License-Identifier: Apache-2.0
#include "verification/suite/report_checks.hpp"

#include "output/report/numbers.hpp"

#include <algorithm>
#include <span>

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

using Results = std::span<const CheckResult>; ///< of one check, by subject

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

/// Texts, each with the subjects that say it.
class Sayings
{
public:
    void add(const std::string& text, const std::string& subject)
    {
        const auto known = std::ranges::find(all_, text, &Saying::text);
        if (known == all_.end()) {
            all_.push_back({text, subject});
        } else {
            known->subjects.append(", ").append(subject);
        }
    }

    struct Saying {
        std::string text;
        std::string subjects;
    };
    const std::vector<Saying>& all() const { return all_; }

private:
    std::vector<Saying> all_;
};

/// What a quantity is, and how its bound follows; where subjects have different ones, each with its subjects.
Text quantity_heading(Results results, const Quantity& quantity)
{
    Sayings derivations;
    for (const CheckResult& r : results) {
        if (const Quantity* q = find(r, quantity.name())) {
            derivations.add(q->derivation(), r.subject);
        }
    }
    std::string why;
    for (const Sayings::Saying& s : derivations.all()) {
        why += (why.empty() ? "" : "\n") + (derivations.all().size() > 1 ? s.subjects + ": " : "") + s.text;
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

Text mark(Verdict verdict)
{
    return {name_of(verdict), verdict == Verdict::holds   ? Look::holds
                              : verdict == Verdict::fails ? Look::fails
                                                          : Look::weak};
}

/// Subjects with the same verdict for the same reason share a line.
report::List verdicts(Results results, const SuiteReport& report)
{
    const auto is_missing = [&](const std::string& reason) {
        return std::ranges::any_of(report.suite.subjects, [&](const SuiteSubject& s) {
            return !reason.empty() && s.missing == reason;
        });
    };
    report::List list;
    for (auto r = results.begin(); r != results.end();) {
        const CheckResult& first = *r;
        Text who;
        for (; r != results.end() && r->verdict == first.verdict && r->message == first.message; ++r) {
            who += (who.empty() ? "" : ", ") + r->subject;
            if (first.verdict != Verdict::not_run) {
                who += Text(" (" + shown(r->seconds) + " s)", Look::weak);
            }
        }
        const std::string why = is_missing(first.message) ? ", not there"
                                : first.message.empty()   ? ""
                                                          : ": " + first.message;
        list.items.push_back(mark(first.verdict) + " for " + who + why);
    }
    return list;
}

/// Subjects with the same note share a line.
report::List notes(Results results)
{
    Sayings all;
    for (const CheckResult& r : results) {
        for (const Note& n : r.notes) {
            all.add(n.name + " = " + shown_value(n.value) + (n.remark.empty() ? "" : "; " + n.remark),
                    r.subject);
        }
    }
    report::List list;
    for (const Sayings::Saying& s : all.all()) {
        list.items.push_back(Text(s.text) + Text(" (" + s.subjects + ")", Look::weak));
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

std::string level_heading(Level level)
{
    return "L" + std::to_string(static_cast<int>(level)) + ": " + std::string(name_of(level));
}

void add_checks(report::Document& document, const SuiteReport& report)
{
    document
        << Heading{2, "Check by check, every number and its bound", "checks"}
        << Text(
               "For each quantity and version the instance that came closest to its bound, or exceeded it most: "
               "what the program computed, what was expected, the difference measured and the one allowed. What "
               "u and gamma_n are stands under the last heading.");
    const Results all = report.suite.results;
    const Check* previous = nullptr;
    for (std::size_t from = 0; from < all.size();) {
        const Check* check = all[from].check;
        std::size_t end = from;
        while (end < all.size() && all[end].check == check) {
            ++end;
        }
        if (previous == nullptr || previous->level != check->level) {
            document << Heading{3, level_heading(check->level)}
                     << Text(words<Level>.at(static_cast<std::size_t>(check->level)).meaning);
        }
        previous = check;
        add_check(document, all.subspan(from, end - from), report);
        from = end;
    }
}

} // namespace aneurysm::suite
