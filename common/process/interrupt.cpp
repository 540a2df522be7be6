// SPDX-License-Identifier: Apache-2.0
#include "common/process/interrupt.hpp"

#include <csignal>
#include <initializer_list>

namespace aneurysm
{
namespace
{

volatile std::sig_atomic_t noted = 0;

void note(int)
{
    noted = 1;
}

void set_action(void (*handler)(int), int flags)
{
    struct sigaction action {
    };
    action.sa_handler = handler;
    action.sa_flags = flags;
    for (const int signal : {SIGINT, SIGTERM}) {
        sigaction(signal, &action, nullptr);
    }
}

} // namespace

InterruptWatch::InterruptWatch()
{
    noted = 0;
    set_action(note, static_cast<int>(SA_RESETHAND | SA_RESTART));
}

InterruptWatch::~InterruptWatch()
{
    set_action(SIG_DFL, 0);
}

bool InterruptWatch::interrupted()
{
    return noted != 0;
}

} // namespace aneurysm
