// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/render.hpp"

#include "app/options.hpp"
#include "app/pictures/studio.hpp"
#include "app/pictures/words.hpp"
#include "common/error.hpp"
#include "common/process/interrupt.hpp"
#include "common/process/progress.hpp"
#include "common/process/subprocess.hpp"
#include "output/file.hpp"
#include "output/pictures/display.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>

namespace aneurysm::app
{
namespace
{

namespace fs = std::filesystem;
using namespace output;
using State = pictures::Look::State;

/// What the command line asks for.
struct RenderOptions {
    std::vector<fs::path> runs;
    std::vector<std::int64_t> frames; ///< empty: all that particles were written for
    std::vector<State> states{State::particles, State::fluid};
    pictures::Quantity color = pictures::Quantity::speed;
    std::vector<double> range; ///< low and high, in the color bar's unit; empty: from the runs
    pictures::View view = pictures::View::tilted;
    std::optional<Size> size;        ///< of a picture or of a sheet's tile; without: the default
    fs::path out;                    ///< empty: RUN_DIR/pictures
    bool sheet = false;              ///< all in one picture
    int columns = 0;                 ///< of a sheet; 0: as fits
    std::vector<std::string> labels; ///< of the runs; empty: their scenarios' names
    bool animation = false;          ///< a video, too
    int rate = 10;                   ///< of the video [pictures/s]
};

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
}

Plan make_plan(const RenderOptions& options)
{
    check_labels(options);
    Plan plan;
    plan.states = options.states;
    plan.studio.view = options.view;
    plan.studio.quantity = options.color;
    plan.studio.tile = options.sheet;
    const Size size = options.size.value_or(options.sheet ? Size{520, 560} : Size{1200, 1200});
    plan.studio.width = size.width;
    plan.studio.height = size.height;
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

/// A WebM file with VP9, which browsers play; it has its name only once it is finished. ffmpeg has a session
/// of its own, since Ctrl-C is for this program, and one thread, so that the same pictures make the same
/// bytes. \throws Error
void write_video(const fs::path& file, const std::vector<std::string>& pictures, int rate)
{
    const fs::path list = file.string() + ".list.tmp";
    const fs::path unfinished = file.string() + ".tmp";
    std::string text;
    for (const std::string& picture : pictures) {
        text += "file '" + picture + "'\n";
    }
    write_atomically(list, text);
    std::istringstream options(
        "setsid ffmpeg -nostdin -loglevel error -y -f concat -r " + std::to_string(rate) +
        " -i LIST -c:v libvpx-vp9 -crf 24 -b:v 0 -cpu-used 4 -threads 1 -pix_fmt yuv420p "
        "-fflags +bitexact -flags +bitexact -f webm");
    std::vector<std::string> command(std::istream_iterator<std::string>(options), {});
    *std::ranges::find(command, "LIST") = list;
    command.push_back(unfinished);
    std::error_code unused;
    try {
        aneurysm::run_program(command, "needed for videos: Debian's package ffmpeg, and enough space");
        fs::rename(unfinished, file);
    } catch (const std::exception&) {
        fs::remove(list, unused);
        fs::remove(unfinished, unused);
        throw;
    }
    fs::remove(list, unused);
}

/// One file for each frame and state, and videos of them. \return whether it came to the end
bool draw_series(const RenderOptions& options, const Plan& plan, const fs::path& directory)
{
    const std::vector<std::int64_t>& frames = plan.frames.front();
    Studio studio(plan.runs.front(), plan.studio);
    Progress progress("picture", 0, static_cast<std::int64_t>(frames.size() * plan.states.size()));
    std::int64_t done = 0;
    for (const State state : plan.states) {
        std::vector<std::string> names;
        for (const std::int64_t frame : frames) {
            if (InterruptWatch::interrupted()) {
                return false;
            }
            const pictures::Image image =
                studio.draw(frame, state, plan.labels.front() + ", frame " + std::to_string(frame));
            names.push_back(name_of(state) + "_" + six_digits(frame) + ".png");
            pictures::write_png(directory / names.back(), *image);
            progress.show(++done, name_of(state));
        }
        if (options.animation) {
            write_video(directory / (name_of(state) + ".webm"), names, options.rate);
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

/// Before memory is taken for a sheet. [pixels]
void refuse_large(std::int64_t width, std::int64_t height)
{
    constexpr std::int64_t longest = 1'000'000; // of a PNG, for most that read it
    constexpr std::int64_t most = std::int64_t{1} << 28;
    if (width > longest || height > longest || width * height > most) {
        throw InputError(
            "--sheet", "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels",
            "allowed: " + std::to_string(most) + " in all; needed: fewer --frames, or a smaller --size");
    }
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
    refuse_large(static_cast<std::int64_t>(columns) * width,
                 static_cast<std::int64_t>(rows) * height + strip);
    const pictures::Image sheet = pictures::blank(columns * width, rows * height + strip);
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
            const pictures::Image drawn = studio->draw(tile.frame, state, title_of(plan, tile));
            const int row = i / columns * states + s;
            pictures::paste(*sheet, *drawn, i % columns * width, strip + (rows - 1 - row) * height);
            progress.show(static_cast<std::int64_t>(i) * states + s + 1, name_of(state));
        }
    }
    studio.reset();
    if (bar) {
        const pictures::Image drawn =
            color_bar_strip(columns * width, strip, font, plan.studio.quantity, plan.studio.range);
        pictures::paste(*sheet, *drawn, 0, 0);
    }
    pictures::write_png(file, *sheet);
    return true;
}

void report(const RenderOptions& options, const Plan& plan, const fs::path& directory)
{
    std::cout << "Pictures in " << directory.string() << "\n";
    for (const State state : plan.states) {
        if (options.animation) {
            std::cout << "  " << name_of(state) << ".webm (VP9, " << options.rate << " pictures a second)\n";
        }
    }
}

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
    return exit_done;
}

} // namespace

void add_render(CLI::App& app, std::optional<int>& code)
{
    const auto o = std::make_shared<RenderOptions>();
    CLI::App* render_app = app.add_subcommand("render", "Draw frames of a run, or make a video of them");
    add_inputs(*render_app, "RUN_DIR", o->runs, "directory of a run; several with --sheet")->required();
    add_counts(*render_app, "--frames", o->frames,
               "which, by commas (default: all that particles were written for)", 0, most_frames);
    render_app
        ->add_option_function<std::string>(
            "--state",
            [o](const std::string& word) {
                if (word != "both") {
                    o->states = {word == "fluid" ? State::fluid : State::particles};
                }
            },
            "particles; fluid: the blood's surface; both")
        ->check(CLI::IsMember({"particles", "fluid", "both"}))
        ->default_str("both");
    static constexpr std::array<std::string_view, 2> colors{"speed", "pressure"};
    add_choice(*render_app, "--color", o->color, colors, "of the particles");
    add_numbers(*render_app, "--range", o->range,
                "LOW,HIGH of the colors (default: from all frames of the runs)");
    add_choice(*render_app, "--view", o->view, pictures::view_names, "sac, breach: close-ups");
    add_size(*render_app, o->size, "of a picture, or of a tile (default: 1200x1200; tile 520x560)");
    add_directory(*render_app, "--out", o->out, "directory for the pictures (default: RUN_DIR/pictures)");
    CLI::Option* sheet =
        render_app->add_flag("--sheet", o->sheet, "all in one picture, sheet.png, with one color bar");
    add_count(*render_app, "--columns", o->columns, "of the sheet (default: as many as tiles, at most 4)", 1,
              most_at_once)
        ->needs(sheet);
    add_words(*render_app, "--labels", o->labels, "of the runs, by commas (default: their scenarios' names)");
    CLI::Option* animation =
        render_app->add_flag("--animation", o->animation, "also particles.webm and fluid.webm")
            ->excludes(sheet);
    add_count(*render_app, "--fps", o->rate, "pictures a second of the video", 1, 120)
        ->needs(animation)
        ->default_str(std::to_string(o->rate));
    add_progress(*render_app);
    render_app->footer("Examples:\n"
                       "  aneurysm render results/paper_tc1 --frames 400,2200,2400 --sheet\n"
                       "  aneurysm render results/quick --state fluid --view sac --animation\n"
                       "Needs no display. Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted.");
    render_app->callback([o, &code] { code = render(*o); });
}

} // namespace aneurysm::app
