// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/pictures/image.hpp"

#include <filesystem>
#include <memory>

namespace aneurysm::pictures
{

/// Whether this build can write videos.
bool can_write_video();

/// A WebM file with VP9, which browsers play. It has its name only once it is finished.
class Video
{
public:
    /// `rate`: pictures a second; width and height are even. \throws Error, also when this build can't
    Video(const std::filesystem::path& file, int width, int height, int rate);
    ~Video(); ///< an unfinished file is removed
    Video(const Video&) = delete;
    Video(Video&&) = delete;
    Video& operator=(const Video&) = delete;
    Video& operator=(Video&&) = delete;

    void add(const Image& image);
    void finish();

private:
    struct Encoder;
    std::unique_ptr<Encoder> encoder_;
};

} // namespace aneurysm::pictures
