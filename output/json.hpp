// SPDX-License-Identifier: Apache-2.0
// What our JSON reports share.
#pragma once

#include "common/error.hpp"
#include "common/file.hpp"
#include "common/json_depth.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <string>

namespace aneurysm::output
{

using Json = nlohmann::ordered_json;

/// JSON has no infinity.
inline Json json_number(double x)
{
    return std::isfinite(x) ? Json(x) : Json(std::isnan(x) ? "nan" : "infinite");
}

/// An array of what f makes of each.
template <class Range, class F>
Json json_array(const Range& range, const F& f)
{
    Json array = Json::array();
    for (const auto& x : range) {
        array.push_back(f(x));
    }
    return array;
}

/// What `read` makes of a file of ours. \throws InputError with `advice` for a file that isn't there, no JSON, nested as
/// none of ours is, or with other types than `read` takes for granted
template <class Read>
auto read_json_as(const std::filesystem::path& file, const std::string& advice, const Read& read)
{
    const auto fail = [&](const std::string& why) {
        throw InputError(file.string(), "not as it was written (" + why + ")", advice);
    };
    const auto watch = [&](int depth, Json::parse_event_t, const Json&) {
        if (depth > deepest_json) {
            fail(nested_too_deep);
        }
        return true;
    };
    try {
        return read(Json::parse(read_text(file), watch));
    } catch (const nlohmann::json::exception& error) {
        fail(error.what());
        throw; // not reached
    }
}

inline Json read_json(const std::filesystem::path& file, const std::string& advice)
{
    return read_json_as(file, advice, [](Json json) { return json; });
}

inline std::string json_text(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace aneurysm::output
