// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/wall_mesh.hpp"

#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <functional>

namespace aneurysm::pictures
{

using output::Box;

/// Points at equal distances that fill a box, with one number at each.
class Grid
{
public:
    /// `cell`: distance between points [m]
    Grid(const Box& box, double cell);

    double cell() const { return cell_; }
    std::array<int, 3> extent() const { return extent_; } ///< points along x, y, z
    Vec3 point(int i, int j, int k) const;
    float& at(int i, int j, int k) { return values_[index(i, j, k)]; }
    /// Sets every point's number.
    void fill(const std::function<double(const Vec3&)>& value);

    /// Triangles where the numbers pass zero, with normals along their gradient; the numbers are linear along
    /// the cells' edges.
    vtkSmartPointer<vtkPolyData> zero() const;

private:
    std::size_t index(int i, int j, int k) const
    {
        return (static_cast<std::size_t>(k) * static_cast<std::size_t>(extent_[1]) +
                static_cast<std::size_t>(j)) *
                   static_cast<std::size_t>(extent_[0]) +
               static_cast<std::size_t>(i);
    }

    double cell_;
    Vec3 origin_;
    std::array<int, 3> extent_{};
    vtkSmartPointer<vtkImageData> image_;
    float* values_ = nullptr; ///< of image_
};

} // namespace aneurysm::pictures
