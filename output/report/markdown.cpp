// SPDX-License-Identifier: Apache-2.0
#include "output/report/markdown.hpp"

#include <algorithm>
#include <array>

namespace aneurysm::report
{
namespace
{

/// Words without a meaning for Markdown; a line break is `line_break`.
std::string escaped(const std::string& words, std::string_view line_break)
{
    static constexpr std::string_view special = "|<*`\\";
    std::string text;
    for (const char c : words) {
        text += special.find(c) != std::string_view::npos ? "\\" : "";
        text += c == '\n' ? std::string(line_break) : std::string(1, c);
    }
    return text;
}

std::string markdown(const Text& text, std::string_view line_break)
{
    static constexpr std::array starts{"", "**", "`", "", "✓ ", "", "**✗ "}; // by Look
    static constexpr std::array ends{"", "**", "`", "", "", "", "**"};
    std::string result;
    for (const Span& span : text.spans()) {
        const auto look = static_cast<std::size_t>(span.look);
        result += starts.at(look);
        result += span.look == Look::code ? span.words : escaped(span.words, line_break);
        result += ends.at(look);
    }
    return result;
}

std::string inline_text(const Text& text)
{
    return markdown(text, " ");
}

bool is_prose(const Column& column)
{
    return column.kind == Column::Kind::prose;
}

/// The head of a table, or nothing when all that it says is prose.
std::string head(const std::vector<Column>& columns)
{
    std::string names = "|";
    std::string rule = "|";
    for (const Column& column : columns) {
        if (!is_prose(column)) {
            names += " " + escaped(column.name, " ") + " |";
            rule += column.kind == Column::Kind::number ? "--:|" : "---|";
        }
    }
    return names + "\n" + rule + "\n";
}

/// What stands in a row's columns of prose, as items of a list.
std::string sentences(const Row& row, const std::vector<Column>& columns)
{
    std::string text;
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (is_prose(columns.at(k)) && !row[k].empty()) {
            text += "- " + inline_text(row.front()) + ", " + columns[k].name + ": " + markdown(row[k], "; ") +
                    "\n";
        }
    }
    return text;
}

struct Writer {
    std::string operator()(const Text& text) const { return markdown(text, "  \n") + "\n"; }
    std::string operator()(const Verdict& verdict) const
    {
        return inline_text(verdict.words) + "\n" +
               (verdict.remark.empty() ? "" : "\n" + inline_text(verdict.remark) + "\n");
    }
    std::string operator()(const Heading& heading) const
    {
        return std::string(static_cast<std::size_t>(heading.level), '#') + " " + inline_text(heading.words) +
               "\n";
    }
    std::string operator()(const Contents&) const { return {}; }
    std::string operator()(const List& list) const
    {
        std::string text;
        for (const Text& item : list.items) {
            text += "- " + inline_text(item) + "\n";
        }
        return text;
    }
    std::string operator()(const Definitions& definitions) const
    {
        std::string text;
        for (const auto& [word, meaning] : definitions.items) {
            text += "- " + inline_text(word) + ": " + inline_text(meaning) + "\n";
        }
        return text;
    }
    std::string operator()(const Table& table) const
    {
        std::string text;
        std::string below;
        for (std::size_t k = 0; k < table.rows.size(); ++k) {
            const Row& row = table.rows[k];
            const bool heads = row.size() == 1 && table.columns.size() > 1;
            if (heads) {
                text += (k > 0 ? "\n" : "") + markdown(row.front(), "  \n") + "\n\n";
            }
            if (heads || k == 0) {
                text += head(table.columns);
            }
            if (!heads) {
                text += cells(row, table.columns);
                below += sentences(row, table.columns);
            }
        }
        return text + (below.empty() ? "" : "\n") + below;
    }
    std::string operator()(const Plot& plot) const
    {
        return "(Plot on the page: " + inline_text(plot.title) + ")\n";
    }
    std::string operator()(const Picture& picture) const
    {
        return "(Picture on the page: " + inline_text(picture.caption) + ")\n";
    }

    static std::string cells(const Row& row, const std::vector<Column>& columns)
    {
        std::string line = "|";
        for (std::size_t k = 0; k < row.size(); ++k) {
            line += is_prose(columns.at(k)) ? "" : " " + inline_text(row[k]) + " |";
        }
        return line + "\n";
    }
};

} // namespace

std::string markdown(const Document& document)
{
    std::string text = "# " + document.title + "\n";
    for (const Block& block : document.blocks) {
        const std::string part = std::visit(Writer{}, block);
        text += part.empty() ? "" : "\n" + part;
    }
    return text;
}

} // namespace aneurysm::report
