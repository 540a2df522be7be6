// SPDX-License-Identifier: Apache-2.0
// The kill matrix as one page that needs no other file.
#include "common/equations.hpp"
#include "output/build_info.hpp"
#include "verification/sensitivity/report.hpp"
#include "verification/suite_html.hpp"
#include "verification/suite_style.hpp"

#include <algorithm>

namespace aneurysm::verification
{
namespace
{

constexpr std::string_view matrix_style = R"css(
.matrix th.check { writing-mode: vertical-rl; transform: rotate(180deg); font-weight: 500; padding: 0.4rem 0.1rem; }
.matrix td.cell { text-align: center; padding: 0.1rem 0.35rem; white-space: nowrap; }
.red { color: var(--good); font-weight: 700; } .green { color: var(--weak); }
)css";

using Rows = std::vector<const FaultRow*>;

/// A fault in both backends.
struct Pair {
    const FaultRow* reference = nullptr;
    const FaultRow* device = nullptr;

    const FaultRow& any() const { return reference != nullptr ? *reference : *device; }
};

std::vector<Pair> pairs_of(const SensitivityStudy& study, const std::string& equation)
{
    std::vector<Pair> pairs;
    for (const FaultRow& row : study.rows) {
        if (equation_of(row.fault.place) != equation) {
            continue;
        }
        const auto same = std::ranges::find_if(pairs, [&](const Pair& p) {
            return p.any().fault.place == row.fault.place && p.any().fault.kind == row.fault.kind;
        });
        Pair& pair = same == pairs.end() ? pairs.emplace_back() : *same;
        (row.fault.side == Side::reference ? pair.reference : pair.device) = &row;
    }
    return pairs;
}

bool is_tried(const FaultRow* row, std::size_t column)
{
    return row != nullptr && !row->cells.empty() && row->cells[column] >= Cell::green;
}

/// Checks that any of these faults was tried with.
std::vector<std::size_t> columns_of(const SensitivityStudy& study, const std::vector<Pair>& pairs)
{
    std::vector<std::size_t> columns;
    for (std::size_t k = 0; k < study.checks.size(); ++k) {
        if (std::ranges::any_of(
                pairs, [&](const Pair& p) { return is_tried(p.reference, k) || is_tried(p.device, k); })) {
            columns.push_back(k);
        }
    }
    return columns;
}

Markup sign(const FaultRow* row, std::size_t column)
{
    const Cell cell = row == nullptr || row->cells.empty() ? Cell::unreached : row->cells[column];
    switch (cell) {
    case Cell::red:
        return element("span", {{"class", "red"}}, "✗");
    case Cell::green:
        return element("span", {{"class", "green"}}, "○");
    case Cell::untried:
        return element("span", {{"class", "weak"}}, "·");
    case Cell::unreached:
        break;
    }
    return " ";
}

Markup found_cell(const FaultRow* row)
{
    if (row == nullptr) {
        return cell("–");
    }
    if (!row->survives()) {
        return cell(element("span", {{"class", "holds"}}, "found"));
    }
    return cell(row->argument.empty() ? element("span", {{"class", "fails"}}, "UNNOTICED")
                                      : element("span", {{"class", "warn"}}, "argued"));
}

Markup matrix(const SensitivityStudy& study, const std::vector<Pair>& pairs)
{
    const std::vector<std::size_t> columns = columns_of(study, pairs);
    Markup head = element("th", {}, "planted fault")
                  << element("th", {}, "reference") << element("th", {}, "cpu");
    for (const std::size_t k : columns) {
        head << element("th", {{"class", "check"}}, study.checks[k]->id);
    }
    Markup rows;
    for (const Pair& pair : pairs) {
        Markup cells = cell(words_of(pair.any().fault))
                       << found_cell(pair.reference) << found_cell(pair.device);
        for (const std::size_t k : columns) {
            cells << element("td", {{"class", "cell"}}, sign(pair.reference, k), " ", sign(pair.device, k));
        }
        rows << row(cells);
    }
    return element("div", {{"class", "wide"}},
                   element("table", {{"class", "matrix"}}, element("thead", {}, row(head)),
                           element("tbody", {}, rows)))
           << "\n";
}

Markup matrices(const SensitivityStudy& study)
{
    Markup text =
        element("h2", {{"id", "matrix"}}, "Which check finds which fault") << element(
            "p", {},
            "One row for each fault, one column for each check that was tried with it; in a cell, first the "
            "reference, then cpu. ✗: the fault turned the check red, as it should. ○: the check stayed "
            "green. ·: not tried, since others had found it. Empty: the check doesn't compute with that "
            "place.");
    for (const FaultTally& t : tallies(study)) {
        if (t.equation != "all") {
            const std::string id =
                t.equation.front() == '(' ? t.equation.substr(1, t.equation.size() - 2) : t.equation;
            text << element("h3", {{"id", "eq" + id}}, t.equation, " ", t.title)
                 << matrix(study, pairs_of(study, id));
        }
    }
    return text;
}

Markup tally_section(const SensitivityStudy& study)
{
    Markup rows;
    for (const FaultTally& t : tallies(study)) {
        rows << row(cell(t.equation), cell(t.title), number_cell(std::to_string(t.planted)),
                    number_cell(std::to_string(t.found)), number_cell(std::to_string(t.argued)),
                    number_cell(std::to_string(t.unexplained())));
    }
    return element("h2", {}, "Equation by equation")
           << table({"equation", "title", "planted", "found", "argued", "unnoticed"}, rows);
}

Markup sight_section(const SensitivityStudy& study)
{
    if (study.sights.empty()) {
        return {};
    }
    Markup rows;
    for (const SightPair& pair : sight_pairs(study)) {
        rows << row(cell(pair.check->id), cell(pair.check->title), cell(smallest_of(pair.reference)),
                    cell(smallest_of(pair.device)));
    }
    return element("h2", {}, "How small a fault each check sees")
           << element("p", {},
                      "The smallest relative error of a coefficient in an equation of its own that turns the "
                      "check red, found by bisection to within a factor of 2, and the place of that "
                      "coefficient. Double precision rounds at 1.1e-16.")
           << table({"check", "what it shows", "reference", "cpu"}, rows);
}

Markup reasons(const std::string& title, const std::vector<std::pair<std::string, std::string_view>>& items)
{
    if (items.empty()) {
        return {};
    }
    Markup list;
    for (const auto& [name, why] : items) {
        list << element("dt", {}, name)
             << element("dd", {{"class", why.empty() ? "fails" : ""}}, why.empty() ? "UNEXPLAINED" : why);
    }
    return element("h2", {}, title) << element("dl", {}, list);
}

Markup remarks(const SensitivityStudy& study)
{
    std::vector<std::pair<std::string, std::string_view>> left_out;
    const std::vector<Unusable> cases = unusable(study);
    for (const Unusable& u : cases) {
        left_out.emplace_back(u.cases, u.why);
    }
    std::vector<std::pair<std::string, std::string_view>> alive;
    for (const FaultRow* r : survivors(study)) {
        alive.emplace_back(name_of(r->fault).append(": ").append(words_of(r->fault)), r->argument);
    }
    std::vector<std::pair<std::string, std::string_view>> unmoved;
    for (const Sight* s : blind(study)) {
        unmoved.emplace_back(std::string(s->check->id).append(", ").append(name_of(s->side)), s->argument);
    }
    return reasons("Left out: red, or not run, without any fault", left_out)
           << reasons("Faults that no check finds, and why", alive)
           << reasons("Checks that no fault turns red, and why", unmoved);
}

} // namespace

