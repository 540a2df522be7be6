// SPDX-License-Identifier: Apache-2.0
// Runs of other scenarios than the paper's own: pressure models, kernels, waveforms, shapes, angles, and what
// ends a run or refuses to start it. What a run of scenario `quick` does is checked by the suite: eq25_bookkeeping,
// eq03_iteration_count, restart, and the hashes of its baseline.
#include "common/scenario/limits.hpp"
#include "common/vessel/initial_state.hpp"
#include "output/checkpoint.hpp"
#include "output/frames.hpp"
#include "reference/incompressible.hpp"
#include "reference/simulation.hpp"
#include "tests/files.hpp"
#include "tests/vessels.hpp"

#include <algorithm>
#include <array>
#include <string>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

/// Frames and the state after the last of them.
struct Run {
    Scenario scenario;
    std::vector<FrameRecord> frames;
    SimulationState end;
};

Run run(const Scenario& scenario, reference::Simulation simulation, int frames)
{
    Run result{scenario, {}, {}};
    for (int n = 0; n < frames; ++n) {
        result.frames.push_back(simulation.advance());
    }
    result.end = simulation.state();
    return result;
}

Scenario quick()
{
    return shipped_scenario("quick");
}

/// Its first state. A scenario with the same vessel, kernel and particles can go on from here.
const SimulationState& settled()
{
    static const SimulationState state = reference::Simulation(quick()).state();
    return state;
}

/// What the error says when the scenario is refused; empty when it isn't.
std::string refusal(const Scenario& scenario)
{
    return message_of([&] { const reference::Simulation unused(scenario, settled()); });
}

/// The number of particles stays, none is outside, and all are somewhere.
bool is_sound(const Run& run)
{
    const auto is_good = [&](const FrameRecord& f) {
        return f.total == run.scenario.particles.count && f.outside == 0;
    };
    return std::ranges::all_of(run.frames, is_good) &&
           std::ranges::all_of(run.end.particles.position, is_finite<double>);
}

} // namespace

BOOST_AUTO_TEST_CASE(the_papers_equation_of_state_blows_up_and_leaves_the_last_good_frame)
{
    Scenario scenario = quick();
    scenario.pressure.model = PressureModel::eos;
    scenario.pressure.stiffness_m2_s2 = 1;
    reference::Simulation simulation(scenario, settled());
    SimulationState last = simulation.state();
    std::string message;
    for (int n = 0; n < 400 && message.empty(); ++n) {
        try {
            const FrameRecord frame = simulation.advance();
            BOOST_TEST_REQUIRE(frame.frame == last.frame + 1);
            last = simulation.state();
        } catch (const SimulationError& error) {
            message = error.what();
        }
    }
    BOOST_TEST_MESSAGE(message);

    BOOST_TEST(contains(message, "frame " + std::to_string(last.frame + 1) + ", particle "));
    BOOST_TEST(contains(message, "density"));
    BOOST_TEST(output::state_hash(simulation.state()) == output::state_hash(last));
    BOOST_TEST(last.frame > 0);
}

BOOST_AUTO_TEST_CASE(a_stiff_equation_of_state_holds_the_blood)
{
    Scenario scenario = quick();
    scenario.pressure.model = PressureModel::eos;
    scenario.pressure.stiffness_m2_s2 = 100.0 * 100; // the square of the speed of sound
    scenario.time.substeps = 4;
    const Run stiff = run(scenario, {scenario, settled()}, 100);
    const auto highest = std::ranges::max(stiff.frames, {}, &FrameRecord::density_error_max);
    BOOST_TEST_MESSAGE("largest density error " << highest.density_error_max << " in frame "
                                                << highest.frame);

    BOOST_TEST(is_sound(stiff));
    BOOST_TEST(highest.density_error_max < scenario.pressure.blow_up_density_ratio - 1);
}

BOOST_AUTO_TEST_CASE(wendland_kernel_runs_below_its_own_relaxation_limit)
{
    Scenario scenario = quick();
    scenario.kernel.function = KernelName::wendland_c2;
    const double limit = reference::relaxation_limit(KernelName::wendland_c2, 1);
    BOOST_TEST_MESSAGE("relaxation limit " << limit);
    scenario.pressure.relaxation = 0.7 * limit;

    BOOST_TEST(is_sound(run(scenario, reference::Simulation(scenario), 50)));
}

BOOST_AUTO_TEST_CASE(a_relaxation_at_its_limit_is_refused)
{
    Scenario scenario = quick();
    const double limit = reference::relaxation_limit(KernelName::cubic_spline, 1);
    scenario.pressure.relaxation = limit;
    BOOST_TEST(contains(refusal(scenario), "pressure.relaxation"));
    scenario.pressure.relaxation = limit * (1 - 1e-12);
    BOOST_TEST(refusal(scenario).empty());
    scenario.pressure.relaxation = limit;
    scenario.pressure.model = PressureModel::eos; // which doesn't relax
    BOOST_TEST(refusal(scenario).empty());
}

BOOST_AUTO_TEST_CASE(a_step_above_the_limit_is_refused_with_the_substeps_that_are_enough)
{
    const auto check = [](Scenario scenario) {
        const double limit = step_limits(scenario, settled().spacing).smallest();
        const auto needed = static_cast<std::int64_t>(std::ceil(scenario.time.frame_s / limit));
        BOOST_TEST_REQUIRE(needed > 1);
        scenario.time.substeps = needed - 1;
        const std::string message = refusal(scenario);
        BOOST_TEST(contains(message, "time.substeps: " + std::to_string(needed - 1)));
        BOOST_TEST(contains(message, "at least " + std::to_string(needed)));
        scenario.time.substeps = needed;
        BOOST_TEST(refusal(scenario).empty());
    };
    Scenario fast = quick();
    fast.inlet.peak_velocity_m_s = 60;
    check(fast);
    Scenario viscous = quick();
    viscous.fluid.viscosity_pa_s = 1e4;
    check(viscous);
    Scenario stiff = quick();
    stiff.pressure.model = PressureModel::eos;
    stiff.pressure.stiffness_m2_s2 = 1e6;
    check(stiff);
}

