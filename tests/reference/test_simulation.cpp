// SPDX-License-Identifier: Apache-2.0
// A run of scenario `quick` from flow to rupture: what must hold in each of its frames.
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

constexpr double fault = 1e-12;

/// The run with a planted fault: change(frame record) for each frame from `first` on.
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

/// After each frame up to rupture no blood is beyond the wall that it was held back by.
bool keeps_blood_inside(const Run& run, double shift)
{
    const Vessel vessel = make_vessel(run.scenario);
    for (std::size_t n = 0; n < run.frames.size() && run.states[n].aneurysm.phase != Phase::ruptured; ++n) {
        const AneurysmState& wall = run.states[n].aneurysm;
        const Particles& p = run.states[n + 1].particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec3 x = p.position[i] + Vec3{shift, 0, 0};
            if (p.kind[i] == Kind::escaped ||
                (p.kind[i] == Kind::fluid &&
                 (vessel.wall(x, wall.radius + wall.displacement).value > distance_rounding ||
                  vessel.openings()[vessel.nearest_tube(x)].beyond(x) > distance_rounding))) {
                return false;
            }
        }
        if (run.frames[n].outside != 0 || run.frames[n].ledger.escaped != 0) {
            return false;
        }
    }
    return true;
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

/// Warm-up as long as asked for, then growing, fully developed once R is the largest, and ruptured from the
/// frame on in which F_b exceeds P_c.
bool passes_its_phases(const Run& run)
{
    const double largest = 0.5 * run.scenario.aneurysm.base_width_radii * run.scenario.vessel.radius_m;
    bool ruptured = false;
    bool good = true;
    for (std::size_t n = 0; n < run.frames.size(); ++n) {
        const FrameRecord& frame = run.frames[n];
        const bool warm = frame.frame <= run.scenario.growth.warm_up_frames;
        ruptured = ruptured || (!warm && frame.impact_force > frame.critical_pressure);
        const Phase expected = ruptured                                   ? Phase::ruptured
                               : warm                                     ? Phase::warm_up
                               : run.states[n].aneurysm.radius >= largest ? Phase::fully_developed
                                                                          : Phase::growing;
        good = good && frame.phase == expected && run.states[n + 1].aneurysm.phase == expected;
    }
    return good;
}

/// (13), (21), (22), (23) and (28) once more, each frame from the one before and the recorded F_b.
bool grows_by_its_equations(const Run& run)
{
    const auto& g = run.scenario.growth;
    const auto& r = run.scenario.rupture;
    const double dt = run.scenario.time.frame_s;
    const double largest = 0.5 * run.scenario.aneurysm.base_width_radii * run.scenario.vessel.radius_m;
    bool good = true;
    for (std::size_t n = 0; n < run.frames.size(); ++n) {
        const FrameRecord& frame = run.frames[n];
        AneurysmState s = run.states[n].aneurysm;
        if (frame.frame > g.warm_up_frames && s.phase != Phase::ruptured) {
            const double F = frame.impact_force;
            const double fibers =
                g.elastin_stiffness_n_m * g.elastin_area_m2 + g.collagen_stiffness_n_m * g.collagen_area_m2;
            const double dR =
                F / (g.wall_mass_kg / dt / dt +
                     g.tissue_density_kg_m3 * g.tissue_area_m2 * g.wave_speed_m_s / dt + fibers / s.radius);
            if (s.radius < largest) {
                const double taken = std::min(dR, largest - s.radius);
                s.thickness *= 1 - r.poisson_ratio * taken / s.radius;
                s.radius += taken;
            } else {
                s.thickness *= 1 - g.thinning_intensity_per_m * std::min(dR, g.largest_increment_m);
            }
            s.wall_velocity += dt / run.scenario.elastic_wall.mass_kg *
                               (F - run.scenario.elastic_wall.stiffness_n_m * s.displacement);
            s.displacement += dt * s.wall_velocity;
        }
        const double P_c = 4 * frame.thickness * r.yield_limit_pa * (2 - r.poisson_ratio) /
                           (3 * frame.radius * r.porosity * (1 + r.poisson_ratio));
        // 16 roundings on either side of a sum or product of positive terms; in (28) F and k u may cancel
        const double force = frame.impact_force + run.scenario.elastic_wall.stiffness_n_m * 1e-2;
        const double u_rounding = dt * dt / run.scenario.elastic_wall.mass_kg * force + 1e-2;
        good = good && within(frame.radius, s.radius, rounding(32) * s.radius) &&
               within(frame.thickness, s.thickness, rounding(32) * s.thickness) &&
               std::abs(s.displacement) < 1e-2 &&
               within(frame.displacement, s.displacement, rounding(32) * u_rounding) &&
               within(frame.critical_pressure, P_c, rounding(32) * P_c) &&
               run.states[n + 1].aneurysm.radius == frame.radius &&
               run.states[n + 1].aneurysm.thickness == frame.thickness;
    }
    return good;
}

