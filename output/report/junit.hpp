// SPDX-License-Identifier: Apache-2.0
// Results of tests as CI systems read them.
#pragma once

#include <string>
#include <vector>

namespace aneurysm::report
{

struct TestCase {
    enum class Outcome { passed, failed, skipped };
    std::string class_name;
    std::string name;
    Outcome outcome = Outcome::passed;
    std::string message{}; ///< why it failed or was skipped
    std::string details{}; ///< of a failure, in lines
    double seconds = 0;
};
struct TestSuite {
    std::string name;
    std::vector<TestCase> cases{};
};

/// `date`: in UTC; `seconds`: of all, as the clock on the wall had it.
std::string junit(const std::string& name, const std::vector<TestSuite>& suites, const std::string& date,
                  double seconds);

} // namespace aneurysm::report
