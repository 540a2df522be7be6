// SPDX-License-Identifier: Apache-2.0
#include "common/scenario/shipped.hpp"

#include "common/error.hpp"

namespace aneurysm
{

std::filesystem::path data_directory()
{
    for (const std::filesystem::path place : {"data", ANEURYSM_DATA}) {
        if (std::filesystem::exists(place / "scenarios" / "base.json")) {
            return place;
        }
    }
    throw InputError("data/", "the shipped scenarios are not there",
                     "start the program in the project's folder");
}

Scenario shipped_scenario(const std::string& name)
{
    return read_scenario(data_directory() / "scenarios" / (name + ".json"));
}

} // namespace aneurysm
