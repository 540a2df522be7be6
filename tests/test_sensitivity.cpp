// SPDX-License-Identifier: Apache-2.0
// The study of the suite's sensitivity, on checks made for it: it finds what can be found, and says what
// can't.
#include "verification/sensitivity/report.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

using namespace aneurysm;
using namespace aneurysm::verification;

namespace
{

/// (8) to a relative error of 1e-6.
void stress(Probe& probe)
{
    Quantity& q = probe.quantity("stress", Source::rounding, "1e-6, to be found again");
    for (const double P : {1000.0, 3000.0}) {
        const double expected = P * 0.4 / (2 * 0.01);
        q.within(probe.equations().wall_stress(P, 0.4, 0.01), expected, 1e-6 * expected);
    }
}

/// Whether (8) is right, without a quantity, whose first failure would end the check.
bool stress_holds(Probe& probe)
{
    probe.quantity("nothing", Source::exact, "always").holds(true);
    return std::abs(probe.equations().wall_stress(1000, 0.4, 0.01) - 20000) < 1;
}

/// What these say of a fault in (8) is: it crashes, or never ends.
void crash(Probe& probe)
{
    if (!stress_holds(probe)) {
        std::abort();
    }
}
void hang(Probe& probe)
{
    for (volatile bool forever = !stress_holds(probe); forever;) {
    }
}

/// Computes (13), and doesn't look.
void look_away(Probe& probe)
{
    const double P_c = probe.equations().critical_pressure(0.01, 0.4, 1e5, 0.4, 3e-3);
    probe.quantity("nothing", Source::exact, "always").holds(P_c == P_c);
}

Check check(std::string_view id, std::string_view equation, void (*run)(Probe&))
{
    return {.id = id,
            .equations = {equation},
            .title = "a test",
            .oracles = {"none"},
            .scope = Scope::equations,
            .run = run};
}

SensitivityStudy run_study(const std::vector<Check>& checks, const StudyOptions& options)
{
    std::vector<const Check*> chosen;
    chosen.reserve(checks.size());
    for (const Check& c : checks) {
        chosen.push_back(&c);
    }
    return verification::run_study(chosen, make_subjects({"reference", "cpu"}), options);
}

constexpr Fault in_stress{eq08_force, Side::reference, faults::Kind::coefficient, fault_size};
constexpr Fault in_pole{eq13_radius, Side::device, faults::Kind::sign, fault_size};

} // namespace

BOOST_AUTO_TEST_CASE(a_fault_is_found_by_the_check_that_looks_at_it)
{
    const std::vector<Check> checks{check("stress", "8", stress), check("pole", "13", look_away)};
    const SensitivityStudy study = run_study(checks, {.faults = {in_stress, in_pole}});
    BOOST_REQUIRE(study.rows.size() == 2U);
    BOOST_TEST(study.rows[0].finder == "stress (reference)");
    BOOST_TEST(study.rows[0].message == "not within its bound: stress");
    BOOST_CHECK(study.rows[0].cells[0] == Cell::red);
    BOOST_CHECK(study.rows[0].cells[1] == Cell::unreached);
    BOOST_TEST(study.rows[1].survives());
    BOOST_CHECK(study.rows[1].cells[0] == Cell::unreached);
    BOOST_CHECK(study.rows[1].cells[1] == Cell::green);
    BOOST_TEST(!passed(study));
}

BOOST_AUTO_TEST_CASE(the_smallest_fault_is_that_of_the_bound)
{
    const std::vector<Check> checks{check("stress", "8", stress)};
    const SensitivityStudy study = run_study(checks, {.faults = {in_stress}});
    BOOST_TEST(passed(study));
    BOOST_REQUIRE(study.sights.size() == 2U);
    BOOST_TEST(study.sights[0].smallest > 1e-6);
    BOOST_TEST(study.sights[0].smallest <= 2e-6);
    BOOST_TEST(study.sights[0].place == eq08_force);
    BOOST_TEST(study.sights[1].sees); // in cpu, where no fault of the study was: looked for by itself
    BOOST_TEST(study.sights[1].smallest == study.sights[0].smallest);
}

