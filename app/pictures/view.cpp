// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/view.hpp"

#include "app/pictures/window.hpp"
#include "app/pictures/words.hpp"
#include "common/error.hpp"
#include "output/pictures/display.hpp"
#include "output/recorded_run.hpp"
#include "verification/backends/make_simulation.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <sstream>
#include <vector>

namespace aneurysm::app
{
namespace
{

constexpr std::array<std::string_view, 12> known_keys{"space", "n", "c", "f", "w", "1",
                                                      "2",     "3", "4", "h", "s", "q"};

std::vector<std::string> keys_of(const std::string& text)
{
    std::vector<std::string> keys;
    std::istringstream words(text);
    for (std::string key; words >> key;) {
        if (std::ranges::find(known_keys, key) == known_keys.end()) {
            throw InputError("--keys", "unknown (" + key + ")", "allowed: space n c f w 1 2 3 4 h s q");
        }
        keys.push_back(key);
    }
    return keys;
}

std::int64_t last_frame(const ViewOptions& options, const Scenario& scenario)
{
    const std::int64_t last = options.frames.value_or(scenario.time.frames);
    if (last < 1) {
        throw InputError("--frames", "out of range (" + std::to_string(last) + ")", "allowed: at least 1");
    }
    return last;
}

void require_display()
{
    if (!pictures::has_display()) {
        throw InputError("DISPLAY", "no display to open a window on",
                         "needed: one, or pictures without one: aneurysm run SCENARIO --out RUN_DIR, then "
                         "aneurysm render RUN_DIR");
    }
}

} // namespace

int view(const ViewOptions& options)
{
    const Scenario scenario = read_scenario(options.scenario);
    require_artery(options.scenario.string(), scenario);
    const std::vector<std::string> keys = keys_of(options.keys);
    const std::int64_t last = last_frame(options, scenario);
    const auto [width, height] = size_of(options.size);
    require_display();
    std::unique_ptr<Simulation> backend =
        backends::make_simulation(options.backend, scenario, std::nullopt, options.scenario);
    const double spacing = backend->state().spacing;
    const pictures::Snapshot start{output::first_record(scenario),
                                   output::shown_particles({backend->state().particles, {}})};
    Worker worker(std::move(backend), start, last);
    Window window(scenario, spacing, worker, last, width, height);
    worker.set_running(!options.paused);
    window.run(keys);
    if (!options.picture.empty()) {
        if (window.picture().rgb.empty()) {
            throw Error(options.picture.string(), "no picture: the window was closed by other means",
                        "needed: the key q");
        }
        pictures::write_png(options.picture, window.picture());
    }
    std::cout << "Closed at frame " << window.frame() << " of " << last << std::endl;
    return worker.status().error.empty() ? 0 : 1;
}

} // namespace aneurysm::app
