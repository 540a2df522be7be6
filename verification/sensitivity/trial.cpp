// SPDX-License-Identifier: Apache-2.0
#include "verification/sensitivity/trial.hpp"

#include "common/error.hpp"
#include "output/json.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <initializer_list>

namespace aneurysm::sensitivity
{
namespace
{

constexpr rlim_t most_memory = rlim_t{4} << 30; ///< of a child; a mutant may ask for all there is [bytes]

[[noreturn]] void fail(const char* what)
{
    throw Error("a process for a mutant", std::string(what) + ": " + std::strerror(errno),
                "needed: room for another process");
}

std::string text_of(const std::bitset<place_count>& places)
{
    return places.to_string();
}

Reached reached_places()
{
    Reached reached;
    for (std::size_t side = 0; side < reached.size(); ++side) {
        for (std::size_t k = 0; k < place_count; ++k) {
            reached.at(side)[k] = visited.at(side).at(k);
        }
    }
    return reached;
}

/// The child's work.
std::string run(const Case& c, const std::optional<Mutant>& mutant, double limit_s)
{
    for (const int signal : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGPROF, SIGSEGV}) {
        std::signal(signal, SIG_DFL); // a test's handlers would go on with the parent's work
    }
    const rlimit memory{most_memory, most_memory};
    setrlimit(RLIMIT_AS, &memory);
    const itimerval timer{{0, 0}, {static_cast<time_t>(std::ceil(limit_s)), 0}};
    setitimer(ITIMER_PROF, &timer, nullptr); // SIGPROF ends the process
    analytic::gsl_return_errors();
    if (mutant) {
        planted = *mutant;
        suite::Quantity::first_failure_ends = true;
    }
    const suite::CheckResult result = suite::run_check(*c.check, *c.subject);
    const Reached reached = reached_places();
    return output::Json{{"verdict", static_cast<int>(result.verdict)},
                        {"message", result.message},
                        {"reached", {text_of(reached[0]), text_of(reached[1])}}}
        .dump(-1, ' ', false, output::Json::error_handler_t::replace);
}

void write_all(int to, const std::string& text)
{
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t n = ::write(to, text.data() + done, text.size() - done);
        if (n < 0 && errno != EINTR) {
            return; // the parent is gone
        }
        done += static_cast<std::size_t>(std::max<ssize_t>(n, 0));
    }
}

std::string read_all(int from)
{
    std::string text;
    std::array<char, 4096> part{};
    while (true) {
        const ssize_t n = ::read(from, part.data(), part.size());
        if (n == 0 || (n < 0 && errno != EINTR)) {
            return text;
        }
        text.append(part.data(), static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    }
}

/// How a child ended.
struct End {
    int status = 0;
    double seconds = 0; ///< of CPU time
};
End wait_for(pid_t child)
{
    End end;
    rusage used{};
    while (wait4(child, &end.status, 0, &used) < 0 && errno == EINTR) {
    }
    constexpr double micro = 1e-6;
    end.seconds = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                  micro * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    return end;
}

std::string why(int status)
{
    if (!WIFSIGNALED(status)) {
        return "ended with nothing to say";
    }
    return WTERMSIG(status) == SIGPROF ? "didn't end in time"
                                       : "crashed with signal " + std::to_string(WTERMSIG(status));
}

TrialResult parsed(const std::string& text, const End& end)
{
    if (WIFSIGNALED(end.status) && WTERMSIG(end.status) == SIGINT) {
        return {.verdict = suite::Verdict::not_run, .message = suite::interruption};
    }
    if (WIFSIGNALED(end.status) || text.empty()) {
        return {.verdict = suite::Verdict::fails, .message = why(end.status), .seconds = end.seconds};
    }
    const output::Json json = output::Json::parse(text);
    TrialResult result{.verdict = static_cast<suite::Verdict>(json["verdict"].get<int>()),
                       .message = json["message"],
                       .seconds = end.seconds};
    for (std::size_t side = 0; side < result.reached.size(); ++side) {
        result.reached.at(side) = std::bitset<place_count>(json["reached"][side].get<std::string>());
    }
    return result;
}

} // namespace

std::string Case::name() const
{
    return std::string(check->id) + " (" + (check->scope == suite::Scope::once ? "once" : subject->name()) +
           ")";
}

TrialResult run_trial(const Case& c, const std::optional<Mutant>& mutant, double limit_s, Turn& turn)
{
    std::array<int, 2> pipe{};
    if (::pipe(pipe.data()) != 0) {
        fail("no pipe");
    }
    const pid_t child = fork();
    if (child < 0) {
        fail("no fork");
    }
    if (child == 0) {
        close(pipe[0]);
        write_all(pipe[1], run(c, mutant, limit_s));
        _exit(0); // nothing of the parent's is flushed or destroyed twice
    }
    close(pipe[1]);
    turn.unlock();
    const std::string text = read_all(pipe[0]);
    const End end = wait_for(child);
    turn.lock();
    close(pipe[0]);
    return parsed(text, end);
}

} // namespace aneurysm::sensitivity
