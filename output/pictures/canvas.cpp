// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/canvas.hpp"

#include "common/error.hpp"

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace aneurysm::pictures
{

Canvas::Canvas(int width, int height, int samples)
    : height_(height), samples_(samples), window_(vtkSmartPointer<vtkRenderWindow>::New())
{
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0); // peeling of translucent layers can't have them
    window_->SetAlphaBitPlanes(1);
    window_->SetSize(width * samples, height * samples);
}

Image Canvas::draw()
{
    window_->Render();
    return reduced(picture_of(*window_), samples_);
}

Image picture_of(vtkRenderWindow& window)
{
    const int* const size = window.GetSize();
    Image image(size[0], size[1]);
    vtkNew<vtkUnsignedCharArray> pixels;
    if (window.GetPixelData(0, 0, image.width - 1, image.height - 1, 0, pixels) == 0 ||
        static_cast<std::size_t>(pixels->GetNumberOfValues()) != image.rgb.size()) {
        throw Error("picture", "cannot be read back from OpenGL", "needed: OpenGL 3.2 (libgl1-mesa-dri)");
    }
    for (int y = 0; y < image.height; ++y) { // OpenGL begins at the bottom
        std::copy_n(pixels->GetPointer(3 * static_cast<vtkIdType>(image.width) * (image.height - 1 - y)),
                    3 * image.width, image.row(y));
    }
    return image;
}

} // namespace aneurysm::pictures
