// SPDX-License-Identifier: Apache-2.0
// The verification suite: which checks, for whom, and what came of them.
#pragma once

#include "verification/suite/check.hpp"
#include "verification/suite/subjects.hpp"

#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace aneurysm::suite
{

enum class Verdict {
    holds,   ///< something was compared, and all of it lies within its bounds
    fails,   ///< something doesn't, nothing was compared, or the check threw
    not_run, ///< the message says why
};

/// The message of what Ctrl-C kept from being done.
inline constexpr const char* interruption = "interrupted";

/// What came of one check for one subject.
struct CheckResult {
    const Check* check = nullptr;
    std::string subject; ///< Subject::name, or "once"
    Verdict verdict = Verdict::not_run;
    std::string message{}; ///< why it fails or was not run; empty when it holds
    std::deque<Quantity> quantities{};
    std::vector<Note> notes{};
    std::vector<Plot> plots{};
    double seconds = 0;
};

/// The result of a run of the suite: one for each check and subject, by check first.
struct SuiteResult {
    std::vector<SuiteSubject> subjects;
    std::vector<CheckResult> results{};
    bool complete = true; ///< not interrupted
    double seconds = 0;
};

/// The quick ones, or all, of `checks`.
/// \param only  words of ids (poiseuille), equations (eq13, 13, EOS), levels (L2); empty: no restriction
/// \throws InputError for one that matches nothing; it lists what there is
std::vector<const Check*> select(const std::vector<Check>& checks, bool full,
                                 const std::vector<std::string>& only);

/// Whether the suite runs this check for this subject; none for those of Scope::once.
bool looks_at(const Check& check, const Subject& subject);

/// Does not throw: what a check throws is its failure.
CheckResult run_check(const Check& check, const Subject& subject);

/// Called in the caller's thread: results done, of how many, and one that is being worked on.
using AfterResult = std::function<void(std::int64_t done, std::int64_t all, const std::string& doing)>;

/// Each check for each subject of its scope, on `threads` threads. Ctrl-C ends it early (see InterruptWatch);
/// what was not done by then was not run.
SuiteResult run_suite(const std::vector<const Check*>& checks, std::vector<SuiteSubject> subjects,
                      int threads, const AfterResult& after_result = {});

} // namespace aneurysm::suite
