// SPDX-License-Identifier: Apache-2.0
// What a run of the suite says as a whole; all reports say it.
#pragma once

#include "common/equations.hpp"
#include "verification/suite/suite.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace aneurysm::suite
{

std::string_view name_of(Level level);    ///< "single formulas"
std::string_view meaning_of(Level level); ///< a sentence for a reader who doesn't know the code
std::string_view name_of(Verdict verdict);
std::string_view name_of(Source source);
std::string_view meaning_of(Source source);
std::string_view name_of(Status status);
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

enum class EquationVerdict {
    holds,       ///< all that was checked, by evidence for at least one backend
    fails,       ///< somewhere
    not_checked, ///< not chosen, not run or interrupted; the remark says which
    no_check,    ///< the suite has none
};
std::string_view name_of(EquationVerdict verdict);

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
    std::string remark{}; ///< why not checked
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

Tally tally(const SuiteResult& suite);
Tally tally(const SuiteResult& suite, Level level);
/// What half of the quantities used of their bounds at most; -1: nothing compared.
double median_ratio(const SuiteResult& suite, Level level);
/// Something was compared, and nothing fails.
bool passed(const SuiteResult& suite);
/// "29 of 29 equations hold", and which others there are.
std::string headline(const std::vector<EquationSummary>& summaries);

/// An error, a bound or a ratio with three digits; "-" for none, which is less than 0
std::string shown(double x);
/// Any number, with six digits.
std::string shown_value(double x);

} // namespace aneurysm::suite
