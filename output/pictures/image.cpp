// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/image.hpp"

#include "output/file.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace aneurysm::pictures
{

Image reduced(const Image& image, int n)
{
    Image small(image.width / n, image.height / n);
    const int half = n * n / 2;
    for (int y = 0; y < small.height; ++y) {
        std::uint8_t* to = small.row(y);
        for (int x = 0; x < 3 * small.width; ++x) {
            int sum = half;
            for (int j = 0; j < n; ++j) {
                const std::uint8_t* from = image.row(n * y + j) + 3 * n * (x / 3) + x % 3;
                for (int i = 0; i < n; ++i) {
                    sum += from[3 * i];
                }
            }
            to[x] = static_cast<std::uint8_t>(sum / (n * n));
        }
    }
    return small;
}

void paste(Image& whole, const Image& part, int x, int y)
{
    for (int row = 0; row < part.height; ++row) {
        std::copy_n(part.row(row), 3 * part.width, whole.row(y + row) + 3 * static_cast<std::ptrdiff_t>(x));
    }
}

void write_png(const std::filesystem::path& file, const Image& image)
{
    vtkNew<vtkImageData> data;
    data->SetDimensions(image.width, image.height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int y = 0; y < image.height; ++y) { // VTK begins at the bottom
        auto* const to = static_cast<std::uint8_t*>(data->GetScalarPointer(0, image.height - 1 - y, 0));
        std::copy_n(image.row(y), 3 * image.width, to);
    }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(data);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray& bytes = *writer->GetResult();
    const auto* const first = reinterpret_cast<const char*>(bytes.GetPointer(0)); // NOLINT
    output::write_atomically(file, {first, static_cast<std::size_t>(bytes.GetNumberOfValues())});
}

} // namespace aneurysm::pictures
