// SPDX-License-Identifier: Apache-2.0
// Particle shifting: what keeps the particles evenly spread where a shear flow would stir them.
#pragma once

#include "common/guards.hpp"
#include "cuda/fields.hpp"

namespace aneurysm::device
{

/// Shift against the gradient of the neighbors' number (Lind, Xu, Stansby and Rogers 2012); `gradient`: sum of m_j grad
/// W_ij:
///
///     s_i = -beta dx^2 sum_j m_j / rho_0 grad W_ij                                            [m]
template <class Real>
ANEURYSM_HD Vec3T<Real> shift(const Vec3T<Real>& gradient, Real rho_0, Real dx, Real beta)
{
    return -beta * dx * dx / rho_0 * gradient;
}

/// Of all blood that flows freely; beside a void evenly spread would mean apart.
template <class Real>
struct ShiftBlood {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const
    {
        const bool has_no_void = f.body_velocity[i].w >= static_cast<Real>(guards::void_density) * f.c.rho_0;
        const Vec3T<Real> gradient = f.blood_gradient[i].vector() + f.wall_gradient[i].vector();
        const Vec3T<Real> s = shift(gradient, f.c.rho_0, f.c.dx, f.c.shifting);
        const bool moves = f.kind[f.order[i]] == Kind::fluid && has_no_void;
        f.shift[i] = row(moves ? s : Vec3T<Real>{}, Real(0));
    }
};

} // namespace aneurysm::device
