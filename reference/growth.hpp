// SPDX-License-Identifier: Apache-2.0
// Section 3.3: how the aneurysm grows, (17)-(23).
#pragma once

#include "common/wall.hpp"

#include <algorithm>

namespace aneurysm::reference
{

/// Eq. (17)  What accelerates the wall: blood against tissue fluid and fibers.
///
///     F_T = F_B - F_F - F_P                                                                   [N]
inline double net_wall_force(double F_B, double F_F, double F_P)
{
    return F_B - F_F - F_P;
}

/// Eq. (18)  The tissue fluid resists the wall's outward speed u_t:
///
///     F_F = rho_F a c u_t                                                                     [N]
inline double tissue_force(const WallTissue& w, double u_t)
{
    return w.rho_F * w.a * w.c * u_t;
}

/// Eq. (19)  Elastin and collagen resist; the paper sets each stress to the strain epsilon:
///
///     F_P = K_E A_E sigma_E + K_C A_C sigma_C,   sigma_E = sigma_C = epsilon                  [N]
inline double fiber_force(const WallTissue& w, double epsilon)
{
    const double sigma = epsilon;
    return w.K_E * w.A_E * sigma + w.K_C * w.A_C * sigma;
}

/// Eq. (20)  Strain of the wall:
///
///     epsilon = dR / R                                                                        [1]
inline double strain(double dR, double R)
{
    return dR / R;
}

/// Eq. (21)  Growth of the radius in one frame, (17)-(20) with F_T = m dR/dt^2 and u_t = dR/dt:
///
///     dR = F_B / ( m/dt^2 + rho_F a c / dt + (K_E A_E + K_C A_C) / R )                        [m]
inline double radius_increment(const WallTissue& w, double F_B, double R, double dt)
{
    return F_B / (w.m / (dt * dt) + w.rho_F * w.a * w.c / dt + (w.K_E * w.A_E + w.K_C * w.A_C) / R);
}

/// Eq. (22)  Thickness of the wall after a growth by dR, the explicit Euler step of (9):
///
///     h' = h - h/R sigma dR                                                                   [m]
inline double thickness_growing(double h, double R, double sigma, double dR)
{
    return h - h / R * sigma * dR;
}

/// Eq. (23)  Thickness once the aneurysm is fully developed; dR does not exceed `largest`:
///
///     h' = h (1 - alpha min(dR, largest))                                                     [m]
///
/// alpha has the unit 1/m, which Table 1 leaves out.
inline double thickness_developed(double h, double alpha, double dR, double largest)
{
    return h * (1 - alpha * std::min(largest, dR));
}

} // namespace aneurysm::reference
