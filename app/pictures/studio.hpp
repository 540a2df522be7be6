// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/pictures/canvas.hpp"
#include "output/pictures/chart.hpp"
#include "output/pictures/overlay.hpp"
#include "output/pictures/scene.hpp"
#include "output/recorded_run.hpp"

#include <string>
#include <vector>

namespace aneurysm::app
{

/// How the pictures of a run are made.
struct StudioOptions {
    int width = 1200;  ///< [pixels]
    int height = 1200; ///< [pixels]
    pictures::View view = pictures::View::tilted;
    pictures::Quantity quantity = pictures::Quantity::speed;
    pictures::Range range;
    bool tile = false; ///< a part of a sheet: neither chart, numbers nor color bar
};

/// Draws frames of one run. Needs a display.
class Studio
{
public:
    /// \throws InputError
    Studio(const output::RecordedRun& run, const StudioOptions& options);

    /// `title`: over the picture. \throws InputError when the frame or its file isn't there or is bad
    pictures::Image draw(std::int64_t frame, pictures::Look::State state, const std::string& title);

private:
    void place_chart();

    const output::RecordedRun& run_;
    StudioOptions options_;
    pictures::Scene scene_;
    pictures::Canvas canvas_;
    int font_;
    pictures::Overlay overlay_;
    pictures::FrameChart chart_;
};

/// A picture `width` wide of nothing but a color bar.
pictures::Image color_bar_strip(int width, int height, int font, pictures::Quantity quantity,
                                const pictures::Range& range);

/// "t = 2.400 s   growing   load = 812 N   P_c = 3098 Pa   R = 0.3932 m   h = 10.43 mm"
std::string numbers_of(const FrameRecord& record);

} // namespace aneurysm::app
