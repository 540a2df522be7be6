// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/studio.hpp"

#include "common/vessel/initial_state.hpp"
#include "output/columns.hpp"
#include "output/report/numbers.hpp"
#include "reference/bifurcation.hpp"

#include <vtkRenderer.h>

#include <algorithm>

namespace aneurysm::app
{
namespace
{

using namespace output;

double spacing_of(const Scenario& scenario)
{
    return sample(scenario, reference::vessel_of(scenario),
                  reference::daughter_radius(scenario.vessel.radius_m), std::nullopt)
        .spacing;
}

/// Whether a view leaves its lower corners to chart and color bar.
bool is_whole(pictures::View view)
{
    return view == pictures::View::front || view == pictures::View::tilted || view == pictures::View::side;
}

} // namespace

std::string numbers_of(const FrameRecord& r)
{
    using report::printed;
    return printed("t = %.3f s", r.time) + "   " + std::string(name_of(r.phase)) +
           printed("   load = %.4g N", r.wall_load) + printed("   P_c = %.4g Pa", r.critical_pressure) +
           printed("   R = %.4g m", r.radius) + printed("   h = %.4g mm", 1000 * r.thickness);
}

Studio::Studio(const RecordedRun& run, const StudioOptions& options)
    : run_(run), options_(options),
      scene_(run.scenario(), reference::vessel_of(run.scenario()), spacing_of(run.scenario())),
      canvas_(options.width, options.height),
      font_(std::max(9, std::min(options.width, options.height) / (options.tile ? 24 : 52)) *
            canvas_.samples()),
      overlay_(scene_.renderer(), font_), chart_(pictures::FrameChart::Content::impact, font_ * 4 / 5)
{
    canvas_.add(scene_.renderer());
    if (!options.tile && is_whole(options.view)) {
        scene_.renderer().AddActor(&chart_.actor());
        place_chart();
    }
}

void Studio::place_chart()
{
    const double edge = canvas_.samples() * std::min(options_.width, options_.height);
    chart_.place(0.01 * edge, 0.01 * edge, 0.37 * edge, 0.25 * edge);
}

pictures::Image Studio::draw(std::int64_t frame, pictures::Look::State state, const std::string& title)
{
    const pictures::Snapshot snapshot{run_.record(frame), run_.particles(frame)};
    scene_.show(snapshot, {.state = state, .quantity = options_.quantity, .range = options_.range});
    const bool particles = state == pictures::Look::State::particles;
    if (options_.tile) {
        overlay_.set_caption(title, "");
        pictures::look(scene_.renderer(), scene_.vessel(), options_.view, 0.94, 0.82);
    } else {
        overlay_.set_caption(title, numbers_of(snapshot.record));
        overlay_.set_color_bar(options_.quantity, options_.range, particles);
        chart_.show(run_.records(), run_.scenario().growth.warm_up_frames, frame, 0);
        pictures::look(scene_.renderer(), scene_.vessel(), options_.view, 0.94, 0.84);
    }
    return canvas_.draw();
}

pictures::Image color_bar_strip(int width, int height, int font, pictures::Quantity quantity,
                                const pictures::Range& range)
{
    pictures::Canvas canvas(width, height);
    const auto renderer = vtkSmartPointer<vtkRenderer>::New();
    renderer->SetBackground(1, 1, 1);
    canvas.add(*renderer);
    pictures::Overlay overlay(*renderer, font * canvas.samples());
    overlay.set_lying_color_bar(quantity, range);
    return canvas.draw();
}

} // namespace aneurysm::app
