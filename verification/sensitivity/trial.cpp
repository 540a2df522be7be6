// SPDX-License-Identifier: Apache-2.0
#include "verification/sensitivity/trial.hpp"

#include "common/error.hpp"

#include <boost/interprocess/anonymous_shared_memory.hpp>
#include <boost/interprocess/mapped_region.hpp>

#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <initializer_list>
#include <new>

namespace aneurysm::sensitivity
{
namespace
{

constexpr rlim_t most_memory = rlim_t{4} << 30; ///< of a child; a mutant may ask for all there is [bytes]

/// What a child leaves for its parent, in memory that they share.
struct Findings {
    bool complete = false; ///< the child came to its end
    suite::Verdict verdict = suite::Verdict::not_run;
    Reached reached{};
    std::array<char, 1 << 14> message{}; ///< ends with a 0
};

/// The child's work.
void run(const Case& c, const std::optional<Mutant>& mutant, double limit_s, Findings& findings)
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
    findings.verdict = result.verdict;
    result.message.copy(findings.message.data(), findings.message.size() - 1);
    for (std::size_t side = 0; side < findings.reached.size(); ++side) {
        for (std::size_t k = 0; k < place_count; ++k) {
            findings.reached.at(side)[k] = visited.at(side).at(k);
        }
    }
    findings.complete = true;
}

std::string why(int status)
{
    if (!WIFSIGNALED(status)) {
        return "ended with nothing to say";
    }
    return WTERMSIG(status) == SIGPROF ? "didn't end in time"
                                       : "crashed with signal " + std::to_string(WTERMSIG(status));
}

double cpu_seconds(const rusage& used)
{
    constexpr double micro = 1e-6;
    return static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           micro * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
}

} // namespace

std::string Case::name() const
{
    return std::string(check->id) + " (" + suite::name_for(*check, *subject) + ")";
}

TrialResult run_trial(const Case& c, const std::optional<Mutant>& mutant, double limit_s, Turn& turn)
{
    const auto shared = boost::interprocess::anonymous_shared_memory(sizeof(Findings));
    Findings& findings = *new (shared.get_address()) Findings;
    const pid_t child = fork();
    if (child < 0) {
        throw Error("a process for a mutant", std::string("no fork: ") + std::strerror(errno),
                    "needed: room for another process");
    }
    if (child == 0) {
        run(c, mutant, limit_s, findings);
        _exit(0); // nothing of the parent's is flushed or destroyed twice
    }
    int status = 0;
    rusage used{};
    turn.unlock();
    while (wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
    }
    turn.lock();
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) {
        return {.verdict = suite::Verdict::not_run, .message = suite::interruption};
    }
    if (WIFSIGNALED(status) || !findings.complete) {
        return {.verdict = suite::Verdict::fails, .message = why(status), .seconds = cpu_seconds(used)};
    }
    return {findings.verdict, findings.message.data(), cpu_seconds(used), findings.reached};
}

} // namespace aneurysm::sensitivity
