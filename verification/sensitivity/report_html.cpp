// SPDX-License-Identifier: Apache-2.0
// The kill matrix as one page that needs no other file.
#include "common/equations.hpp"
#include "output/build_info.hpp"
#include "output/report/style.hpp"
#include "verification/sensitivity/report.hpp"
#include "verification/suite/html.hpp"

#include <algorithm>

namespace aneurysm::sensitivity
{
namespace
{

constexpr std::string_view matrix_style = R"css(
.matrix th.check { writing-mode: vertical-rl; transform: rotate(180deg); font-weight: 500; padding: 0.4rem 0.1rem; }
.matrix td.cell { text-align: center; padding: 0.1rem 0.35rem; white-space: nowrap; }
.red { color: var(--good); font-weight: 700; } .green { color: var(--weak); }
)css";

using Rows = std::vector<const MutantRow*>;

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

bool is_tried(const MutantRow* row, std::size_t column)
{
    return row != nullptr && !row->cells.empty() && row->cells[column] >= Cell::green;
}

/// Checks that any of these mutants was tried with.
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

report::Markup sign(const MutantRow* row, std::size_t column)
{
    const Cell cell = row == nullptr || row->cells.empty() ? Cell::unreached : row->cells[column];
    switch (cell) {
    case Cell::red:
        return report::element("span", {{"class", "red"}}, "✗");
    case Cell::green:
        return report::element("span", {{"class", "green"}}, "○");
    case Cell::untried:
        return report::element("span", {{"class", "weak"}}, "·");
    case Cell::unreached:
        break;
    }
    return " ";
}

report::Markup found_cell(const MutantRow* row)
{
    if (row == nullptr) {
        return suite::cell("–");
    }
    if (!row->survives()) {
        return suite::cell(report::element("span", {{"class", "holds"}}, "found"));
    }
    return suite::cell(row->argument.empty() ? report::element("span", {{"class", "fails"}}, "UNNOTICED")
                                             : report::element("span", {{"class", "warn"}}, "argued"));
}

report::Markup matrix(const SensitivityStudy& study, const std::vector<Pair>& pairs)
{
    const std::vector<std::size_t> columns = columns_of(study, pairs);
    report::Markup head = report::element("th", {}, "planted fault")
                          << report::element("th", {}, "reference") << report::element("th", {}, "cpu");
    for (const std::size_t k : columns) {
        head << report::element("th", {{"class", "check"}}, study.checks[k]->id);
    }
    report::Markup rows;
    for (const Pair& pair : pairs) {
        report::Markup cells = suite::cell(words_of(pair.any().mutant))
                               << found_cell(pair.reference) << found_cell(pair.device);
        for (const std::size_t k : columns) {
            cells << report::element("td", {{"class", "cell"}}, sign(pair.reference, k), " ",
                                     sign(pair.device, k));
        }
        rows << suite::row(cells);
    }
    return report::element("div", {{"class", "wide"}},
                           report::element("table", {{"class", "matrix"}},
                                           report::element("thead", {}, suite::row(head)),
                                           report::element("tbody", {}, rows)))
           << "\n";
}

report::Markup matrices(const SensitivityStudy& study)
{
    report::Markup text =
        report::element("h2", {{"id", "matrix"}}, "Which check finds which fault") << report::element(
            "p", {},
            "One row for each fault, one column for each check that was tried with it; in a cell, first the "
            "reference, then cpu. ✗: the fault turned the check red, as it should. ○: the check stayed "
            "green. ·: not tried, since others had found it. Empty: the check doesn't compute with that "
            "place.");
    for (const MutantTally& t : tallies(study)) {
        if (t.equation != "all") {
            const std::string id =
                t.equation.front() == '(' ? t.equation.substr(1, t.equation.size() - 2) : t.equation;
            text << report::element("h3", {{"id", "eq" + id}}, t.equation, " ", t.title)
                 << matrix(study, pairs_of(study, id));
        }
    }
    return text;
}

report::Markup tally_section(const SensitivityStudy& study)
{
    report::Markup rows;
    for (const MutantTally& t : tallies(study)) {
        rows << suite::row(
            suite::cell(t.equation), suite::cell(t.title), suite::number_cell(std::to_string(t.planted)),
            suite::number_cell(std::to_string(t.found)), suite::number_cell(std::to_string(t.argued)),
            suite::number_cell(std::to_string(t.unexplained())));
    }
    return report::element("h2", {}, "Equation by equation")
           << suite::table({"equation", "title", "planted", "found", "argued", "unnoticed"}, rows);
}

report::Markup sight_section(const SensitivityStudy& study)
{
    if (study.sights.empty()) {
        return {};
    }
    report::Markup rows;
    for (const SightPair& pair : sight_pairs(study)) {
        rows << suite::row(suite::cell(pair.check->id), suite::cell(pair.check->title),
                           suite::cell(smallest_of(pair.reference)), suite::cell(smallest_of(pair.device)));
    }
    return report::element("h2", {}, "How small a fault each check sees")
           << report::element(
                  "p", {},
                  "The smallest relative error of a coefficient in an equation of its own that turns the "
                  "check red, found by bisection to within a factor of 2, and the place of that "
                  "coefficient. Double precision rounds at 1.1e-16.")
           << suite::table({"check", "what it shows", "reference", "cpu"}, rows);
}

report::Markup reasons(const std::string& title,
                       const std::vector<std::pair<std::string, std::string_view>>& items)
{
    if (items.empty()) {
        return {};
    }
    report::Markup list;
    for (const auto& [name, why] : items) {
        list << report::element("dt", {}, name)
             << report::element("dd", {{"class", why.empty() ? "fails" : ""}},
                                why.empty() ? "UNEXPLAINED" : why);
    }
    return report::element("h2", {}, title) << report::element("dl", {}, list);
}

report::Markup remarks(const SensitivityStudy& study)
{
    std::vector<std::pair<std::string, std::string_view>> left_out;
    const std::vector<Unusable> cases = unusable(study);
    for (const Unusable& u : cases) {
        left_out.emplace_back(u.cases, u.why);
    }
    std::vector<std::pair<std::string, std::string_view>> alive;
    for (const MutantRow* r : survivors(study)) {
        alive.emplace_back(name_of(r->mutant).append(": ").append(words_of(r->mutant)), r->argument);
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
    const report::Markup head =
        report::element("head", {},
                        report::Markup::verbatim(
                            "<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
                            "initial-scale=1\">\n"),
                        report::element("title", {}, title),
                        report::element("style", {}, report::Markup::verbatim(report::suite_style),
                                        report::Markup::verbatim(matrix_style)));
    const report::Markup body =
        report::element("h1", {}, title)
        << report::element("p", {{"class", good ? "verdict holds" : "verdict fails"}}, verdict_of(study),
                           ": ", headline(study))
        << report::element(
               "p", {},
               "A check is worth something only if it can fail. Here each formula of the paper was made "
               "wrong on purpose, in one place of one backend at a time, and the suite was run to see "
               "which check notices.")
        << report::element("p", {{"class", "weak"}}, report.selection, ". ", report.date, ", ",
                           report.machine, ", ", std::to_string(report.jobs), " processes, ",
                           std::to_string(static_cast<int>(study.seconds)), " s. Repeat it with ",
                           report::element("code", {}, report.command), ".")
        << tally_section(study) << sight_section(study) << remarks(study) << matrices(study);
    return report::Markup::verbatim("<!DOCTYPE html>\n").text() +
           report::element("html", {{"lang", "en"}}, head, report::element("body", {}, body)).text() + "\n";
}

} // namespace aneurysm::sensitivity
