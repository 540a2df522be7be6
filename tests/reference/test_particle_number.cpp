// SPDX-License-Identifier: Apache-2.0
// Section 3.4 and Table 3: a run starts with exactly the particles that were asked for, all in their places.
#include "reference/simulation.hpp"
#include "tests/runs.hpp"
#include "tests/support.hpp"
#include "tests/vessels.hpp"

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

/// As many as asked for, a part of them in reserve; blood inside the wall and between the openings, ghosts
/// behind their own opening; at rest, under the outlets' pressure; nothing counted yet.
bool is_a_start(const Scenario& scenario, const SimulationState& state)
{
    const Vessel vessel = make_vessel(scenario);
    const Particles& p = state.particles;
    const auto lattice = sample_lattice(vessel, state.aneurysm.radius, state.spacing).size();
    bool good = static_cast<std::int64_t>(p.size()) == scenario.particles.count && lattice <= p.size() &&
                p.size() - lattice <= static_cast<std::size_t>(std::ranges::count(p.kind, Kind::reserve)) &&
                entries(state.ledger) == std::array<std::int64_t, 7>{} && state.frame == 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const std::size_t k = vessel.nearest_tube(p.position[i]);
        const double beyond = vessel.openings()[k].beyond(p.position[i]);
        const bool inside = vessel.wall(p.position[i], state.aneurysm.radius).value <= distance_rounding;
        const double depth = opening_layers * state.spacing + distance_rounding;
        switch (p.kind[i]) {
        case Kind::fluid:
            good = good && inside && beyond <= 0 && p.pressure[i] == scenario.outlet.pressure_pa;
            break;
        case Kind::inlet:
            good = good && k == 0 && beyond > 0 && beyond <= depth;
            break;
        case Kind::outlet_1:
            good = good && k == 1 && beyond > 0 && beyond <= depth;
            break;
        case Kind::outlet_2:
            good = good && k == 2 && beyond > 0 && beyond <= depth;
            break;
        case Kind::escaped:
            return false;
        case Kind::reserve:
            break;
        }
        good = good && p.velocity[i] == Vec3{};
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

/// The first frame reports the density of the start.
void check_density(const Scenario& scenario, reference::Simulation& simulation)
{
    const auto reserve = std::ranges::count(simulation.state().particles.kind, Kind::reserve);
    const FrameRecord first = simulation.advance();
    const double mean = first.density_error_mean;
    const double largest = std::max(first.density_error_max, first.density_error_max_ends);
    BOOST_TEST_MESSAGE(scenario.particles.count
                       << " particles, " << reserve << " in reserve, spacing " << simulation.state().spacing
                       << ", excess density " << mean << " on average, " << largest
                       << " at most, first frame: " << first.iterations << " iterations, largest speed "
                       << first.speed_max << ", F_b " << first.impact_force << ", P_c "
                       << first.critical_pressure);

    BOOST_TEST(is_settled(scenario, mean, largest));
    BOOST_TEST(!is_settled(scenario, 1.02 * mean, largest)); // the settled state is just within its tolerance
    BOOST_TEST(!is_settled(scenario, mean, largest + 0.02));
}

void check_start(const Scenario& scenario)
{
    reference::Simulation simulation(scenario);
    const SimulationState start = simulation.state();
    BOOST_TEST(is_a_start(scenario, start));
    check_density(scenario, simulation);

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
    faulty = start;
    faulty.particles.kind[first_of(Kind::outlet_1)] = Kind::outlet_2;
    BOOST_TEST(!is_a_start(scenario, faulty));
    faulty = start;
    faulty.particles.kind[first_of(Kind::reserve)] = Kind::fluid;
    BOOST_TEST(!is_a_start(scenario, faulty));
}

} // namespace

BOOST_AUTO_TEST_CASE(any_other_number)
{
    check_start(scenario_of(1999)); // between two layers of the lattice
}

// Its lattice holds more than fits between the walls: settling sends the surplus to the reserve.
BOOST_AUTO_TEST_CASE(too_full_a_lattice)
{
    const Scenario scenario = scenario_of(2200);
    reference::Simulation simulation(scenario);
    const SimulationState start = simulation.state();
    const FrameRecord first = simulation.advance();
    const double largest = std::max(first.density_error_max, first.density_error_max_ends);
    const auto sampled = sample_lattice(simulation.vessel(), start.aneurysm.radius, start.spacing).size();

    BOOST_TEST(is_a_start(scenario, start));
    BOOST_TEST(is_settled(scenario, first.density_error_mean, largest));
    BOOST_TEST(start.particles.size() - sampled <
               static_cast<std::size_t>(std::ranges::count(start.particles.kind, Kind::reserve)));
}

BOOST_AUTO_TEST_CASE(table_3_tc1)
{
    check_start(scenario_of(5520));
}

BOOST_AUTO_TEST_CASE(table_3_tc2)
{
    check_start(scenario_of(15'456));
}

BOOST_AUTO_TEST_CASE(table_3_tc4)
{
    Scenario scenario = scenario_of(40'296);
    check_start(scenario);
}
