// SPDX-License-Identifier: Apache-2.0
#include "output/report/junit.hpp"

#include "output/report/markup.hpp"
#include "output/report/numbers.hpp"

#include <algorithm>

namespace aneurysm::report
{
namespace
{

using Cases = std::vector<TestCase>;

Markup markup(const TestCase& test)
{
    Markup outcome;
    if (test.outcome == TestCase::Outcome::failed) {
        outcome = element("failure", {{"message", test.message}}, test.details);
    } else if (test.outcome == TestCase::Outcome::skipped) {
        outcome = empty_element("skipped", {{"message", test.message}});
    }
    return element(
               "testcase",
               {{"classname", test.class_name}, {"name", test.name}, {"time", printed("%.3f", test.seconds)}},
               outcome)
           << "\n";
}

std::string count(const Cases& cases, TestCase::Outcome outcome)
{
    return std::to_string(std::ranges::count(cases, outcome, &TestCase::outcome));
}

/// An element around them that counts them.
Markup counted(const char* element_name, const std::string& name, const Cases& cases, double seconds,
               const std::string& date, const Markup& content)
{
    return element(element_name,
                   {{"name", name},
                    {"tests", std::to_string(cases.size())},
                    {"failures", count(cases, TestCase::Outcome::failed)},
                    {"errors", "0"},
                    {"skipped", count(cases, TestCase::Outcome::skipped)},
                    {"time", printed("%.3f", seconds)},
                    {"timestamp", date}},
                   "\n", content)
           << "\n";
}

} // namespace

std::string junit(const std::string& name, const std::vector<TestSuite>& suites, const std::string& date,
                  double seconds)
{
    Markup content;
    Cases all;
    for (const TestSuite& suite : suites) {
        Markup cases;
        double sum = 0;
        for (const TestCase& test : suite.cases) {
            cases << markup(test);
            sum += test.seconds;
        }
        content << counted("testsuite", suite.name, suite.cases, sum, date, cases);
        all.insert(all.end(), suite.cases.begin(), suite.cases.end());
    }
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" +
           counted("testsuites", name, all, seconds, date, content).text();
}

} // namespace aneurysm::report
