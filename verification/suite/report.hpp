// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/report/document.hpp"
#include "verification/suite/summary.hpp"

#include <string>
#include <vector>

namespace aneurysm::suite
{

/// A run of the suite and how it came about.
struct SuiteReport {
    SuiteResult suite;
    std::vector<EquationSummary> equations;
    std::string selection; ///< which checks, in words
    std::string command;   ///< that does it again
    std::string date;      ///< UTC, when it ended
    std::string machine;   ///< in words
    int threads = 1;
};

/// For the terminal: levels, what fails, what was not run, the verdict.
std::string suite_text(const SuiteReport& report);
/// Everything, for programs.
std::string suite_json(const SuiteReport& report);
/// A test suite for each level, a test case for each check and subject.
std::string suite_junit(const SuiteReport& report);
/// Everything, for people; its first screen is for readers who don't know the code.
report::Document suite_document(const SuiteReport& report);

} // namespace aneurysm::suite
