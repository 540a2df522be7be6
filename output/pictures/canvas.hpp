// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/pictures/image.hpp"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace aneurysm::pictures
{

/// Something to draw on that no one sees. Needs a display, see PrivateDisplay. Every pixel of a picture is
/// the mean of `samples` x `samples`.
class Canvas
{
public:
    Canvas(int width, int height, int samples = 2);

    void add(vtkRenderer& renderer) { window_->AddRenderer(&renderer); }
    /// Pixels that a pixel of the picture is made of, along an edge:
    /// what lengths in pixels are multiplied by.
    int samples() const { return samples_; }
    int height() const { return height_; }
    Image draw();

private:
    int height_;
    int samples_;
    vtkSmartPointer<vtkRenderWindow> window_;
};

/// What a window shows.
Image picture_of(vtkRenderWindow& window);

} // namespace aneurysm::pictures
