// SPDX-License-Identifier: Apache-2.0
#include "common/process/interrupt.hpp"

#include <array>
#include <csignal>
#include <cstddef>

namespace aneurysm
{
namespace
{

volatile std::sig_atomic_t noted = 0;

void note(int)
{
    noted = 1;
}

void ignore(int) {}

/// What is done about a signal while a watch lives.
struct Rule {
    int signal;
    void (*handler)(int);
    bool ends_at_second; ///< or it is only noted again: a shell that goes sends SIGHUP twice
    bool may_be_ignored; ///< whoever started us may have asked for that, as nohup does
};
constexpr std::array rules{Rule{SIGINT, note, true, false}, Rule{SIGTERM, note, true, false},
                           Rule{SIGHUP, note, false, true}, Rule{SIGUSR1, note, false, false},
                           Rule{SIGPIPE, ignore, false, true}};
static_assert(rules.size() == InterruptWatch::signals);

} // namespace

InterruptWatch::InterruptWatch()
{
    noted = 0;
    for (std::size_t k = 0; k < rules.size(); ++k) {
        const Rule& rule = rules.at(k);
        struct sigaction action {
        };
        action.sa_handler = rule.handler;
        action.sa_flags = static_cast<int>(SA_RESTART | (rule.ends_at_second ? SA_RESETHAND : 0));
        sigaction(rule.signal, nullptr, &before_.at(k));
        if (!rule.may_be_ignored || before_.at(k).sa_handler != SIG_IGN) {
            sigaction(rule.signal, &action, nullptr);
        }
    }
}

InterruptWatch::~InterruptWatch()
{
    for (std::size_t k = 0; k < rules.size(); ++k) {
        sigaction(rules.at(k).signal, &before_.at(k), nullptr);
    }
}

bool InterruptWatch::interrupted()
{
    return noted != 0;
}

} // namespace aneurysm
