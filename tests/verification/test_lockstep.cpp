// SPDX-License-Identifier: Apache-2.0
// The comparison in lockstep: the reference, rounded to float, passes; a mutant of it doesn't.
#include "output/columns.hpp"
#include "tests/verification/candidates.hpp"

#include <array>
#include <cmath>
#include <limits>

using namespace aneurysm;
using namespace aneurysm::test;
using comparison::ComparisonResult;

namespace
{

const Scenario& scenario()
{
    static const Scenario result = shipped_scenario("quick");
    return result;
}

/// Frame 10, where blood has begun to move and needs no pressure yet, and frame 30, where it is in full flow.
const std::array<SimulationState, 2>& starts()
{
    static const std::array<SimulationState, 2> states = [] {
        std::array<SimulationState, 2> result;
        reference::Simulation simulation(scenario());
        for (int n = 1; n <= 30; ++n) {
            simulation.advance();
            result[n > 10 ? 1 : 0] = simulation.state();
        }
        return result;
    }();
    return states;
}
const SimulationState& start()
{
    return starts()[1];
}

/// A candidate that computes `scenario` as it is.
ComparisonResult compare_right(const Scenario& right, Precision precision, int frames)
{
    Candidate candidate(right, start(), precision);
    return lockstep(right, candidate, frames);
}

ComparisonResult compare_faulty(const Faults& faults, Precision precision = Precision::float_, int frames = 1)
{
    Candidate candidate(scenario(), start(), precision, faults);
    return lockstep(scenario(), candidate, frames);
}

/// Blood in the middle of the parent tube.
std::size_t some_blood(const SimulationState& state)
{
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        const Vec3& x = state.particles.position[i];
        if (state.particles.kind[i] == Kind::fluid && x.y < -0.5 && x.y > -1 && std::hypot(x.x, x.z) < 0.2) {
            return i;
        }
    }
    throw std::runtime_error("no blood in the parent tube");
}

/// Blood in the far layer of an outlet's buffer, on which nothing pulls.
std::size_t last_blood(const SimulationState& state)
{
    const Opening end = make_vessel(scenario()).openings()[1];
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        if (state.particles.kind[i] == Kind::outlet_1 &&
            end.beyond(state.particles.position[i]) > 2 * state.spacing) {
            return i;
        }
    }
    throw std::runtime_error("no blood in the far layer");
}

} // namespace

BOOST_AUTO_TEST_CASE(lockstep_the_reference_passes_in_both_precisions)
{
    Scenario growing = scenario();
    growing.growth.warm_up_frames = start().frame + 2;
    for (const Precision precision : {Precision::double_, Precision::float_}) {
        const ComparisonResult result = compare_right(growing, precision, 15);
        BOOST_TEST(result.passed());
        BOOST_TEST(result.frames.size() == 15U);
        BOOST_TEST(result.open_frames.empty());
        BOOST_TEST(result.phases.contains(Phase::growing));
    }
}

BOOST_AUTO_TEST_CASE(lockstep_passes_through_rupture_and_bleeding)
{
    Scenario weak = scenario();
    weak.growth.warm_up_frames = start().frame + 2;
    weak.rupture.yield_limit_pa /= 1000;
    weak.rupture.breach_radius_radii *= 2;
    const ComparisonResult result = compare_right(weak, Precision::float_, 25);
    BOOST_TEST(result.passed());
    BOOST_TEST(result.phases.contains(Phase::warm_up));
    BOOST_TEST(result.phases.contains(Phase::ruptured));
}

BOOST_AUTO_TEST_CASE(lockstep_passes_with_substeps_and_with_the_equation_of_state)
{
    Scenario fine = scenario();
    fine.time.substeps = 2;
    BOOST_TEST(compare_right(fine, Precision::float_, 5).passed());
    Scenario eos = scenario();
    eos.pressure.model = PressureModel::eos;
    eos.pressure.stiffness_m2_s2 = 100;
    BOOST_TEST(compare_right(eos, Precision::float_, 5).passed());
    Candidate wrong(scenario(), start(), Precision::float_);
    BOOST_TEST(!lockstep(eos, wrong, 1).passed());
}

/// Pressures that would have to be lower, where the reference and a float candidate know their lowest value
/// only up to rounding.
BOOST_AUTO_TEST_CASE(lockstep_passes_where_blood_would_tear)
{
    Scenario tearing = scenario();
    tearing.outlet.pressure_pa = 10 * start().particles.pressure[last_blood(start())];
    Candidate candidate(tearing, start(), Precision::float_);
    BOOST_TEST(lockstep(tearing, candidate, 3).passed());
    const std::vector<double>& p = candidate.solved_pressure();
    BOOST_TEST(std::ranges::count(p, *std::ranges::min_element(p)) > 1);
}

