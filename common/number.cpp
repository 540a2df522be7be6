// SPDX-License-Identifier: Apache-2.0
#include "common/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace aneurysm
{
namespace
{

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

std::string_view without_plus(std::string_view text)
{
    return text.starts_with('+') && text.size() > 1 && text[1] != '-' ? text.substr(1) : text;
}

template <class Number>
std::optional<Number> parsed(std::string_view text)
{
    Number number{};
    const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = end.ec == std::errc() && end.ptr == text.data() + text.size();
    return whole ? std::optional(number) : std::nullopt;
}

/// Digits and the power of ten that they are to be multiplied by.
struct Decimal {
    std::string digits;
    std::int64_t exponent = 0;
};

/// Of a text without sign.
std::optional<Decimal> decimal(std::string_view text)
{
    const std::size_t e = std::min(text.find_first_of("eE"), text.size());
    Decimal number;
    bool has_point = false;
    for (const char c : text.substr(0, e)) {
        if (is_digit(c)) {
            number.digits += c;
            number.exponent -= has_point ? 1 : 0;
        } else if (c == '.' && !has_point) {
            has_point = true;
        } else {
            return std::nullopt;
        }
    }
    if (e < text.size()) {
        const auto power = parsed<std::int32_t>(without_plus(text.substr(e + 1)));
        if (!power) {
            return std::nullopt;
        }
        number.exponent += *power;
    }
    return number.digits.empty() ? std::nullopt : std::optional(number);
}

} // namespace

std::optional<std::int64_t> whole_number(std::string_view text)
{
    constexpr std::int64_t most_digits = 19; // of an std::int64_t
    text = without_plus(text);
    const bool negative = text.starts_with('-');
    std::optional<Decimal> number = decimal(text.substr(negative ? 1 : 0));
    if (!number) {
        return std::nullopt;
    }
    auto& [digits, exponent] = *number;
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
    while (digits.ends_with('0')) {
        digits.pop_back();
        ++exponent;
    }
    if (digits.empty()) {
        return 0;
    }
    if (exponent < 0 || static_cast<std::int64_t>(digits.size()) + exponent > most_digits) {
        return std::nullopt;
    }
    return parsed<std::int64_t>((negative ? "-" : "") +
                                digits.append(static_cast<std::size_t>(exponent), '0'));
}

std::optional<double> finite_number(std::string_view text)
{
    const std::optional<double> number = parsed<double>(without_plus(text));
    return number && std::isfinite(*number) ? number : std::nullopt;
}

} // namespace aneurysm
