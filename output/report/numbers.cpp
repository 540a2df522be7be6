// SPDX-License-Identifier: Apache-2.0
#include "output/report/numbers.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace aneurysm::report
{

std::string shown(double x)
{
    return x < 0 ? "-" : std::isinf(x) ? "infinite" : printed("%.3g", x);
}

std::string shown_value(double x)
{
    return printed("%.6g", x);
}

std::string grouped(std::int64_t n)
{
    std::string text = std::to_string(n);
    for (auto place = static_cast<std::int64_t>(text.size()) - 3; place > 0; place -= 3) {
        text.insert(static_cast<std::size_t>(place), ",");
    }
    return text;
}

std::string percent(double ratio)
{
    return ratio < 0 ? "-" : std::isinf(ratio) ? "more than it all" : shown(100 * ratio) + " %";
}

std::string printed(const char* format, double x)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), format, x);
    return text.data();
}

} // namespace aneurysm::report