BOOST_AUTO_TEST_CASE(lockstep_nothing_compared_is_a_failure)
{
    BOOST_TEST(!compare_right(scenario(), Precision::float_, 0).passed());
}

/// Another scenario is computed than should be.
BOOST_AUTO_TEST_CASE(lockstep_finds_other_constants)
{
    const auto finds_from = [](const SimulationState& begin, auto change, Precision precision,
                               const char* field) {
        Scenario other = scenario();
        change(other);
        Candidate candidate(other, begin, precision);
        return is_red(lockstep(scenario(), candidate, 5), field);
    };
    const auto finds = [&](auto... how) { return finds_from(start(), how...); };
    // Bounds of the velocity grow with the pressure.
    const auto finds_early = [&](auto... how) { return finds_from(starts()[0], how...); };
    constexpr Precision in_float = Precision::float_;
    constexpr Precision in_double = Precision::double_;
    constexpr const char* v = "velocity [m/s]";
    constexpr const char* v_inlet = "inlet_velocity_m_s";
    BOOST_TEST(finds_early([](Scenario& s) { s.fluid.viscosity_pa_s *= 1 + 1e-4; }, in_float, v));
    BOOST_TEST(finds_early([](Scenario& s) { s.fluid.viscosity_pa_s *= 1 + 1e-12; }, in_double, v));
    BOOST_TEST(finds([](Scenario& s) { s.fluid.density_kg_m3 *= 1 + 1e-4; }, in_float, "density [kg/m^3]"));
    BOOST_TEST(finds([](Scenario& s) { s.outlet.level_margin *= 1 + 1e-4; }, in_float, v));
    BOOST_TEST(finds([](Scenario& s) { s.inlet.peak_velocity_m_s *= 1 + 1e-6; }, in_float, v_inlet));
    BOOST_TEST(finds([](Scenario& s) { s.inlet.ramp_s *= 1 + 1e-6; }, in_float, v_inlet));
    BOOST_TEST(finds([](Scenario& s) { s.inlet.profile = InletProfile::parabolic; }, in_float, v));
    BOOST_TEST(finds([](Scenario& s) { s.controller.refill_distance_spacings *= 0.9; }, in_float, "kind"));
    BOOST_TEST(finds([](Scenario& s) { s.rupture.impact_band_spacings *= 4; }, in_float, "impact_count"));
    BOOST_TEST(finds([](Scenario& s) { s.pressure.relaxation *= 0.8; }, in_double, "iterations"));
    BOOST_TEST(
        finds([](Scenario& s) { s.pressure.correction_tolerance_per_s /= 2; }, in_double, "corrections"));
    BOOST_TEST(finds([](Scenario& s) { s.pressure.tolerance_per_s *= 2; }, in_float,
                     "solution of (3): residual_mean [1/s]"));
    BOOST_TEST(finds([](Scenario& s) { s.pressure.correction_tolerance_per_s *= 2; }, in_float,
                     "solution of (3): correction's mean residual [1/s]"));
    BOOST_TEST(finds([](Scenario& s) { s.pressure.density_correction *= 0.9; }, in_float,
                     "solution of (3): correction's mean residual [1/s]"));
}

/// Gravity and the pressure at the outlets act once the wall has a hole.
BOOST_AUTO_TEST_CASE(lockstep_finds_other_constants_when_blood_flows_out)
{
    SimulationState ruptured = start();
    ruptured.aneurysm.phase = Phase::ruptured;
    const auto finds = [&](auto change) {
        Scenario other = scenario();
        change(other);
        Candidate candidate(other, ruptured, Precision::float_);
        return is_red(lockstep(scenario(), candidate, 1), "velocity [m/s]");
    };
    BOOST_TEST(!finds([](Scenario&) {}));
    BOOST_TEST(finds([](Scenario& s) { s.fluid.gravity_m_s2.y *= 1 + 1e-2; }));
    BOOST_TEST(finds([](Scenario& s) { s.outlet.pressure_pa *= 1 + 1e-4; }));
}

