// SPDX-License-Identifier: Apache-2.0
// What the checks of level L0 call equations and oracles with.
#pragma once

#include "verification/checks/vectors.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <random>
#include <string>
#include <utility>

namespace aneurysm::checks
{

/// Numbers without a pattern that could hide an exponent, a factor or an exchange; the same in every run and
/// on every machine.
class Arguments
{
public:
    explicit Arguments(std::uint64_t seed) : engine_(seed) {}

    /// Even in [low, high).
    double between(double low, double high)
    {
        return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11U), -53);
    }
    /// Each component in [-size, size).
    Vec3 vector(double size)
    {
        const double x = between(-size, size);
        const double y = between(-size, size);
        return {x, y, between(-size, size)};
    }
    /// A whole number in [-size, size).
    std::int64_t whole(std::int64_t size)
    {
        return static_cast<std::int64_t>(engine_() % static_cast<std::uint64_t>(2 * size)) - size;
    }

private:
    std::mt19937_64 engine_;
};

/// "R = 0.11, h = 0.0075", for the report.
inline std::string at(std::initializer_list<std::pair<const char*, double>> arguments)
{
    std::string text;
    for (const auto& [name, value] : arguments) {
        std::array<char, 32> number{};
        std::snprintf(number.data(), number.size(), "%.9g", value);
        text.append(text.empty() ? "" : ", ").append(name).append(" = ").append(number.data());
    }
    return text;
}

} // namespace aneurysm::checks
