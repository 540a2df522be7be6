// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

namespace aneurysm::report
{

/// XML or HTML. Plain text is escaped as it becomes Markup, so nothing that a check says can turn into tags.
class Markup
{
public:
    Markup() = default;
    Markup(std::string_view plain);                                       // NOLINT: wanted
    Markup(const char* plain) : Markup(std::string_view(plain)) {}        // NOLINT
    Markup(const std::string& plain) : Markup(std::string_view(plain)) {} // NOLINT

    /// As it is: style sheets.
    static Markup verbatim(std::string_view text);

    Markup& operator<<(const Markup& more);
    const std::string& text() const { return text_; }
    bool empty() const { return text_.empty(); }

private:
    std::string text_;
};

using Attributes = std::initializer_list<std::pair<std::string_view, std::string>>;

/// <name attributes>content</name>, or <name attributes/> for an empty one of SVG or JUnit. Attributes without a
/// value are left out.
template <class... Content>
Markup element(std::string_view name, Attributes attributes, const Content&... content);
Markup empty_element(std::string_view name, Attributes attributes);

Markup opening(std::string_view name, Attributes attributes, std::string_view end);

template <class... Content>
Markup element(std::string_view name, Attributes attributes, const Content&... content)
{
    Markup result = opening(name, attributes, ">");
    (result << ... << content);
    return result << Markup::verbatim(std::string("</").append(name).append(">"));
}

} // namespace aneurysm::report
