// SPDX-License-Identifier: Apache-2.0
#include "verification/suite/suite.hpp"

#include "common/error.hpp"
#include "common/process/interrupt.hpp"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace aneurysm::suite
{
namespace
{

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string upper(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

/// Whether `words`, joined by _, are some of an id's in a row.
bool has_words(std::string_view id, const std::string& words)
{
    const auto framed = [](std::string_view text) { return std::string("_").append(text).append("_"); };
    return framed(upper(std::string(id))).find(framed(words)) != std::string::npos;
}

bool matches(const Check& check, const std::string& word)
{
    std::string name = upper(word);
    const bool level = name == std::string("L").append(std::to_string(static_cast<int>(check.level)));
    if (level || has_words(check.id, name)) {
        return true;
    }
    if (name.starts_with("EQ")) {
        name.erase(0, 2);
    }
    name.erase(0, name.find_first_not_of('0'));
    return std::ranges::find(check.equations, name) != check.equations.end();
}

std::string list(const std::vector<const Check*>& checks)
{
    std::string text;
    for (const Check* check : checks) {
        text += (text.empty() ? "" : ", ") + std::string(check->id);
    }
    return text;
}

/// What its quantities say.
void judge(CheckResult& result)
{
    std::int64_t compared = 0;
    std::string failed;
    std::string empty;
    for (const Quantity& q : result.quantities) {
        compared += q.compared();
        if (q.compared() > 0 && !q.passed()) {
            failed += (failed.empty() ? "not within its bound: " : ", ") + q.name();
        } else if (q.compared() == 0) {
            empty += (empty.empty() ? "nothing compared: " : ", ") + q.name();
        }
    }
    const bool excused = !result.message.empty(); // the check itself said why it isn't run
    if (!failed.empty()) {
        result.verdict = Verdict::fails;
        result.message = failed;
    } else if (excused) {
        result.verdict = Verdict::not_run;
    } else if (compared == 0 || !empty.empty()) {
        result.verdict = Verdict::fails;
        result.message = empty.empty() ? "nothing compared" : empty;
    } else {
        result.verdict = Verdict::holds;
    }
}

/// One entry of the result, and whom to run it for; null: it can't be run.
struct Job {
    CheckResult result;
    const Subject* subject = nullptr;
};

std::vector<Job> make_jobs(const std::vector<const Check*>& checks, const std::vector<SuiteSubject>& subjects)
{
    std::vector<Job> jobs;
    for (const Check* check : checks) {
        if (check->scope == Scope::once) {
            jobs.push_back({{.check = check, .subject = "once"}, &once()});
            continue;
        }
        for (const SuiteSubject& s : subjects) {
            if (looks_at(*check, s.subject) && s.missing.empty()) {
                jobs.push_back({{.check = check, .subject = s.subject.name()}, &s.subject});
            } else if (looks_at(*check, s.subject) && check->scope != Scope::equations) {
                jobs.push_back(
                    {{.check = check, .subject = s.subject.name(), .message = s.missing}, nullptr});
            }
        }
    }
    return jobs;
}

/// The jobs in their order on several threads; the caller's own looks on.
class Workers
{
public:
    Workers(std::vector<Job>& jobs, int threads) : jobs_(jobs)
    {
        for (int t = 0; t < std::max(threads, 1); ++t) {
            threads_.emplace_back([this] { work(); });
        }
    }

    void watch(const AfterResult& after_result)
    {
        const auto all = static_cast<std::int64_t>(jobs_.size());
        std::unique_lock lock(mutex_);
        while (done_ < all) {
            changed_.wait_for(lock, std::chrono::milliseconds(200));
            const std::int64_t done = done_;
            const std::string doing = doing_;
            lock.unlock();
            if (after_result) {
                after_result(done, all, doing);
            }
            lock.lock();
        }
    }

private:
    void work()
    {
        for (std::size_t k = next_++; k < jobs_.size(); k = next_++) {
            Job& job = jobs_[k];
            {
                const std::scoped_lock lock(mutex_);
                doing_ = std::string(job.result.check->id) + " (" + job.result.subject + ")";
            }
            run(job);
            {
                const std::scoped_lock lock(mutex_);
                ++done_;
            }
            changed_.notify_one();
        }
    }

    static void run(Job& job)
    {
        if (job.subject == nullptr) {
            return;
        }
        if (InterruptWatch::interrupted()) {
            job.result.message = interruption;
            return;
        }
        const std::string name = job.result.subject;
        job.result = run_check(*job.result.check, *job.subject);
        job.result.subject = name;
    }

    std::vector<Job>& jobs_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::int64_t done_ = 0;
    std::string doing_;
    std::vector<std::jthread> threads_; // last: they end before what they use
};

} // namespace

std::vector<const Check*> select(const std::vector<Check>& checks, bool full,
                                 const std::vector<std::string>& only)
{
    std::vector<const Check*> all;
    for (const Check& check : checks) {
        if (full || check.quick) {
            all.push_back(&check);
        }
    }
    for (const std::string& word : only) {
        if (std::ranges::none_of(all, [&](const Check* check) { return matches(*check, word); })) {
            throw InputError("--only", "matches no check (" + word + ")",
                             std::string("allowed: L0 to L5, equations such as 13 or EOS, words of ") +
                                 list(all) + (full ? "" : "; --full has more"));
        }
    }
    if (!only.empty()) {
        std::erase_if(all, [&](const Check* check) {
            return std::ranges::none_of(only, [&](const std::string& word) { return matches(*check, word); });
        });
    }
    return all;
}

bool looks_at(const Check& check, const Subject& subject)
{
    switch (check.scope) {
    case Scope::equations:
        return subject.equations != nullptr;
    case Scope::flows:
        return true;
    case Scope::backends:
        return subject.choice.backend != Backend::reference;
    case Scope::once:
        break;
    }
    return false;
}

CheckResult run_check(const Check& check, const Subject& subject)
{
    const auto start = Clock::now();
    Probe probe(subject);
    CheckResult result{.check = &check, .subject = subject.name()};
    std::string thrown;
    try {
        check.run(probe);
    } catch (const Interrupted&) {
        probe.not_run(interruption);
    } catch (const FirstFailure&) { // its quantity says what failed
    } catch (const std::exception& error) {
        thrown = error.what();
    } catch (...) {
        thrown = "something that is no std::exception";
    }
    result.message = probe.reason_not_run();
    result.quantities = probe.quantities();
    result.notes = probe.notes();
    result.plots = probe.plots();
    judge(result);
    if (result.verdict == Verdict::not_run) { // what was prepared for it says nothing
        std::erase_if(result.quantities, [](const Quantity& q) { return q.compared() == 0; });
        result.plots.clear();
    }
    if (!thrown.empty()) {
        result.verdict = Verdict::fails;
        result.message = "stopped: " + thrown;
    }
    result.seconds = seconds_since(start);
    return result;
}

SuiteResult run_suite(const std::vector<const Check*>& checks, std::vector<SuiteSubject> subjects,
                      int threads, const AfterResult& after_result)
{
    const auto start = Clock::now();
    analytic::gsl_return_errors(); // else an error in one check ends the program
    SuiteResult suite{.subjects = std::move(subjects)};
    std::vector<Job> jobs = make_jobs(checks, suite.subjects);
    Workers(jobs, threads).watch(after_result);
    for (Job& job : jobs) {
        suite.results.push_back(std::move(job.result));
    }
    suite.complete =
        std::ranges::none_of(suite.results, [](const CheckResult& r) { return r.message == interruption; });
    suite.seconds = seconds_since(start);
    return suite;
}

} // namespace aneurysm::suite
