// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace aneurysm
{

/// Thrown out of a flow that a check makes, once it was noted. No error: it passes handlers of those.
struct Interrupted {
};

/// While one lives, Ctrl-C, SIGTERM, SIGHUP (the connection is lost) and SIGUSR1 (a batch system's warning) are only
/// noted; a second Ctrl-C or SIGTERM ends the program at once. A reader of a pipe that goes ends nothing.
class InterruptWatch
{
public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch(InterruptWatch&&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;
    InterruptWatch& operator=(InterruptWatch&&) = delete;

    static bool interrupted();

    static constexpr std::size_t signals = 5; ///< that it sees

private:
    std::array<struct sigaction, signals> before_{};
};

} // namespace aneurysm
