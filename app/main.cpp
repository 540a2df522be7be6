// SPDX-License-Identifier: Apache-2.0
// The program `aneurysm`.
#include "app/compare.hpp"
#include "app/info.hpp"
#include "app/options.hpp"
#include "app/reproduce.hpp"
#include "app/run.hpp"
#include "app/verify.hpp"
#include "common/process/subprocess.hpp"
#include "output/build_info.hpp"

namespace
{

using namespace aneurysm;

/// A subcommand of the program aneurysm-pictures, which gets all that stands behind its name.
void add_handed_over(CLI::App& app, const std::string& name, const std::string& description)
{
    CLI::App* command = app.add_subcommand(name, description);
    command->set_help_flag();
    command->prefix_command();
    command->callback([command, name] {
        std::vector<std::string> words = command->remaining();
        words.insert(words.begin(), name);
        become_program("aneurysm-pictures", words, name,
                       "it is built (target aneurysm-pictures) where VTK is: Debian's libvtk9-dev");
    });
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Aneurysms by smoothed particle hydrodynamics: flow, growth and rupture.", "aneurysm");
    app.set_version_flag("--version", std::string("aneurysm ") + output::build_info().version);
    app.footer("Example:\n  aneurysm run data/scenarios/quick.json --out results/quick\n"
               "aneurysm SUBCOMMAND --help says more.");
    app.require_subcommand(0, 1); // what follows may be called like one: aneurysm info run
    std::optional<int> code;
    app::add_run(app, code);
    app::add_compare(app, code);
    app::add_verify(app, code);
    app::add_reproduce(app, code);
    app::add_info(app, code);
    add_handed_over(app, "render", "Draw frames of a run, or make a video of them");
    add_handed_over(app, "view", "Simulate a scenario in a window");
    return app::run_program(app, code, argc, argv);
}
