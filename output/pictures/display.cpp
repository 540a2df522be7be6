// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/display.hpp"

#include "common/error.hpp"

#include <X11/Xlib.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <string>

namespace aneurysm::pictures
{
namespace
{

constexpr int start_ms = 30'000; ///< more than Xvfb takes on a busy machine

[[noreturn]] void fail(const std::string& reason)
{
    throw InputError("Xvfb", "cannot be started (" + reason + ")",
                     "needed: Debian's packages xvfb and libgl1-mesa-dri");
}

/// The child's part, which never comes back: becomes the server, which writes its number to `report`.
[[noreturn]] void become_server(pid_t parent, int report)
{
    setsid(); // Ctrl-C is for the program, which ends the server itself
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    const int null = open("/dev/null", O_RDWR); // NOLINT(cppcoreguidelines-pro-type-vararg)
    dup2(null, STDIN_FILENO);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    const std::string number = std::to_string(report);
    if (getppid() == parent) {
        execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "640x480x24", "-nolisten", "tcp",
               "-noreset", nullptr);
    }
    _exit(127);
}

/// What the server writes once it is ready: the number of its display. Empty when it ends before.
std::string read_number(int report)
{
    std::string text;
    pollfd wait{report, POLLIN, 0};
    while (!text.ends_with('\n') && poll(&wait, 1, start_ms) > 0) {
        std::array<char, 16> buffer{};
        const ssize_t count = read(report, buffer.data(), buffer.size());
        if (count <= 0) {
            break;
        }
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    return text.ends_with('\n') ? text.substr(0, text.size() - 1) : "";
}

void end(pid_t server)
{
    kill(server, SIGTERM);
    waitpid(server, nullptr, 0);
}

} // namespace

PrivateDisplay::PrivateDisplay()
{
    std::array<int, 2> report{};
    if (pipe(report.data()) != 0) {
        fail("no pipe");
    }
    const pid_t parent = getpid();
    server_ = fork();
    if (server_ == 0) {
        close(report[0]);
        become_server(parent, report[1]);
    }
    close(report[1]);
    const std::string number = server_ > 0 ? read_number(report[0]) : "";
    close(report[0]);
    if (number.empty()) {
        if (server_ > 0) {
            end(server_);
        }
        fail("not found, or no display left");
    }
    setenv("DISPLAY", (":" + number).c_str(), 1); // NOLINT(concurrency-mt-unsafe)
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);      // NOLINT(concurrency-mt-unsafe)
}

PrivateDisplay::~PrivateDisplay()
{
    end(server_);
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
