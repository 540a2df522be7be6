// SPDX-License-Identifier: Apache-2.0
// Section 3.3: how the aneurysm grows, (17)-(23). Once a frame, in double whatever the flow's precision.
#pragma once

#include "common/host_device.hpp"
#include "common/wall.hpp"

namespace aneurysm::device
{

/// Eq. (17)  F_T = F_B - F_F - F_P                                                             [N]
ANEURYSM_HD inline double net_wall_force(double F_B, double F_F, double F_P)
{
    return F_B - F_F - F_P;
}

/// Eq. (18)  The tissue fluid resists the wall's outward speed u_t: F_F = rho_F a c u_t        [N]
ANEURYSM_HD inline double tissue_force(const WallTissue& w, double u_t)
{
    return w.rho_F * w.a * w.c * u_t;
}

/// Eq. (19)  Elastin and collagen resist: F_P = (K_E A_E + K_C A_C) epsilon                    [N]
ANEURYSM_HD inline double fiber_force(const WallTissue& w, double epsilon)
{
    return (w.K_E * w.A_E + w.K_C * w.A_C) * epsilon;
}

/// Eq. (20)  Strain of the wall: epsilon = dR / R                                              [1]
ANEURYSM_HD inline double strain(double dR, double R)
{
    return dR / R;
}

/// Eq. (21)  Growth of the radius in one frame: (17) with F_T = m dR/dt^2, u_t = dR/dt and (20) is linear in
/// dR. For dR = 1 m the forces (18), (19) and the inertia add up to the denominator:
///
///     dR = F_B / ( m/dt^2 + rho_F a c / dt + (K_E A_E + K_C A_C) / R )                        [m]
ANEURYSM_HD inline double radius_increment(const WallTissue& w, double F_B, double R, double dt)
{
    const double inertia = w.m / (dt * dt);
    const double resistance = tissue_force(w, 1 / dt) + fiber_force(w, strain(1, R));
    return F_B / (inertia + resistance);
}

/// Eq. (22)  Thickness of the wall after a growth by dR: h' = h - h/R sigma dR                 [m]
ANEURYSM_HD inline double thickness_growing(double h, double R, double sigma, double dR)
{
    return h - h / R * sigma * dR;
}

/// Eq. (23)  Thickness once the aneurysm is fully developed: h' = h (1 - alpha min(dR, largest)) [m]
ANEURYSM_HD inline double thickness_developed(double h, double alpha, double dR, double largest)
{
    const double taken = dR < largest ? dR : largest;
    return h * (1 - alpha * taken);
}

} // namespace aneurysm::device
