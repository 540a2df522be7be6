// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>

struct _XDisplay; // of X11/Xlib.h, whose macros no other header would stand

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
    std::FILE* server_;               ///< what it prints
    _XDisplay* connection_ = nullptr; ///< the one that keeps it alive
};

/// Whether DISPLAY names an X server that lets this program in.
bool has_display();

} // namespace aneurysm::pictures
