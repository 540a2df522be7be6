// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace aneurysm::verification
{

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

} // namespace aneurysm::verification
