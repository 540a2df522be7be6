// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "reference/growth.hpp"

#include <cstdint>

namespace aneurysm::reference
{

/// What a frame's impact does to the sac: growth, the elastic wall (28) and, when its load exceeds P_c, rupture. Of the
/// flow it needs F_b, as the wall's load, alone, so that along the impacts of one run it says when another wall had ruptured.
class Deform
{
public:
    /// `largest_radius`: of the developed sac [m]; `spacing`: of the particles, more than which the elastic
    /// wall mustn't move [m]. Only for a scenario with a sac.
    Deform(const Scenario& scenario, double largest_radius, double spacing);

    /// Ends a frame with the load F [N], see wall_load.
    /// \return P_c, (13) [Pa]
    /// \throws SimulationError when the elastic wall moves too far
    double operator()(AneurysmState& aneurysm, std::int64_t frame, double F) const;

private:
    void grow(AneurysmState& aneurysm, double F) const;
    void move_wall(AneurysmState& aneurysm, std::int64_t frame, double F) const;

    Scenario scenario_;
    WallTissue tissue_;
    double largest_radius_;
    double spacing_;
};

} // namespace aneurysm::reference
