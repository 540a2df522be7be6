// SPDX-License-Identifier: Apache-2.0
// The study of the suite's sensitivity, on checks made for it:
// it finds what can be found, and says what can't.
#include "output/report/html.hpp"
#include "output/report/markdown.hpp"
#include "verification/sensitivity/report.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <string>

using namespace aneurysm;

namespace
{

/// (8) to a relative error of 1e-6.
void stress(suite::Probe& probe)
{
    suite::Quantity& q = probe.quantity("stress", suite::Source::rounding, "1e-6, to be found again");
    for (const double P : {1000.0, 3000.0}) {
        const double expected = P * 0.4 / (2 * 0.01);
        q.within(probe.equations().wall_stress(P, 0.4, 0.01), expected, 1e-6 * expected);
    }
}

/// Whether (8) is right, without a quantity, whose first failure would end the check.
bool stress_holds(suite::Probe& probe)
{
    probe.quantity("nothing", suite::Source::exact, "always").holds(true);
    return std::abs(probe.equations().wall_stress(1000, 0.4, 0.01) - 20000) < 1;
}

/// What these say of a mutant in (8) is: it crashes, or never ends.
void crash(suite::Probe& probe)
{
    if (!stress_holds(probe)) {
        std::abort();
    }
}
void hang(suite::Probe& probe)
{
    for (volatile bool forever = !stress_holds(probe); forever;) {
    }
}

/// Computes (13), and doesn't look.
void look_away(suite::Probe& probe)
{
    const double P_c = probe.equations().critical_pressure(0.01, 0.4, 1e5, 0.4, 3e-3);
    probe.quantity("nothing", suite::Source::exact, "always").holds(P_c == P_c);
}

suite::Check check(std::string_view id, std::string_view equation, void (*run)(suite::Probe&))
{
    return {.id = id,
            .equations = {equation},
            .title = "a test",
            .oracles = {"none"},
            .scope = suite::Scope::equations,
            .run = run};
}

sensitivity::SensitivityStudy run_study(const std::vector<suite::Check>& checks,
                                        const sensitivity::StudyOptions& options)
{
    std::vector<const suite::Check*> chosen;
    chosen.reserve(checks.size());
    for (const suite::Check& c : checks) {
        chosen.push_back(&c);
    }
    return sensitivity::run_study(chosen, suite::make_subjects({Backend::reference, Backend::cpu}), options);
}

constexpr sensitivity::Mutant in_stress{sensitivity::eq08_force, sensitivity::Side::reference,
                                        sensitivity::Kind::coefficient, sensitivity::mutant_size};
constexpr sensitivity::Mutant in_pole{sensitivity::eq13_radius, sensitivity::Side::device,
                                      sensitivity::Kind::sign, sensitivity::mutant_size};

} // namespace

BOOST_AUTO_TEST_CASE(a_mutant_is_found_by_the_check_that_looks_at_it_and_else_named_by_the_reports)
{
    const std::vector<suite::Check> checks{check("stress", "8", stress), check("pole", "13", look_away)};
    const sensitivity::SensitivityReport report{
        run_study(checks, {.mutants = {in_stress, in_pole}}), "", "", "", "", 1};
    const sensitivity::SensitivityStudy& study = report.study;
    BOOST_REQUIRE(study.rows.size() == 2U);
    BOOST_TEST(study.rows[0].finder == "stress (reference)");
    BOOST_TEST(study.rows[0].message == "not within its bound: stress");
    BOOST_CHECK(study.rows[0].cells[0] == sensitivity::Cell::red);
    BOOST_CHECK(study.rows[0].cells[1] == sensitivity::Cell::unreached);
    BOOST_TEST(study.rows[1].survives());
    BOOST_CHECK(study.rows[1].cells[0] == sensitivity::Cell::unreached);
    BOOST_CHECK(study.rows[1].cells[1] == sensitivity::Cell::green);
    BOOST_TEST(!sensitivity::passed(study));
    for (const std::string& text : {sensitivity::sensitivity_text(report),
                                    report::markdown(sensitivity::sensitivity_document(report, false)),
                                    sensitivity::sensitivity_json(report)}) {
        BOOST_TEST(text.find("FAIL") != std::string::npos);
        BOOST_TEST(text.find("eq13_radius/sign/cpu") != std::string::npos);
        BOOST_TEST(text.find("eq08_force") != std::string::npos);
    }
    BOOST_TEST(report::html(sensitivity::sensitivity_document(report, true)).find("UNNOTICED") !=
               std::string::npos);
}

