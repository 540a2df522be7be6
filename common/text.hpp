// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace aneurysm
{

/// Words with a separator between them.
template <class Words>
std::string joined(const Words& words, std::string_view separator = ", ")
{
    std::string text;
    for (const auto& word : words) {
        text.append(text.empty() ? "" : separator).append(word);
    }
    return text;
}

} // namespace aneurysm