std::string sensitivity_html(const SensitivityReport& report)
{
    const SensitivityStudy& study = report.study;
    const bool good = study.complete && passed(study);
    const std::string title =
        std::string("Sensitivity of the verification of aneurysm ") + output::build_info().version;
    const Markup head = element(
        "head", {},
        Markup::verbatim("<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
                         "initial-scale=1\">\n"),
        element("title", {}, title),
        element("style", {}, Markup::verbatim(suite_style), Markup::verbatim(matrix_style)));
    const Markup body =
        element("h1", {}, title)
        << element("p", {{"class", good ? "verdict holds" : "verdict fails"}}, verdict_of(study), ": ",
                   headline(study))
        << element("p", {},
                   "A check is worth something only if it can fail. Here each formula of the paper was made "
                   "wrong on purpose, in one place of one backend at a time, and the suite was run to see "
                   "which check notices.")
        << element("p", {{"class", "weak"}}, report.selection, ". ", report.date, ", ", report.machine, ", ",
                   std::to_string(report.jobs), " processes, ",
                   std::to_string(static_cast<int>(study.seconds)), " s. Repeat it with ",
                   element("code", {}, report.command), ".")
        << tally_section(study) << sight_section(study) << remarks(study) << matrices(study);
    return Markup::verbatim("<!DOCTYPE html>\n").text() +
           element("html", {{"lang", "en"}}, head, element("body", {}, body)).text() + "\n";
}

} // namespace aneurysm::verification
