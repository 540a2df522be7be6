// SPDX-License-Identifier: Apache-2.0
#include "common/scenario/shipped.hpp"

#include "common/error.hpp"
#include "common/process/subprocess.hpp"

#include <cstdlib>
#include <optional>
#include <system_error>
#include <vector>

namespace aneurysm
{
namespace
{

namespace fs = std::filesystem;

constexpr const char* variable = "ANEURYSM_DATA";
/// Where data/ and the scripts may be, the nearest first.
std::vector<fs::path> homes()
{
    std::vector<fs::path> places;
    const fs::path folder = program_folder();
    if (!folder.empty()) {
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
    const fs::path data = data_directory();
    for (const fs::path file : shipped_files()) {
        std::error_code error;
        if (!fs::exists(data / file, error)) {
            throw InputError((data / file).string(), "not there", "needed: the file as it was shipped");
        }
        if (file.parent_path() == "scenarios") {
            read_scenario(data / file);
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
    return read_scenario(data_directory() / "scenarios" / (name + ".json"));
}

} // namespace aneurysm
