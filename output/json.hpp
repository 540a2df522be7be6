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

inline std::string json_text(const Json& json)
{
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace aneurysm::output
