// SPDX-License-Identifier: Apache-2.0
#include "output/report/markup.hpp"

namespace aneurysm::report
{

Markup::Markup(std::string_view plain)
{
    for (const char c : plain) {
        switch (c) {
        case '<':
            text_ += "&lt;";
            break;
        case '>':
            text_ += "&gt;";
            break;
        case '&':
            text_ += "&amp;";
            break;
        case '"':
            text_ += "&quot;";
            break;
        default: // XML has no place for other control characters
            text_ += static_cast<unsigned char>(c) >= 32 || c == '\n' ? c : ' ';
        }
    }
}

Markup Markup::verbatim(std::string_view text)
{
    Markup result;
    result.text_ = text;
    return result;
}

Markup& Markup::operator<<(const Markup& more)
{
    text_ += more.text_;
    return *this;
}

Markup opening(std::string_view name, Attributes attributes, std::string_view end)
{
    std::string tag = "<";
    tag += name;
    for (const auto& [key, value] : attributes) {
        if (!value.empty()) {
            tag.append(" ").append(key).append("=\"").append(Markup(value).text()).append("\"");
        }
    }
    return Markup::verbatim(tag.append(end));
}

Markup empty_element(std::string_view name, Attributes attributes)
{
    return opening(name, attributes, "/>");
}

} // namespace aneurysm::report
