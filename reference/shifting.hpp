// SPDX-License-Identifier: Apache-2.0
// Particle shifting: what keeps the particles evenly spread where a shear flow would stir them.
#pragma once

#include "reference/neighbors.hpp"

#include <span>

namespace aneurysm::reference
{

/// Shift of body i against the gradient of its neighbors' number (Lind, Xu, Stansby and Rogers 2012):
///
///     s_i = -beta dx^2 sum_j m_j / rho_0 grad W_ij                                            [m]
///
/// It moves the body and leaves its velocity alone.
inline Vec3 shift(const Bodies& b, std::span<const Neighbor> neighbors, double rho_0, double dx, double beta)
{
    Vec3 gradient;
    for (const Neighbor& n : neighbors) {
        gradient += b.mass[n.j] / rho_0 * n.grad_W;
    }
    return -beta * dx * dx * gradient;
}

} // namespace aneurysm::reference
