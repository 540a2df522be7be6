// SPDX-License-Identifier: Apache-2.0
#include "output/report/markup.hpp"
#include "output/report/numbers.hpp"
#include "verification/suite/report.hpp"

namespace aneurysm::suite
{
namespace
{

using report::element;
using report::empty_element;
using report::Markup;

/// What failed, line by line.
std::string details(const CheckResult& r)
{
    std::string text;
    for (const Quantity& q : r.quantities) {
        const Quantity::Worst& w = q.worst();
        if (!q.passed()) {
            text += q.name() + ": " + std::to_string(q.failed()) + " of " + std::to_string(q.compared()) +
                    " not within the bound; measured " + report::shown(w.error) + ", allowed " +
                    report::shown(w.allowed) + (w.where.empty() ? "" : " at " + w.where) +
                    "; bound: " + q.derivation() + "\n";
        }
    }
    return text;
}

Markup test_case(const CheckResult& r)
{
    Markup outcome;
    if (r.verdict == Verdict::fails) {
        outcome = element("failure", {{"message", r.message}}, details(r));
    } else if (r.verdict == Verdict::not_run) {
        outcome = empty_element("skipped", {{"message", r.message}});
    } else if (r.verdict == Verdict::limit) {
        outcome = element("system-out", {}, r.message);
    }
    return element("testcase",
                   {{"classname", number_of(r.check->level) + "." + std::string(r.check->id)},
                    {"name", r.subject},
                    {"time", report::printed("%.3f", r.seconds)}},
                   outcome)
           << "\n";
}

/// An element around test cases that counts them.
Markup counted(const char* element_name, const std::string& name, const Tally& tally, double seconds,
               const std::string& date, const Markup& content)
{
    return element(element_name,
                   {{"name", name},
                    {"tests", std::to_string(tally.holds + tally.fails + tally.not_run + tally.limits)},
                    {"failures", std::to_string(tally.fails)},
                    {"errors", "0"},
                    {"skipped", std::to_string(tally.not_run)},
                    {"time", report::printed("%.3f", seconds)},
                    {"timestamp", date}},
                   "\n", content)
           << "\n";
}

} // namespace

std::string suite_junit(const SuiteReport& report)
{
    Markup suites;
    for (const Level level : levels) {
        Markup cases;
        double seconds = 0;
        for (const CheckResult& r : report.suite.results) {
            if (r.check->level == level) {
                cases << test_case(r);
                seconds += r.seconds;
            }
        }
        suites << counted("testsuite", number_of(level) + " " + std::string(name_of(level)),
                          tally(report.suite, level), seconds, report.date, cases);
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + counted("testsuites", "aneurysm verify",
                                                                    tally(report.suite), report.suite.seconds,
                                                                    report.date, suites)
                                                                .text();
}

} // namespace aneurysm::suite
