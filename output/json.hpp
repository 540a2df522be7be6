// SPDX-License-Identifier: Apache-2.0
// What our JSON reports share.
#pragma once

#include <nlohmann/json.hpp>

#include <cmath>
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

inline std::string json_text(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace aneurysm::output
