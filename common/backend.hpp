// SPDX-License-Identifier: Apache-2.0
// Who computes, and the words for it on the command line, in manifests and in reports.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace aneurysm
{

enum class Backend { reference, cpu, cuda };
inline constexpr std::array<std::string_view, 3> backend_names{"reference", "cpu", "cuda"};

enum class Precision { double_, float_ };
inline constexpr std::array<std::string_view, 2> precision_names{"double", "float"};

inline std::string name_of(Backend backend)
{
    return std::string(backend_names.at(static_cast<std::size_t>(backend)));
}
inline std::string name_of(Precision precision)
{
    return std::string(precision_names.at(static_cast<std::size_t>(precision)));
}

/// The value of an enumeration that a word names.
template <class Enum, std::size_t n>
constexpr std::optional<Enum> value_of(std::string_view word, const std::array<std::string_view, n>& names)
{
    const auto found = std::ranges::find(names, word);
    return found == names.end() ? std::nullopt : std::optional(static_cast<Enum>(found - names.begin()));
}

/// A backend on this machine.
struct Engine {
    Backend backend = Backend::reference;
    Precision precision = Precision::double_;
    std::string device; ///< in words
};

} // namespace aneurysm
