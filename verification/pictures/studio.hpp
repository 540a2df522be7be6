// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/recorded_run.hpp"
#include "output/scene/canvas.hpp"
#include "output/scene/chart.hpp"
#include "output/scene/overlay.hpp"
#include "output/scene/scene.hpp"

#include <string>
#include <vector>

namespace aneurysm::verification
{

/// How the pictures of a run are made.
struct StudioOptions {
    int width = 1200;  ///< [pixels]
    int height = 1200; ///< [pixels]
    output::View view = output::View::tilted;
    output::Quantity quantity = output::Quantity::speed;
    output::Range range;
    bool tile = false; ///< a part of a sheet: neither chart, numbers nor colour bar
};

/// Draws frames of one run. Needs a display.
class Studio
{
public:
    /// \throws InputError
    Studio(const output::RecordedRun& run, const StudioOptions& options);

    /// `title`: over the picture. \throws InputError when the frame or its file isn't there or is bad
    output::Image draw(std::int64_t frame, output::Look::State state, const std::string& title);

private:
    void place_chart();

    const output::RecordedRun& run_;
    StudioOptions options_;
    output::Scene scene_;
    output::Canvas canvas_;
    int font_;
    output::Overlay overlay_;
    output::FrameChart chart_;
};

/// A picture `width` wide of nothing but a colour bar.
output::Image colour_bar_strip(int width, int height, int font, output::Quantity quantity,
                               const output::Range& range);

/// "t = 2.400 s   growing   F_b = 812 N   P_c = 3098 Pa   R = 0.3932 m   h = 10.43 mm"
std::string numbers_of(const FrameRecord& record);

/// The artery of a scenario, with the daughters of (24).
Vessel vessel_of(const Scenario& scenario);

} // namespace aneurysm::verification
