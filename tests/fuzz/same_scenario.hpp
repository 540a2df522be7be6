// SPDX-License-Identifier: Apache-2.0
// What holds for every scenario that a reader takes.
#pragma once

#include "common/scenario/fields.hpp"
#include "common/scenario/scenario.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>

namespace aneurysm::test
{

/// Written and read again it is the same, to the last bit.
inline void require_same_again(const Scenario& scenario)
{
    const std::string text = to_json(scenario);
    const Scenario again = parse_scenario(text, "again");
    require(to_json(again) == text, "the same text again: " + text);
    require(scenario_hash(again) == scenario_hash(scenario), "the same hash again");
}

/// Every number is finite and within the range of its field.
inline void require_in_range(const Scenario& scenario)
{
    fields::visit(scenario, [](const fields::Field& field, const auto& member) {
        const auto number = [&field](double x) {
            require(std::isfinite(x) && field.range.contains(x), "in range: " + std::string(field.path));
        };
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (std::is_arithmetic_v<Member>) {
            number(static_cast<double>(member));
        } else if constexpr (std::is_same_v<Member, Vec3>) {
            number(member.x), number(member.y), number(member.z);
        } else if constexpr (std::is_same_v<Member, std::vector<double>>) {
            std::for_each(member.begin(), member.end(), number);
        }
    });
}

/// Every value of the text is in the scenario, as it stands in the text.
inline void require_all_taken(const nlohmann::json& said, const Scenario& scenario)
{
    const nlohmann::json taken = nlohmann::json::parse(to_json(scenario));
    for (const auto& [group, value] : said.items()) {
        if (group == "base" || group == "$schema") {
            continue;
        }
        if (!value.is_object()) {
            require(taken.at(group) == value, "taken as it stands: " + group);
            continue;
        }
        for (const auto& [key, member] : value.items()) {
            require(taken.at(group).at(key) == member, "taken as it stands: " + group + "." + key);
        }
    }
}

} // namespace aneurysm::test
