// SPDX-License-Identifier: Apache-2.0
// What a report says, before it is written down: whoever knows the content builds a Document, and html.hpp and
// markdown.hpp write it. So all forms of a report have the same rows and numbers.
#pragma once

#include "output/report/plot.hpp"

#include <algorithm>
#include <concepts>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace aneurysm::report
{

/// How words look. The writers add a sign to what holds or fails, so that color is never needed to tell.
enum class Look { plain, strong, code, weak, holds, warn, fails };

/// Words that look the same.
struct Span {
    std::string words; ///< a line break in them is one of the cell or paragraph
    Look look = Look::plain;
    std::string target{}; ///< id of a heading that they lead to; empty: no link
    std::string remark{}; ///< what the pointer shows
};

/// A line of spans.
class Text
{
public:
    Text() = default;
    template <std::convertible_to<std::string_view> Words>
    Text(const Words& words, Look look = Look::plain) // NOLINT: wanted
        : spans_{{std::string(std::string_view(words)), look}}
    {
    }
    Text(Span span) : spans_{std::move(span)} {} // NOLINT: wanted

    const std::vector<Span>& spans() const { return spans_; }
    bool empty() const
    {
        return std::ranges::all_of(spans_, [](const Span& s) { return s.words.empty(); });
    }

    Text& operator+=(Text more) // a copy: it may be this one
    {
        std::ranges::move(more.spans_, std::back_inserter(spans_));
        return *this;
    }
    friend Text operator+(Text a, const Text& b) { return std::move(a += b); }

private:
    std::vector<Span> spans_;
};

/// Items with a separator between them.
template <class Range>
Text joined(const Range& items, std::string_view separator)
{
    Text text;
    for (const auto& item : items) {
        text += (text.empty() ? Text() : Text(separator)) + Text(item);
    }
    return text;
}

/// A column of a table.
struct Column {
    enum class Kind {
        text,
        number, ///< right-aligned
        prose,  ///< sentences: wide on a page, below the table in Markdown
        sign,   ///< one sign a row under a heading from bottom to top
    };
    template <std::convertible_to<std::string_view> Words>
    Column(const Words& heading, Kind k = Kind::text)
        : name(std::string_view(heading)), kind(k) // NOLINT: wanted
    {
    }

    std::string name;
    Kind kind;
};
inline Column number(std::string_view name)
{
    return {name, Column::Kind::number};
}
inline Column prose(std::string_view name)
{
    return {name, Column::Kind::prose};
}

using Row = std::vector<Text>;

/// Rows under the names of their columns. A row of a single cell heads those after it.
struct Table {
    std::vector<Column> columns;
    std::vector<Row> rows{};
};

/// What stands largest, right below the title.
struct Verdict {
    Text words;
    Text remark{};
};
struct Heading {
    int level = 2;
    Text words;
    std::string id{};
};
/// Links to all headings of level 2 that have an id.
struct Contents {
};
struct List {
    std::vector<Text> items{};
    bool large = false; ///< numbers that a reader should see first: strong, each with what it counts
};
struct Picture {
    std::filesystem::path file; ///< PNG
    std::string caption;
};

/// A Text is a paragraph.
using Block = std::variant<Text, Verdict, Heading, Contents, List, Table, Plot, Picture>;

struct Document {
    std::string title;
    std::vector<Block> blocks{};

    Document& operator<<(Block block)
    {
        blocks.push_back(std::move(block));
        return *this;
    }
};

} // namespace aneurysm::report
