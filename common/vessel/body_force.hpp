// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/portable_math.hpp"
#include "common/scenario/scenario.hpp"

#include <numbers>

namespace aneurysm
{

/// What g of (1) is multiplied with at time t: 1, or sin(2 pi t/T)
/// where the scenario gives the force a cycle T.
inline double body_force_factor(const Scenario& scenario, double t)
{
    const double T = scenario.fluid.gravity_cycle_s;
    return T > 0 ? sine(2 * std::numbers::pi * t / T) : 1;
}

} // namespace aneurysm