BOOST_AUTO_TEST_CASE(a_check_that_sees_nothing_fails_the_study)
{
    const std::vector<Check> checks{check("stress", "8", stress), check("pole", "13", look_away)};
    const SensitivityStudy study = run_study(checks, {.faults = {in_stress}});
    BOOST_REQUIRE(blind(study).size() == 2U);
    BOOST_TEST(blind(study)[0]->check->id == "pole");
    BOOST_TEST(!passed(study));
}

BOOST_AUTO_TEST_CASE(a_crash_and_a_check_without_end_are_found_faults)
{
    const std::vector<Check> crashing{check("crash", "8", crash)};
    const SensitivityStudy crashed = run_study(crashing, {.faults = {in_stress}, .daily = true});
    BOOST_TEST(crashed.rows[0].message == "crashed with signal 6");

    const std::vector<Check> hanging{check("hang", "8", hang)};
    const SensitivityStudy hung = run_study(hanging, {.faults = {in_stress}, .daily = true});
    BOOST_TEST(hung.rows[0].message == "didn't end in time");
}

BOOST_AUTO_TEST_CASE(a_check_that_is_red_by_itself_is_left_out_and_fails_the_study)
{
    const std::vector<Check> checks{check("stress", "8", stress), check("red", "8", [](Probe& probe) {
                                        probe.quantity("q", Source::exact, "never").holds(false);
                                    })};
    const SensitivityStudy study = run_study(checks, {.faults = {in_stress}});
    BOOST_TEST(unusable(study).size() == 1U); // in both backends, for the same reason
    BOOST_TEST(!study.rows[0].survives());
    BOOST_CHECK(study.rows[0].cells[1] == Cell::unreached);
    BOOST_TEST(!passed(study));
}

BOOST_AUTO_TEST_CASE(each_equation_has_five_faults_in_each_backend)
{
    std::map<std::string, int> faults;
    for (const Fault& fault : all_faults()) {
        ++faults[name_of(fault.side) + " " + equation_of(fault.place)];
    }
    for (const char* backend : {"reference", "cpu"}) {
        for (int n = 1; n <= 28; ++n) {
            BOOST_TEST(faults[backend + (" " + std::to_string(n))] >= 5, backend << " " << n);
        }
        BOOST_TEST(faults[std::string(backend) + " EOS"] >= 5);
    }
}

BOOST_AUTO_TEST_CASE(the_daily_faults_are_24_of_every_kind_in_both_backends)
{
    const std::vector<Fault> all = all_faults();
    std::map<std::string, int> sides;
    std::set<faults::Kind> kinds;
    std::set<std::string> names;
    std::set<std::string> equations{"1", "15", "5", "6", "21"}; // through those that use or feed them
    for (const Fault& fault : daily_faults()) {
        BOOST_TEST(std::ranges::any_of(all, [&](const Fault& f) { return name_of(f) == name_of(fault); }),
                   name_of(fault));
        ++sides[name_of(fault.side)];
        kinds.insert(fault.kind);
        names.insert(name_of(fault));
        equations.insert(equation_of(fault.place));
    }
    BOOST_TEST(names.size() == 24U);
    BOOST_TEST(sides["reference"] == 12);
    BOOST_TEST(sides["cpu"] == 12);
    BOOST_TEST(kinds.size() == 5U);
    BOOST_TEST(equations.size() == 29U); // (1) to (28), and the equation of state
}

BOOST_AUTO_TEST_CASE(reports_name_what_went_unnoticed)
{
    const std::vector<Check> checks{check("stress", "8", stress), check("pole", "13", look_away)};
    const SensitivityReport report{run_study(checks, {.faults = {in_stress, in_pole}}), "", "", "", "", 1};
    for (const std::string& text :
         {sensitivity_text(report), sensitivity_markdown(report), sensitivity_json(report)}) {
        BOOST_TEST(text.find("FAIL") != std::string::npos);
        BOOST_TEST(text.find("eq13_radius/sign/cpu") != std::string::npos);
        BOOST_TEST(text.find("eq08_force") != std::string::npos);
    }
    BOOST_TEST(sensitivity_html(report).find("UNNOTICED") != std::string::npos);
}
