// SPDX-License-Identifier: Apache-2.0
// Section 3.4: the radii of a branching artery, (24).
#pragma once

#include "common/vessel/geometry.hpp"

namespace aneurysm::reference
{

/// Eq. (24)  Murray's law r_0^3 = r_1^3 + r_2^3 for two equal daughters:
///
///     r_1 = r_2 = r_0 / 2^(1/3)                                                               [m]
///
/// The root is written out: compilers and libraries differ in the last
/// bit of cbrt, and every frame would with it.
inline double daughter_radius(double r_0)
{
    constexpr double cube_root_of_2 = 1.259921049894873164767;
    return r_0 / cube_root_of_2;
}

/// The vessel of a scenario, its daughters by (24).
inline Vessel vessel_of(const Scenario& scenario)
{
    return {scenario, daughter_radius(scenario.vessel.radius_m)};
}

} // namespace aneurysm::reference
