// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"

#include <chrono>
#include <cstdint>

namespace aneurysm::verification
{

/// One line on the terminal that says how far a run is; silent when stderr is no terminal.
class Progress
{
public:
    Progress(std::int64_t first_frame, std::int64_t frames);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress& operator=(Progress&&) = delete;

    void show(const FrameRecord& record);
    double frames_per_second(std::int64_t frame) const;

private:
    using Clock = std::chrono::steady_clock;

    std::int64_t first_frame_;
    std::int64_t frames_;
    bool terminal_;
    bool shown_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_;
};

} // namespace aneurysm::verification
