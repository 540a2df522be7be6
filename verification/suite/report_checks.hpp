// SPDX-License-Identifier: Apache-2.0
// The report's section on single checks; only report.cpp includes it.
#pragma once

#include "verification/suite/report.hpp"

namespace aneurysm::suite
{

/// To the check's own part of the section.
report::Text check_link(const Check& check);
/// "L0: single formulas"
std::string heading_of(Level level);
void add_checks(report::Document& document, const SuiteReport& report);

} // namespace aneurysm::suite
