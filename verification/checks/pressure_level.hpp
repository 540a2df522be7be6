// SPDX-License-Identifier: Apache-2.0
// Section 3.5, the inlet's velocity (25) and what it makes of the outlets' pressure (26), in words of their own.
#pragma once

#include "common/scenario/scenario.hpp"

#include <vector>

namespace aneurysm::checks
{

/// The smooth start as the cubic between two points of slope 0, in its factors [1].
double ramp(const Scenario& s, double t);
/// (25) after the smooth start; the waveform is no table [m/s].
double inlet_velocity(const Scenario& s, double t);

/// A straight tube that all blood passes, or several alike side by side.
struct Tube {
    double length = 0; ///< [m]
    double radius = 0; ///< [m]
    double share = 1;  ///< the inlet's area over that of all tubes of this part
};

/// What the flow through tubes in a row pulls at the blood at time t: Newton's law and Poiseuille's drop for each, and
/// what turns it to rest, rho v^2 [Pa].
double pull(const Scenario& s, const std::vector<Tube>& tubes, double t);

} // namespace aneurysm::checks
