// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace aneurysm
{

/// How often the program says how far it is; the same for all that it does.
struct ProgressRhythm {
    bool quiet = false;            ///< never
    std::optional<double> seconds; ///< a line of its own each; without: see Progress
};

/// Says on stderr how far something is: on a terminal in one line that changes, no longer than the terminal is wide;
/// elsewhere, and on a terminal that knows no such lines (TERM=dumb), in a line of its own every 30 s.
class Progress
{
public:
    /// `unit`: what is counted, in the singular
    Progress(std::string unit, std::int64_t first, std::int64_t all);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress& operator=(Progress&&) = delete;

    void show(std::int64_t done, std::string_view remark);
    double per_second(std::int64_t done) const;

    /// For all that are made from now on.
    static void set_rhythm(const ProgressRhythm& rhythm);

private:
    using Clock = std::chrono::steady_clock;

    std::string line(std::int64_t done, std::string_view remark) const;

    std::string unit_;
    std::int64_t first_;
    std::int64_t all_;
    bool quiet_;
    bool in_place_; ///< one line that changes
    std::chrono::duration<double> interval_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_;
};

} // namespace aneurysm
