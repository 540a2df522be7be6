// SPDX-License-Identifier: Apache-2.0
#include "output/report/html.hpp"

#include "common/file.hpp"
#include "output/report/markup.hpp"
#include "output/report/style.hpp"
#include "output/report/svg_plot.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <array>

namespace aneurysm::report
{
namespace
{

/// Words whose line breaks are the page's.
Markup lines(const std::string& words)
{
    Markup result;
    for (std::size_t from = 0; from <= words.size();) {
        const std::size_t end = std::min(words.find('\n', from), words.size());
        result << (from > 0 ? empty_element("br", {}) : Markup()) << words.substr(from, end - from);
        from = end + 1;
    }
    return result;
}

/// How a Look is shown.
struct Style {
    std::string_view element; ///< empty: none
    const char* css_class;
    const char* sign;
};
constexpr std::array<Style, 7> styles{{{"", "", ""},
                                       {"b", "", ""},
                                       {"code", "", ""},
                                       {"span", "weak", ""},
                                       {"span", "holds", "✓ "},
                                       {"span", "warn", ""},
                                       {"span", "fails", "✗ "}}};

Markup markup(const Span& span)
{
    const Style& style = styles.at(static_cast<std::size_t>(span.look));
    Markup words = Markup(style.sign) << lines(span.words);
    if (!span.target.empty()) {
        words = element("a", {{"href", "#" + span.target}}, words);
    }
    if (style.element.empty() && span.remark.empty()) {
        return words;
    }
    return element(style.element.empty() ? "span" : style.element,
                   {{"class", style.css_class}, {"title", span.remark}}, words);
}

Markup markup(const Text& text)
{
    Markup result;
    for (const Span& span : text.spans()) {
        result << markup(span);
    }
    return result;
}

Markup row(const Row& row, const std::vector<Column>& columns)
{
    if (row.size() == 1 && columns.size() > 1) {
        return element("tr", {{"class", "group"}},
                       element("th", {{"colspan", std::to_string(columns.size())}}, markup(row.front())));
    }
    static constexpr std::array classes{"", "number", "long", "sign"}; // by Column::Kind
    Markup cells;
    for (std::size_t k = 0; k < row.size(); ++k) {
        const char* style = classes.at(static_cast<std::size_t>(columns.at(k).kind));
        cells << element("td", {{"class", style}}, markup(row[k]));
    }
    return element("tr", {}, cells);
}

/// Blocks to elements of the page.
struct Writer {
    const Document& document;

    Markup operator()(const Text& text) const { return element("p", {}, markup(text)); }
    Markup operator()(const Verdict& verdict) const
    {
        const Look look = verdict.words.spans().front().look;
        const std::string style = look == Look::holds ? "verdict holds" : "verdict fails";
        Markup remark;
        if (!verdict.remark.empty()) {
            remark = element("div", {{"class", "who"}}, markup(verdict.remark));
        }
        return element("div", {{"class", style}}, markup(verdict.words), remark);
    }
    Markup operator()(const Heading& heading) const
    {
        return element("h" + std::to_string(heading.level), {{"id", heading.id}}, markup(heading.words));
    }
    Markup operator()(const Contents&) const
    {
        Markup items;
        for (const Block& block : document.blocks) {
            const auto* heading = std::get_if<Heading>(&block);
            if (heading != nullptr && heading->level == 2 && !heading->id.empty()) {
                items << element("li", {},
                                 element("a", {{"href", "#" + heading->id}}, markup(heading->words)));
            }
        }
        return element("nav", {}, element("ul", {}, items));
    }
    Markup operator()(const List& list) const
    {
        Markup items;
        for (const Text& item : list.items) {
            items << element("li", {}, markup(item));
        }
        return element("ul", {{"class", list.large ? "figures" : ""}}, items);
    }
    Markup operator()(const Table& table) const
    {
        Markup head;
        for (const Column& column : table.columns) {
            head << element("th", {{"class", column.kind == Column::Kind::sign ? "sign" : ""}}, column.name);
        }
        Markup body;
        for (const Row& r : table.rows) {
            body << row(r, table.columns) << "\n";
        }
        return element(
            "div", {{"class", "wide"}},
            element("table", {}, element("thead", {}, element("tr", {}, head)), element("tbody", {}, body)));
    }
    Markup operator()(const Plot& plot) const
    {
        return element("figure", {}, element("figcaption", {}, plot.title), svg(plot));
    }
    Markup operator()(const Picture& picture) const
    {
        const std::string source = "data:image/png;base64," + base64(read_text(picture.file));
        return element("figure", {{"class", "picture"}},
                       empty_element("img", {{"src", source}, {"alt", picture.caption}}),
                       element("figcaption", {}, picture.caption));
    }

    static std::string base64(const std::string& bytes)
    {
        namespace iterators = boost::archive::iterators;
        using Encoder =
            iterators::base64_from_binary<iterators::transform_width<std::string::const_iterator, 6, 8>>;
        std::string text(Encoder(bytes.cbegin()), Encoder(bytes.cend()));
        constexpr std::size_t group = 4;
        text.append((group - text.size() % group) % group, '=');
        return text;
    }
};

} // namespace

std::string html(const Document& document)
{
    Markup body = element("h1", {}, document.title) << "\n";
    for (const Block& block : document.blocks) {
        body << std::visit(Writer{document}, block) << "\n";
    }
    const Markup head = element(
        "head", {}, empty_element("meta", {{"charset", "utf-8"}}), "\n",
        empty_element("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}),
        "\n", element("title", {}, document.title), element("style", {}, Markup::verbatim(page_style)));
    return "<!DOCTYPE html>\n" +
           element("html", {{"lang", "en"}}, head, "\n", element("body", {}, "\n", body)).text() + "\n";
}

} // namespace aneurysm::report
