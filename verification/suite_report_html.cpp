// SPDX-License-Identifier: Apache-2.0
#include "output/build_info.hpp"
#include "verification/suite_html.hpp"
#include "verification/suite_style.hpp"

#include <array>
#include <utility>

namespace aneurysm::verification
{

Markup table(const std::vector<std::string>& head, const Markup& rows)
{
    Markup cells;
    for (const std::string& name : head) {
        cells << element("th", {}, name);
    }
    return element("div", {{"class", "wide"}},
                   element("table", {}, element("thead", {}, row(cells)), element("tbody", {}, rows)))
           << "\n";
}

Markup cell(const Markup& content)
{
    return element("td", {}, content);
}

Markup number_cell(const Markup& content)
{
    return element("td", {{"class", "number"}}, content);
}

Markup mark(Verdict verdict, const std::string& more)
{
    static constexpr std::array classes{"holds", "fails", "weak"};
    static constexpr std::array signs{"✓ ", "✗ ", ""};
    const auto k = static_cast<std::size_t>(verdict);
    const bool plain = verdict == Verdict::holds && !more.empty(); // the colour says enough
    return element("span", {{"class", classes.at(k)}}, signs.at(k), plain ? "" : name_of(verdict),
                   plain || more.empty() ? "" : " ", more);
}

Markup check_link(const Check& check)
{
    return element("a", {{"href", "#check-" + std::string(check.id)}}, check.id);
}

Markup level_heading(Level level)
{
    return Markup("L") << std::to_string(static_cast<int>(level)) << ": " << name_of(level);
}

Markup joined(const std::vector<std::string_view>& words, std::string_view separator)
{
    Markup text;
    for (const std::string_view word : words) {
        text << (text.empty() ? "" : separator) << word;
    }
    return text;
}

namespace
{

Markup contents()
{
    Markup list;
    for (const auto& [id, title] : {std::pair{"equations", "Equation by equation"},
                                    {"checks", "Check by check"},
                                    {"ledger", "Every number and its bound"},
                                    {"about", "How to read and repeat this"}}) {
        list << element("li", {}, element("a", {{"href", "#" + std::string(id)}}, title));
    }
    return element("nav", {}, element("ul", {}, list)) << "\n";
}

Markup head(const std::string& title)
{
    return element("head", {},
                   Markup::verbatim("<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                                    "content=\"width=device-width, initial-scale=1\">\n"),
                   element("title", {}, title), element("style", {}, Markup::verbatim(suite_style)));
}

} // namespace

std::string suite_html(const SuiteReport& report)
{
    const std::string title = std::string("Verification of aneurysm ") + output::build_info().version;
    const Markup body = element("h1", {}, title)
                        << summary_section(report) << contents() << equations_section(report)
                        << checks_section(report) << ledger_section(report) << about_section(report);
    return "<!DOCTYPE html>\n" +
           element("html", {{"lang", "en"}}, head(title), "\n", element("body", {}, "\n", body)).text() +
           "\n";
}

} // namespace aneurysm::verification
