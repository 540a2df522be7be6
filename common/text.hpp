// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
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

/// Without line ends and what else a terminal acts on, which names and files may have in them.
inline std::string one_line(std::string text)
{
    std::ranges::replace_if(
        text, [](unsigned char c) { return c < ' ' || c == 0x7F; }, '?');
    return text;
}

/// A piece of a file for a message: on one line, and not too long.
inline std::string excerpt(std::string_view piece, std::size_t longest = 60)
{
    if (piece.size() <= longest) {
        return one_line(std::string(piece));
    }
    while (longest > 0 && (static_cast<unsigned char>(piece[longest]) & 0xC0U) == 0x80U) {
        --longest; // not within a character of UTF-8
    }
    return one_line(std::string(piece.substr(0, longest))) + "...";
}

/// As a shell takes it for one word.
inline std::string shell_word(const std::string& word)
{
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
        return word;
    }
    std::string text = "'";
    for (const char c : word) {
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return text + "'";
}

} // namespace aneurysm
