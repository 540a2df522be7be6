// SPDX-License-Identifier: Apache-2.0
// What our JSON reports share.
#pragma once

#include "common/error.hpp"
#include "common/file.hpp"

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

/// \throws InputError with `advice` for a file that isn't there or no JSON
inline Json read_json(const std::filesystem::path& file, const std::string& advice)
{
    try {
        return Json::parse(read_text(file));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(file.string(), std::string("not as it was written (") + error.what() + ")", advice);
    }
}

inline std::string json_text(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace aneurysm::output
