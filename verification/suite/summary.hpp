// SPDX-License-Identifier: Apache-2.0
// What a run of the suite says as a whole; all reports say it.
#pragma once

#include "verification/suite/words.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace aneurysm::suite
{

/// How many results, and how close to their bounds the numbers in them came.
struct Tally {
    int holds = 0;
    int fails = 0;
    int not_run = 0;
    int limits = 0; ///< known ones: not met yet
    std::int64_t compared = 0;
    double ratio = -1;                  ///< largest measured / allowed; -1: nothing compared
    const Quantity* closest = nullptr;  ///< whose ratio that is
    const CheckResult* where = nullptr; ///< in which
    std::vector<double> ratios{};       ///< of all quantities

    void add(const CheckResult& result);
    /// What half of the quantities used of their bounds at most; -1: nothing compared.
    double median() const;
};
/// Of all results, or those of a level.
Tally tally(const SuiteResult& suite, std::optional<Level> level = {});

/// Whether it compares the program itself with an answer found without it, which tells whether the equations are
/// implemented as derived: only such a check can show that an
/// equation holds. The others, of oracles and of runs with one another, can only show that something fails.
bool is_evidence(const Check& check);
/// Whether the check is of this equation above all: its id names it, or it lists no other.
bool is_own(const Check& check, const Equation& equation);

/// What the checks of an equation say of one subject.
struct EquationCell {
    enum class State {
        holds,
        fails,
        not_run,
        shared, ///< the formula is another subject's, in whose cell the result is
        equal,  ///< no evidence of its own, but compared with the reference or itself
        none,   ///< nothing chosen that looks at it
    };
    State state = State::none;
    std::string remark{}; ///< why not run, whose result it shares
    Tally tally{};
};

struct EquationSummary {
    const Equation* equation = nullptr;
    std::vector<const Check*> checks{}; ///< all of the suite that name it, chosen or not
    std::vector<EquationCell> cells{};  ///< by subject of the suite
    EquationVerdict verdict = EquationVerdict::no_check;
    bool only_shared = false; ///< it fails, but only in runs of several equations
    std::string remark{};     ///< why not checked
};

/// One for each row of the table of equations.
/// \param checks  all there are
std::vector<EquationSummary> by_equation(const SuiteResult& suite, const std::vector<Check>& checks);

/// The results of a check, by subject.
using Results = std::span<const CheckResult>;
std::vector<Results> by_check(const SuiteResult& suite);

/// What several say, said once: {"cuda double, cuda float", "no GPU"}.
struct Reason {
    std::string who; ///< by commas
    std::string why;
};
void add(std::vector<Reason>& reasons, const std::string& who, const std::string& why);

/// Subjects that are missing, then what was not run for others: {"eq13_pole (cpu double, cpu float)", ...}.
std::vector<Reason> not_run(const SuiteResult& suite);

/// A quantity that isn't within its bound, or a check that stopped or compared nothing.
struct Failure {
    const CheckResult* where = nullptr; ///< of the version that is worst off
    const Quantity* quantity = nullptr; ///< null: a check's
    std::string what{};                 ///< the quantity's name, or the check's message
    std::string subjects{};             ///< all for which it fails, by commas
};
/// By level, the lowest first: what it is made of is smallest, so that it is the place to look at first.
std::vector<Failure> what_fails(const SuiteResult& suite);

/// Something was compared, and nothing fails: a known limit of the model isn't a failure.
bool passed(const SuiteResult& suite);
/// "29 of 29 equations hold", and which others there are.
std::string headline(const std::vector<EquationSummary>& summaries);

} // namespace aneurysm::suite
