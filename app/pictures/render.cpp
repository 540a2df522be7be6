// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/render.hpp"

#include "app/pictures/studio.hpp"
#include "app/pictures/words.hpp"
#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "output/pictures/display.hpp"
#include "output/pictures/video.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>

namespace aneurysm::app
{
namespace
{

namespace fs = std::filesystem;
using namespace output;
using State = pictures::Look::State;

constexpr int exit_interrupted = 130;

/// What is to be drawn, checked.
struct Plan {
    std::vector<RecordedRun> runs;
    std::vector<std::string> labels;               ///< of the runs
    std::vector<std::vector<std::int64_t>> frames; ///< by run
    std::vector<State> states;
    StudioOptions studio;
};

std::string name_of(State state)
{
    return state == State::particles ? "particles" : "fluid";
}

std::vector<State> states_of(const std::string& word)
{
    if (word == "both") {
        return {State::particles, State::fluid};
    }
    if (word != "particles" && word != "fluid") {
        throw InputError("--state", "unknown (" + word + ")", "allowed: particles, fluid, both");
    }
    return {word == "fluid" ? State::fluid : State::particles};
}

pictures::Range range_of(const RenderOptions& options, const std::vector<RecordedRun>& runs,
                         pictures::Quantity quantity)
{
    if (!options.range.empty()) {
        if (options.range.size() != 2 || !(options.range[0] < options.range[1])) {
            throw InputError("--range", "no range",
                             "needed: LOW,HIGH in the color bar's unit, LOW less than HIGH");
        }
        return {options.range[0], options.range[1]};
    }
    pictures::RangeFinder finder(quantity); // over all frames, so that those drawn later have the same colors
    for (const RecordedRun& run : runs) {
        for (const std::int64_t frame : run.particle_frames()) {
            finder.add(run.particles(frame));
        }
    }
    return finder.range();
}

void check_labels(const RenderOptions& options)
{
    if (options.runs.size() > 1 && !options.sheet) {
        throw InputError("RUN_DIR", "several runs", "needed: --sheet, which shows them in one picture");
    }
    if (!options.labels.empty() && options.labels.size() != options.runs.size()) {
        throw InputError("--labels",
                         std::to_string(options.labels.size()) + " for " +
                             std::to_string(options.runs.size()) + " runs",
                         "needed: one for each run");
    }
    if (options.columns < 0) {
        throw InputError("--columns", "out of range (" + std::to_string(options.columns) + ")",
                         "allowed: at least 1");
    }
    if (options.rate < 1 || options.rate > 120) {
        throw InputError("--fps", "out of range (" + std::to_string(options.rate) + ")", "allowed: 1 to 120");
    }
    if (options.animation && options.sheet) {
        throw InputError("--animation", "no video of a sheet", "needed: either --animation or --sheet");
    }
}

Plan make_plan(const RenderOptions& options)
{
    check_labels(options);
    Plan plan;
    plan.states = states_of(options.state);
    plan.studio.view = view_of(options.view);
    plan.studio.quantity = quantity_of(options.color);
    plan.studio.tile = options.sheet;
    const auto [width, height] =
        size_of(options.size.empty() ? (options.sheet ? "520x560" : "1200x1200") : options.size);
    plan.studio.width = width;
    plan.studio.height = height;
    for (const fs::path& directory : options.runs) {
        RecordedRun& run = plan.runs.emplace_back(directory);
        require_artery(directory.string(), run.scenario());
        plan.frames.push_back(options.frames.empty() ? run.particle_frames() : options.frames);
        for (const std::int64_t frame : plan.frames.back()) {
            run.record(frame);
            run.particles(frame);
        }
        plan.labels.push_back(options.labels.empty() ? run.scenario().name
                                                     : options.labels[plan.runs.size() - 1]);
    }
    plan.studio.range = range_of(options, plan.runs, plan.studio.quantity);
    return plan;
}

std::string six_digits(std::int64_t number)
{
    const std::string text = std::to_string(number);
    return std::string(6 - std::min<std::size_t>(6, text.size()), '0') + text;
}

fs::path make_directory(const RenderOptions& options)
{
    fs::path directory = options.out.empty() ? options.runs.front() / "pictures" : options.out;
    std::error_code error;
    fs::create_directories(directory, error);
    if (error) {
        throw InputError(directory.string(), "cannot be made (" + error.message() + ")",
                         "needed: --out DIR in a writable place");
    }
    return directory;
}

/// One file for each frame and state, and videos of them. \return whether it came to the end
bool draw_series(const RenderOptions& options, const Plan& plan, const fs::path& directory)
{
    const std::vector<std::int64_t>& frames = plan.frames.front();
    Studio studio(plan.runs.front(), plan.studio);
    Progress progress("picture", 0, static_cast<std::int64_t>(frames.size() * plan.states.size()));
    std::int64_t done = 0;
    for (const State state : plan.states) {
        std::optional<pictures::Video> video;
        if (options.animation && pictures::can_write_video()) {
            video.emplace(directory / (name_of(state) + ".webm"), plan.studio.width, plan.studio.height,
                          options.rate);
        }
        for (const std::int64_t frame : frames) {
            if (InterruptWatch::interrupted()) {
                return false;
            }
            const pictures::Image image =
                studio.draw(frame, state, plan.labels.front() + ", frame " + std::to_string(frame));
            pictures::write_png(directory / (name_of(state) + "_" + six_digits(frame) + ".png"), image);
            if (video) {
                video->add(image);
            }
            progress.show(++done, name_of(state));
        }
        if (video) {
            video->finish();
        }
    }
    return true;
}

/// One tile's place in the order of the sheet.
struct Tile {
    std::size_t run = 0;
    std::int64_t frame = 0;
};

std::vector<Tile> tiles_of(const Plan& plan)
{
    std::vector<Tile> tiles;
    for (std::size_t run = 0; run < plan.runs.size(); ++run) {
        for (const std::int64_t frame : plan.frames[run]) {
            tiles.push_back({run, frame});
        }
    }
    return tiles;
}

std::string title_of(const Plan& plan, const Tile& tile)
{
    const std::string frame = "frame " + std::to_string(tile.frame);
    return plan.runs.size() == 1 ? frame : plan.labels[tile.run] + ", " + frame;
}

/// All frames and runs in one picture: the states of a tile below one another, a color bar below all.
/// \return whether it came to the end
bool draw_sheet(const RenderOptions& options, const Plan& plan, const fs::path& file)
{
    const std::vector<Tile> tiles = tiles_of(plan);
    const int count = static_cast<int>(tiles.size());
    const int columns = options.columns > 0 ? std::min(options.columns, count) : std::min(count, 4);
    const int states = static_cast<int>(plan.states.size());
    const int rows = states * ((count + columns - 1) / columns);
    const auto [width, height] = std::pair(plan.studio.width, plan.studio.height);
    const bool bar = plan.states.front() == State::particles;
    const int font = std::max(9, std::min(width, height) / 26);
    const int strip = bar ? 6 * font / 2 * 2 : 0;
    pictures::Image sheet(columns * width, rows * height + strip);
    std::ranges::fill(sheet.rgb, std::uint8_t{255});
    std::unique_ptr<Studio> studio;
    Progress progress("tile", 0, static_cast<std::int64_t>(count) * states);
    for (int i = 0; i < count; ++i) {
        const Tile& tile = tiles[static_cast<std::size_t>(i)];
        if (i == 0 || tile.run != tiles[static_cast<std::size_t>(i) - 1].run) {
            studio.reset();
            studio = std::make_unique<Studio>(plan.runs[tile.run], plan.studio);
        }
        for (int s = 0; s < states; ++s) {
            if (InterruptWatch::interrupted()) {
                return false;
            }
            const State state = plan.states[static_cast<std::size_t>(s)];
            pictures::paste(sheet, studio->draw(tile.frame, state, title_of(plan, tile)), i % columns * width,
                            (i / columns * states + s) * height);
            progress.show(static_cast<std::int64_t>(i) * states + s + 1, name_of(state));
        }
    }
    studio.reset();
    if (bar) {
        pictures::paste(sheet,
                        color_bar_strip(sheet.width, strip, font, plan.studio.quantity, plan.studio.range), 0,
                        rows * height);
    }
    pictures::write_png(file, sheet);
    return true;
}

void report(const RenderOptions& options, const Plan& plan, const fs::path& directory)
{
    std::cout << "Pictures in " << directory.string() << "\n";
    for (const State state : plan.states) {
        if (options.animation && pictures::can_write_video()) {
            std::cout << "  " << name_of(state) << ".webm (VP9, " << options.rate << " pictures a second)\n";
        }
    }
    if (options.animation && !pictures::can_write_video()) {
        std::cout
            << "  no video: this build is without libavcodec's VP9; the numbered pictures make one with\n"
               "  ffmpeg -pattern_type glob -i 'particles_*.png' particles.webm\n";
    }
}

} // namespace

int render(const RenderOptions& options)
{
    const Plan plan = make_plan(options);
    const InterruptWatch watch;
    const pictures::PrivateDisplay display;
    const fs::path directory = make_directory(options);
    const bool complete = options.sheet ? draw_sheet(options, plan, directory / "sheet.png")
                                        : draw_series(options, plan, directory);
    if (!complete) {
        std::cerr << "interrupted; the pictures made so far are in " << directory.string() << "\n";
        return exit_interrupted;
    }
    report(options, plan, directory);
    return 0;
}

} // namespace aneurysm::app
