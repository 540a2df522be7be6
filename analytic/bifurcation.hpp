// SPDX-License-Identifier: Apache-2.0
// Oracles of section 3.4, (24): Murray's law, from what it minimizes.
#pragma once

#include "analytic/gsl.hpp"

namespace aneurysm::analytic
{

/// What a vessel costs: pumping Q through it and keeping its blood alive.
struct VesselCost {
    double mu = 0; ///< viscosity of blood [Pa s]
    double b = 0;  ///< metabolic cost of blood [W/m^3]
};

/// Eq. (24)  Cost per length 8 mu Q^2/(pi r^4) + b pi r^2 [W/m].
double vessel_cost(const VesselCost& cost, double Q, double r);

/// Eq. (24)  The radius that minimizes it for the flow Q, as the root of its derivative [m].
Estimate cheapest_radius(const VesselCost& cost, double Q);

/// Eq. (24)  The same radius by a search for the minimum (gsl_multimin); flat there, so the error is about
/// sqrt(u) r [m].
Estimate cheapest_radius_by_search(const VesselCost& cost, double Q);

/// Eq. (24)  Radius of each of n equal branches, r_0^gamma = n r^gamma [m]; gamma = 3 is Murray's. Relative
/// error 8 u.
double branch_radius(double r_0, int n, double gamma);

} // namespace aneurysm::analytic