BOOST_AUTO_TEST_CASE(the_smallest_mutant_is_that_of_the_bound)
{
    const std::vector<suite::Check> checks{check("stress", "8", stress)};
    const sensitivity::SensitivityStudy study = run_study(checks, {.mutants = {in_stress}});
    BOOST_TEST(sensitivity::passed(study));
    BOOST_REQUIRE(study.sights.size() == 2U);
    BOOST_TEST(study.sights[0].smallest > 1e-6);
    BOOST_TEST(study.sights[0].smallest <= 2e-6);
    BOOST_TEST(study.sights[0].place == sensitivity::eq08_force);
    BOOST_TEST(study.sights[1].sees); // in cpu, where no mutant of the study was: looked for by itself
    BOOST_TEST(study.sights[1].smallest == study.sights[0].smallest);
}

BOOST_AUTO_TEST_CASE(a_check_that_sees_nothing_fails_the_study)
{
    const std::vector<suite::Check> checks{check("stress", "8", stress), check("pole", "13", look_away)};
    const sensitivity::SensitivityStudy study = run_study(checks, {.mutants = {in_stress}});
    for (const sensitivity::Sight& sight : study.sights) {
        BOOST_TEST(sight.sees == (sight.check->id == "stress"));
    }
    BOOST_TEST(!sensitivity::passed(study));
}

BOOST_AUTO_TEST_CASE(a_crash_and_a_check_without_end_are_found_mutants)
{
    const std::vector<suite::Check> crashing{check("crash", "8", crash)};
    const sensitivity::SensitivityStudy crashed =
        run_study(crashing, {.mutants = {in_stress}, .daily = true});
    BOOST_TEST(crashed.rows[0].message == "crashed with signal 6");

    const std::vector<suite::Check> hanging{check("hang", "8", hang)};
    const sensitivity::SensitivityStudy hung = run_study(hanging, {.mutants = {in_stress}, .daily = true});
    BOOST_TEST(hung.rows[0].message == "didn't end in time");
}

BOOST_AUTO_TEST_CASE(a_check_that_is_red_by_itself_is_left_out_and_fails_the_study)
{
    const std::vector<suite::Check> checks{
        check("stress", "8", stress), check("red", "8", [](suite::Probe& probe) {
            probe.quantity("q", suite::Source::exact, "never").holds(false);
        })};
    const sensitivity::SensitivityStudy study = run_study(checks, {.mutants = {in_stress}});
    BOOST_TEST(sensitivity::unusable(study).size() == 1U); // in both backends, for the same reason
    BOOST_TEST(!study.rows[0].survives());
    BOOST_CHECK(study.rows[0].cells[1] == sensitivity::Cell::unreached);
    BOOST_TEST(!sensitivity::passed(study));
}

BOOST_AUTO_TEST_CASE(each_equation_has_five_mutants_in_each_backend)
{
    std::map<std::string, int> mutants;
    for (const sensitivity::Mutant& mutant : sensitivity::all_mutants()) {
        ++mutants[sensitivity::name_of(mutant.side) + " " + sensitivity::equation_of(mutant.place)];
    }
    for (const char* backend : {"reference", "cpu"}) {
        for (int n = 1; n <= 28; ++n) {
            BOOST_TEST(mutants[backend + (" " + std::to_string(n))] >= 5, backend << " " << n);
        }
        BOOST_TEST(mutants[std::string(backend) + " EOS"] >= 5);
    }
}

BOOST_AUTO_TEST_CASE(the_daily_mutants_are_24_of_every_kind_in_both_backends)
{
    const std::vector<sensitivity::Mutant> all = sensitivity::all_mutants();
    std::map<std::string, int> sides;
    std::set<sensitivity::Kind> kinds;
    std::set<std::string> names;
    std::set<std::string> equations{"1", "15", "5", "6", "21"}; // through those that use or feed them
    for (const sensitivity::Mutant& mutant : sensitivity::daily_mutants()) {
        BOOST_TEST(std::ranges::any_of(all,
                                       [&](const sensitivity::Mutant& f) {
                                           return sensitivity::name_of(f) == sensitivity::name_of(mutant);
                                       }),
                   sensitivity::name_of(mutant));
        ++sides[sensitivity::name_of(mutant.side)];
        kinds.insert(mutant.kind);
        names.insert(sensitivity::name_of(mutant));
        equations.insert(sensitivity::equation_of(mutant.place));
    }
    BOOST_TEST(names.size() == 24U);
    BOOST_TEST(sides["reference"] == 12);
    BOOST_TEST(sides["cpu"] == 12);
    BOOST_TEST(kinds.size() == 5U);
    BOOST_TEST(equations.size() == 29U); // (1) to (28), and the equation of state
}
