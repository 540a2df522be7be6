// SPDX-License-Identifier: Apache-2.0
#include "verification/sensitivity/report.hpp"

#include "common/equations.hpp"
#include "output/build_info.hpp"
#include "output/report/numbers.hpp"
#include "output/report/text.hpp"
#include "verification/suite/summary.hpp"

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

/// Mutants by equation, in the paper's order, with the names of their tallies.
std::vector<std::pair<MutantTally, std::string>> by_equation(const SensitivityStudy& study)
{
    std::map<std::string, MutantTally> by_id;
    for (const MutantRow& row : study.rows) {
        by_id[equation_of(row.mutant.place)].add(row);
    }
    std::vector<std::pair<MutantTally, std::string>> result;
    const auto take = [&](const std::string& id, const std::string& name, std::string_view title) {
        if (const auto found = by_id.find(id); found != by_id.end()) {
            MutantTally tally = found->second;
            tally.equation = name;
            tally.title = title;
            result.emplace_back(tally, id);
        }
    };
    for (const Equation& equation : equations) {
        take(std::string(equation.id), suite::number_of(equation), equation.title);
    }
    take("Fig. 1", "Fig. 1", "collision with the wall");
    take("3.4", "3.4", "particle controller");
    return result;
}

/// A mutant in both backends.
struct Pair {
    const MutantRow* reference = nullptr;
    const MutantRow* device = nullptr;

    const MutantRow& any() const { return reference != nullptr ? *reference : *device; }
};

std::vector<Pair> pairs_of(const SensitivityStudy& study, const std::string& equation)
{
    std::vector<Pair> pairs;
    for (const MutantRow& row : study.rows) {
        if (equation_of(row.mutant.place) != equation) {
            continue;
        }
        const auto same = std::ranges::find_if(pairs, [&](const Pair& p) {
            return p.any().mutant.place == row.mutant.place && p.any().mutant.kind == row.mutant.kind;
        });
        Pair& pair = same == pairs.end() ? pairs.emplace_back() : *same;
        (row.mutant.side == Side::reference ? pair.reference : pair.device) = &row;
    }
    return pairs;
}

Cell cell_of(const MutantRow* row, std::size_t check)
{
    return row == nullptr || row->cells.empty() ? Cell::unreached : row->cells[check];
}

/// Checks that any of these mutants was tried with.
std::vector<std::size_t> columns_of(const SensitivityStudy& study, const std::vector<Pair>& pairs)
{
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k < study.checks.size(); ++k) {
        if (std::ranges::any_of(pairs, [&](const Pair& p) {
                return std::max(cell_of(p.reference, k), cell_of(p.device, k)) >= Cell::green;
            })) {
            columns.push_back(k);
        }
    }
    return columns;
}

Text found_cell(const MutantRow* row)
{
    return row == nullptr          ? Text("–")
           : !row->survives()      ? Text("found", Look::holds)
           : row->argument.empty() ? Text("UNNOTICED", Look::fails)
                                   : Text("argued", Look::warn);
}

