// SPDX-License-Identifier: Apache-2.0
#include "verification/suite/suite.hpp"

#include "common/error.hpp"
#include "common/parallel.hpp"
#include "common/process/interrupt.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <chrono>
#include <mutex>

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

/// What a word that matches no chosen check may have meant: checks that only --full makes, or such as have
/// its first letters in their names.
std::string hint(const std::vector<Check>& checks, const std::string& word)
{
    const std::string first = upper(word.substr(0, 4));
    std::vector<std::string_view> slow;
    std::vector<std::string_view> near;
    for (const Check& check : checks) {
        if (matches(check, word)) {
            slow.push_back(check.id);
        } else if (!first.empty() && upper(std::string(check.id)).find(first) != std::string::npos) {
            near.push_back(check.id);
        }
    }
    if (!slow.empty()) {
        return "with --full there is " + joined(slow);
    }
    return near.empty() ? "the names stand in the report" : "near it: " + joined(near);
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
    std::string unmet;
    for (const Accuracy& a : result.accuracies) {
        unmet += a.met() ? "" : (unmet.empty() ? "not met yet: " : ", ") + a.name;
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
    } else if (!unmet.empty()) {
        result.verdict = Verdict::limit;
        result.message = unmet;
    } else {
        result.verdict = Verdict::holds;
    }
}

/// Who the model is measured with: what is recorded of it are the bits of single precision, on a CPU or a GPU.
const SuiteSubject* measured(const std::vector<SuiteSubject>& subjects)
{
    static const SuiteSubject not_chosen{
        {{Backend::cpu, Precision::float_, 1, 0}}, "", "the model is measured in single precision only"};
    const auto found = std::ranges::find_if(subjects, [](const SuiteSubject& s) {
        return s.subject.choice.precision == Precision::float_ && s.missing.empty();
    });
    return found == subjects.end() ? &not_chosen : &*found;
}

/// A check, and whom to run it for.
struct Job {
    const Check* check = nullptr;
    const SuiteSubject* on = nullptr;

    std::string subject() const { return name_for(*check, on->subject); }
};

CheckResult run(const Job& job)
{
    const std::string obstacle = !job.on->missing.empty()        ? job.on->missing
                                 : InterruptWatch::interrupted() ? interruption
                                                                 : "";
    return obstacle.empty() ? run_check(*job.check, job.on->subject)
                            : CheckResult{.check = job.check, .subject = job.subject(), .message = obstacle};
}

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
                             "allowed: L0 to L5, equations such as 13 or EOS, words of checks' names; " +
                                 hint(checks, word));
        }
    }
    if (!only.empty()) {
        std::erase_if(all, [&](const Check* check) {
            return std::ranges::none_of(only, [&](const std::string& word) { return matches(*check, word); });
        });
    }
    return all;
}

std::vector<const SuiteSubject*> subjects_of(const Check& check, const std::vector<SuiteSubject>& subjects)
{
    static const SuiteSubject any{once(), "", ""};
    if (check.scope == Scope::once) {
        return {&any};
    }
    if (check.scope == Scope::model) {
        return {measured(subjects)};
    }
    std::vector<const SuiteSubject*> chosen;
    for (const SuiteSubject& s : subjects) {
        const bool has_equations = s.subject.equations != nullptr && s.missing.empty();
        const bool is_reference = s.subject.choice.backend == Backend::reference;
        if (check.scope == Scope::flows || (check.scope == Scope::equations && has_equations) ||
            (check.scope == Scope::backends && !is_reference)) {
            chosen.push_back(&s);
        }
    }
    return chosen;
}

std::string name_for(const Check& check, const Subject& subject)
{
    return check.scope == Scope::once ? "once" : subject.name();
}

CheckResult run_check(const Check& check, const Subject& subject)
{
    const auto start = Clock::now();
    CheckResult result{.check = &check, .subject = name_for(check, subject)};
    Probe probe(subject, result);
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
    std::vector<Job> jobs;
    for (const Check* check : checks) {
        for (const SuiteSubject* s : subjects_of(*check, suite.subjects)) {
            jobs.push_back({check, s});
        }
    }
    suite.results.resize(jobs.size());
    std::mutex mutex;
    std::string doing; // guarded by it
    std::atomic<std::int64_t> done = 0;
    const auto work = [&](std::size_t k) {
        {
            const std::scoped_lock lock(mutex);
            doing = std::string(jobs[k].check->id) + " (" + jobs[k].subject() + ")";
        }
        suite.results[k] = run(jobs[k]);
        ++done;
    };
    in_parallel(jobs.size(), threads, work, [&] {
        const std::scoped_lock lock(mutex);
        if (after_result) {
            after_result(done, static_cast<std::int64_t>(jobs.size()), doing);
        }
    });
    suite.complete =
        std::ranges::none_of(suite.results, [](const CheckResult& r) { return r.message == interruption; });
    suite.seconds = seconds_since(start);
    return suite;
}

} // namespace aneurysm::suite
