// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/wall_surface.hpp"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace aneurysm::pictures
{
namespace
{

vtkSmartPointer<vtkPolyData> to_vtk(const output::WallMesh& mesh, const Vessel& vessel, double R)
{
    const vtkNew<vtkPoints> points;
    const vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    for (const Vec3& x : mesh.corners) {
        points->InsertNextPoint(x.x, x.y, x.z);
        const Vec3 gradient = vessel.wall(x, R).gradient;
        const Vec3 n = gradient / length(gradient);
        normals->InsertNextTuple3(n.x, n.y, n.z);
    }
    const vtkNew<vtkCellArray> triangles;
    for (const auto& [a, b, c] : mesh.triangles) {
        triangles->InsertNextCell({a, b, c});
    }
    auto surface = vtkSmartPointer<vtkPolyData>::New();
    surface->SetPoints(points);
    surface->SetPolys(triangles);
    surface->GetPointData()->SetNormals(normals);
    return surface;
}

/// Adds a closed line.
void add_circle(vtkPolyData& lines, const std::vector<Vec3>& corners)
{
    const vtkNew<vtkIdList> numbers;
    for (const Vec3& x : corners) {
        numbers->InsertNextId(lines.GetPoints()->InsertNextPoint(x.x, x.y, x.z));
    }
    numbers->InsertNextId(numbers->GetId(0));
    lines.GetLines()->InsertNextCell(numbers);
}

vtkSmartPointer<vtkPolyData> no_lines()
{
    auto lines = vtkSmartPointer<vtkPolyData>::New();
    lines->SetPoints(vtkNew<vtkPoints>());
    lines->SetLines(vtkNew<vtkCellArray>());
    return lines;
}

} // namespace

double outside(const Vessel& vessel, const WallShape& shape, const Vec3& x)
{
    return std::max(vessel.wall(x, shape.radius).value, vessel.openings()[vessel.nearest_tube(x)].beyond(x));
}

WallSurface wall_surface(const Vessel& vessel, const WallShape& shape, double cell)
{
    const output::WallMesh mesh = output::wall_mesh(vessel, shape, cell);
    WallSurface surface{to_vtk(mesh, vessel, shape.radius), no_lines(), no_lines()};
    if (shape.breach) {
        add_circle(*surface.rim, output::rim_of_breach(vessel, shape));
    }
    for (std::size_t k = 0; k < 3; ++k) {
        if (vessel.is_open(k)) {
            add_circle(*surface.ends, output::rim_of(vessel.openings()[k]));
        }
    }
    return surface;
}

} // namespace aneurysm::pictures
