// SPDX-License-Identifier: Apache-2.0
// Rounding of what goes through the seams of a periodic box. Its edges L are rounded once to the candidate's
// precision; differences of places on both sides of a seam round at the size of an edge.
#pragma once

#include "reference/neighbors.hpp"
#include "verification/bounds/inexact.hpp"

namespace aneurysm::bounds
{

/// A difference of two places, or the shorter way through a seam.
inline InexactVec shortest(const InexactVec& d, const reference::Period& box)
{
    const auto component = [](const Inexact& x, double L) {
        if (!(L > 0) || std::abs(x.value) <= L / 2) {
            return x;
        }
        return x.value > 0 ? x - rounded(L) : x + rounded(L);
    };
    return {component(d.x, box.x), component(d.y, box.y), component(d.z, box.z)};
}

/// What it adds to the difference of two exact places, beyond one rounding of the result: 0 where the way
/// leads through no seam. The difference rounds to a number of at most L, L itself is rounded, the result is
/// at most L: 3 L [in U].
inline double seam_error(const Vec3& a, const Vec3& b, const reference::Period& box)
{
    return 3 * length(reference::difference(a, b, box) - (a - b));
}

/// What a place x at the end of a way of this length [m] may have been rounded by on its way through a seam:
/// the place beyond it, the edge and their difference, each at most L. The two sides may have ended on
/// different sides of it; what is computed from their places then rounds differently, by no more than the way
/// through the seam.
inline double seam_error(const Vec3& x, double way, const reference::Period& box)
{
    const auto edge = [&](double place, double L) { return place < way || place > L - way ? L : 0; };
    return (3 + 3) * length(Vec3{edge(x.x, box.x), edge(x.y, box.y), edge(x.z, box.z)});
}

} // namespace aneurysm::bounds
