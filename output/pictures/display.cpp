// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/display.hpp"

#include "common/error.hpp"

#include <X11/Xlib.h>

#include <array>
#include <cstdlib>
#include <string>

namespace aneurysm::pictures
{
namespace
{

/// Prints the number of its display once it is ready, and ends when the last that was connected has gone, or when this
/// program was killed before it was. In a session of its own, since Ctrl-C is for this program.
constexpr const char* start_server =
    "exec setsid setpriv --pdeathsig TERM Xvfb -displayfd 1 -screen 0 640x480x24 -nolisten tcp "
    "-terminate </dev/null 2>/dev/null";

} // namespace

PrivateDisplay::PrivateDisplay() : server_(popen(start_server, "re")) // NOLINT(cert-env33-c)
{
    std::array<char, 16> number{};
    if (server_ != nullptr && std::fgets(number.data(), number.size(), server_) != nullptr) {
        const std::string name(number.data());
        setenv("DISPLAY", (":" + name.substr(0, name.find('\n'))).c_str(),
               1);                               // NOLINT(concurrency-mt-unsafe)
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1); // NOLINT(concurrency-mt-unsafe)
        connection_ = XOpenDisplay(nullptr);
    }
    if (connection_ == nullptr) {
        throw InputError("Xvfb", "cannot be started (not found, or no display left)",
                         "needed: Debian's packages xvfb and libgl1-mesa-dri");
    }
}

PrivateDisplay::~PrivateDisplay()
{
    XCloseDisplay(connection_);
    pclose(server_);
}

bool has_display()
{
    Display* const display = XOpenDisplay(nullptr);
    if (display != nullptr) {
        XCloseDisplay(display);
    }
    return display != nullptr;
}

} // namespace aneurysm::pictures
