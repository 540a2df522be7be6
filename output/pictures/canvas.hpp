// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkImageData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <filesystem>

namespace aneurysm::pictures
{

/// Red, green and blue of each pixel, row by row from the bottom.
using Image = vtkSmartPointer<vtkImageData>;

/// All white.
Image blank(int width, int height);
/// Copies `part` with its lower left corner to x, y. \pre it fits
void paste(vtkImageData& whole, vtkImageData& part, int x, int y);
/// In one step, see write_atomically. The same pixels make the same bytes. \throws Error
void write_png(const std::filesystem::path& file, vtkImageData& image);
/// What a window shows.
Image picture_of(vtkRenderWindow& window);

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
    Image draw();

private:
    int samples_;
    vtkSmartPointer<vtkRenderWindow> window_;
};

} // namespace aneurysm::pictures
