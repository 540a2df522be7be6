// SPDX-License-Identifier: Apache-2.0
#include "output/report/document.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace aneurysm::report
{

bool Text::empty() const
{
    return std::ranges::all_of(spans_, [](const Span& s) { return s.words.empty(); });
}

Text& Text::operator+=(const Text& more)
{
    const std::vector<Span> added = more.spans_; // `more` may be this one
    spans_.insert(spans_.end(), added.begin(), added.end());
    return *this;
}

Document& Document::operator<<(Block block)
{
    blocks.push_back(std::move(block));
    return *this;
}

} // namespace aneurysm::report
