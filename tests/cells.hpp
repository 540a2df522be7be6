// SPDX-License-Identifier: Apache-2.0
// The cells of a vessel's lattice, for the tests that look at each of them.
#pragma once

#include "tests/vessels.hpp"

#include <optional>

namespace aneurysm::test
{

/// Which multiples of dx a cell is from the first one beside the parent's axis, above the inlet plane.
using Cell = std::array<long, 3>;

inline Vec3 center_of(const Vessel& vessel, double dx, const Cell& c)
{
    const Vec3 steps{static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])};
    return vessel.openings()[0].center + dx * (steps + Vec3{0.5, 0.5, 0.5});
}

/// The cell that x is the center of; none when it is off by more than rounding.
inline std::optional<Cell> cell_of(const Vessel& vessel, double dx, const Vec3& x)
{
    const Vec3 steps = (x - vessel.openings()[0].center) / dx - Vec3{0.5, 0.5, 0.5};
    const Cell cell{std::lround(steps.x), std::lround(steps.y), std::lround(steps.z)};
    // 8 roundings of a coordinate
    const bool is_center = distance(center_of(vessel, dx, cell), x) <= rounding(8) * vessel_extent;
    return is_center ? std::optional(cell) : std::nullopt;
}

/// Calls visit(cell) for every cell of a box around a vessel: `extent` to both sides, twice that up. [m]
template <class Visit>
void for_each_cell(double dx, double extent, const Visit& visit)
{
    const auto n = static_cast<long>(std::ceil(extent / dx));
    for (long i = -n; i < n; ++i) {
        for (long j = -n / 2; j < 2 * n; ++j) {
            for (long k = -n / 2; k < n / 2; ++k) {
                visit(Cell{i, j, k});
            }
        }
    }
}

} // namespace aneurysm::test
