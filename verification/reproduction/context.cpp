// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/context.hpp"

#include "common/error.hpp"
#include "common/process/subprocess.hpp"
#include "common/scenario/shipped.hpp"
#include "output/file.hpp"
#include "output/json.hpp"

namespace aneurysm::reproduction
{
namespace
{

namespace fs = std::filesystem;
using output::Json;

/// Beyond the reach of any impact here [Pa].
constexpr double unreachable_yield = 1e9;

Json to_json(const PlotPanel& panel)
{
    const Json series = output::json_array(panel.series, [](const PlotSeries& s) {
        return Json{{"name", s.name}, {"x", s.x}, {"y", s.y}, {"style", s.style}, {"color", s.color}};
    });
    return {{"title", panel.title},
            {"x_label", panel.x_label},
            {"y_label", panel.y_label},
            {"log_y", panel.log_y},
            {"series", series}};
}

/// Debian's matplotlib is that of Debian's python3, whatever else is first on the path; elsewhere that is it.
const std::string& plot_python()
{
    static const std::string python = [] {
        const std::string debian = "/usr/bin/python3";
        const std::string command = debian + " -c 'import matplotlib' >/dev/null 2>&1";
        return std::system(command.c_str()) == 0 ? debian : std::string("python3"); // NOLINT(cert-env33-c)
    }();
    return python;
}

} // namespace

fs::path Reproduction::folder(const std::string& id) const
{
    const fs::path folder = out / id;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw Error(folder.string(), "can't be made (" + error.message() + ")", "needed: a writable place");
    }
    return folder;
}

void Reproduction::write(const Section& section) const
{
    const fs::path where = folder(section.id);
    output::write_atomically(where / (section.id + ".json"), reproduction::to_json(section).dump(2) + "\n");
    int k = 0;
    for (const ResultTable& table : section.tables) {
        const std::string suffix = ++k == 1 ? "" : "_" + std::to_string(k);
        output::write_atomically(where / (section.id + suffix + ".csv"), to_csv(table));
    }
}

Picture plot(const fs::path& file, const std::string& caption, std::size_t columns,
             const std::vector<PlotPanel>& panels)
{
    const Json all = output::json_array(panels, [](const PlotPanel& panel) { return to_json(panel); });
    fs::path spec = file;
    spec.replace_extension(".plot.json");
    output::write_atomically(spec, Json{{"columns", columns}, {"panels", all}}.dump() + "\n");
    const fs::path script = shipped_script("verification/reproduction/plot.py");
    run_program({plot_python(), "-B", script.string(), spec.string(), file.string()},
                "needed: a python3 with matplotlib (Debian's python3-matplotlib)");
    return {file, caption};
}

void render(const std::vector<std::string>& words)
{
    std::vector<std::string> command{own_program("aneurysm-pictures"), "render"};
    command.insert(command.end(), words.begin(), words.end());
    run_program(command, "needed: the build target aneurysm-pictures, with Debian's libvtk9-dev and xvfb");
}

nlohmann::json read_data(const std::string& name)
{
    return output::read_json(data_directory() / name, "needed: the file as it was shipped");
}

Scenario changed(const Scenario& scenario, const nlohmann::json& changes, const std::string& name,
                 const std::string& where)
{
    nlohmann::json text = nlohmann::json::parse(to_json(scenario));
    text.merge_patch(changes);
    Scenario result = parse_scenario(text.dump(), where + ": " + name);
    result.name += "_" + name;
    return result;
}

Scenario unbreakable(Scenario scenario)
{
    scenario.rupture.yield_limit_pa = unreachable_yield;
    scenario.assumed["rupture.yield_limit_pa"] = "out of reach: what the wall does is worked out afterwards";
    scenario.name += "_unbreakable";
    return scenario;
}

Scenario with_seed(Scenario scenario, int seed)
{
    scenario.particles.seed = seed;
    scenario.name += "_seed" + std::to_string(seed);
    return scenario;
}

} // namespace aneurysm::reproduction
