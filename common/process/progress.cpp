// SPDX-License-Identifier: Apache-2.0
#include "common/process/progress.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace aneurysm
{
namespace
{

ProgressRhythm chosen; // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

bool can_change_lines()
{
    const char* const terminal = std::getenv("TERM"); // NOLINT(concurrency-mt-unsafe)
    const std::string_view name = terminal == nullptr ? "" : terminal;
    return isatty(STDERR_FILENO) != 0 && !name.empty() && name != "dumb";
}

/// Characters that fit into a line of the terminal; a full one would begin the next.
std::size_t line_width()
{
    winsize size{};
    const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
    return known ? size.ws_col - 1U : 79U;
}

double seconds_between(bool in_place)
{
    constexpr double on_terminal = 0.2;
    constexpr double elsewhere = 30;
    return chosen.seconds.value_or(in_place ? on_terminal : elsewhere);
}

} // namespace

void Progress::set_rhythm(const ProgressRhythm& rhythm)
{
    chosen = rhythm;
}

Progress::Progress(std::string unit, std::int64_t first, std::int64_t all)
    : unit_(std::move(unit)), first_(first), all_(all), quiet_(chosen.quiet),
      in_place_(can_change_lines() && !chosen.seconds), interval_(seconds_between(in_place_)), last_(start_)
{
}

Progress::~Progress()
{
    if (shown_ && in_place_) {
        std::fputs("\r\033[K", stderr);
    }
}

double Progress::per_second(std::int64_t done) const
{
    const std::chrono::duration<double> elapsed = Clock::now() - start_;
    return elapsed.count() > 0 ? static_cast<double>(done - first_) / elapsed.count() : 0;
}

std::string Progress::line(std::int64_t done, std::string_view remark) const
{
    std::array<char, 128> part{};
    std::snprintf(part.data(), part.size(), "%s %lld of %lld (%lld %%), ", unit_.c_str(),
                  static_cast<long long>(done), static_cast<long long>(all_),
                  static_cast<long long>(all_ > 0 ? 100 * done / all_ : 100));
    std::string text = part.data();
    if (const double rate = per_second(done); rate > 0) { // else the time that is left isn't known
        const auto left = static_cast<long>(static_cast<double>(all_ - done) / rate);
        std::snprintf(part.data(), part.size(), "%.1f %ss/s, %ld:%02ld:%02ld left, ", rate, unit_.c_str(),
                      left / 3600, left / 60 % 60, left % 60);
        text += part.data();
    }
    return text.append(remark);
}

void Progress::show(std::int64_t done, std::string_view remark)
{
    const auto now = Clock::now();
    if (quiet_ || now - last_ < interval_) {
        return;
    }
    last_ = now;
    shown_ = true;
    const std::string text = line(done, remark);
    if (in_place_) {
        std::fprintf(stderr, "\r%s\033[K", text.substr(0, line_width()).c_str());
    } else {
        std::fprintf(stderr, "%s\n", text.c_str());
    }
    std::fflush(stderr);
}

} // namespace aneurysm
