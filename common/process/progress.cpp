// SPDX-License-Identifier: Apache-2.0
#include "common/process/progress.hpp"

#include <cstdio>
#include <unistd.h>
#include <utility>

namespace aneurysm
{

Progress::Progress(std::string unit, std::int64_t first, std::int64_t all)
    : unit_(std::move(unit)), first_(first), all_(all), terminal_(isatty(STDERR_FILENO) != 0), last_(start_)
{
}

Progress::~Progress()
{
    if (shown_) {
        std::fputs("\r\033[K", stderr);
    }
}

double Progress::per_second(std::int64_t done) const
{
    const std::chrono::duration<double> elapsed = Clock::now() - start_;
    return elapsed.count() > 0 ? static_cast<double>(done - first_) / elapsed.count() : 0;
}

void Progress::show(std::int64_t done, std::string_view remark)
{
    constexpr std::chrono::milliseconds interval{200};
    const auto now = Clock::now();
    if (!terminal_ || now - last_ < interval) {
        return;
    }
    last_ = now;
    shown_ = true;
    const double rate = per_second(done);
    const auto left = rate > 0 ? static_cast<long>(static_cast<double>(all_ - done) / rate) : 0;
    std::fprintf(stderr, "\r%s %lld of %lld (%lld %%), %.1f %ss/s, %ld:%02ld:%02ld left, %.*s\033[K",
                 unit_.c_str(), static_cast<long long>(done), static_cast<long long>(all_),
                 static_cast<long long>(100 * done / all_), rate, unit_.c_str(), left / 3600, left / 60 % 60,
                 left % 60, static_cast<int>(remark.size()), remark.data());
    std::fflush(stderr);
}

} // namespace aneurysm
