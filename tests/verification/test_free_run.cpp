// SPDX-License-Identifier: Apache-2.0
// The comparison of free runs with an ensemble: another member passes, another model doesn't.
#include "tests/verification/candidates.hpp"
#include "verification/comparison/free_run.hpp"

#include <cmath>
#include <limits>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

/// Coarse, and it flows at once and ruptures within a few frames.
const Scenario& brief()
{
    static const Scenario scenario = [] {
        Scenario s = shipped_scenario("quick");
        s.particles.count = 700;
        s.inlet.ramp_s = 0.01;
        s.growth.warm_up_frames = 8;
        s.rupture.yield_limit_pa /= 1000;
        return s;
    }();
    return scenario;
}

const SimulationState& start()
{
    static const SimulationState state = reference::Simulation(brief()).state();
    return state;
}

comparison::ComparisonResult compare(const Scenario& computed, const Faults& faults = {}, int frames = 32)
{
    Candidate candidate(computed, start(), Precision::float_, faults);
    comparison::FreeRunSettings settings;
    settings.frames = frames;
    settings.windows = 4;
    settings.members = 6;
    settings.false_alarm = 0.05; // few members make wide intervals; the seeds are fixed
    return comparison::compare_free(brief(), candidate, settings, go_on);
}

/// Whether another model is found, and in this field.
template <class Change>
bool finds(Change change, std::string_view field)
{
    Scenario other = brief();
    change(other);
    return is_red(compare(other), field);
}

} // namespace

BOOST_AUTO_TEST_CASE(free_run_of_the_same_model_passes)
{
    const comparison::ComparisonResult result = compare(brief());
    for (const auto& field : result.fields) {
        BOOST_TEST(field.worst.failed == 0, field.worst.name);
    }
    BOOST_TEST(result.passed());
    BOOST_TEST(result.phases.contains(Phase::ruptured));
    BOOST_TEST(result.frames.size() == 4U);
}

BOOST_AUTO_TEST_CASE(free_run_of_another_model_fails)
{
    BOOST_TEST(finds([](Scenario& s) { s.fluid.viscosity_pa_s *= 1.1; }, "kinetic energy [J]"));
    BOOST_TEST(finds([](Scenario& s) { s.inlet.peak_velocity_m_s *= 1.02; }, "momentum y [kg m/s]"));
    BOOST_TEST(finds([](Scenario& s) { s.rupture.yield_limit_pa *= 1.01; }, "P_c [Pa]"));
    BOOST_TEST(finds([](Scenario& s) { s.growth.warm_up_frames = 31; }, "frame of rupture"));
}

BOOST_AUTO_TEST_CASE(free_run_with_a_fault_in_a_number_fails)
{
    const Faults faults{{}, [](Frame& f) {
                            f.record.impact_force *= 1.5;
                            f.record.radius *= 1 + 1e-4;
                            f.record.thickness *= 1 + 1e-4;
                        }};
    const comparison::ComparisonResult result = compare(brief(), faults);
    BOOST_TEST(is_red(result, "F_b [N]"));
    BOOST_TEST(is_red(result, "R [m]"));
    BOOST_TEST(is_red(result, "h [m]"));
    const Faults nan{{},
                     [](Frame& f) { f.record.kinetic_energy = std::numeric_limits<double>::quiet_NaN(); }};
    BOOST_TEST(is_red(compare(brief(), nan, 4), "kinetic energy [J]"));
    BOOST_TEST(!compare(brief(), {}, 0).passed());
}

BOOST_AUTO_TEST_CASE(free_run_prediction_interval_is_students)
{
    struct Row {
        int freedom;
        double alpha; ///< two-sided
        double t;     ///< as printed in tables of Student's distribution
    };
    for (const auto& [freedom, alpha, t] :
         {Row{2, 0.05, 4.302653}, Row{3, 0.05, 3.182446}, Row{7, 0.05, 2.364624}, Row{19, 0.05, 2.093024},
          Row{2, 1e-3, 31.599055}, Row{7, 1e-3, 5.407883}, Row{19, 1e-3, 3.883406}}) {
        const double factor = comparison::prediction_factor(freedom + 1, alpha);
        BOOST_TEST(within(factor / std::sqrt(1 + 1.0 / (freedom + 1)), t, 1e-6));
    }
    BOOST_TEST(
        !within(comparison::prediction_factor(8, 0.05), comparison::prediction_factor(8, 0.051), 1e-3));
}
