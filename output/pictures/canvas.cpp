// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/canvas.hpp"

#include "common/error.hpp"
#include "output/file.hpp"

#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

namespace aneurysm::pictures
{

Image blank(int width, int height)
{
    auto image = Image::New();
    image->SetDimensions(width, height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    image->GetPointData()->GetScalars()->Fill(255);
    return image;
}

void paste(vtkImageData& whole, vtkImageData& part, int x, int y)
{
    const int* const size = part.GetDimensions();
    part.SetExtent(x, x + size[0] - 1, y, y + size[1] - 1, 0, 0);
    whole.CopyAndCastFrom(&part, part.GetExtent());
}

void write_png(const std::filesystem::path& file, vtkImageData& image)
{
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(&image);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray& bytes = *writer->GetResult();
    const auto* const first = reinterpret_cast<const char*>(bytes.GetPointer(0)); // NOLINT
    output::write_atomically(file, {first, static_cast<std::size_t>(bytes.GetNumberOfValues())});
}

Image picture_of(vtkRenderWindow& window)
{
    const int* const size = window.GetSize();
    Image image = blank(size[0], size[1]);
    auto& pixels = *vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
    const vtkIdType wanted = pixels.GetNumberOfValues();
    if (window.GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, &pixels) == 0 ||
        pixels.GetNumberOfValues() != wanted) {
        throw Error("picture", "cannot be read back from OpenGL", "needed: OpenGL 3.2 (libgl1-mesa-dri)");
    }
    return image;
}

Canvas::Canvas(int width, int height, int samples)
    : samples_(samples), window_(vtkSmartPointer<vtkRenderWindow>::New())
{
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0); // peeling of translucent layers can't have them
    window_->SetAlphaBitPlanes(1);
    window_->SetSize(width * samples, height * samples);
}

Image Canvas::draw()
{
    window_->Render();
    vtkNew<vtkImageShrink3D> mean;
    mean->SetInputData(picture_of(*window_));
    mean->SetShrinkFactors(samples_, samples_, 1);
    mean->AveragingOn();
    mean->Update();
    return mean->GetOutput();
}

} // namespace aneurysm::pictures
