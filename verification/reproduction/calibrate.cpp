// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/calibrate.hpp"

#include "common/error.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/reproduction/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aneurysm::reproduction
{
namespace
{

using nlohmann::json;

/// Steps of Y that are tried: 1 %.
constexpr double yield_step = 1.01;

/// A set of values, and how well it does with its best Y.
struct Candidate {
    std::string name;
    json changes; ///< to the scenario
    double yield_limit = 0;
    double error = std::numeric_limits<double>::infinity(); ///< log-RMS over the plan's rows
    std::vector<double> means{};                            ///< frames of rupture, by row
};

/// The paper's rows that the plan fits to.
std::vector<RuptureRow> rows_of(const json& plan, const json& paper)
{
    std::vector<RuptureRow> rows;
    for (const RuptureRow& row : table4_rows(paper)) {
        const bool wanted = std::ranges::any_of(plan.at("rows"), [&row](const json& r) {
            return r.at("sigma") == row.sigma && r.at("phi") == row.phi;
        });
        if (wanted) {
            rows.push_back(row);
        }
    }
    constexpr std::size_t most = 3;
    if (rows.empty() || rows.size() != plan.at("rows").size() || rows.size() > most) {
        throw InputError("data/calibration.json: rows", std::to_string(rows.size()) + " rows of Table 4",
                         "allowed: one to three of its rows; the others are predictions");
    }
    return rows;
}

void fit_yield_limit(Candidate& candidate, const Scenario& scenario, const std::vector<RuptureRow>& rows,
                     const std::vector<Member>& members, const json& range)
{
    std::vector<std::vector<RuptureTimes>> all(rows.size());
    std::vector<double> wanted;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (const Member& member : members) {
            all[k].emplace_back(with_wall(scenario, rows[k]), member);
        }
        wanted.push_back(static_cast<double>(rows[k].paper));
    }
    for (double Y = range.at("from"); Y <= range.at("to"); Y *= yield_step) {
        std::vector<double> means;
        for (const std::vector<RuptureTimes>& row : all) {
            means.push_back(mean(row, [Y](const RuptureTimes& times) { return times.frame(Y); }));
        }
        const double error = log_rms(means, wanted);
        if (error < candidate.error) {
            candidate = {candidate.name, candidate.changes, Y, error, means};
        }
    }
}

} // namespace

Section calibrate(Reproduction& reproduction, const json& plan, std::optional<int> first_seed)
{
    const Scenario scenario = shipped_scenario(plan.at("scenario"));
    const std::vector<RuptureRow> rows = rows_of(plan, reproduction.paper);
    const int first = first_seed.value_or(plan.at("first_seed"));
    const int seeds = plan.at("seeds");
    std::vector<Candidate> candidates;
    for (const auto& [name, changes] : plan.at("candidates").items()) {
        candidates.push_back({name, changes});
    }
    ResultTable table{"Candidates: mean frames of rupture with the best Y", {"candidate", "changes"}, {}};
    for (const RuptureRow& row : rows) {
        table.columns.push_back(row.name() + " (paper: " + std::to_string(row.paper) + ")");
    }
    table.columns.insert(table.columns.end(), {"Y [Pa]", "log-RMS error over these rows"});
    for (Candidate& c : candidates) {
        const Scenario its = changed(scenario, c.changes, c.name, "data/calibration.json: candidates");
        fit_yield_limit(c, its, rows, ensemble(reproduction.runs, its, first, seeds),
                        plan.at("yield_limit_pa"));
        table.rows.push_back({c.name, c.changes.dump()});
        for (const double mean : c.means) {
            table.rows.back().push_back(number(mean));
        }
        table.rows.back().push_back(number(c.yield_limit, 3));
        table.rows.back().push_back(number(c.error, 3));
    }
    const Candidate& best = *std::ranges::min_element(candidates, {}, &Candidate::error);
    Section section{"calibration", "Calibration of the values that the paper doesn't give"};
    section.text.push_back("Seeds " + std::to_string(first) + " to " + std::to_string(first + seeds - 1) +
                           ", which no other item uses. Best: " + best.name + " with " + best.changes.dump() +
                           " and rupture.yield_limit_pa " + number(best.yield_limit, 3) + ".");
    section.tables.push_back(table);
    return section;
}

} // namespace aneurysm::reproduction
