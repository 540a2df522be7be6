// SPDX-License-Identifier: Apache-2.0
// The program `aneurysm-pictures`, which `aneurysm render` and
// `aneurysm view` hand over to: all that needs VTK.
#include "app/options.hpp"
#include "app/pictures/render.hpp"
#include "app/pictures/view.hpp"
#include "common/error.hpp"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>

namespace
{

using namespace aneurysm;
using app::RenderOptions;
using app::ViewOptions;

constexpr int bad_input = 2;

CLI::App* add_render(CLI::App& app, RenderOptions& o)
{
    CLI::App* render = app.add_subcommand("render", "Draw frames of a run, or make a video of them");
    render->add_option("RUN_DIR", o.runs, "directory of a run; several with --sheet")->required();
    render
        ->add_option("--frames", o.frames, "which, by commas (default: all that particles were written for)")
        ->delimiter(',')
        ->allow_extra_args(false);
    render->add_option("--state", o.state, "particles; fluid: the blood's surface; both")
        ->capture_default_str();
    render->add_option("--color", o.color, "of the particles: speed, pressure")->capture_default_str();
    render->add_option("--range", o.range, "LOW,HIGH of the colors (default: from all frames of the runs)")
        ->delimiter(',')
        ->allow_extra_args(false);
    render->add_option("--view", o.view, "front, tilted, side; sac, breach: close-ups")
        ->capture_default_str();
    render->add_option("--size", o.size, "of a picture, or of a tile (default: 1200x1200; tile 520x560)");
    render->add_option("--out", o.out, "directory for the pictures (default: RUN_DIR/pictures)");
    render->add_flag("--sheet", o.sheet, "all in one picture, sheet.png, with one color bar");
    render->add_option("--columns", o.columns, "of the sheet (default: as many as tiles, at most 4)");
    render->add_option("--labels", o.labels, "of the runs, by commas (default: their scenarios' names)")
        ->delimiter(',')
        ->allow_extra_args(false);
    render->add_flag("--animation", o.animation, "also particles.webm and fluid.webm");
    render->add_option("--fps", o.rate, "pictures a second of the video")->capture_default_str();
    render->footer("Examples:\n"
                   "  aneurysm render results/paper_tc1 --frames 400,2200,2400 --sheet\n"
                   "  aneurysm render results/quick --state fluid --view sac --animation\n"
                   "Needs no display. Exit codes: 0 done, 1 failed, 2 bad input, 130 interrupted.");
    return render;
}

CLI::App* add_view(CLI::App& app, ViewOptions& o)
{
    CLI::App* view = app.add_subcommand("view", "Simulate a scenario in a window");
    view->add_option("SCENARIO", o.scenario, "scenario file")->required();
    app::add_choice(*view, "--backend", o.backend.backend, backend_names, "who computes");
    app::add_choice(*view, "--precision", o.backend.precision, precision_names, "of its flow");
    view->add_option("--threads", o.backend.threads, "of backend cpu; 0: as many as pay")
        ->capture_default_str();
    view->add_option("--frames", o.frames, "stop at this frame instead of the scenario's last");
    view->add_option("--size", o.size, "of the window")->capture_default_str();
    view->add_flag("--paused", o.paused, "start with a pause");
    view->add_option("--keys", o.keys, "keys to press one by one, such as \"space n n q\"");
    view->add_option("--picture", o.picture, "PNG file for what the window shows when it closes");
    view->footer("Example:\n"
                 "  aneurysm view data/scenarios/quick.json\n"
                 "Needs a display; the window lists its keys. Exit codes: 0 done, 1 failed, 2 bad input.");
    return view;
}

int parse_and_run(int argc, char** argv)
{
    CLI::App app("Pictures of runs.", "aneurysm");
    RenderOptions render_options;
    ViewOptions view_options;
    const CLI::App* render = add_render(app, render_options);
    const CLI::App* view = add_view(app, view_options);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
            return app.exit(error); // --help
        }
        throw InputError("command line", error.what(), "see aneurysm render --help, aneurysm view --help");
    }
    if (view->parsed()) {
        return app::view(view_options);
    }
    if (!render->parsed()) {
        throw InputError("command line", "no subcommand given", "see aneurysm --help");
    }
    return app::render(render_options);
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return parse_and_run(argc, argv);
    } catch (const InputError& error) {
        std::cerr << "aneurysm: " << error.what() << "\n";
        return bad_input;
    } catch (const std::exception& error) {
        std::cerr << "aneurysm: " << error.what() << "\n";
        return 1;
    }
}
