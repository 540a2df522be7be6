// SPDX-License-Identifier: Apache-2.0
// What the parts of the suite's page share; nothing else includes it.
#pragma once

#include "verification/markup.hpp"
#include "verification/suite_report.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace aneurysm::verification
{

/// Rows behind a head; scrolls sideways where the page is too narrow.
Markup table(const std::vector<std::string>& head, const Markup& rows);
template <class... Cells>
Markup row(const Cells&... cells)
{
    return element("tr", {}, cells...);
}
Markup cell(const Markup& content);
Markup number_cell(const Markup& content);
/// A verdict with its sign and colour.
Markup mark(Verdict verdict, const std::string& more = "");
/// To the check's own section.
Markup check_link(const Check& check);
Markup level_heading(Level level);
Markup joined(const std::vector<std::string_view>& words, std::string_view separator);

/// The sections of the page.
Markup summary_section(const SuiteReport& report);
Markup equations_section(const SuiteReport& report);
Markup checks_section(const SuiteReport& report);
Markup ledger_section(const SuiteReport& report);
Markup about_section(const SuiteReport& report);

} // namespace aneurysm::verification
