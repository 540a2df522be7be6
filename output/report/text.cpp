// SPDX-License-Identifier: Apache-2.0
#include "output/report/text.hpp"

#include <algorithm>

namespace aneurysm::report
{
namespace
{

/// Characters, of which some are several bytes of UTF-8.
std::size_t width(const std::string& words)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        words, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(const std::string& words, std::size_t to, bool right)
{
    const std::string space(to - std::min(to, width(words)), ' ');
    return right ? space + words : words + space;
}

/// Each cell as wide as its column, without space at the end of the line.
std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                 const std::vector<Column>& columns)
{
    std::string text;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        text +=
            (k > 0 ? "  " : "") + padded(cells[k], widths.at(k), columns.at(k).kind == Column::Kind::number);
    }
    return text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
}

struct Writer {
    std::string operator()(const Text& words) const { return text(words) + "\n\n"; }
    std::string operator()(const Verdict& verdict) const { return text(verdict.words) + "\n\n"; }
    std::string operator()(const Heading& heading) const { return text(heading.words) + "\n\n"; }
    std::string operator()(const List& list) const
    {
        std::string lines;
        for (const Text& item : list.items) {
            lines += "- " + text(item) + "\n";
        }
        return lines + "\n";
    }
    std::string operator()(const Definitions& definitions) const
    {
        std::string lines;
        for (const auto& [word, meaning] : definitions.items) {
            lines += "- " + text(word) + ": " + text(meaning) + "\n";
        }
        return lines + "\n";
    }
    std::string operator()(const Table& table) const { return text(table) + "\n"; }
    std::string operator()(const Contents&) const { return {}; }
    std::string operator()(const Plot&) const { return {}; }
    std::string operator()(const Picture&) const { return {}; }
};

} // namespace

std::string text(const Text& text)
{
    std::string words;
    for (const Span& span : text.spans()) {
        words += span.words;
    }
    return words;
}

std::string text(const Table& table)
{
    std::vector<std::vector<std::string>> rows{{}};
    for (const Column& column : table.columns) {
        rows.front().push_back(column.name);
    }
    for (const Row& row : table.rows) {
        std::vector<std::string>& cells = rows.emplace_back();
        for (const Text& cell : row) {
            cells.push_back(text(cell));
        }
    }
    std::vector<std::size_t> widths(table.columns.size(), 0);
    for (const std::vector<std::string>& row : rows) {
        for (std::size_t k = 0; row.size() == widths.size() && k < row.size(); ++k) {
            widths[k] = std::max(widths[k], width(row[k]));
        }
    }
    std::string lines;
    for (const std::vector<std::string>& row : rows) {
        lines += line(row, widths, table.columns);
    }
    return lines;
}

std::string text(const Document& document)
{
    std::string lines = document.title + "\n\n";
    for (const Block& block : document.blocks) {
        lines += std::visit(Writer{}, block);
    }
    return lines;
}

} // namespace aneurysm::report
