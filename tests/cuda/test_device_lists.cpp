// SPDX-License-Identifier: Apache-2.0
// The optimized backend's lists of neighbors, which grow when a frame needs more room.
#include "common/scenario/shipped.hpp"
#include "common/vessel/geometry.hpp"
#include "common/vessel/sampling.hpp"
#include "cuda/bifurcation.hpp"
#include "cuda/simulation.hpp"

#include <boost/test/unit_test.hpp>

#include <utility>

using namespace aneurysm;

namespace
{

Scenario two_steps()
{
    Scenario scenario = shipped_scenario("quick");
    scenario.particles.count = 700;
    scenario.time.substeps = 2;
    return scenario;
}

std::unique_ptr<Simulation> simulate(const SimulationState& state, int list_blocks)
{
    device::Tuning tuning;
    tuning.list_blocks = list_blocks;
    return device::make_cpu_simulation(two_steps(), Precision::double_, tuning, state);
}

SimulationState settled()
{
    return device::make_cpu_simulation(two_steps(), Precision::double_, {}, {})->state();
}

/// The reserve starts beyond the far end of the first outlet's buffer: it has neighbors in the first step, and is in the
/// reserve again in the second.
SimulationState with_blood_beyond_an_outlet()
{
    SimulationState state = settled();
    const Scenario scenario = two_steps();
    const Vessel vessel(scenario, device::daughter_radius(scenario.vessel.radius_m));
    const Vec3 beyond = (opening_layers + 0.5) * state.spacing * vessel.openings()[1].outward;
    Particles& p = state.particles;
    std::size_t next = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] != Kind::outlet_1) {
            continue;
        }
        while (next < p.size() && p.kind[next] != Kind::reserve) {
            ++next;
        }
        if (next == p.size()) {
            break;
        }
        p.kind[next] = Kind::fluid; // not to be copied itself
        p.position[next] = p.position[i] + beyond;
    }
    for (std::size_t i = 0; i < p.size(); ++i) {
        const bool is_beyond = vessel.openings()[1].beyond(p.position[i]) > opening_layers * state.spacing;
        p.kind[i] = p.kind[i] == Kind::fluid && is_beyond ? Kind::outlet_1 : p.kind[i];
    }
    return state;
}

/// Places in the lists of blood, at most in one step of the first frame.
std::int64_t wanted(const SimulationState& state)
{
    const auto simulation = simulate(state, 0);
    simulation->advance();
    return simulation->pairs().first;
}

} // namespace

BOOST_AUTO_TEST_CASE(lists_that_start_too_short_give_the_same_bits)
{
    const SimulationState start = settled();
    const auto enough = simulate(start, 0);
    const auto short_of = simulate(start, 1);
    for (int frame = 0; frame < 2; ++frame) {
        enough->advance();
        short_of->advance();
        BOOST_TEST((enough->state().particles.position == short_of->state().particles.position));
    }
    BOOST_TEST(enough->pairs().first == short_of->pairs().first);
}

/// A step that finds its lists too short is followed by one for which they are long enough.
BOOST_AUTO_TEST_CASE(lists_have_room_for_the_longest_of_a_frames_steps)
{
    const SimulationState start = with_blood_beyond_an_outlet();
    const std::int64_t longest = wanted(start);
    const std::int64_t later = wanted(settled());
    BOOST_TEST(later < longest);
    const auto simulation = simulate(start, static_cast<int>((longest + later) / 2 / 8));
    BOOST_TEST(simulation->advance().frame == 1);
    BOOST_TEST(simulation->pairs().first == longest);
}
