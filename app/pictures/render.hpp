// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace aneurysm::app
{

/// What the command line asks for, not yet checked.
struct RenderOptions {
    std::vector<std::filesystem::path> runs;
    std::vector<std::int64_t> frames; ///< empty: all that particles were written for
    std::string state = "both";       ///< particles, fluid, both
    std::string color = "speed";      ///< speed, pressure
    std::vector<double> range;        ///< low and high, in the color bar's unit; empty: from the runs
    std::string view = "tilted";      ///< see output::view_names
    std::string size;                 ///< WIDTHxHEIGHT of a picture or of a sheet's tile; empty: the default
    std::filesystem::path out;        ///< empty: RUN_DIR/pictures
    bool sheet = false;               ///< all in one picture
    int columns = 0;                  ///< of a sheet; 0: as fits
    std::vector<std::string> labels;  ///< of the runs; empty: their scenarios' names
    bool animation = false;           ///< a video, too
    int rate = 10;                    ///< of the video [pictures/s]
};

/// `aneurysm render`: draws frames of runs to PNG files, prints where they are.
/// \return exit code: 0, or 130 when interrupted
/// \throws InputError before anything is written, or at a bad particle file
int render(const RenderOptions& options);

} // namespace aneurysm::app
