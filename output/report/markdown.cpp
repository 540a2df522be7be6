// SPDX-License-Identifier: Apache-2.0
#include "output/report/markdown.hpp"

#include <algorithm>
#include <array>

namespace aneurysm::report
{
namespace
{

using Cells = std::vector<std::string>;

/// Characters, of which some are several bytes of UTF-8.
std::size_t width(const std::string& words)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        words, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

bool is_prose(const Column& column)
{
    return column.kind == Column::Kind::prose;
}

bool is_number(const Column& column)
{
    return column.kind == Column::Kind::number;
}

bool is_head(const Row& row, const Table& table)
{
    return row.size() == 1 && table.columns.size() > 1;
}

/// Blocks to paragraphs, in Markdown or in its words alone.
class Writer
{
public:
    explicit Writer(bool marks) : marks_(marks) {}

    std::string words(const Text& text, std::string_view line_break = " ") const
    {
        static constexpr std::array starts{"", "**", "`", "", "✓ ", "", "**✗ "}; // by Look
        static constexpr std::array ends{"", "**", "`", "", "", "", "**"};
        std::string result;
        for (const Span& span : text.spans()) {
            const auto look = static_cast<std::size_t>(span.look);
            result += marks_ ? starts.at(look) : "";
            result += escaped(span.words, span.look == Look::code, line_break);
            result += marks_ ? ends.at(look) : "";
        }
        return result;
    }

    std::string operator()(const Text& text) const { return words(text, "  \n") + "\n"; }
    std::string operator()(const Verdict& verdict) const
    {
        return words(verdict.words) + "\n" +
               (verdict.remark.empty() ? "" : "\n" + words(verdict.remark) + "\n");
    }
    std::string operator()(const Heading& heading) const
    {
        return std::string(static_cast<std::size_t>(heading.level), '#') + " " + words(heading.words) + "\n";
    }
    std::string operator()(const Contents&) const { return {}; }
    std::string operator()(const List& list) const
    {
        std::string text;
        for (const Text& item : list.items) {
            text += "- " + words(item) + "\n";
        }
        return text;
    }
    std::string operator()(const Table& table) const
    {
        const std::vector<std::size_t> widths = widths_of(table);
        std::string text;
        std::string below;
        for (std::size_t k = 0; k < table.rows.size(); ++k) {
            const Row& row = table.rows[k];
            const bool heads = is_head(row, table);
            if (heads) {
                text += (k > 0 ? "\n" : "") + words(row.front(), "  \n") + "\n\n";
            }
            if (heads || k == 0) {
                text += head(table.columns, widths);
            }
            if (!heads) {
                text += line(cells(row), table.columns, widths);
                below += marks_ ? sentences(row, table.columns) : "";
            }
        }
        return text + (below.empty() ? "" : "\n") + below;
    }
    std::string operator()(const Plot& plot) const
    {
        return "(Plot on the page: " + words(plot.title) + ")\n";
    }
    std::string operator()(const Picture& picture) const
    {
        return "(Picture on the page: " + words(picture.caption) + ")\n";
    }

private:
    /// Words without a meaning for Markdown.
    std::string escaped(const std::string& words, bool code, std::string_view line_break) const
    {
        const std::string_view special = marks_ && !code ? "|<*`\\" : "";
        std::string text;
        for (const char c : words) {
            text += special.find(c) != std::string_view::npos ? "\\" : "";
            text += c == '\n' ? std::string(line_break) : std::string(1, c);
        }
        return text;
    }

    Cells cells(const Row& row) const
    {
        Cells all;
        std::ranges::transform(row, std::back_inserter(all), [this](const Text& t) { return words(t); });
        return all;
    }

    /// Of each column; at least 3, the length of a rule.
    std::vector<std::size_t> widths_of(const Table& table) const
    {
        std::vector<std::size_t> widths;
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            widths.push_back(std::max<std::size_t>(width(words(table.columns[k].name)), 3));
            for (const Row& row : table.rows) {
                widths[k] = std::max(widths[k], is_head(row, table) ? 0 : width(words(row.at(k))));
            }
        }
        return widths;
    }

    /// Cells below one another, as wide as their columns; without the columns of prose.
    std::string line(const Cells& cells, const std::vector<Column>& columns,
                     const std::vector<std::size_t>& widths) const
    {
        std::string text = marks_ ? "| " : "";
        for (std::size_t k = 0; k < cells.size(); ++k) {
            if (!is_prose(columns.at(k))) {
                const std::string blanks(widths.at(k) - std::min(widths.at(k), width(cells[k])), ' ');
                text += is_number(columns[k]) ? blanks + cells[k] : cells[k] + blanks;
                text += marks_ ? " | " : "  ";
            }
        }
        return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
    }

    std::string head(const std::vector<Column>& columns, const std::vector<std::size_t>& widths) const
    {
        Cells names;
        Cells rule;
        for (std::size_t k = 0; k < columns.size(); ++k) {
            names.push_back(words(columns[k].name));
            rule.emplace_back(widths[k], '-');
            rule.back().back() = is_number(columns[k]) ? ':' : '-';
        }
        return line(names, columns, widths) + (marks_ ? line(rule, columns, widths) : "");
    }

    /// What stands in a row's columns of prose, as items of a list.
    std::string sentences(const Row& row, const std::vector<Column>& columns) const
    {
        std::string text;
        for (std::size_t k = 0; k < row.size(); ++k) {
            if (is_prose(columns.at(k)) && !row[k].empty()) {
                text +=
                    "- " + words(row.front()) + ", " + columns[k].name + ": " + words(row[k], "; ") + "\n";
            }
        }
        return text;
    }

    bool marks_;
};

std::string written(const Document& document, bool marks)
{
    std::string text = "# " + document.title + "\n";
    for (const Block& block : document.blocks) {
        const std::string part = std::visit(Writer(marks), block);
        text += part.empty() ? "" : "\n" + part;
    }
    return text;
}

} // namespace

std::string markdown(const Document& document)
{
    return written(document, true);
}

std::string text(const Document& document)
{
    return written(document, false);
}

std::string text(const Table& table)
{
    return Writer(false)(table);
}

std::string text(const Text& text)
{
    return Writer(false).words(text);
}

} // namespace aneurysm::report
