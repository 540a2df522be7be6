// SPDX-License-Identifier: Apache-2.0
#include "output/report/junit.hpp"
#include "output/report/numbers.hpp"
#include "verification/suite/report.hpp"

namespace aneurysm::suite
{
namespace
{

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

} // namespace

std::string suite_junit(const SuiteReport& report)
{
    using Outcome = report::TestCase::Outcome;
    static constexpr std::array outcomes{Outcome::passed, Outcome::failed, Outcome::skipped}; // by Verdict
    std::vector<report::TestSuite> suites;
    for (std::size_t n = 0; n < words<Level>.size(); ++n) {
        suites.push_back({"L" + std::to_string(n) + " " + std::string(words<Level>.at(n).name)});
    }
    for (const CheckResult& r : report.suite.results) {
        const auto level = static_cast<std::size_t>(r.check->level);
        const std::string class_name = "L" + std::to_string(level) + "." + std::string(r.check->id);
        suites.at(level).cases.push_back({class_name, r.subject,
                                          outcomes.at(static_cast<std::size_t>(r.verdict)), r.message,
                                          details(r), r.seconds});
    }
    return report::junit("aneurysm verify", suites, report.date, report.suite.seconds);
}

} // namespace aneurysm::suite
