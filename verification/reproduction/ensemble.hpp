// SPDX-License-Identifier: Apache-2.0
// When the walls of Table 4 rupture in runs that differ by their seed alone.
#pragma once

#include "verification/reproduction/context.hpp"
#include "verification/reproduction/wall_history.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace aneurysm::reproduction
{

/// A row of Table 4.
struct RuptureRow {
    double sigma = 0;         ///< Poisson's ratio
    double phi = 0;           ///< porosity
    std::int64_t paper = 0;   ///< frame of rupture
    std::string name() const; ///< as in "sigma 0.2, phi 0.003"
};
std::vector<RuptureRow> table4_rows(const nlohmann::json& paper);

/// The scenario with the row's wall.
Scenario with_wall(Scenario scenario, const RuptureRow& row);

/// One run without rupture.
struct Member {
    Scenario scenario;
    std::vector<FrameRecord> records;

    int seed() const { return static_cast<int>(scenario.particles.seed); }
};
/// Makes those that are missing. \throws Error where the reserve ran dry, which leaves holes in the inflow
std::vector<Member> steady_runs(RunStore& runs, const std::vector<Scenario>& scenarios);

/// Runs of seeds first, first + 1, ... without rupture. \throws Error, see steady_runs
std::vector<Member> ensemble(RunStore& runs, const Scenario& scenario, int first_seed, int count);

/// A wall along all of a run's impacts, were it whole in spite of them, with its own P_c.
WallHistory whole_wall(const Scenario& wall, const Member& member);

/// Frames of rupture of one wall by its yield limit: (13) is proportional to Y, and (22) and (23) don't know
/// it, so that one walk along the impacts serves for all. To rounding: a frame in which the load comes
/// within 1e-15 of P_c may differ from wall_along's.
class RuptureTimes
{
public:
    RuptureTimes(const Scenario& wall, const Member& member);
    /// \return one more than there are frames when the wall holds
    std::int64_t frame(double yield_limit) const;

private:
    std::vector<double> strongest_; ///< yield limit that the impacts so far would have broken [Pa], by frame
};

/// The mean of what `value` makes of each.
template <class Range, class Value>
double mean(const Range& range, const Value& value)
{
    double sum = 0;
    for (const auto& x : range) {
        sum += static_cast<double>(std::invoke(value, x));
    }
    return sum / static_cast<double>(std::size(range));
}

/// Mean and spread of some numbers.
struct Spread {
    double mean = 0;
    double deviation = 0; ///< standard deviation of a sample
    double least = 0;
    double most = 0;
};
Spread spread(const std::vector<double>& values);

/// sqrt(mean(log(a/b)^2))
double log_rms(const std::vector<double>& found, const std::vector<double>& wanted);

} // namespace aneurysm::reproduction
