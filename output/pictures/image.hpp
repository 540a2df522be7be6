// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace aneurysm::pictures
{

/// A picture: red, green and blue of each pixel, row by row from the top.
struct Image {
    Image() = default;
    Image(int w, int h)
        : width(w), height(h), rgb(3 * static_cast<std::size_t>(w) * static_cast<std::size_t>(h))
    {
    }

    std::uint8_t* row(int y) { return rgb.data() + 3 * static_cast<std::ptrdiff_t>(width) * y; }
    const std::uint8_t* row(int y) const { return rgb.data() + 3 * static_cast<std::ptrdiff_t>(width) * y; }

    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;
};

/// The mean of each square of n x n pixels. \pre n divides width and height
Image reduced(const Image& image, int n);
/// Copies `part` with its top left corner to x, y. \pre it fits
void paste(Image& whole, const Image& part, int x, int y);
/// In one step, see write_atomically. The same pixels make the same bytes. \throws Error
void write_png(const std::filesystem::path& file, const Image& image);

} // namespace aneurysm::pictures