BOOST_AUTO_TEST_CASE(lockstep_finds_one_particle)
{
    const std::size_t i = some_blood(start());
    const auto after = [&](auto change, const char* field) {
        return is_red(compare_faulty({{}, change}), field);
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_TEST(after([i](Frame& f) { f.state.particles.velocity[i].x += 1e-3; }, "velocity [m/s]"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.position[i].x += 1e-6; }, "position [m]"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.pressure[i] *= 1 + 1e-6; }, "pressure [Pa]"));
    BOOST_TEST(after([i](Frame& f) { f.density[i] *= 1 + 1e-4; }, "density [kg/m^3]"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.kind[i] = Kind::escaped; }, "kind"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.velocity[i].z = nan; }, "velocity [m/s]"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.position[i].z = nan; }, "position [m]"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.pressure[i] = nan; }, "pressure [Pa]"));
    BOOST_TEST(after([i](Frame& f) { f.density[i] = nan; }, "density [kg/m^3]"));
    BOOST_TEST(after([](Frame& f) { f.state.outlet_velocity[0] += 1e-3; }, "state: outlet velocities [m/s]"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.kappa[i] *= 1 + 1e-6; }, "kappa [Pa]"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.drift[i] += 0.1; }, "drift [kg/m^3]"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.kappa[i] = nan; }, "kappa [Pa]"));
    BOOST_TEST(after([i](Frame& f) { f.state.particles.drift[i] = nan; }, "drift [kg/m^3]"));
    BOOST_TEST(
        after([i](Frame& f) { f.solved_pressure[i] = -1e7; }, "solution of (3): pressure >= lowest [Pa]"));
    BOOST_TEST(after([](Frame& f) { f.solved_kappa[last_blood(start())] = -1; },
                     "solution of (3): kappa >= lowest [Pa]"));
    BOOST_TEST(!compare_faulty({{}, [i](Frame& f) { f.solved_pressure[i] = nan; }}).passed());
    BOOST_TEST(!compare_faulty({{}, [i](Frame& f) { f.solved_kappa[i] = nan; }}).passed());
    BOOST_TEST(!compare_faulty({{}, [](Frame& f) { f.state.particles.kind.pop_back(); }}).passed());
}

/// Blood of a buffer was there, but wasn't seen.
BOOST_AUTO_TEST_CASE(lockstep_finds_missing_blood)
{
    const auto blood = static_cast<std::size_t>(std::ranges::find(start().particles.kind, Kind::outlet_1) -
                                                start().particles.kind.begin());
    const Faults faults{[blood](SimulationState& s) { s.particles.kind[blood] = Kind::reserve; },
                        [blood](Frame& f) { f.state.particles.kind[blood] = Kind::outlet_1; }};
    BOOST_TEST(is_red(compare_faulty(faults), "density [kg/m^3]"));
    BOOST_TEST(is_red(compare_faulty(faults), "velocity [m/s]"));
}

namespace
{

void spoil(double& x, double relative, double unit)
{
    x += relative * (std::abs(x) + unit);
}
void spoil(Phase& x, double, double)
{
    x = x == Phase::ruptured ? Phase::growing : Phase::ruptured;
}
void spoil(std::int64_t& x, double, double)
{
    ++x;
}

} // namespace

BOOST_AUTO_TEST_CASE(lockstep_finds_a_fault_in_every_number_of_a_frame)
{
    const FrameRecord unused;
    output::visit_record(unused, [&](std::string_view name, const auto&) {
        const Faults faults{{}, [name](Frame& f) {
                                output::visit_record(f.record, [&](std::string_view column, auto& value) {
                                    if (column == name) {
                                        spoil(value, 0.2, 1e-3);
                                    }
                                });
                            }};
        if (name == "iterations" || name == "corrections") { // of a float candidate they are its own
            BOOST_TEST(is_red(compare_faulty(faults, Precision::double_), name));
        } else {
            BOOST_TEST(!compare_faulty(faults).passed(), name);
        }
    });
}

BOOST_AUTO_TEST_CASE(lockstep_finds_a_fault_in_every_number_of_the_wall)
{
    const AneurysmState unused;
    output::visit_aneurysm(unused, [&](std::string_view name, const auto&) {
        const Faults faults{{}, [name](Frame& f) {
                                output::visit_aneurysm(f.state.aneurysm,
                                                       [&](std::string_view column, auto& value) {
                                                           if (column == name) {
                                                               spoil(value, 1e-5, 1);
                                                           }
                                                       });
                            }};
        BOOST_TEST(is_red(compare_faulty(faults), "state: " + std::string(name)), name);
    });
}