Table matrix(const SensitivityStudy& study, const std::vector<Pair>& pairs)
{
    static const std::array<Text, 4> signs{Text(" "), Text("·", Look::weak), Text("○", Look::weak),
                                           Text("✗", Look::strong)}; // by Cell
    const auto sign = [](Cell cell) { return signs.at(static_cast<std::size_t>(cell)); };
    const std::vector<std::size_t> columns = columns_of(study, pairs);
    Table table{{"mutant", "reference", "cpu"}};
    for (const std::size_t k : columns) {
        table.columns.emplace_back(study.checks[k]->id, Column::Kind::sign);
    }
    for (const Pair& pair : pairs) {
        Row row{words_of(pair.any().mutant), found_cell(pair.reference), found_cell(pair.device)};
        for (const std::size_t k : columns) {
            row.push_back(sign(cell_of(pair.reference, k)) + " " + sign(cell_of(pair.device, k)));
        }
        table.rows.push_back(std::move(row));
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
    for (const auto& [t, id] : by_equation(study)) {
        document << Heading{3, t.equation + " " + t.title, "eq" + id} << matrix(study, pairs_of(study, id));
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
std::string smallest_of(const Sight* sight)
{
    return sight == nullptr ? "-"
           : sight->smallest > 0
               ? report::shown(sight->smallest) + " (" + std::string(places.at(sight->place).name) + ")"
           : sight->sees ? "none of its own"
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
        table.rows.back().at(sight.side == Side::reference ? 1 : 2) = smallest_of(&sight);
        previous = &sight;
    }
    document
        << Heading{2, "Smallest relative fault in a coefficient that turns a check red", "sights"}
        << Text("The smallest relative error of a coefficient in an equation of its own that turns the check "
                "red, found by bisection to within a factor of 2, and the place of that coefficient. Double "
                "precision rounds at 1.1e-16.")
        << table;
}

using Reasons = std::vector<std::pair<Text, Text>>;

Text reason(std::string_view why)
{
    return why.empty() ? Text("UNEXPLAINED", Look::fails) : Text(why);
}

/// What needs a reader's attention.
void add_remarks(Document& document, const SensitivityStudy& study)
{
    Reasons left_out;
    for (const Unusable& u : unusable(study)) {
        left_out.emplace_back(u.cases, reason(u.why));
    }
    Reasons alive;
    for (const MutantRow* r : survivors(study)) {
        alive.emplace_back(name_of(r->mutant) + " (" + words_of(r->mutant) + ")", reason(r->argument));
    }
    Reasons unmoved;
    for (const Sight* s : blind(study)) {
        unmoved.emplace_back(std::string(s->check->id) + ", " + name_of(s->side), reason(s->argument));
    }
    for (const auto& [title, items] : {std::pair{"Left out: red, or not run, without any fault", &left_out},
                                       {"Faults that no check finds", &alive},
                                       {"Checks that no fault turns red", &unmoved}}) {
        if (!items->empty()) {
            document << Heading{2, title} << report::Definitions{*items};
        }
    }
    report::List oracles;
    for (const suite::Check* check : without_backend(study)) {
        oracles.items.emplace_back(check->id);
    }
    if (!oracles.items.empty()) {
        document << Heading{2,
                            "Checks of the oracles alone: there is nothing of a backend to plant a fault in"}
                 << oracles;
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

void MutantTally::add(const MutantRow& row)
{
    ++planted;
    found += row.survives() ? 0 : 1;
    argued += row.survives() && !row.argument.empty() ? 1 : 0;
}

std::vector<MutantTally> tallies(const SensitivityStudy& study)
{
    std::vector<MutantTally> result;
    for (const auto& [tally, id] : by_equation(study)) {
        result.push_back(tally);
    }
    MutantTally& all = result.emplace_back();
    all.equation = "all";
    std::ranges::for_each(study.rows, [&](const MutantRow& row) { all.add(row); });
    return result;
}

std::vector<const MutantRow*> survivors(const SensitivityStudy& study)
{
    std::vector<const MutantRow*> rows;
    for (const MutantRow& row : study.rows) {
        if (row.survives()) {
            rows.push_back(&row);
        }
    }
    return rows;
}

std::vector<const Sight*> blind(const SensitivityStudy& study)
{
    std::vector<const Sight*> all;
    for (const Sight& sight : study.sights) {
        if (!sight.sees) {
            all.push_back(&sight);
        }
    }
    return all;
}

std::vector<Unusable> unusable(const SensitivityStudy& study)
{
    std::vector<Unusable> all;
    for (const BaselineCase& c : study.baseline) {
        if (c.result.verdict == suite::Verdict::holds) {
            continue;
        }
        const auto known = std::ranges::find(all, c.result.message, &Unusable::why);
        if (known == all.end()) {
            all.push_back({c.what.name(), c.result.message});
        } else {
            known->cases.append(", ").append(c.what.name());
        }
    }
    return all;
}

std::vector<const suite::Check*> without_backend(const SensitivityStudy& study)
{
    std::vector<const suite::Check*> checks;
    for (const suite::Check* check : study.checks) {
        const bool computes = std::ranges::any_of(study.baseline, [&](const BaselineCase& c) {
            return c.what.check == check && (c.result.verdict != suite::Verdict::holds ||
                                             c.result.reached[0].any() || c.result.reached[1].any());
        });
        if (!computes) {
            checks.push_back(check);
        }
    }
    return checks;
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