BOOST_AUTO_TEST_CASE(a_checkpoint_holds_all_that_a_run_goes_on_from)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "checkpoint.h5";
    reference::Simulation whole(quick(), settled());
    for (int n = 0; n < 60; ++n) { // long enough for flow and exchange
        whole.advance();
    }
    output::write_checkpoint(file, quick(), whole.state());
    const auto state_after = [&file](auto change) {
        SimulationState state = output::read_checkpoint(file).state;
        change(state.particles);
        reference::Simulation resumed(quick(), std::move(state));
        resumed.advance();
        resumed.advance();
        return output::state_hash(resumed.state());
    };
    whole.advance();
    whole.advance();
    BOOST_TEST(state_after([](Particles&) {}) == output::state_hash(whole.state()));
    const auto cleared = [&](auto field) {
        return state_after([field](Particles& p) { std::ranges::fill(p.*field, 0.0); });
    };
    for (const auto field : {&Particles::pressure, &Particles::kappa, &Particles::drift}) {
        BOOST_TEST(cleared(field) != output::state_hash(whole.state()));
    }
}

BOOST_AUTO_TEST_CASE(blood_comes_in_by_a_parabola)
{
    Scenario scenario = quick();
    scenario.inlet.profile = InletProfile::parabolic;
    scenario.inlet.peak_velocity_m_s = 5;
    const Run parabolic = run(scenario, {scenario, settled()}, 150);
    BOOST_TEST(is_sound(parabolic));
    BOOST_TEST(parabolic.frames.back().ledger.inlet_in > 0);
}

BOOST_AUTO_TEST_CASE(what_never_corrects_the_density_starts_on_the_jittered_lattice)
{
    const auto starts_there = [](const Scenario& scenario) {
        const reference::Simulation simulation(scenario);
        const Lattice lattice =
            sample_lattice(simulation.vessel(), initial_radius(scenario), simulation.state().spacing);
        const Particles sampled =
            initial_state(scenario, lattice, simulation.state().particles.mass).particles;
        return simulation.state().particles.position == sampled.position;
    };
    Scenario scenario = quick();
    BOOST_TEST(!starts_there(scenario));
    scenario.pressure.density_correction = 0;
    BOOST_TEST(starts_there(scenario));
    scenario = quick();
    scenario.pressure.model = PressureModel::eos;
    BOOST_TEST(starts_there(scenario));
}

BOOST_AUTO_TEST_CASE(books_are_kept_through_both_halves_of_the_cycle)
{
    Scenario scenario = quick();
    scenario.rupture.yield_limit_pa = 1e6; // never ruptures
    SimulationState late = settled();
    late.frame = 320; // the inlet turns at 400
    const std::int64_t fluid = std::ranges::count(late.particles.kind, Kind::fluid);
    const Run cycle = run(scenario, {scenario, late}, 290);
    const auto balanced = [&](auto gained) {
        return std::ranges::all_of(cycle.frames,
                                   [&](const FrameRecord& f) { return f.fluid == fluid + gained(f.ledger); });
    };
    const Ledger& half = cycle.frames[79].ledger;
    const FrameRecord& last = cycle.frames.back();
    const Ledger& end = last.ledger;

    BOOST_TEST(is_sound(cycle));
    BOOST_TEST(last.total - last.active == std::ranges::count(cycle.end.particles.kind, Kind::reserve));
    BOOST_TEST(half.inlet_in > 0);
    BOOST_TEST(half.outlet_out > 0);
    BOOST_TEST(end.inlet_out > half.inlet_out);
    BOOST_TEST(end.outlet_in > half.outlet_in);
    BOOST_TEST(
        balanced([](const Ledger& l) { return l.inlet_in - l.inlet_out + l.outlet_in - l.outlet_out; }));
    BOOST_TEST(!balanced([](const Ledger& l) { return l.inlet_in + l.outlet_in - l.outlet_out; }));
    BOOST_TEST(!balanced([](const Ledger& l) { return l.inlet_in - l.inlet_out - l.outlet_out; }));
}

BOOST_AUTO_TEST_CASE(all_shapes_and_angles_start_and_run)
{
    for (const SacWidths& sac : sacs) {
        const Scenario scenario = with_sac(quick(), sac);
        const Run started = run(scenario, reference::Simulation(scenario), 3);
        BOOST_TEST(is_sound(started));
        BOOST_TEST((started.frames.back().critical_pressure > 0) == (sac.shape != SacShape::none));
    }
    for (const double angle : {30.0, 60.0, 75.0}) {
        Scenario scenario = quick();
        scenario.vessel.angle_deg = angle;
        scenario.particles.count = 1999;
        BOOST_TEST(is_sound(run(scenario, reference::Simulation(scenario), 3)));
    }
}

BOOST_AUTO_TEST_CASE(the_soundness_that_is_asked_for_above_can_fail)
{
    Run broken{quick(), {FrameRecord{}}, settled()};
    broken.frames[0].total = broken.scenario.particles.count;
    BOOST_TEST(is_sound(broken));
    broken.frames[0].outside = 1;
    BOOST_TEST(!is_sound(broken));
    broken.frames[0].outside = 0;
    broken.frames[0].total -= 1;
    BOOST_TEST(!is_sound(broken));
    broken.frames[0].total += 1;
    broken.end.particles.position[5].y = std::nan("");
    BOOST_TEST(!is_sound(broken));
}
