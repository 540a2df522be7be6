// SPDX-License-Identifier: Apache-2.0
// The verification suite: which checks, for whom, and what came of them.
#pragma once

#include "verification/suite/check.hpp"
#include "verification/suite/subjects.hpp"

#include <functional>
#include <string>
#include <vector>

namespace aneurysm::suite
{

/// The message of what Ctrl-C kept from being done.
inline constexpr const char* interruption = "interrupted";

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

/// Those that the suite runs this check for; one that is missing is among them unless the check would have run
/// for another all the same.
std::vector<const SuiteSubject*> subjects_of(const Check& check, const std::vector<SuiteSubject>& subjects);

/// Subject::name, or "once".
std::string name_for(const Check& check, const Subject& subject);

/// Does not throw: what a check throws is its failure.
CheckResult run_check(const Check& check, const Subject& subject);

/// Called in the caller's thread: results done, of how many, and one that is being worked on.
using AfterResult = std::function<void(std::int64_t done, std::int64_t all, const std::string& doing)>;

/// Each check for each subject of its scope, on `threads` threads. Ctrl-C ends it early (see InterruptWatch);
/// what was not done by then was not run.
SuiteResult run_suite(const std::vector<const Check*>& checks, std::vector<SuiteSubject> subjects,
                      int threads, const AfterResult& after_result = {});

} // namespace aneurysm::suite
