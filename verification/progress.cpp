// SPDX-License-Identifier: Apache-2.0
#include "verification/progress.hpp"

#include "output/columns.hpp"

#include <cstdio>
#include <unistd.h>

namespace aneurysm::verification
{

Progress::Progress(std::int64_t first_frame, std::int64_t frames)
    : first_frame_(first_frame), frames_(frames), terminal_(isatty(STDERR_FILENO) != 0), last_(start_)
{
}

Progress::~Progress()
{
    if (shown_) {
        std::fputs("\r\033[K", stderr);
    }
}

double Progress::frames_per_second(std::int64_t frame) const
{
    const std::chrono::duration<double> elapsed = Clock::now() - start_;
    return elapsed.count() > 0 ? static_cast<double>(frame - first_frame_) / elapsed.count() : 0;
}

void Progress::show(const FrameRecord& record)
{
    constexpr std::chrono::milliseconds interval{200};
    const auto now = Clock::now();
    if (!terminal_ || now - last_ < interval) {
        return;
    }
    last_ = now;
    shown_ = true;
    const double rate = frames_per_second(record.frame);
    const auto left = rate > 0 ? static_cast<long>(static_cast<double>(frames_ - record.frame) / rate) : 0;
    std::fprintf(stderr, "\rframe %lld of %lld (%lld %%), %.1f frames/s, %ld:%02ld:%02ld left, %s\033[K",
                 static_cast<long long>(record.frame), static_cast<long long>(frames_),
                 static_cast<long long>(100 * record.frame / frames_), rate, left / 3600, left / 60 % 60,
                 left % 60, output::name_of(record.phase).data());
    std::fflush(stderr);
}

} // namespace aneurysm::verification
