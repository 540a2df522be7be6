// SPDX-License-Identifier: Apache-2.0
#include "common/scenario/shipped.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

namespace aneurysm
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* variable = "ANEURYSM_DATA";
constexpr std::array<std::string_view, 31> scenario_names{"base",
                                                          "calibrated",
                                                          "paper_angle_30",
                                                          "paper_angle_40",
                                                          "paper_angle_60",
                                                          "paper_angle_75",
                                                          "paper_phi_3",
                                                          "paper_phi_4",
                                                          "paper_phi_5",
                                                          "paper_phi_6",
                                                          "paper_shape_hemispherical",
                                                          "paper_shape_piriform",
                                                          "paper_shape_spherical",
                                                          "paper_sigma_02",
                                                          "paper_sigma_03",
                                                          "paper_sigma_04",
                                                          "paper_sigma_05",
                                                          "paper_sigma_06",
                                                          "paper_tc1",
                                                          "paper_tc2",
                                                          "paper_tc3",
                                                          "paper_tc4",
                                                          "quick",
                                                          "verify_box",
                                                          "verify_channel",
                                                          "verify_duct",
                                                          "verify_hydrostatic",
                                                          "verify_pipe",
                                                          "verify_slip_channel",
                                                          "verify_tube",
                                                          "verify_womersley_channel"};
constexpr std::array other_files{"baseline.json",
                                 "calibration.json",
                                 "paper.json",
                                 "scenario.schema.json",
                                 "hashes/paper_tc1.double.csv",
                                 "hashes/paper_tc1.float.csv",
                                 "hashes/paper_tc1.reference.csv",
                                 "hashes/quick.double.csv",
                                 "hashes/quick.float.csv",
                                 "hashes/quick.reference.csv"};

/// Where data/ and the scripts may be, the nearest first.
std::vector<fs::path> homes()
{
    std::vector<fs::path> places;
    std::error_code no_proc;
    const fs::path program = fs::read_symlink("/proc/self/exe", no_proc);
    if (!no_proc) {
        const fs::path folder = program.parent_path();
        places.push_back((folder / installed_share()).lexically_normal());
        places.push_back(folder.parent_path().parent_path().parent_path()); // of PROJECT/build/PRESET/bin
    }
    places.emplace_back(project_sources());
    places.emplace_back(".");
    return places;
}

std::optional<fs::path> find(const fs::path& name)
{
    for (const fs::path& home : homes()) {
        std::error_code error;
        if (fs::exists(home / name, error)) {
            return (home / name).lexically_normal();
        }
    }
    return std::nullopt;
}

} // namespace

fs::path data_directory()
{
    const fs::path proof = fs::path("scenarios") / "base.json";
    const char* const named = std::getenv(variable);
    std::error_code error;
    if (named != nullptr && *named != '\0') {
        if (!fs::exists(named / proof, error)) {
            throw InputError(named, "not the folder of the shipped data, it has no scenarios/base.json",
                             "needed: --data, or the variable ANEURYSM_DATA, names the project's data/");
        }
        return named;
    }
    if (const auto found = find("data" / proof)) {
        return found->parent_path().parent_path();
    }
    throw InputError("data/", "the shipped scenarios are not there",
                     "needed: the project's data/, in " + homes().front().string() +
                         " or named by --data or the variable ANEURYSM_DATA");
}

void use_data_directory(const fs::path& directory)
{
    setenv(variable, directory.c_str(), 1);
}

void require_data()
{
    for (const std::string_view name : scenario_names) {
        shipped_scenario(std::string(name));
    }
    const fs::path data = data_directory();
    for (const fs::path name : other_files) {
        std::error_code error;
        if (!fs::exists(data / name, error)) {
            throw InputError((data / name).string(), "not there", "needed: the file as it was shipped");
        }
    }
}

fs::path shipped_script(const std::string& name)
{
    if (const auto found = find(name)) {
        return *found;
    }
    throw InputError(name, "not there",
                     "needed: the script as it was shipped, in " + homes().front().string());
}

Scenario shipped_scenario(const std::string& name)
{
    if (std::ranges::find(scenario_names, name) == scenario_names.end()) {
        throw std::logic_error(name + " is in no list of shipped scenarios (common/scenario/shipped.cpp)");
    }
    return read_scenario(data_directory() / "scenarios" / (name + ".json"));
}

} // namespace aneurysm
