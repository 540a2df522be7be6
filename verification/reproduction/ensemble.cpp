// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/ensemble.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <cmath>

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

std::vector<Member> steady_runs(RunStore& runs, const std::vector<Scenario>& scenarios)
{
    runs.make(scenarios);
    std::vector<Member> members;
    for (const Scenario& scenario : scenarios) {
        members.push_back({scenario, runs.records(scenario)});
        for (const FrameRecord& record : members.back().records) {
            if (record.ledger.missed > 0) {
                throw Error(scenario.name + ", frame " + std::to_string(record.frame),
                            "the reserve ran dry: the inflow has had holes since",
                            "needed: a larger particles.reserve_fraction");
            }
        }
    }
    return members;
}

std::vector<Member> ensemble(RunStore& runs, const Scenario& scenario, int first_seed, int count)
{
    std::vector<Scenario> scenarios;
    for (int k = 0; k < count; ++k) {
        scenarios.push_back(with_seed(unbreakable(scenario), first_seed + k));
    }
    return steady_runs(runs, scenarios);
}

WallHistory whole_wall(const Scenario& wall, const Member& member)
{
    const Scenario holding = unbreakable(wall);
    WallHistory history = wall_along(holding, member.records);
    for (WallFrame& frame : history.frames) {
        frame.critical_pressure *= wall.rupture.yield_limit_pa / holding.rupture.yield_limit_pa;
    }
    return history;
}

RuptureTimes::RuptureTimes(const Scenario& wall, const Member& member)
{
    const std::vector<WallFrame> frames = whole_wall(wall, member).frames;
    double strongest = 0;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        if (frames[k].phase != Phase::warm_up) {
            const double pressure = member.records[k].wall_load / wall.rupture.conversion_area_m2;
            strongest =
                std::max(strongest, pressure / frames[k].critical_pressure * wall.rupture.yield_limit_pa);
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
    const double middle = mean(values, std::identity());
    const double variance = mean(values, [middle](double v) { return (v - middle) * (v - middle); });
    const auto n = static_cast<double>(values.size());
    const auto [least, most] = std::ranges::minmax(values);
    return {middle, std::sqrt(variance * n / (n - 1)), least, most};
}

double log_rms(const std::vector<double>& found, const std::vector<double>& wanted)
{
    double sum = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        sum += std::pow(std::log(found[k] / wanted[k]), 2);
    }
    return std::sqrt(sum / static_cast<double>(found.size()));
}

} // namespace aneurysm::reproduction
