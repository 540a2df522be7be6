// SPDX-License-Identifier: Apache-2.0
// How reports write numbers.
#pragma once

#include <cstdint>
#include <string>

namespace aneurysm::report
{

/// An error, a bound or a ratio with three digits; "-" for none, which is less than 0.
std::string shown(double x);
/// Any number, with six digits.
std::string shown_value(double x);
/// 12345 -> "12,345"
std::string grouped(std::int64_t n);
/// 0.3 -> "30 %"; "-" for none, which is less than 0.
std::string percent(double ratio);
/// printf of one number.
std::string printed(const char* format, double x);

} // namespace aneurysm::report
