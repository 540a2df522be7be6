// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace aneurysm
{

/// Thrown out of a flow that a check makes, once it was noted. No error: it passes handlers of those.
struct Interrupted {
};

/// While one lives, the first Ctrl-C or SIGTERM is only noted; a second one ends the program at once.
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
};

} // namespace aneurysm
