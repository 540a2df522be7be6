// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/guards.hpp"
#include "common/vessel/geometry.hpp"

#include <algorithm>
#include <cstdint>

namespace aneurysm
{

/// Slices of a vessel across y, the parent artery's axis, from the inlet to the farthest outlet. The first and the last go on
/// beyond.
template <class Real>
struct SlicesT {
    Real low = 0;       ///< where the first begins [m]
    Real thickness = 1; ///< [m]
    std::int32_t count = 0;

    /// The number of the slice that holds y; 0 for no number.
    ANEURYSM_HD std::int32_t at(Real y) const
    {
        const Real c = (y - low) / thickness;
        return c >= 1 ? (c < static_cast<Real>(count) ? static_cast<std::int32_t>(c) : count - 1) : 0;
    }
};
using Slices = SlicesT<double>;

/// Of a vessel with open ends; so thick that a body sees its own slice and one other, for kernels of this support [m].
inline Slices make_slices(const Vessel& vessel, double support)
{
    const double low = vessel.openings()[0].center.y;
    double high = low;
    for (const std::size_t k : {1U, 2U}) {
        high = vessel.is_open(k) ? std::max(high, vessel.openings()[k].center.y) : high;
    }
    const double thickness = guards::slice_supports * support;
    return {low, thickness, std::max(static_cast<std::int32_t>((high - low) / thickness), 1)};
}

} // namespace aneurysm