/// None before rupture; then it comes out where the breach is,
/// and goes back to the reserve when it is far away.
bool bleeds_through_the_breach(const Run& run)
{
    const Vessel vessel = make_vessel(run.scenario);
    const double far = run.scenario.rupture.recycle_distance_radii * run.scenario.vessel.radius_m;
    bool good = run.frames.back().ledger.escaped > 0;
    for (std::size_t n = 0; n < run.frames.size(); ++n) {
        const AneurysmState& wall = run.states[n].aneurysm;
        const Particles& p = run.states[n + 1].particles;
        const Vec3 dome = vessel.dome(wall.radius + wall.displacement);
        good = good && (wall.phase == Phase::ruptured || run.frames[n].ledger.escaped == 0);
        for (std::size_t i = 0; i < p.size(); ++i) {
            good = good && (p.kind[i] != Kind::escaped || length(p.position[i] - dome) <= far);
        }
    }
    return good;
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

BOOST_AUTO_TEST_CASE(no_blood_is_outside_before_rupture)
{
    BOOST_TEST(keeps_blood_inside(quick_run(), 0));
    BOOST_TEST(!keeps_blood_inside(quick_run(), 1e-12)); // all blood moved aside by so much
}

BOOST_AUTO_TEST_CASE(pressure_solve_ends_within_its_tolerance_unless_it_reports_the_cap)
{
    BOOST_TEST(solves_within_tolerance(quick_run()));
    BOOST_TEST(!solves_within_tolerance(with_fault(
        quick_run(), [](FrameRecord& f) { f.residual_mean += 0.05; }, 30)));
    BOOST_TEST(!solves_within_tolerance(with_fault(
        quick_run(), [](FrameRecord& f) { f.residual_max += 5; }, 30)));
}

BOOST_AUTO_TEST_CASE(phases_follow_one_another)
{
    BOOST_TEST(passes_its_phases(quick_run()));
    BOOST_TEST(quick_run().frames.back().ledger.missed == 0);
    BOOST_TEST_REQUIRE(rupture_of(quick_run()) + 20 < quick_run().frames.size()); // time to bleed
    BOOST_TEST(quick_run().states.back().aneurysm.rupture_frame ==
               static_cast<std::int64_t>(rupture_of(quick_run())));
    Run faulty = quick_run();
    faulty.frames[49].phase = Phase::growing; // a frame too early
    BOOST_TEST(!passes_its_phases(faulty));
    faulty = quick_run();
    faulty.frames[rupture_of(faulty) - 1].critical_pressure *= 2; // it need not have ruptured
    BOOST_TEST(!passes_its_phases(faulty));
    faulty = quick_run();
    faulty.frames[60].impact_force = 1e5; // it should have ruptured
    BOOST_TEST(!passes_its_phases(faulty));
}

BOOST_AUTO_TEST_CASE(eq13_eq21_eq22_eq28_hold_from_frame_to_frame)
{
    BOOST_TEST(grows_by_its_equations(quick_run()));
    Run faulty = quick_run();
    faulty.frames[60].impact_force *= 1 + 1e-8; // dR is 1e-4 of R
    BOOST_TEST(!grows_by_its_equations(faulty));
    faulty = quick_run();
    faulty.frames[60].thickness *= 1 + fault;
    BOOST_TEST(!grows_by_its_equations(faulty));
    faulty = quick_run();
    faulty.frames[60].critical_pressure *= 1 - fault;
    BOOST_TEST(!grows_by_its_equations(faulty));
    faulty = quick_run();
    faulty.frames[60].displacement += fault;
    BOOST_TEST(!grows_by_its_equations(faulty));
}

BOOST_AUTO_TEST_CASE(eq23_holds_once_the_sac_is_fully_developed)
{
    Scenario scenario = shipped_scenario("quick");
    scenario.pressure.max_iterations = 40;
    scenario.growth.warm_up_frames = 15;
    scenario.rupture.yield_limit_pa = 1e6; // never ruptures
    scenario.aneurysm.initial_radius_radii = 0.7999;
    const Run developed = run(scenario, 40);

    BOOST_TEST(passes_its_phases(developed));
    BOOST_TEST(grows_by_its_equations(developed));
    BOOST_TEST((developed.frames.back().phase == Phase::fully_developed));
    BOOST_TEST(developed.frames.back().radius == 0.4);
    BOOST_TEST(!passes_its_phases(with_fault(
        developed, [](FrameRecord& f) { f.phase = Phase::growing; }, 30)));
    BOOST_TEST(!grows_by_its_equations(with_fault(
        developed, [](FrameRecord& f) { f.thickness *= 1 + fault; }, 30)));
}

BOOST_AUTO_TEST_CASE(blood_passes_the_breach_and_is_counted)
{
    const Run& run = quick_run();
    BOOST_TEST(bleeds_through_the_breach(run));
    BOOST_TEST(run.frames.back().ledger.recycled > 0);
    Run faulty = run;
    faulty.frames[rupture_of(run) - 5].ledger.escaped = 1;
    BOOST_TEST(!bleeds_through_the_breach(faulty));
    faulty = run;
    faulty.scenario.rupture.recycle_distance_radii = 0.1;
    BOOST_TEST(!bleeds_through_the_breach(faulty));
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
