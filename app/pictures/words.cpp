// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/words.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <charconv>

namespace aneurysm::app
{

pictures::View view_of(const std::string& word)
{
    const auto* const found = std::ranges::find(pictures::view_names, word);
    if (found == pictures::view_names.end()) {
        std::string allowed;
        for (const std::string_view name : pictures::view_names) {
            allowed += (allowed.empty() ? "" : ", ") + std::string(name);
        }
        throw InputError("--view", "unknown (" + word + ")", "allowed: " + allowed);
    }
    return static_cast<pictures::View>(found - pictures::view_names.begin());
}

pictures::Quantity quantity_of(const std::string& word)
{
    if (word != "speed" && word != "pressure") {
        throw InputError("--color", "unknown (" + word + ")", "allowed: speed, pressure");
    }
    return word == "speed" ? pictures::Quantity::speed : pictures::Quantity::pressure;
}

std::pair<int, int> size_of(const std::string& word)
{
    constexpr int least = 64;
    constexpr int most = 4096; // twice as many are drawn; OpenGL's textures end at 8192
    const auto good = [](int n) { return n >= least && n <= most && n % 2 == 0; };
    int width = 0;
    int height = 0;
    const char* const end = word.data() + word.size();
    const auto first = std::from_chars(word.data(), end, width);
    const bool cross = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
    const auto second = cross ? std::from_chars(first.ptr + 1, end, height) : first;
    if (!cross || second.ec != std::errc() || second.ptr != end || !good(width) || !good(height)) {
        throw InputError("--size", "no size (" + word + ")",
                         "needed: WIDTHxHEIGHT, even numbers from " + std::to_string(least) + " to " +
                             std::to_string(most));
    }
    return {width, height};
}

void require_artery(const std::string& where, const Scenario& scenario)
{
    if (scenario.domain.form != DomainForm::artery) {
        throw InputError(where + ": domain.form", "scenario " + scenario.name + " has no artery to show",
                         "needed: artery");
    }
}

} // namespace aneurysm::app
