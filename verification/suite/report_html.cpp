// SPDX-License-Identifier: Apache-2.0
#include "output/build_info.hpp"
#include "output/report/style.hpp"
#include "verification/suite/html.hpp"

#include <array>
#include <utility>

namespace aneurysm::suite
{

report::Markup table(const std::vector<std::string>& head, const report::Markup& rows)
{
    report::Markup cells;
    for (const std::string& name : head) {
        cells << report::element("th", {}, name);
    }
    return report::element("div", {{"class", "wide"}},
                           report::element("table", {}, report::element("thead", {}, row(cells)),
                                           report::element("tbody", {}, rows)))
           << "\n";
}

report::Markup cell(const report::Markup& content)
{
    return report::element("td", {}, content);
}

report::Markup number_cell(const report::Markup& content)
{
    return report::element("td", {{"class", "number"}}, content);
}

report::Markup mark(Verdict verdict, const std::string& more)
{
    static constexpr std::array classes{"holds", "fails", "weak"};
    static constexpr std::array signs{"✓ ", "✗ ", ""};
    const auto k = static_cast<std::size_t>(verdict);
    const bool plain = verdict == Verdict::holds && !more.empty(); // the color says enough
    return report::element("span", {{"class", classes.at(k)}}, signs.at(k), plain ? "" : name_of(verdict),
                           plain || more.empty() ? "" : " ", more);
}

report::Markup check_link(const Check& check)
{
    return report::element("a", {{"href", "#check-" + std::string(check.id)}}, check.id);
}

report::Markup level_heading(Level level)
{
    return report::Markup("L") << std::to_string(static_cast<int>(level)) << ": " << name_of(level);
}

report::Markup joined(const std::vector<std::string_view>& words, std::string_view separator)
{
    report::Markup text;
    for (const std::string_view word : words) {
        text << (text.empty() ? "" : separator) << word;
    }
    return text;
}

namespace
{

report::Markup contents()
{
    report::Markup list;
    for (const auto& [id, title] : {std::pair{"equations", "Equation by equation"},
                                    {"checks", "Check by check"},
                                    {"ledger", "Every number and its bound"},
                                    {"about", "How to read and repeat this"}}) {
        list << report::element("li", {}, report::element("a", {{"href", "#" + std::string(id)}}, title));
    }
    return report::element("nav", {}, report::element("ul", {}, list)) << "\n";
}

report::Markup head(const std::string& title)
{
    return report::element("head", {},
                           report::Markup::verbatim("<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                                                    "content=\"width=device-width, initial-scale=1\">\n"),
                           report::element("title", {}, title),
                           report::element("style", {}, report::Markup::verbatim(report::suite_style)));
}

} // namespace

std::string suite_html(const SuiteReport& report)
{
    const std::string title = std::string("Verification of aneurysm ") + output::build_info().version;
    const report::Markup body = report::element("h1", {}, title)
                                << summary_section(report) << contents() << equations_section(report)
                                << checks_section(report) << ledger_section(report) << about_section(report);
    return "<!DOCTYPE html>\n" +
           report::element("html", {{"lang", "en"}}, head(title), "\n",
                           report::element("body", {}, "\n", body))
               .text() +
           "\n";
}

} // namespace aneurysm::suite
