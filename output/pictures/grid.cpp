// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/grid.hpp"

#include <vtkFlyingEdges3D.h>
#include <vtkNew.h>

#include <cmath>

namespace aneurysm::pictures
{

Grid::Grid(const Box& box, double cell)
    : cell_(cell), origin_(box.low), image_(vtkSmartPointer<vtkImageData>::New())
{
    const Vec3 size = box.high - box.low;
    const auto points = [cell](double length) { return static_cast<int>(std::ceil(length / cell)) + 1; };
    extent_ = {points(size.x), points(size.y), points(size.z)};
    image_->SetDimensions(extent_.data());
    image_->SetOrigin(origin_.x, origin_.y, origin_.z);
    image_->SetSpacing(cell, cell, cell);
    image_->AllocateScalars(VTK_FLOAT, 1);
    values_ = static_cast<float*>(image_->GetScalarPointer());
}

Vec3 Grid::point(int i, int j, int k) const
{
    return origin_ + cell_ * Vec3{static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)};
}

void Grid::fill(const std::function<double(const Vec3&)>& value)
{
    for (int k = 0; k < extent_[2]; ++k) {
        for (int j = 0; j < extent_[1]; ++j) {
            for (int i = 0; i < extent_[0]; ++i) {
                at(i, j, k) = static_cast<float>(value(point(i, j, k)));
            }
        }
    }
}

vtkSmartPointer<vtkPolyData> Grid::zero() const
{
    vtkNew<vtkFlyingEdges3D> contour;
    contour->SetInputData(image_);
    contour->SetValue(0, 0);
    contour->ComputeNormalsOn();
    contour->ComputeScalarsOff();
    contour->Update();
    return contour->GetOutput();
}

} // namespace aneurysm::pictures
