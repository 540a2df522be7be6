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

/// Which open end a particle of this kind is in the buffer of; none is 3.
std::size_t end_of(Kind kind)
{
    constexpr std::array buffers{Kind::inlet, Kind::outlet_1, Kind::outlet_2};
    return static_cast<std::size_t>(std::ranges::find(buffers, kind) - buffers.begin());
}

/// As many as asked for, of each kind as many as the lattice has, the others in reserve; blood inside the wall, that of
/// a buffer in its tube; at rest, without a pressure; nothing counted yet. Settling may have moved it across a plane.
bool is_a_start(const Scenario& scenario, const SimulationState& state)
{
    const Vessel vessel = make_vessel(scenario);
    const Particles& p = state.particles;
    const Lattice lattice = sample_lattice(vessel, state.aneurysm.radius, state.spacing);
    const auto are = [&](Kind kind, std::size_t expected) {
        return static_cast<std::size_t>(std::ranges::count(p.kind, kind)) == expected;
    };
    bool good = static_cast<std::int64_t>(p.size()) == scenario.particles.count && state.frame == 0 &&
                are(Kind::fluid, lattice.fluid.size()) && are(Kind::inlet, lattice.openings[0].size()) &&
                are(Kind::outlet_1, lattice.openings[1].size()) &&
                are(Kind::outlet_2, lattice.openings[2].size()) &&
                are(Kind::reserve, p.size() - lattice.size());
    output::visit_ledger(state.ledger, [&](std::string_view, std::int64_t n) { good = good && n == 0; });
    for (std::size_t i = 0; i < p.size(); ++i) {
        const std::size_t k = vessel.nearest_tube(p.position[i]);
        const double outside = vessel.wall(p.position[i], state.aneurysm.radius).value;
        const bool is_blood = outside <= distance_rounding || !vessel.between_openings(p.position[i]);
        good = good && p.velocity[i] == Vec3{} && p.pressure[i] == 0 && p.kappa[i] == 0 && p.drift[i] == 0 &&
               (p.kind[i] == Kind::reserve || (p.kind[i] == Kind::fluid ? is_blood : end_of(p.kind[i]) == k));
    }
    return good;
}

/// Settling ends when a round finds nothing to correct: the mean residual beta (rho / rho_0 - 1) / dt of all blood is
/// within its tolerance, and so is the largest. Here only the excess of density is looked at, which always counts.
bool is_settled(const Scenario& scenario, const SimulationState& start, const std::vector<double>& density)
{
    const double rate = scenario.settling.density_correction * static_cast<double>(scenario.time.substeps) /
                        scenario.time.frame_s;
    double sum = 0;
    double largest = 0;
    double count = 0;
    for (std::size_t i = 0; i < density.size(); ++i) {
        if (start.particles.kind[i] != Kind::reserve) {
            const double excess = std::max(0.0, density[i] / scenario.fluid.density_kg_m3 - 1);
            sum += excess;
            largest = std::max(largest, excess);
            ++count;
        }
    }
    // the mean of at most 1e5 terms, and a few roundings of densities around 1
    const double mean_allowed = scenario.pressure.correction_tolerance_per_s * (1 + rounding(1e5));
    return rate * sum / count <= mean_allowed + rate * rounding(100) &&
           rate * largest <= scenario.pressure.correction_max_tolerance_per_s + rate * rounding(100);
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
    faulty.particles.position[first_of(Kind::fluid)] =
        scenario.vessel.radius_m * Vec3{2, -1, 0}; // beside the parent
    BOOST_TEST(!is_a_start(scenario, faulty));
    for (const auto& [from, to] : {std::pair{Kind::outlet_1, Kind::outlet_2}, {Kind::reserve, Kind::fluid}}) {
        faulty = start;
        faulty.particles.kind[first_of(from)] = to;
        BOOST_TEST(!is_a_start(scenario, faulty));
    }
}

} // namespace

/// Of Table 3; between two layers of the lattice; and more than fit between the walls.
const std::int64_t counts[] = {1999, 2200, 5520, 15'456, 40'296};

BOOST_DATA_TEST_CASE(a_run_starts_with_as_many_particles_as_asked_for, counts)
{
    const Scenario scenario = scenario_of(sample);
    reference::Simulation simulation(scenario);
    const SimulationState start = simulation.state();
    simulation.advance(); // computes the density of the start

    BOOST_TEST(is_a_start(scenario, start));
    check_faults(scenario, start);
    BOOST_TEST(is_settled(scenario, start, simulation.density()));

    const auto with_excess = [&](std::size_t from, std::size_t to, double per_second) {
        std::vector<double> density = simulation.density();
        const double excess = per_second * scenario.time.frame_s / scenario.settling.density_correction;
        std::fill(density.begin() + static_cast<std::ptrdiff_t>(from),
                  density.begin() + static_cast<std::ptrdiff_t>(to),
                  scenario.fluid.density_kg_m3 * (1 + excess));
        return density;
    };
    const auto& pressure = scenario.pressure;
    const std::size_t all = simulation.density().size();
    BOOST_TEST(is_settled(scenario, start, with_excess(0, all, 0.99 * pressure.correction_tolerance_per_s)));
    BOOST_TEST(!is_settled(scenario, start, with_excess(0, all, 1.01 * pressure.correction_tolerance_per_s)));
    BOOST_TEST(
        !is_settled(scenario, start, with_excess(0, 1, 1.01 * pressure.correction_max_tolerance_per_s)));
}
