// SPDX-License-Identifier: Apache-2.0
// One check with one mutant planted, in a process of its own: a mutant may crash it, or keep it busy for ever.
#pragma once

#include "verification/sensitivity/mutants.hpp"
#include "verification/suite/suite.hpp"

#include <array>
#include <bitset>
#include <mutex>
#include <optional>
#include <string>

namespace aneurysm::sensitivity
{

/// A check and whose equations and flows it looks at.
struct Case {
    const suite::Check* check = nullptr;
    const suite::Subject* subject = nullptr;

    std::string name() const; ///< "eq13_pole (reference)"
};

/// The places that a case computes with, by side.
using Reached = std::array<std::bitset<place_count>, 2>;

struct TrialResult {
    suite::Verdict verdict = suite::Verdict::not_run;
    std::string message{}; ///< why it fails: a quantity, an exception, a crash, no end
    double seconds = 0;    ///< of CPU time
    Reached reached{};

    bool red() const { return verdict == suite::Verdict::fails; }
};

/// Held by each thread of this process unless it waits for a child, so that no thread is in the middle of
/// anything while another makes one.
using Turn = std::unique_lock<std::mutex>;

/// \param limit_s  CPU time after which the case counts as failing
/// \throws Error when there can be no other process
TrialResult run_trial(const Case& c, const std::optional<Mutant>& mutant, double limit_s, Turn& turn);

} // namespace aneurysm::sensitivity
