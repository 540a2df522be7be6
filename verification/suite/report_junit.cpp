// SPDX-License-Identifier: Apache-2.0
#include "output/report/markup.hpp"
#include "verification/suite/report.hpp"

#include <array>
#include <cstdio>

namespace aneurysm::suite
{
namespace
{

std::string seconds_text(double seconds)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3f", seconds);
    return text.data();
}

/// What failed, line by line.
std::string failures(const CheckResult& r)
{
    std::string text;
    for (const Quantity& q : r.quantities) {
        const Quantity::Worst& w = q.worst();
        if (!q.passed()) {
            text += q.name() + ": " + std::to_string(q.failed()) + " of " + std::to_string(q.compared()) +
                    " not within the bound; measured " + shown(w.error) + ", allowed " + shown(w.allowed) +
                    (w.where.empty() ? "" : " at " + w.where) + "; bound: " + q.derivation() + "\n";
        }
    }
    return text;
}

report::Markup test_case(const CheckResult& r)
{
    report::Markup outcome;
    if (r.verdict == Verdict::fails) {
        outcome << report::element("failure", {{"message", r.message}}, failures(r));
    } else if (r.verdict == Verdict::not_run) {
        outcome << report::empty_element("skipped", {{"message", r.message}});
    }
    return report::element("testcase",
                           {{"classname", "L" + std::to_string(static_cast<int>(r.check->level)) + "." +
                                              std::string(r.check->id)},
                            {"name", r.subject},
                            {"time", seconds_text(r.seconds)}},
                           outcome);
}

} // namespace

std::string suite_junit(const SuiteReport& report)
{
    report::Markup suites;
    for (int n = 0; n <= static_cast<int>(Level::executors); ++n) {
        report::Markup cases;
        Tally t;
        double seconds = 0;
        for (const CheckResult& r : report.suite.results) {
            if (static_cast<int>(r.check->level) == n) {
                cases << test_case(r) << "\n";
                t.add(r);
                seconds += r.seconds;
            }
        }
        suites << report::element(
                      "testsuite",
                      {{"name", "L" + std::to_string(n) + " " + std::string(name_of(static_cast<Level>(n)))},
                       {"tests", std::to_string(t.holds + t.fails + t.not_run)},
                       {"failures", std::to_string(t.fails)},
                       {"errors", "0"},
                       {"skipped", std::to_string(t.not_run)},
                       {"time", seconds_text(seconds)},
                       {"timestamp", report.date}},
                      "\n", cases)
               << "\n";
    }
    const Tally all = tally(report.suite);
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
           report::element("testsuites",
                           {{"name", "aneurysm verify"},
                            {"tests", std::to_string(all.holds + all.fails + all.not_run)},
                            {"failures", std::to_string(all.fails)},
                            {"errors", "0"},
                            {"skipped", std::to_string(all.not_run)},
                            {"time", seconds_text(report.suite.seconds)}},
                           "\n", suites)
               .text() +
           "\n";
}

} // namespace aneurysm::suite
