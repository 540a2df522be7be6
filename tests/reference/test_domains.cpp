// SPDX-License-Identifier: Apache-2.0
// The straight domains that verification runs in: their lattices, walls and seams.
#include "common/vessel/initial_state.hpp"
#include "reference/simulation.hpp"
#include "tests/vessels.hpp"

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

Scenario scenario(const std::string& name)
{
    return shipped_scenario("verify_" + name);
}

std::int64_t count(const SimulationState& state, Kind kind)
{
    return std::ranges::count(state.particles.kind, kind);
}

} // namespace

BOOST_AUTO_TEST_CASE(lattices_fill_their_domains)
{
    const auto fluid = [](const std::string& name) {
        return count(reference::Simulation(scenario(name)).state(), Kind::fluid);
    };
    BOOST_TEST(fluid("box") == 8 * 8 * 8);
    BOOST_TEST(fluid("channel") == 6 * 16 * 6);
    int in_circle = 0; // lattice points more than 0.08 spacings inside a circle of radius 8
    for (int i = -8; i < 8; ++i) {
        for (int k = -8; k < 8; ++k) {
            in_circle += std::hypot(i + 0.5, k + 0.5) < 8 - 0.08 ? 1 : 0;
        }
    }
    BOOST_TEST(fluid("tube") == 6 * in_circle);
    const SimulationState duct = reference::Simulation(scenario("duct")).state();
    BOOST_TEST(count(duct, Kind::inlet) == 3 * 6 * 6);
    BOOST_TEST(count(duct, Kind::outlet_1) == 3 * 6 * 6);
    BOOST_TEST(count(duct, Kind::outlet_2) == 0);
}

BOOST_AUTO_TEST_CASE(walls_stand_where_the_cells_end)
{
    const Scenario s = scenario("channel");
    const Vessel channel(s, 0.1);
    const double H = 16 * s.domain.spacing_m;
    BOOST_TEST(channel.wall({0.3, 0.25 * H, 7}, 0).value == -0.25 * H);
    BOOST_TEST(channel.wall({0.3, 0.875 * H, 7}, 0).value == -0.125 * H);
    BOOST_TEST(channel.wall({0.3, 1.25 * H, 7}, 0).value == 0.25 * H);
    BOOST_TEST(channel.wall({0.3, 1.25 * H, 7}, 0).gradient.y == 1);
    BOOST_TEST(channel.wall({0.3, -0.25 * H, 7}, 0).gradient.y == -1);
    const Vessel tube(scenario("tube"), 0.1);
    BOOST_TEST(tube.wall({0.3, 123, 0.4}, 0).value == 0.5 - 8 * s.domain.spacing_m);
    BOOST_TEST(Vessel(scenario("box"), 0.1).wall({0, 0, 0}, 0).value < -1);
}

BOOST_AUTO_TEST_CASE(places_return_through_the_seams)
{
    const Vessel channel(scenario("channel"), 0.1);
    const Vec3 edge = channel.extent();
    const Vec3 inside = channel.wrapped({-0.25 * edge.x, -0.25 * edge.y, 1.25 * edge.z});
    BOOST_TEST(inside.x == 0.75 * edge.x);
    BOOST_TEST(inside.y == -0.25 * edge.y); // a wall is no seam
    BOOST_TEST(inside.z == 0.25 * edge.z);
}

BOOST_AUTO_TEST_CASE(uniform_motion_carries_the_lattice_through_the_seams)
{
    const Scenario s = scenario("box");
    SimulationState state = reference::Simulation(s).state();
    const Vec3 v{2, -1, 0.5}; // multiples of a power of two: a lattice that moves stays exact
    std::ranges::fill(state.particles.velocity, v);
    const SimulationState start = state;
    reference::Simulation box(s, std::move(state));
    const Vec3 edge = Vessel(s, 0.1).extent();
    for (int frame = 1; frame <= 100; ++frame) {
        BOOST_TEST(box.advance().density_error_max < 1e-12);
    }
    const auto moved = [&](double x, double way, double L) {
        return x + way - L * std::floor((x + way) / L);
    };
    for (std::size_t i = 0; i < start.particles.size(); ++i) {
        const Vec3& x = start.particles.position[i];
        const Vec3 expected{moved(x.x, 0.2, edge.x), moved(x.y, -0.1, edge.y), moved(x.z, 0.05, edge.z)};
        const Vec3 d = box.state().particles.position[i] - expected;
        // 100 additions of numbers below the edge
        BOOST_REQUIRE(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) < 100 * 0x1p-53 * edge.x);
    }
}

BOOST_AUTO_TEST_CASE(fewer_particles_than_cells_are_refused)
{
    Scenario few = scenario("channel");
    few.particles.count = 575;
    BOOST_CHECK_THROW(reference::Simulation{few}, InputError);
}
