// SPDX-License-Identifier: Apache-2.0
// What is near through the seams of a periodic box; 0 stands for the edge of a box that isn't periodic.
#pragma once

#include "cuda/executor/lanes.hpp"

namespace aneurysm::device
{

/// d, a difference of two places within the box, or the shorter way through a seam.
template <class Number, class Real>
ANEURYSM_INLINE Number shortest(const Number& d, Real edge)
{
    const Number L(edge);
    const Number half(Real(0.5) * edge);
    return select(half < d, d - L, select(d < Number(0) - half, d + L, d));
}
template <class Number, class Real>
ANEURYSM_INLINE Vec3T<Number> shortest(const Vec3T<Number>& d, const Vec3T<Real>& edges)
{
    return {shortest(d.x, edges.x), shortest(d.y, edges.y), shortest(d.z, edges.z)};
}

/// Cell c of a direction, or the one that it is beyond a seam; -1 beyond the first that isn't periodic.
ANEURYSM_INLINE Index through_seam(Index c, Index cells)
{
    return c < 0 ? c + cells : cells > 0 && c >= cells ? c - cells : c;
}

} // namespace aneurysm::device
