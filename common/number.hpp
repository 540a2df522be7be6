// SPDX-License-Identifier: Apache-2.0
// Numbers as people type them, the same in all options: decimal, whatever they begin with.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace aneurysm
{

/// A number without a fraction: 10, 010 (ten), +10, 1e3, 20.0. Nothing for other text, and for what doesn't fit.
std::optional<std::int64_t> whole_number(std::string_view text);

/// Nothing for other text, nan, and what is beyond double.
std::optional<double> finite_number(std::string_view text);

} // namespace aneurysm
