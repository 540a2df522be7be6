// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/view.hpp"

#include "app/options.hpp"
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

struct ViewOptions {
    std::filesystem::path scenario;
    backends::BackendChoice backend{Backend::cpu, Precision::float_};
    std::optional<std::int64_t> frames;         ///< where to stop; without: the scenario's last
    std::optional<Size> size = Size{1400, 900}; ///< of the window
    bool paused = false;                        ///< at the start
    std::string keys;              ///< pressed one by one, each when the one before has had its effect
    std::filesystem::path picture; ///< of the window when it closes; empty: none
};

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

void require_display()
{
    if (!pictures::has_display()) {
        throw InputError("DISPLAY", "no display to open a window on",
                         "needed: one, or pictures without one: aneurysm run SCENARIO --out RUN_DIR, then "
                         "aneurysm render RUN_DIR");
    }
}

int view(const ViewOptions& options)
{
    const Scenario scenario = read_scenario(options.scenario);
    require_artery(options.scenario.string(), scenario);
    const std::vector<std::string> keys = keys_of(options.keys);
    const std::int64_t last = options.frames.value_or(scenario.time.frames);
    require_display();
    std::unique_ptr<Simulation> backend =
        backends::make_simulation(options.backend, scenario, std::nullopt, options.scenario);
    const double spacing = backend->state().spacing;
    const pictures::Snapshot start{output::first_record(scenario),
                                   output::shown_particles({backend->state().particles, {}})};
    Worker worker(std::move(backend), start, last);
    Window window(scenario, spacing, worker, last, options.size->width, options.size->height);
    worker.set_running(!options.paused);
    window.run(keys);
    if (!options.picture.empty()) {
        if (window.picture() == nullptr) {
            throw Error(options.picture.string(), "no picture: the window was closed by other means",
                        "needed: the key q");
        }
        pictures::write_png(options.picture, *window.picture());
    }
    std::cout << "Closed at frame " << window.frame() << " of " << last << std::endl;
    return worker.status().error.empty() ? exit_done : exit_failed;
}

} // namespace

void add_view(CLI::App& app, std::optional<int>& code)
{
    const auto o = std::make_shared<ViewOptions>();
    CLI::App* view_app = app.add_subcommand("view", "Simulate a scenario in a window");
    add_input(*view_app, "SCENARIO", o->scenario, "scenario file")->required();
    add_backend(*view_app, o->backend);
    add_tuning(*view_app, o->backend);
    add_count(*view_app, "--frames", o->frames, "stop at this frame instead of the scenario's last", 1,
              most_frames);
    add_size(*view_app, o->size, "of the window")->default_str("1400x900");
    view_app->add_flag("--paused", o->paused, "start with a pause");
    view_app->add_option("--keys", o->keys,
                         "keys to press one by one, such as \"space n n q\"; q closes the window");
    add_output_file(*view_app, "--picture", o->picture,
                    "PNG file for what the window shows when q closes it");
    view_app->footer(
        "Example:\n"
        "  aneurysm view data/scenarios/quick.json\n"
        "Needs a display; the window lists its keys. Exit codes: 0 done, 1 failed, 2 bad input.");
    view_app->callback([view_app, o, &code] {
        settle_tuning(*view_app, o->backend);
        code = view(*o);
    });
}

} // namespace aneurysm::app
