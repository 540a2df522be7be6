// SPDX-License-Identifier: Apache-2.0
// Section 3.4 and Table 3: a run starts with exactly the particles that were asked for, all in their places.
#include "output/columns.hpp"
#include "reference/simulation.hpp"
#include "tests/vessels.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>

#include <algorithm>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

/// Scenario `base` with another number of particles.
Scenario scenario_of(std::int64_t count)
{
    Scenario scenario = shipped_scenario("base");
    scenario.particles.count = count;
    return scenario;
}

/// Which open end a particle of this kind is a ghost of; none is 3.
std::size_t end_of(Kind kind)
{
    constexpr std::array ghosts{Kind::inlet, Kind::outlet_1, Kind::outlet_2};
    return static_cast<std::size_t>(std::ranges::find(ghosts, kind) - ghosts.begin());
}

/// As many as asked for, a part of them in reserve; blood inside the wall and between the openings, ghosts
/// behind their own opening; at rest, under the outlets' pressure; nothing counted yet.
bool is_a_start(const Scenario& scenario, const SimulationState& state)
{
    const Vessel vessel = make_vessel(scenario);
    const Particles& p = state.particles;
    const auto lattice = sample_lattice(vessel, state.aneurysm.radius, state.spacing).size();
    bool good = static_cast<std::int64_t>(p.size()) == scenario.particles.count && lattice <= p.size() &&
                p.size() - lattice <= static_cast<std::size_t>(std::ranges::count(p.kind, Kind::reserve)) &&
                state.frame == 0;
    output::visit_ledger(state.ledger, [&](std::string_view, std::int64_t n) { good = good && n == 0; });
    const double depth = opening_layers * state.spacing + distance_rounding;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const std::size_t k = vessel.nearest_tube(p.position[i]);
        const double beyond = vessel.openings()[k].beyond(p.position[i]);
        const bool inside = vessel.wall(p.position[i], state.aneurysm.radius).value <= distance_rounding;
        const bool is_blood = inside && beyond <= 0 && p.pressure[i] == scenario.outlet.pressure_pa;
        const bool is_ghost = end_of(p.kind[i]) == k && beyond > 0 && beyond <= depth;
        good = good && p.velocity[i] == Vec3{} &&
               (p.kind[i] == Kind::reserve || (p.kind[i] == Kind::fluid ? is_blood : is_ghost));
    }
    return good;
}

/// Settling ends when a step with the velocity 0 finds nothing to correct: the mean residual beta excess / dt
/// of (3) is within its tolerance, and so is the largest. beta is 0.25 there.
bool is_settled(const Scenario& scenario, double mean_excess, double largest_excess)
{
    const double per_rate = scenario.time.frame_s / static_cast<double>(scenario.time.substeps) / 0.25;
    // the mean of at most 1e5 terms, and a few roundings of densities around 1
    const double allowed = rounding(1e5) * scenario.pressure.tolerance_per_s * per_rate + rounding(100);
    return mean_excess <= scenario.pressure.tolerance_per_s * per_rate + allowed &&
           largest_excess <= scenario.pressure.max_tolerance_per_s * per_rate + allowed;
}

/// Whether is_a_start() sees a particle too many, one out of its place and two of another kind.
void check_faults(const Scenario& scenario, const SimulationState& start)
{
    Scenario other = scenario;
    ++other.particles.count;
    BOOST_TEST(!is_a_start(other, start));
    const auto first_of = [&](Kind kind) {
        return static_cast<std::size_t>(std::ranges::find(start.particles.kind, kind) -
                                        start.particles.kind.begin());
    };
    SimulationState faulty = start;
    faulty.particles.position[first_of(Kind::fluid)].x = 2 * scenario.vessel.radius_m;
    BOOST_TEST(!is_a_start(scenario, faulty));
    for (const auto& [from, to] : {std::pair{Kind::outlet_1, Kind::outlet_2}, {Kind::reserve, Kind::fluid}}) {
        faulty = start;
        faulty.particles.kind[first_of(from)] = to;
        BOOST_TEST(!is_a_start(scenario, faulty));
    }
}

} // namespace

/// Of Table 3; between two layers of the lattice; and more than fit between the walls.
constexpr std::int64_t too_full = 2200;
const std::int64_t counts[] = {1999, too_full, 5520, 15'456, 40'296};

BOOST_DATA_TEST_CASE(a_run_starts_with_as_many_particles_as_asked_for, counts)
{
    const Scenario scenario = scenario_of(sample);
    reference::Simulation simulation(scenario);
    const SimulationState start = simulation.state();
    const auto in_reserve = static_cast<std::size_t>(std::ranges::count(start.particles.kind, Kind::reserve));
    const auto sampled = sample_lattice(simulation.vessel(), start.aneurysm.radius, start.spacing).size();
    // The first frame reports the density of the start.
    const FrameRecord first = simulation.advance();
    const double mean = first.density_error_mean;
    const double largest = std::max(first.density_error_max, first.density_error_max_ends);

    BOOST_TEST(is_a_start(scenario, start));
    BOOST_TEST(is_settled(scenario, mean, largest));
    if (sample == too_full) { // settling sends the surplus to the reserve
        BOOST_TEST(start.particles.size() - sampled < in_reserve);
    } else { // the settled state is just within its tolerance
        check_faults(scenario, start);
        BOOST_TEST(!is_settled(scenario, 1.02 * mean, largest));
        BOOST_TEST(!is_settled(scenario, mean, largest + 0.02));
    }
}
