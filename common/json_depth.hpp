// SPDX-License-Identifier: Apache-2.0
// How deep the JSON that we read may be nested: what recursion over its values can stand.
#pragma once

namespace aneurysm
{

inline constexpr int deepest_json = 100;
inline constexpr const char* nested_too_deep = "nested deeper than 100 levels";

} // namespace aneurysm
