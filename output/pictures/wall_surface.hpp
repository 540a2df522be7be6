// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/wall_mesh.hpp"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace aneurysm::pictures
{

using output::WallShape;

/// Triangles of the wall.
struct WallSurface {
    vtkSmartPointer<vtkPolyData> wall; ///< with normals that point outwards
    vtkSmartPointer<vtkPolyData> rim;  ///< lines around the breach; empty without
    vtkSmartPointer<vtkPolyData> ends; ///< lines around the open ends
};

/// The wall of a frame for VTK. `cell`: as in output::wall_mesh [m]
WallSurface wall_surface(const Vessel& vessel, const WallShape& shape, double cell);

/// How far x lies outside the blood's part of the vessel, wall and open ends taken together [m].
double outside(const Vessel& vessel, const WallShape& shape, const Vec3& x);

} // namespace aneurysm::pictures
