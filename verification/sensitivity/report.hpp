// SPDX-License-Identifier: Apache-2.0
// What a study of the suite's sensitivity says, to people and to programs.
#pragma once

#include "output/report/document.hpp"
#include "verification/sensitivity/sensitivity.hpp"
#include "verification/suite/summary.hpp"

#include <string>
#include <vector>

namespace aneurysm::sensitivity
{

/// A study and where it comes from.
struct SensitivityReport {
    SensitivityStudy study{};
    std::string selection; ///< which mutants and checks, in words
    std::string command;   ///< that repeats it
    std::string date;      ///< in UTC
    std::string machine;
    int jobs = 1;
};

/// Mutants of one equation, or of all.
struct MutantTally {
    std::string id;       ///< as equation_of has it; empty: all
    std::string equation; ///< "(13)", "EOS", "Fig. 1", "3.4" or "all"
    std::string_view title{};
    int planted = 0;
    int found = 0;
    int argued = 0;

    int unexplained() const { return planted - found - argued; }
};
/// By equation, in the paper's order, and all in the last.
std::vector<MutantTally> tallies(const SensitivityStudy& study);

/// Cases that are red or can't be run without any mutant.
std::vector<suite::Reason> unusable(const SensitivityStudy& study);

/// "PASS" and what was found, in a sentence.
std::string verdict_of(const SensitivityStudy& study);
std::string headline(const SensitivityStudy& study);

std::string sensitivity_text(const SensitivityReport& report); ///< for the terminal
std::string sensitivity_json(const SensitivityReport& report);
/// `with_matrix`: which check finds which mutant, in tables too wide for Markdown.
report::Document sensitivity_document(const SensitivityReport& report, bool with_matrix);

} // namespace aneurysm::sensitivity
