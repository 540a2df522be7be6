// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/ensemble.hpp"

#include "common/error.hpp"
#include "verification/reproduction/wall_history.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace aneurysm::reproduction
{

std::string RuptureRow::name() const
{
    return "sigma " + number(sigma) + ", phi " + number(phi);
}

std::vector<RuptureRow> table4_rows(const nlohmann::json& paper)
{
    std::vector<RuptureRow> rows;
    for (const auto& row : paper.at("table4")) {
        rows.push_back({row.at("sigma"), row.at("phi"), row.at("frame")});
    }
    return rows;
}

Scenario with_wall(Scenario scenario, const RuptureRow& row)
{
    scenario.rupture.poisson_ratio = row.sigma;
    scenario.rupture.porosity = row.phi;
    return scenario;
}

std::vector<FrameRecord> steady_records(const RunStore& runs, const Scenario& scenario)
{
    std::vector<FrameRecord> records = runs.records(scenario);
    const auto dry = std::ranges::find_if(records, [](const FrameRecord& r) { return r.ledger.missed > 0; });
    if (dry != records.end()) {
        throw Error(scenario.name + ", frame " + std::to_string(dry->frame),
                    "the reserve ran dry: the inflow has had holes since",
                    "needed: a larger particles.reserve_fraction");
    }
    return records;
}

std::vector<Member> ensemble(RunStore& runs, const Scenario& scenario, int first_seed, int count)
{
    std::vector<Scenario> scenarios;
    scenarios.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
        scenarios.push_back(with_seed(unbreakable(scenario), first_seed + k));
    }
    runs.make(scenarios);
    std::vector<Member> members;
    members.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
        members.push_back({first_seed + k, steady_records(runs, scenarios.at(static_cast<std::size_t>(k)))});
    }
    return members;
}

RuptureTimes::RuptureTimes(const Scenario& wall, const Member& member)
{
    const Scenario holding = unbreakable(wall);
    const WallHistory history = wall_along(holding, member.records);
    double strongest = 0;
    for (std::size_t k = 0; k < history.frames.size(); ++k) {
        if (history.frames[k].phase != Phase::warm_up) {
            const double pressure = member.records[k].impact_force / wall.rupture.conversion_area_m2;
            strongest = std::max(strongest, pressure / history.frames[k].critical_pressure *
                                                holding.rupture.yield_limit_pa);
        }
        strongest_.push_back(strongest);
    }
}

std::int64_t RuptureTimes::frame(double yield_limit) const
{
    return 1 + (std::ranges::upper_bound(strongest_, yield_limit) - strongest_.begin());
}

Spread spread(const std::vector<double>& values)
{
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (const double v : values) {
        squares += (v - mean) * (v - mean);
    }
    const auto [least, most] = std::ranges::minmax(values);
    return {mean, std::sqrt(squares / (n - 1)), least, most};
}

double log_rms(const std::vector<double>& found, const std::vector<double>& wanted)
{
    double sum = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const double error = std::log(found[k] / wanted[k]);
        sum += error * error;
    }
    return std::sqrt(sum / static_cast<double>(found.size()));
}

} // namespace aneurysm::reproduction
