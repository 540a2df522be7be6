// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace aneurysm
{

/// 64-bit FNV-1a, byte by byte: the same on every machine of one byte order.
class Fnv1a
{
public:
    void add(std::span<const std::byte> bytes)
    {
        for (const std::byte b : bytes) {
            value_ = (value_ ^ std::to_integer<std::uint64_t>(b)) * 0x100000001b3U;
        }
    }

    std::uint64_t value() const { return value_; }

    /// The value as 16 hex digits.
    std::string hex() const
    {
        constexpr std::array digits{'0', '1', '2', '3', '4', '5', '6', '7',
                                    '8', '9', 'a', 'b', 'c', 'd', 'e', 'f'};
        std::string text(16, '0');
        for (std::size_t i = 0; i < text.size(); ++i) {
            text[i] = digits[(value_ >> (60 - 4 * i)) & 0xfU];
        }
        return text;
    }

private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

} // namespace aneurysm
