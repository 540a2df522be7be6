// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vessel/geometry.hpp"
#include "common/vessel/sampling.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace aneurysm::output
{

/// A box along the axes. [m]
struct Box {
    Vec3 low;
    Vec3 high;

    void include(const Vec3& x, double margin = 0);
};

/// Everything between the open ends, with the sac at its radius R.
Box box_of(const Vessel& vessel, double R);

/// The wall of a frame.
struct WallShape {
    double radius = 0; ///< R + u, of the sac [m]
    std::optional<Breach> breach;
};

/// A sac of this radius, R + u, with a breach at its top once it is ruptured. [m]
WallShape wall_shape(const Vessel& vessel, double radius, bool ruptured, double breach_radius);

/// Triangles; corner numbers in the order in which the corners go around counterclockwise, seen from outside.
struct WallMesh {
    std::vector<Vec3> corners; ///< [m]
    std::vector<std::array<std::int64_t, 3>> triangles;
};

/// The zero of the signed distance, cut at the planes of the open ends, with a hole where the breach is: no
/// point of a triangle is in it. `cell`: distance between the points of the grid that it is looked for on [m].
/// The corners lie on the wall to a millionth of it, those of a cut on the straight line between two such.
WallMesh wall_mesh(const Vessel& vessel, const WallShape& shape, double cell);

/// Corners around an open end, counterclockwise seen from outside [m].
std::vector<Vec3> rim_of(const Opening& opening);
/// Corners around the breach, on the wall, counterclockwise seen from outside [m]. \pre there is a breach
std::vector<Vec3> rim_of_breach(const Vessel& vessel, const WallShape& shape);

/// What the cells of a wall's file are.
enum class WallPart : std::uint8_t {
    wall,     ///< triangles
    breach,   ///< a disc
    inlet,    ///< a disc
    outlet_1, ///< a disc
    outlet_2, ///< a disc
};

/// Wall, breach and open ends as VTKHDF 1.0, in the array `part` numbered as WallPart. \throws Error
void write_wall(const std::filesystem::path& file, const Vessel& vessel, const WallShape& shape);

} // namespace aneurysm::output
