// SPDX-License-Identifier: Apache-2.0
#include "output/build_info.hpp"
#include "output/file.hpp"
#include "output/provenance.hpp"
#include "output/report/markup.hpp"
#include "output/report/style.hpp"
#include "verification/reproduction/section.hpp"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>

namespace aneurysm::reproduction
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

report::Markup picture(const Picture& p)
{
    const std::string source = "data:image/png;base64," + base64(output::read_bytes(p.file));
    return report::element("figure", {{"class", "picture"}},
                           report::empty_element("img", {{"src", source}, {"alt", p.caption}}),
                           report::element("figcaption", {}, p.caption));
}

report::Markup table(const ResultTable& t)
{
    report::Markup head;
    for (const std::string& column : t.columns) {
        head << report::element("th", {}, column);
    }
    report::Markup body;
    for (const std::vector<std::string>& row : t.rows) {
        report::Markup cells;
        for (const std::string& cell : row) {
            cells << report::element("td", {}, cell);
        }
        body << report::element("tr", {}, cells) << "\n";
    }
    report::Markup title;
    if (!t.title.empty()) {
        title << report::element("h4", {}, t.title);
    }
    return title << report::element(
               "div", {{"class", "wide"}},
               report::element("table", {}, report::element("thead", {}, report::element("tr", {}, head)),
                               report::element("tbody", {}, body)));
}

report::Markup verdict(bool holds)
{
    return holds ? report::element("span", {{"class", "holds"}}, "holds")
                 : report::element("span", {{"class", "fails"}}, "does not hold");
}

report::Markup claims(const std::vector<Claim>& all)
{
    report::Markup rows;
    for (const Claim& claim : all) {
        rows << report::element("tr", {}, report::element("td", {}, claim.words),
                                report::element("td", {}, verdict(claim.holds)),
                                report::element("td", {}, claim.found));
    }
    return report::element(
        "div", {{"class", "wide"}},
        report::element(
            "table", {},
            report::element("thead", {},
                            report::element("tr", {}, report::element("th", {}, "What the paper says"),
                                            report::element("th", {}, "here"),
                                            report::element("th", {}, "found"))),
            report::element("tbody", {}, rows)));
}

report::Markup section(const Section& s)
{
    report::Markup body = report::element("h2", {{"id", s.id}}, s.title);
    for (const std::string& paragraph : s.text) {
        body << report::element("p", {}, paragraph);
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

report::Markup summary(const std::vector<Section>& sections)
{
    report::Markup rows;
    for (const Section& s : sections) {
        const auto hold = std::ranges::count_if(s.claims, &Claim::holds);
        const std::string count = s.claims.empty() ? ""
                                                   : std::to_string(hold) + " of " +
                                                         std::to_string(s.claims.size()) + " claims hold";
        rows << report::element(
            "tr", {}, report::element("td", {}, report::element("a", {{"href", "#" + s.id}}, s.title)),
            report::element("td", {}, count));
    }
    return report::element("table", {}, report::element("tbody", {}, rows));
}

} // namespace

std::string page(const std::vector<Section>& sections, const std::string& command)
{
    const std::string title =
        std::string("The paper, reproduced by aneurysm ") + output::build_info().version;
    report::Markup body = report::element("h1", {}, title);
    body << report::element(
                "p", {},
                "Wu et al., Computational Simulation of Aneurysms Using Smoothed Particle Hydrodynamics, "
                "Mathematics 2025, 13(15), 2439: each table and figure beside what this program makes of "
                "it. Made by ",
                report::element("code", {}, command), " on ", output::machine(), ", commit ",
                report::element("code", {}, output::build_info().commit), ", ", output::now_utc(), ".")
         << summary(sections);
    for (const Section& s : sections) {
        body << section(s);
    }
    const report::Markup head =
        report::element("head", {},
                        report::Markup::verbatim("<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                                                 "content=\"width=device-width, initial-scale=1\">\n"),
                        report::element("title", {}, title),
                        report::element("style", {}, report::Markup::verbatim(report::suite_style),
                                        report::Markup::verbatim(picture_style)));
    return "<!DOCTYPE html>\n" +
           report::element("html", {{"lang", "en"}}, head, "\n", report::element("body", {}, "\n", body))
               .text() +
           "\n";
}

} // namespace aneurysm::reproduction
