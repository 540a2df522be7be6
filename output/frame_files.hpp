// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace aneurysm::output
{

/// The files KIND/frame_NNNNNN.hdf of a run, one a frame, and KIND.hdf.series, the list of them with their
/// times. ParaView 5.10 and 5.11 choose their reader of VTKHDF by the ending .hdf only, later ones also by it.
class FrameFiles
{
public:
    /// `kind`: name of the folder; `frame_s`: time of a frame [s]
    FrameFiles(std::filesystem::path directory, std::string kind, double frame_s);

    static std::filesystem::path file(const std::filesystem::path& directory, const std::string& kind,
                                      std::int64_t frame);
    /// Frames that there are files of, rising.
    static std::vector<std::int64_t> frames(const std::filesystem::path& directory, const std::string& kind);

    /// Where the frame's file belongs; its folder is made.
    std::filesystem::path place(std::int64_t frame) const;
    /// Lists the file of a frame, which is there. \throws Error for a full disk
    void add(std::int64_t frame);
    /// Finds the files up to a frame again, removes the later ones and writes the list. \throws Error
    void go_back(std::int64_t last_frame);

private:
    void write_series() const;

    std::filesystem::path directory_;
    std::string kind_;
    double frame_s_;
    std::vector<std::int64_t> frames_;
};

} // namespace aneurysm::output
