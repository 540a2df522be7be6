// SPDX-License-Identifier: Apache-2.0
#include "output/build_info.hpp"
#include "output/file.hpp"
#include "output/provenance.hpp"
#include "verification/markup.hpp"
#include "verification/reproduce/section.hpp"
#include "verification/suite_style.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>

namespace aneurysm::verification
{
namespace
{

constexpr std::string_view picture_style = R"css(
figure.picture { max-width: none; display: block; margin: 1rem 0; }
figure.picture img { max-width: 100%; height: auto; background: #fff; }
)css";

std::string base64(const std::vector<std::byte>& bytes)
{
    namespace iterators = boost::archive::iterators;
    using Encoder =
        iterators::base64_from_binary<iterators::transform_width<std::string::const_iterator, 6, 8>>;
    std::string raw(bytes.size(), '\0');
    std::ranges::transform(bytes, raw.begin(), [](std::byte b) { return static_cast<char>(b); });
    std::string text(Encoder(raw.cbegin()), Encoder(raw.cend()));
    constexpr std::size_t group = 4;
    text.append((group - text.size() % group) % group, '=');
    return text;
}

Markup picture(const Picture& p)
{
    const std::string source = "data:image/png;base64," + base64(output::read_bytes(p.file));
    return element("figure", {{"class", "picture"}},
                   empty_element("img", {{"src", source}, {"alt", p.caption}}),
                   element("figcaption", {}, p.caption));
}

Markup table(const ResultTable& t)
{
    Markup head;
    for (const std::string& column : t.columns) {
        head << element("th", {}, column);
    }
    Markup body;
    for (const std::vector<std::string>& row : t.rows) {
        Markup cells;
        for (const std::string& cell : row) {
            cells << element("td", {}, cell);
        }
        body << element("tr", {}, cells) << "\n";
    }
    Markup title;
    if (!t.title.empty()) {
        title << element("h4", {}, t.title);
    }
    return title << element("div", {{"class", "wide"}},
                            element("table", {}, element("thead", {}, element("tr", {}, head)),
                                    element("tbody", {}, body)));
}

Markup verdict(bool holds)
{
    return holds ? element("span", {{"class", "holds"}}, "holds")
                 : element("span", {{"class", "fails"}}, "does not hold");
}

Markup claims(const std::vector<Claim>& all)
{
    Markup rows;
    for (const Claim& claim : all) {
        rows << element("tr", {}, element("td", {}, claim.words), element("td", {}, verdict(claim.holds)),
                        element("td", {}, claim.found));
    }
    return element("div", {{"class", "wide"}},
                   element("table", {},
                           element("thead", {},
                                   element("tr", {}, element("th", {}, "What the paper says"),
                                           element("th", {}, "here"), element("th", {}, "found"))),
                           element("tbody", {}, rows)));
}

Markup section(const Section& s)
{
    Markup body = element("h2", {{"id", s.id}}, s.title);
    for (const std::string& paragraph : s.text) {
        body << element("p", {}, paragraph);
    }
    for (const Picture& p : s.pictures) {
        body << picture(p);
    }
    for (const ResultTable& t : s.tables) {
        body << table(t);
    }
    if (!s.claims.empty()) {
        body << claims(s.claims);
    }
    return body << "\n";
}

Markup summary(const std::vector<Section>& sections)
{
    Markup rows;
    for (const Section& s : sections) {
        const auto hold = std::ranges::count_if(s.claims, &Claim::holds);
        const std::string count = s.claims.empty() ? ""
                                                   : std::to_string(hold) + " of " +
                                                         std::to_string(s.claims.size()) + " claims hold";
        rows << element("tr", {}, element("td", {}, element("a", {{"href", "#" + s.id}}, s.title)),
                        element("td", {}, count));
    }
    return element("table", {}, element("tbody", {}, rows));
}

} // namespace

std::string page(const std::vector<Section>& sections, const std::string& command)
{
    const std::string title =
        std::string("The paper, reproduced by aneurysm ") + output::build_info().version;
    Markup body = element("h1", {}, title);
    body << element("p", {},
                    "Wu et al., Computational Simulation of Aneurysms Using Smoothed Particle Hydrodynamics, "
                    "Mathematics 2025, 13(15), 2439: each table and figure beside what this program makes of "
                    "it. Made by ",
                    element("code", {}, command), " on ", output::machine(), ", commit ",
                    element("code", {}, output::build_info().commit), ", ", output::now_utc(), ".")
         << summary(sections);
    for (const Section& s : sections) {
        body << section(s);
    }
    const Markup head =
        element("head", {},
                Markup::verbatim("<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                                 "content=\"width=device-width, initial-scale=1\">\n"),
                element("title", {}, title),
                element("style", {}, Markup::verbatim(suite_style), Markup::verbatim(picture_style)));
    return "<!DOCTYPE html>\n" +
           element("html", {{"lang", "en"}}, head, "\n", element("body", {}, "\n", body)).text() + "\n";
}

} // namespace aneurysm::verification
