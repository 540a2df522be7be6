// SPDX-License-Identifier: Apache-2.0
// What a run of the suite says as a whole; all reports say it.
#pragma once

#include "verification/suite/words.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace aneurysm::suite
{

/// "(13)", or "EOS"
std::string number_of(const Equation& equation);

/// How many results, and how close to its bound the closest number came.
struct Tally {
    int holds = 0;
    int fails = 0;
    int not_run = 0;
    std::int64_t compared = 0;
    double ratio = -1;                  ///< largest measured / allowed; -1: nothing compared
    const Quantity* closest = nullptr;  ///< whose ratio that is
    const CheckResult* where = nullptr; ///< in which

    void add(const CheckResult& result);
};
Tally tally(const CheckResult& result);

/// Whether it compares the program itself with an answer found without it: only such a check can show that an
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

/// What fails or was not run, each reason once: {"cuda double, cuda float", "no GPU"}, {"eq13_pole (cpu
/// double, cpu float)", "not within its bound: pole [Pa]"}.
struct Reason {
    std::string who;
    std::string why;
};
std::vector<Reason> failures(const SuiteResult& suite);
std::vector<Reason> not_run(const SuiteResult& suite);

/// A quantity that isn't within its bound, or a check that stopped or compared nothing.
struct Failure {
    const CheckResult* where = nullptr;  ///< of the version that is worst off
    const Quantity* quantity = nullptr;  ///< null: see the message of `where`
    std::vector<std::string> subjects{}; ///< all for which it fails
};
/// By level, the lowest first: what it is made of is smallest, so that it is the place to look at first.
std::vector<Failure> what_fails(const SuiteResult& suite);

Tally tally(const SuiteResult& suite);
Tally tally(const SuiteResult& suite, Level level);
/// What half of the quantities used of their bounds at most; -1: nothing compared.
double median_ratio(const SuiteResult& suite, Level level);
/// Something was compared, and nothing fails.
bool passed(const SuiteResult& suite);
/// "29 of 29 equations hold", and which others there are.
std::string headline(const std::vector<EquationSummary>& summaries);

} // namespace aneurysm::suite
