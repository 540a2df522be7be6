// SPDX-License-Identifier: Apache-2.0
// Which planted mutant turns which check red, and how small a mutant each check sees.
#pragma once

#include "verification/sensitivity/trial.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace aneurysm::sensitivity
{

/// A case, and what it says without a mutant; only one that holds is used.
struct BaselineCase {
    Case what;
    TrialResult result{};
};

/// What became of a mutant, as one check sees it.
enum class Cell {
    unreached, ///< the check doesn't compute with the place
    untried,   ///< it does, but wasn't needed
    green,
    red,
};

/// A row of the kill matrix.
struct MutantRow {
    Mutant mutant;
    std::vector<Cell> cells{};   ///< by check of the study
    std::string finder{};        ///< the first case that it turned red; empty: it survives
    std::string message{};       ///< what that case said
    std::string_view argument{}; ///< why no check can find it; empty: no reason is known

    bool survives() const { return finder.empty(); }
};

/// What a check sees of the mutants in one backend.
struct Sight {
    const suite::Check* check = nullptr;
    Side side = Side::reference;
    bool sees = false;   ///< some mutant turned it red
    double smallest = 0; ///< relative size of the smallest mutant in a coefficient of an equation of its
                         ///< own that does, to within a factor of 2; 0: not looked for, or none up to 1
    Place place = place_count;   ///< where that is
    std::string_view argument{}; ///< why no mutant can turn it red; empty: no reason is known
};

struct SensitivityStudy {
    std::vector<const suite::Check*> checks{};
    std::vector<suite::SuiteSubject> subjects{}; ///< that the cases are about
    std::vector<BaselineCase> baseline{};
    std::vector<MutantRow> rows{};
    std::vector<Sight> sights{}; ///< each check that computes with a backend; empty in a daily study
    bool complete = true;        ///< not interrupted
    double seconds = 0;
};

struct StudyOptions {
    std::vector<Mutant> mutants{};
    bool daily = false; ///< the first red check is enough for a mutant, and nothing is asked of the checks
    int jobs = 1;       ///< processes at once
};

/// Called now and then: what of the study, how much of it is done, of how much, and what was last.
using AfterStep = std::function<void(const std::string& part, std::int64_t done, std::int64_t all,
                                     const std::string& last)>;

/// `subjects`: the reference, and cpu.
SensitivityStudy run_study(const std::vector<const suite::Check*>& checks,
                           std::vector<suite::SuiteSubject> subjects, const StudyOptions& options,
                           const AfterStep& after_step = {});

/// Why no check can find this mutant; empty: no reason is known.
std::string_view argument_for(const Mutant& mutant);
/// Why no mutant in this backend can turn this check red; empty: no reason is known.
std::string_view argument_for(const suite::Check& check, Side side);

/// No case is red without a mutant, each mutant is found or argued, and each check sees some or is argued.
bool passed(const SensitivityStudy& study);

} // namespace aneurysm::sensitivity
