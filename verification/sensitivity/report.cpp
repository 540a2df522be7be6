// SPDX-License-Identifier: Apache-2.0
#include "verification/sensitivity/report.hpp"

#include "common/equations.hpp"
#include "output/build_info.hpp"
#include "output/report/markdown.hpp"
#include "output/report/numbers.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace aneurysm::sensitivity
{
namespace
{

using report::Column;
using report::Document;
using report::Heading;
using report::Look;
using report::number;
using report::prose;
using report::Row;
using report::Table;
using report::Text;

/// The same mutant in both backends, by Side; null: not in this one.
using Pair = std::array<const MutantRow*, 2>;

std::map<std::pair<Place, Kind>, Pair> pairs_of(const SensitivityStudy& study, const std::string& equation)
{
    std::map<std::pair<Place, Kind>, Pair> pairs;
    for (const MutantRow& row : study.rows) {
        const auto& [place, side, kind, size] = row.mutant;
        if (equation_of(place) == equation) {
            pairs[{place, kind}].at(static_cast<std::size_t>(side)) = &row;
        }
    }
    return pairs;
}

Cell cell_of(const MutantRow* row, std::size_t check)
{
    return row == nullptr || row->cells.empty() ? Cell::unreached : row->cells[check];
}

Text found_cell(const MutantRow* row)
{
    return row == nullptr          ? Text("–")
           : !row->survives()      ? Text("found", Look::holds)
           : row->argument.empty() ? Text("UNNOTICED", Look::fails)
                                   : Text("argued", Look::warn);
}

/// Its columns are the checks that any of these mutants was tried with.
Table matrix(const SensitivityStudy& study, const std::string& equation)
{
    static const std::array<Text, 4> signs{Text(" "), Text("·", Look::weak), Text("○", Look::weak),
                                           Text("✗", Look::strong)}; // by Cell
    Table table{{"mutant", "reference", "cpu"}};
    const auto pairs = pairs_of(study, equation);
    for (const auto& [what, pair] : pairs) {
        const auto& [place, kind] = what;
        table.rows.push_back(
            {words_of({.place = place, .kind = kind}), found_cell(pair[0]), found_cell(pair[1])});
    }
    for (std::size_t k = 0; k < study.checks.size(); ++k) {
        if (std::ranges::all_of(pairs, [&](const auto& p) {
                return std::max(cell_of(p.second[0], k), cell_of(p.second[1], k)) < Cell::green;
            })) {
            continue;
        }
        table.columns.emplace_back(study.checks[k]->id, Column::Kind::sign);
        auto row = table.rows.begin();
        for (const auto& [what, pair] : pairs) {
            const auto sign = [&](const MutantRow* r) {
                return signs.at(static_cast<std::size_t>(cell_of(r, k)));
            };
            (row++)->push_back(sign(pair[0]) + " " + sign(pair[1]));
        }
    }
    return table;
}

void add_matrices(Document& document, const SensitivityStudy& study)
{
    document
        << Heading{2, "Which check finds which fault", "matrix"}
        << Text(
               "One row for each fault, one column for each check that was tried with it; in a cell, first the "
               "reference, then cpu. ✗: the fault turned the check red, as it should. ○: the check stayed "
               "green. ·: not tried, since others had found it. Empty: the check doesn't compute with that "
               "place.");
    for (const MutantTally& t : tallies(study)) {
        if (!t.id.empty()) {
            document << Heading{3, t.equation + " " + std::string(t.title), "eq" + t.id}
                     << matrix(study, t.id);
        }
    }
}

void add_tallies(Document& document, const SensitivityStudy& study)
{
    Table table{
        {"equation", "title", number("planted"), number("found"), number("argued"), number("unexplained")}};
    for (const MutantTally& t : tallies(study)) {
        table.rows.push_back({t.equation, t.title, std::to_string(t.planted), std::to_string(t.found),
                              std::to_string(t.argued), std::to_string(t.unexplained())});
    }
    document << Heading{2, "Equation by equation", "equations"} << table;
}

/// "1.1e-15 (eq13_radius)"
std::string smallest_of(const Sight& sight)
{
    return sight.smallest > 0
               ? report::shown(sight.smallest) + " (" + std::string(places.at(sight.place).name) + ")"
           : sight.sees ? "none of its own"
                        : "blind";
}

void add_sights(Document& document, const SensitivityStudy& study)
{
    if (study.sights.empty()) {
        return;
    }
    Table table{{"check", "reference", "cpu", prose("what it shows")}};
    const Sight* previous = nullptr;
    for (const Sight& sight : study.sights) {
        if (previous == nullptr || previous->check != sight.check) {
            table.rows.push_back({sight.check->id, "-", "-", sight.check->title});
        }
        table.rows.back().at(sight.side == Side::reference ? 1 : 2) = smallest_of(sight);
        previous = &sight;
    }
    document
        << Heading{2, "Smallest relative fault in a coefficient that turns a check red", "sights"}
        << Text("The smallest relative error of a coefficient in an equation of its own that turns the check "
                "red, found by bisection to within a factor of 2, and the place of that coefficient. Double "
                "precision rounds at 1.1e-16.")
        << table;
}

Text reason(const std::string& what, std::string_view why)
{
    return Text(what, Look::strong) + ": " + (why.empty() ? Text("UNEXPLAINED", Look::fails) : Text(why));
}

/// Whether it computes with a backend, or only with oracles.
bool computes(const SensitivityStudy& study, const suite::Check* check)
{
    return std::ranges::any_of(study.baseline, [&](const BaselineCase& c) {
        return c.what.check == check && (c.result.verdict != suite::Verdict::holds ||
                                         c.result.reached[0].any() || c.result.reached[1].any());
    });
}

/// What needs a reader's attention.
void add_remarks(Document& document, const SensitivityStudy& study)
{
    report::List left_out;
    for (const auto& [cases, why] : unusable(study)) {
        left_out.items.push_back(reason(cases, why));
    }
    report::List alive;
    for (const MutantRow& row : study.rows) {
        if (row.survives()) {
            alive.items.push_back(
                reason(name_of(row.mutant) + " (" + words_of(row.mutant) + ")", row.argument));
        }
    }
    report::List unmoved;
    for (const Sight& s : study.sights) {
        if (!s.sees) {
            unmoved.items.push_back(reason(std::string(s.check->id) + ", " + name_of(s.side), s.argument));
        }
    }
    report::List oracles;
    for (const suite::Check* check : study.checks) {
        if (!computes(study, check)) {
            oracles.items.emplace_back(check->id);
        }
    }
    for (const auto& [title, list] :
         {std::pair{"Left out: red, or not run, without any fault", &left_out},
          {"Faults that no check finds", &alive},
          {"Checks that no fault turns red", &unmoved},
          {"Checks of the oracles alone: there is nothing of a backend to plant a fault in", &oracles}}) {
        if (!list->items.empty()) {
            document << Heading{2, title} << *list;
        }
    }
}

void add_mutants(Document& document, const SensitivityStudy& study)
{
    Table table{{"fault", "what", "first found by"}};
    for (const MutantRow& row : study.rows) {
        table.rows.push_back({name_of(row.mutant), words_of(row.mutant), row.survives() ? "-" : row.finder});
    }
    document << Heading{2, "All faults", "faults"} << table;
}

Document summary(const SensitivityReport& report)
{
    const SensitivityStudy& study = report.study;
    const bool good = study.complete && passed(study);
    Document document{std::string("Sensitivity of the verification suite of aneurysm ") +
                      output::build_info().version};
    document
        << report::Verdict{{verdict_of(study) + ": " + headline(study), good ? Look::holds : Look::fails}}
        << Text(
               "A check is worth something only if it can fail. Here each formula of the paper was made wrong "
               "on purpose, in one place of one backend at a time, and the suite was run to see which check "
               "notices.")
        << Text(report.selection + ". " + report.date + ", " + report.machine + ", " +
                std::to_string(report.jobs) + " processes, " + report::printed("%.0f", study.seconds) +
                " s. Repeat it with ") +
               Text(report.command, Look::code) + ".";
    add_tallies(document, study);
    add_sights(document, study);
    add_remarks(document, study);
    return document;
}

} // namespace

std::vector<MutantTally> tallies(const SensitivityStudy& study)
{
    std::vector<MutantTally> all;
    for (const Equation& e : equations) {
        all.push_back({std::string(e.id), suite::number_of(e), e.title});
    }
    all.insert(all.end(), {{"Fig. 1", "Fig. 1", "collision with the wall"},
                           {"3.4", "3.4", "particle controller"},
                           {"", "all"}});
    for (MutantTally& t : all) {
        for (const MutantRow& row : study.rows) {
            if (t.id.empty() || t.id == equation_of(row.mutant.place)) {
                ++t.planted;
                t.found += row.survives() ? 0 : 1;
                t.argued += row.survives() && !row.argument.empty() ? 1 : 0;
            }
        }
    }
    std::erase_if(all, [](const MutantTally& t) { return t.planted == 0 && !t.id.empty(); });
    return all;
}

std::vector<suite::Reason> unusable(const SensitivityStudy& study)
{
    std::vector<suite::Reason> all;
    for (const BaselineCase& c : study.baseline) {
        if (c.result.verdict != suite::Verdict::holds) {
            add(all, c.what.name(), c.result.message);
        }
    }
    return all;
}

std::string verdict_of(const SensitivityStudy& study)
{
    return !study.complete ? "INCOMPLETE" : passed(study) ? "PASS" : "FAIL";
}

std::string headline(const SensitivityStudy& study)
{
    const MutantTally all = tallies(study).back();
    const auto planted_in = [&](Side side) {
        return std::to_string(
            std::ranges::count(study.rows, side, [](const MutantRow& r) { return r.mutant.side; }));
    };
    const auto also = [](int n, const std::string& what) {
        return n > 0 ? ", " + std::to_string(n) + what : std::string();
    };
    return std::to_string(all.planted) + " faults planted, one at a time: " + planted_in(Side::reference) +
           " in the reference, " + planted_in(Side::device) + " in cpu. " + std::to_string(all.found) +
           " turned a check red" + also(all.argued, " can't, for a reason given") +
           also(all.unexplained(), " went unnoticed") + ".";
}

std::string sensitivity_text(const SensitivityReport& report)
{
    return report::text(summary(report));
}

report::Document sensitivity_document(const SensitivityReport& report, bool with_matrix)
{
    Document document = summary(report);
    if (with_matrix) {
        add_matrices(document, report.study);
    }
    add_mutants(document, report.study);
    return document;
}

} // namespace aneurysm::sensitivity
