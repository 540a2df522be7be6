// SPDX-License-Identifier: Apache-2.0
// What one flow step sees and computes.
#pragma once

#include "common/vessel/geometry.hpp"
#include "common/vessel/sampling.hpp"
#include "reference/incompressible.hpp"

#include <optional>
#include <vector>

namespace aneurysm::reference
{

/// The wall as one flow step sees it.
struct Wall {
    double radius = 0; ///< of the sac, displacement included [m]
    /// Of a wall of this radius; none in the breach.
    WallGhosts ghosts;
    /// Once the wall is ruptured.
    std::optional<Breach> breach;
};

/// What one flow step computes on the way.
struct FlowStep {
    Bodies bodies; ///< velocity: before the blood's own pressure acts
    /// Of each body.
    Neighbors neighbors;
    std::vector<double> rho;        ///< by body, (5) [kg/m^3]
    std::vector<Vec3> F_viscosity;  ///< by particle, (7) [N/m^3]
    std::vector<Vec3> F_outlet;     ///< by particle, (26) [N/m^3]
    std::vector<double> pressure;   ///< by body, as the solve left it [Pa]
    std::vector<Vec3> F_pressure;   ///< by particle [N/m^3]
    std::vector<Vec3> velocity;     ///< by particle, at the end of the step [m/s]
    std::vector<Vec3> shift;        ///< by particle, to where its neighbors lie evenly around it [m]
    std::vector<Vec3> correction;   ///< by particle, what the density moves it by beyond that [m]
    IncompressibleReport corrected; ///< how the solve for it ended
};

} // namespace aneurysm::reference
