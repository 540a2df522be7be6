// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario/scenario.hpp"

#include <algorithm>

namespace aneurysm
{

/// Particle spacing that the count leads to, from the volume of the tubes without their overlap [m]; within
/// 10 % of the spacing that sampling finds.
double estimated_spacing(const Scenario& scenario);

/// Largest magnitude of (25), the mean velocity over the inlet [m/s].
double largest_inlet_velocity(const Scenario& scenario);

/// Largest speed of blood in the inlet: that of a parabola is twice its mean [m/s].
double largest_inlet_speed(const Scenario& scenario);

/// Longest stable flow steps (a frame over its substeps) at the particle spacing dx [s].
struct StepLimits {
    /// the fastest particles, 2.5 times the inlet's in the jets of the junction, move half a spacing
    double convective = 0;
    double viscous = 0;  ///< 0.125 h^2 rho_0 / mu (Morris et al. 1997)
    double acoustic = 0; ///< 0.4 h / sqrt(kappa), only of model `eos`; else infinite

    double smallest() const { return std::min({convective, viscous, acoustic}); }
};
StepLimits step_limits(const Scenario& scenario, double dx);

} // namespace aneurysm
