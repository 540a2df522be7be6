// SPDX-License-Identifier: Apache-2.0
// A run of scenario `quick` from flow to rupture: its books, its tolerance, its bits. What its wall and its blood do is
// checked by the suite: eq21_history, eq23_history, fig1_containment, fig1_breach.
#include "reference/simulation.hpp"
#include "tests/runs.hpp"
#include "tests/support.hpp"
#include "tests/vessels.hpp"

#include <algorithm>
#include <vector>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

/// The run with a mutant: change(frame record) for each frame from `first` on.
template <class Change>
Run with_fault(Run faulty, Change change, std::size_t first = 0)
{
    std::for_each(faulty.frames.begin() + static_cast<std::ptrdiff_t>(first), faulty.frames.end(), change);
    return faulty;
}

std::int64_t blood_gained(const Ledger& l)
{
    return l.inlet_in - l.inlet_out + l.outlet_in - l.outlet_out - l.escaped;
}

bool keeps_its_books(const Run& run)
{
    std::int64_t fluid = std::ranges::count(run.states[0].particles.kind, Kind::fluid);
    Ledger before = run.states[0].ledger;
    bool good = true;
    for (std::size_t n = 0; n < run.frames.size(); ++n) {
        const FrameRecord& frame = run.frames[n];
        const std::vector<Kind>& kinds = run.states[n + 1].particles.kind;
        good = good && frame.frame == static_cast<std::int64_t>(n) + 1 &&
               frame.total == run.scenario.particles.count &&
               frame.total - frame.active == std::ranges::count(kinds, Kind::reserve) &&
               frame.fluid == std::ranges::count(kinds, Kind::fluid) &&
               frame.fluid - fluid == blood_gained(frame.ledger) - blood_gained(before);
        fluid = frame.fluid;
        before = frame.ledger;
    }
    return good;
}

bool solves_within_tolerance(const Run& run)
{
    const auto& pressure = run.scenario.pressure;
    return std::ranges::all_of(run.frames, [&](const FrameRecord& frame) {
        return frame.iterations >= pressure.max_iterations ||
               (frame.residual_mean <= pressure.tolerance_per_s &&
                frame.residual_max <= pressure.max_tolerance_per_s);
    });
}

/// The frame of rupture, from 1.
std::size_t rupture_of(const Run& run)
{
    const auto first = std::ranges::find(run.frames, Phase::ruptured, &FrameRecord::phase);
    return static_cast<std::size_t>(first - run.frames.begin()) + 1;
}

} // namespace

BOOST_AUTO_TEST_CASE(every_frame_keeps_its_books)
{
    BOOST_TEST(keeps_its_books(quick_run()));
    BOOST_TEST(!keeps_its_books(with_fault(
        quick_run(), [](FrameRecord& f) { ++f.total; }, 80)));
    BOOST_TEST(!keeps_its_books(with_fault(
        quick_run(), [](FrameRecord& f) { --f.active; }, 80)));
    BOOST_TEST(!keeps_its_books(with_fault(
        quick_run(), [](FrameRecord& f) { ++f.ledger.inlet_in; }, 80)));
    BOOST_TEST(!keeps_its_books(with_fault(
        quick_run(), [](FrameRecord& f) { ++f.fluid; }, 80)));
}

BOOST_AUTO_TEST_CASE(pressure_solve_ends_within_its_tolerance_unless_it_reports_the_cap)
{
    BOOST_TEST(solves_within_tolerance(quick_run()));
    BOOST_TEST(!solves_within_tolerance(with_fault(
        quick_run(), [](FrameRecord& f) { f.residual_mean += 0.05; }, 30)));
    BOOST_TEST(!solves_within_tolerance(with_fault(
        quick_run(), [](FrameRecord& f) { f.residual_max += 5; }, 30)));
}

BOOST_AUTO_TEST_CASE(a_run_gives_the_same_bits_again_and_from_any_frame_on)
{
    const Run& first = quick_run();
    reference::Simulation again(first.scenario);
    BOOST_TEST(same_bits(again.state(), first.states[0]));
    for (const std::size_t start : {std::size_t{0}, std::size_t{40}, rupture_of(first) - 2}) {
        reference::Simulation resumed(first.scenario, first.states[start]);
        const Run second = run(first.scenario, resumed, 6);
        for (std::size_t n = 0; n < second.states.size(); ++n) {
            BOOST_TEST(same_bits(second.states[n], first.states[start + n]));
        }
    }
    SimulationState other = first.states[40];
    other.particles.velocity[17].x = std::nextafter(first.states[40].particles.velocity[17].x, 1e9);
    BOOST_TEST(!same_bits(other, first.states[40]));
}
