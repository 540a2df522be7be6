// SPDX-License-Identifier: Apache-2.0
// What the parts of the suite's page share; nothing else includes it.
#pragma once

#include "output/report/markup.hpp"
#include "verification/suite/report.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace aneurysm::suite
{

/// Rows behind a head; scrolls sideways where the page is too narrow.
report::Markup table(const std::vector<std::string>& head, const report::Markup& rows);
template <class... Cells>
report::Markup row(const Cells&... cells)
{
    return report::element("tr", {}, cells...);
}
report::Markup cell(const report::Markup& content);
report::Markup number_cell(const report::Markup& content);
/// A verdict with its sign and color.
report::Markup mark(Verdict verdict, const std::string& more = "");
/// To the check's own section.
report::Markup check_link(const Check& check);
report::Markup level_heading(Level level);
report::Markup joined(const std::vector<std::string_view>& words, std::string_view separator);

/// The sections of the page.
report::Markup summary_section(const SuiteReport& report);
report::Markup equations_section(const SuiteReport& report);
report::Markup checks_section(const SuiteReport& report);
report::Markup ledger_section(const SuiteReport& report);
report::Markup about_section(const SuiteReport& report);

} // namespace aneurysm::suite
