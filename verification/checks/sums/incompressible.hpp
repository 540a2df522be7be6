// SPDX-License-Identifier: Apache-2.0
// What the checks of the pressure solve (3) have in common.
#pragma once

#include "verification/checks/box.hpp"

namespace aneurysm::checks
{

inline constexpr double omega = 0.4;
inline constexpr double never = 1e11; ///< a tolerance that stops nothing [1/s]

/// A box in which nothing but the pressure acts, and no density is corrected.
inline Scenario solve_scenario(KernelName kernel)
{
    Scenario s = box_scenario(kernel);
    s.fluid.viscosity_pa_s = 0;
    s.pressure.relaxation = omega;
    s.pressure.density_correction = 0;
    s.pressure.max_tolerance_per_s = never;
    return s;
}

} // namespace aneurysm::checks
