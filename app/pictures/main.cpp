// SPDX-License-Identifier: Apache-2.0
// The program `aneurysm-pictures`, which `aneurysm render` and
// `aneurysm view` hand over to: all that needs VTK.
#include "app/options.hpp"
#include "app/pictures/render.hpp"
#include "app/pictures/view.hpp"

int main(int argc, char** argv)
{
    using namespace aneurysm;
    CLI::App app("Pictures of runs.", "aneurysm");
    app.require_subcommand(0, 1); // what follows may be called like one: aneurysm render view
    std::optional<int> code;
    app::add_render(app, code);
    app::add_view(app, code);
    return app::run_program(app, code, argc, argv);
}
