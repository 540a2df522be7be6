// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace aneurysm
{

/// One line on the terminal that says how far something is; silent when stderr is no terminal.
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

private:
    using Clock = std::chrono::steady_clock;

    std::string unit_;
    std::int64_t first_;
    std::int64_t all_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_;
};

} // namespace aneurysm
