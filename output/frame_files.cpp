// SPDX-License-Identifier: Apache-2.0
#include "output/frame_files.hpp"

#include "output/file.hpp"
#include "output/json.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace aneurysm::output
{
namespace
{

namespace fs = std::filesystem;

std::string name_of(const std::string& kind, std::int64_t frame)
{
    constexpr std::size_t width = 6;
    const std::string number = std::to_string(frame);
    return kind + "/frame_" + std::string(width - std::min(width, number.size()), '0') + number + ".hdf";
}

} // namespace

FrameFiles::FrameFiles(fs::path directory, std::string kind, double frame_s)
    : directory_(std::move(directory)), kind_(std::move(kind)), frame_s_(frame_s)
{
}

fs::path FrameFiles::file(const fs::path& directory, const std::string& kind, std::int64_t frame)
{
    return directory / name_of(kind, frame);
}

std::vector<std::int64_t> FrameFiles::frames(const fs::path& directory, const std::string& kind)
{
    std::vector<std::int64_t> frames;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(directory / kind, error)) {
        const std::string stem = entry.path().stem().string();
        const std::int64_t frame = stem.starts_with("frame_") ? std::atoll(stem.c_str() + 6) : -1;
        if (frame >= 0 && entry.path().filename() == file(directory, kind, frame).filename()) {
            frames.push_back(frame);
        }
    }
    std::sort(frames.begin(), frames.end());
    return frames;
}

fs::path FrameFiles::place(std::int64_t frame) const
{
    const fs::path path = file(directory_, kind_, frame);
    std::error_code error; // what follows from it shows when the file is written
    fs::create_directories(path.parent_path(), error);
    return path;
}

void FrameFiles::add(std::int64_t frame)
{
    if (std::ranges::find(frames_, frame) == frames_.end()) {
        frames_.push_back(frame);
    }
    write_series();
}

void FrameFiles::go_back(std::int64_t last_frame)
{
    for (const std::int64_t frame : frames(directory_, kind_)) {
        if (frame <= last_frame) {
            frames_.push_back(frame);
        } else {
            std::error_code unused;
            fs::remove(file(directory_, kind_, frame), unused);
        }
    }
    if (!frames_.empty()) {
        write_series();
    }
}

void FrameFiles::write_series() const
{
    Json files = Json::array();
    for (const std::int64_t frame : frames_) {
        files.push_back({{"name", name_of(kind_, frame)}, {"time", static_cast<double>(frame) * frame_s_}});
    }
    const Json series{{"file-series-version", "1.0"}, {"files", files}};
    write_atomically(directory_ / (kind_ + ".hdf.series"), series.dump(2) + "\n");
}

} // namespace aneurysm::output
