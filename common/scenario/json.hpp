// SPDX-License-Identifier: Apache-2.0
// What the files of the scenario's reader share; nothing else includes it.
#pragma once

#include "common/error.hpp"
#include "common/scenario/fields.hpp"
#include "common/text.hpp"

#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace aneurysm::fields
{

using Json = nlohmann::ordered_json;

/// {"group", "key"} of a path; the group of a top-level key is empty.
inline std::pair<std::string, std::string> split(std::string_view path)
{
    const auto dot = path.find('.');
    if (dot == std::string_view::npos) {
        return {"", std::string(path)};
    }
    return {std::string(path.substr(0, dot)), std::string(path.substr(dot + 1))};
}

/// A value for a message: one line, not too long.
inline std::string shown(const Json& value)
{
    constexpr std::size_t longest = 60;
    const std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
    return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

/// Where something is wrong, for messages: "file: path".
inline std::string place(const std::string& origin, std::string_view path)
{
    return origin + ": " + excerpt(path);
}

/// What a range allows, for messages: "a number > 0 and <= 1.0".
std::string describe(const Range& range, bool integer);

/// Parses JSON text; refuses malformed text and keys that appear twice in an object.
Json parse_strictly(const std::string& text, const std::string& origin);

/// Reads what `json` has into `scenario` and adds the paths to `present`. Unknown keys, wrong types and
/// values out of range are errors; missing keys are not. `base` and `$schema` are for the caller.
void apply(const Json& json, const std::string& origin, Scenario& scenario, std::set<std::string>& present);

} // namespace aneurysm::fields
