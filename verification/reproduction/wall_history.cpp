// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/wall_history.hpp"

#include "common/error.hpp"
#include "common/vessel/geometry.hpp"
#include "common/vessel/initial_state.hpp"
#include "reference/bifurcation.hpp"
#include "reference/deform.hpp"

#include <limits>
#include <string>

namespace aneurysm::reproduction
{
namespace
{

AneurysmState first_wall(const Scenario& scenario)
{
    AneurysmState wall;
    wall.radius = initial_radius(scenario);
    wall.thickness = scenario.rupture.thickness_ratio * scenario.vessel.radius_m;
    return wall;
}

/// The end of a frame for a wall that has any room to swing: (28) has no part in what is asked here.
reference::Deform deform_of(const Scenario& scenario, const Vessel& vessel)
{
    return {scenario, vessel.largest_radius(), std::numeric_limits<double>::infinity()};
}

} // namespace

WallHistory wall_along(const Scenario& scenario, std::span<const FrameRecord> records)
{
    const Vessel vessel = reference::vessel_of(scenario);
    const reference::Deform deform = deform_of(scenario, vessel);
    WallHistory history;
    AneurysmState wall = first_wall(scenario);
    for (const FrameRecord& record : records) {
        const double P_c = deform(wall, record.frame, record.wall_load);
        if (wall.radius != record.radius) {
            throw Error("frame " + std::to_string(record.frame),
                        "R is " + std::to_string(wall.radius) + " m along the recorded impacts and " +
                            std::to_string(record.radius) + " m in the run",
                        "needed: a run without rupture, of a scenario that differs in its wall alone");
        }
        history.frames.push_back({wall.radius, wall.thickness, P_c, wall.phase});
        if (!history.developed && wall.radius >= vessel.largest_radius()) {
            history.developed = record.frame;
        }
        if (wall.phase == Phase::ruptured) {
            history.rupture_frame = record.frame;
            break;
        }
    }
    return history;
}

std::vector<WallFrame> wall_under(const Scenario& scenario, double impact, std::int64_t frames)
{
    const Vessel vessel = reference::vessel_of(scenario);
    const reference::Deform deform = deform_of(scenario, vessel);
    std::vector<WallFrame> history;
    AneurysmState wall = first_wall(scenario);
    for (std::int64_t frame = 1; frame <= frames; ++frame) {
        const double P_c = deform(wall, frame, impact);
        history.push_back({wall.radius, wall.thickness, P_c, wall.phase});
    }
    return history;
}

} // namespace aneurysm::reproduction
