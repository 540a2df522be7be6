// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

namespace aneurysm::pictures
{

/// An X server of our own without a screen, for as long as this lives: Debian's VTK draws through one only.
/// Sets DISPLAY, and has Mesa draw in software, so that a picture doesn't depend on the graphics card. The
/// server ends with this program, also when that is killed. One at a time, made by the main thread; what
/// draws must be gone before it goes.
class PrivateDisplay
{
public:
    /// \throws InputError when there is no Xvfb, with the package's name
    PrivateDisplay();
    ~PrivateDisplay();
    PrivateDisplay(const PrivateDisplay&) = delete;
    PrivateDisplay(PrivateDisplay&&) = delete;
    PrivateDisplay& operator=(const PrivateDisplay&) = delete;
    PrivateDisplay& operator=(PrivateDisplay&&) = delete;

private:
    pid_t server_ = -1;
};

/// Whether DISPLAY names an X server that lets this program in.
bool has_display();

} // namespace aneurysm::pictures
