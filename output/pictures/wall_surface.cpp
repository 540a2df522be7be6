// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/wall_surface.hpp"

#include <vtkClipPolyData.h>
#include <vtkDoubleArray.h>
#include <vtkFeatureEdges.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStripper.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace aneurysm::pictures
{
namespace
{

Vec3 corner(vtkPolyData& surface, vtkIdType i)
{
    std::array<double, 3> x{};
    surface.GetPoint(i, x.data());
    return {x[0], x[1], x[2]};
}

/// Moves the corners along the gradient onto the wall, which leaves the square of their distance, and gives
/// them its normals.
void put_on_wall(vtkPolyData& surface, const Vessel& vessel, double R)
{
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(surface.GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
        Vec3 x = corner(surface, i);
        Distance d = vessel.wall(x, R);
        for (int step = 0; step < 2; ++step) {
            x -= d.value / dot(d.gradient, d.gradient) * d.gradient;
            d = vessel.wall(x, R);
        }
        surface.GetPoints()->SetPoint(i, x.x, x.y, x.z);
        const Vec3 n = d.gradient / length(d.gradient);
        normals->SetTuple3(i, n.x, n.y, n.z);
    }
    surface.GetPointData()->SetNormals(normals);
}

/// The part of a surface where the function is negative.
vtkSmartPointer<vtkPolyData> cut(vtkPolyData& surface, const std::function<double(const Vec3&)>& function)
{
    vtkNew<vtkDoubleArray> values;
    values->SetNumberOfTuples(surface.GetNumberOfPoints());
    for (vtkIdType i = 0; i < surface.GetNumberOfPoints(); ++i) {
        values->SetValue(i, function(corner(surface, i)));
    }
    surface.GetPointData()->SetScalars(values);
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(&surface);
    clip->SetValue(0);
    clip->InsideOutOn();
    clip->Update();
    vtkSmartPointer<vtkPolyData> rest = clip->GetOutput();
    rest->GetPointData()->SetScalars(nullptr);
    return rest;
}

/// Positive inside a hole that is wider than the breach by as much as the middle of an edge, or of a
/// triangle, can lie nearer to its axis than the ends.
double inside_hole(const Breach& breach, double cell, const Vec3& x)
{
    const double diagonal = std::sqrt(3.0) * cell;
    const double radius = std::sqrt(breach.radius * breach.radius + diagonal * diagonal);
    const Vec3 d = x - breach.center;
    return d.y > -breach.radius ? radius - std::sqrt(d.x * d.x + d.z * d.z) : -radius;
}

/// The lines at which the surface ends.
vtkSmartPointer<vtkPolyData> edges_of(vtkPolyData& surface)
{
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(&surface);
    edges->BoundaryEdgesOn();
    edges->FeatureEdgesOff();
    edges->NonManifoldEdgesOff();
    edges->ManifoldEdgesOff();
    edges->ColoringOff();
    vtkNew<vtkStripper> lines;
    lines->SetInputConnection(edges->GetOutputPort());
    lines->SetMaximumLength(100000);
    lines->JoinContiguousSegmentsOn();
    lines->Update();
    return lines->GetOutput();
}

/// The lines that are near to the breach, or those that aren't.
vtkSmartPointer<vtkPolyData> lines_at(vtkPolyData& all, const std::optional<Breach>& breach, bool near)
{
    auto some = vtkSmartPointer<vtkPolyData>::New();
    some->SetPoints(all.GetPoints());
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkIdList> line;
    for (vtkIdType i = 0; i < all.GetNumberOfCells(); ++i) {
        all.GetCellPoints(i, line);
        const Vec3 x = corner(all, line->GetId(0));
        if ((breach && length(x - breach->center) < 2 * breach->radius) == near) {
            lines->InsertNextCell(line);
        }
    }
    some->SetLines(lines);
    return some;
}

double beyond_ends(const Vessel& vessel, const Vec3& x)
{
    return vessel.openings()[vessel.nearest_tube(x)].beyond(x);
}

} // namespace

double outside(const Vessel& vessel, const WallShape& shape, const Vec3& x)
{
    return std::max(vessel.wall(x, shape.radius).value, beyond_ends(vessel, x));
}

Box box_of(const Vessel& vessel, double R)
{
    const Vec3& first = vessel.openings()[0].center;
    Box box{first, first};
    for (std::size_t k = 0; k < 3; ++k) {
        if (vessel.is_open(k)) {
            const auto& [center, axis, radius] = vessel.openings()[k];
            const auto across = [radius = radius](double along) {
                return radius * std::sqrt(std::max(0.0, 1 - along * along));
            };
            const Vec3 disc{across(axis.x), across(axis.y), across(axis.z)};
            box.include(center - disc);
            box.include(center + disc);
        }
    }
    if (vessel.has_sac()) {
        box.include(vessel.dome(R) - Vec3{0, R, 0}, R);
    }
    return box;
}

WallSurface wall_surface(const Vessel& vessel, const WallShape& shape, double cell)
{
    Box box = box_of(vessel, shape.radius);
    box.include(box.low, 3 * cell);
    box.include(box.high, 3 * cell);
    Grid grid(box, cell);
    grid.fill([&](const Vec3& x) { return vessel.wall(x, shape.radius).value; });
    vtkSmartPointer<vtkPolyData> wall = grid.zero();
    put_on_wall(*wall, vessel, shape.radius);
    wall = cut(*wall, [&](const Vec3& x) { return beyond_ends(vessel, x); });
    if (shape.breach) {
        wall = cut(*wall, [&](const Vec3& x) { return inside_hole(*shape.breach, cell, x); });
    }
    const vtkSmartPointer<vtkPolyData> edges = edges_of(*wall);
    return {wall, lines_at(*edges, shape.breach, true), lines_at(*edges, shape.breach, false)};
}

} // namespace aneurysm::pictures
