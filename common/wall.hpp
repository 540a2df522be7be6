// SPDX-License-Identifier: Apache-2.0
// Plain data of the vessel's wall and of what hits it, for all that have its equations; no formula.
#pragma once

#include "common/scenario/scenario.hpp"

namespace aneurysm
{

/// The constants of (18), (19) and (21); Table 1 gives all but the mass.
struct WallTissue {
    double rho_F = 0; ///< density of the tissue fluid [kg/m^3]
    double a = 0;     ///< area of tissue fluid that acts on the aneurysm [m^2]
    double c = 0;     ///< wave speed [m/s]
    double K_E = 0;   ///< elastin [N/m]
    double A_E = 0;   ///< elastin [m^2]
    double K_C = 0;   ///< collagen [N/m]
    double A_C = 0;   ///< collagen [m^2]
    double m = 0;     ///< mass of the aneurysm's wall [kg]
};

inline WallTissue wall_tissue(const Scenario& scenario)
{
    const auto& g = scenario.growth;
    return {.rho_F = g.tissue_density_kg_m3,
            .a = g.tissue_area_m2,
            .c = g.wave_speed_m_s,
            .K_E = g.elastin_stiffness_n_m,
            .A_E = g.elastin_area_m2,
            .K_C = g.collagen_stiffness_n_m,
            .A_C = g.collagen_area_m2,
            .m = g.wall_mass_kg};
}

/// The impact of (16) and who made it.
struct Impact {
    double force = 0;           ///< F_b [N]; 0 when S is empty: nothing touches the wall
    std::int64_t particle = -1; ///< the member of S that attains it; -1 when S is empty
};

/// What is left of a particle's state after the collision of Fig. 1.
struct Collision {
    Vec3 position; ///< [m]
    Vec3 velocity; ///< [m/s]
};

/// The wall of (28): how far it is displaced, and how fast it moves.
struct ElasticWall {
    double u = 0; ///< [m]
    double v = 0; ///< du/dt [m/s]
};

} // namespace aneurysm
