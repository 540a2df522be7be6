// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vessel/geometry.hpp"
#include "common/vessel/sampling.hpp"
#include "output/pictures/grid.hpp"

#include <optional>

namespace aneurysm::pictures
{

/// The wall of a frame.
struct WallShape {
    double radius = 0; ///< R + u, of the sac [m]
    std::optional<Breach> breach;
};

/// Triangles of the wall.
struct WallSurface {
    vtkSmartPointer<vtkPolyData> wall; ///< with normals that point outwards
    vtkSmartPointer<vtkPolyData> rim;  ///< lines around the breach; empty without
    vtkSmartPointer<vtkPolyData> ends; ///< lines around the open ends
};

/// The zero of the signed distance, cut at the planes of the open ends, with a hole where the breach is: no
/// point of a triangle is in it. `cell`: distance between the grid's points [m]; the corners of the triangles
/// lie on the wall to a small part of cell^2 over the radius of curvature.
WallSurface wall_surface(const Vessel& vessel, const WallShape& shape, double cell);

/// How far x lies outside the blood's part of the vessel, wall and open ends taken together [m].
double outside(const Vessel& vessel, const WallShape& shape, const Vec3& x);

/// Everything between the open ends, with the sac at its radius R.
Box box_of(const Vessel& vessel, double R);

} // namespace aneurysm::pictures
