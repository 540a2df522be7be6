// SPDX-License-Identifier: Apache-2.0
// The optimized backend in the straight domains that verification runs in: every frame against the reference
// in lockstep, and the same bits on any number of threads.
#include "tests/verification/candidates.hpp"
#include "verification/comparison/lockstep.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <string>

using namespace aneurysm;
using namespace aneurysm::test;
using comparison::ComparisonResult;

namespace
{

struct Case {
    std::string name;
    int frames = 0;
};
/// Scenarios verify_*; the duct's blood is exchanged by then.
const Case cases[] = {{"box", 10},  {"channel", 10}, {"slip_channel", 10}, {"womersley_channel", 10},
                      {"tube", 10}, {"duct", 150},   {"pipe", 10}};

Scenario scenario(const std::string& name)
{
    return shipped_scenario("verify_" + name);
}

/// Off the lattice and with waves of velocity that carry blood through all seams.
SimulationState shaken(const Scenario& s)
{
    SimulationState state = reference::Simulation(s).state();
    const Vec3 edges = make_vessel(s).extent();
    std::mt19937_64 bits(5);
    const auto random = [&] { return std::ldexp(static_cast<double>(bits() >> 11U), -52) - 1; };
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        Vec3& x = state.particles.position[i];
        const bool blood = state.particles.kind[i] == Kind::fluid;
        const double across = std::sin(2 * std::numbers::pi * x.y / edges.y);
        const double along = std::sin(2 * std::numbers::pi * x.x / edges.x);
        state.particles.velocity[i] = blood ? Vec3{2 * across, along, -2 * across} : Vec3{};
        const double amplitude = blood ? 0.1 * state.spacing : 0;
        x += amplitude * Vec3{random(), random(), random()};
    }
    return state;
}

comparison::ComparisonResult compare(const Scenario& s, Simulation& candidate, int frames)
{
    return comparison::compare_lockstep(s, candidate, frames, [](const FrameRecord&) { return true; });
}
bool passes(const Scenario& s, const SimulationState& start, Precision precision, int frames)
{
    const auto candidate = backends::make_simulation({Backend::cpu, precision}, s, start);
    return compare(s, *candidate, frames).passed();
}

/// How many particles are somewhere else than their way led without a seam.
std::int64_t through_seams(const SimulationState& before, const SimulationState& after)
{
    std::int64_t count = 0;
    for (std::size_t i = 0; i < before.particles.size(); ++i) {
        const Vec3 way = after.particles.position[i] - before.particles.position[i];
        count += is_free(after.particles.kind[i]) && length(way) > 4 * before.spacing ? 1 : 0;
    }
    return count;
}
/// Whether all blood is within the periodic box.
bool in_box(const SimulationState& state, const Vec3& box)
{
    const auto inside = [](double x, double L) { return L == 0 || (x >= 0 && x < L); };
    return std::ranges::all_of(state.particles.position, [&](const Vec3& x) {
        return inside(x.x, box.x) && inside(x.y, box.y) && inside(x.z, box.z);
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(domains_pass_in_lockstep_from_the_start)
{
    for (const Case& c : cases) {
        BOOST_TEST_CONTEXT(c.name)
        {
            const Scenario s = scenario(c.name);
            const SimulationState start = reference::Simulation(s).state();
            for (const Precision precision : {Precision::double_, Precision::float_}) {
                BOOST_TEST(passes(s, start, precision, c.frames), name_of(precision));
            }
        }
    }
}

/// Two steps a frame, so that errors pass through seams, too.
BOOST_AUTO_TEST_CASE(domains_pass_in_lockstep_when_blood_goes_through_seams)
{
    for (const Case& c : cases) {
        BOOST_TEST_CONTEXT(c.name)
        {
            Scenario s = scenario(c.name);
            s.time.substeps = 2;
            const SimulationState start = shaken(s);
            const Vec3 box = make_vessel(s).period();
            for (const Precision precision : {Precision::double_, Precision::float_}) {
                const auto candidate = backends::make_simulation({Backend::cpu, precision}, s, start);
                BOOST_TEST(compare(s, *candidate, 8).passed(), name_of(precision));
                BOOST_TEST((through_seams(start, candidate->state()) > 0) == (length(box) > 0));
                BOOST_TEST(in_box(candidate->state(), box));
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(domains_have_the_same_bits_on_one_and_two_threads)
{
    for (const Case& c : cases) {
        BOOST_TEST_CONTEXT(c.name)
        {
            const Scenario s = scenario(c.name);
            const SimulationState start = shaken(s);
            for (const Precision precision : {Precision::double_, Precision::float_}) {
                const auto one = backends::make_simulation({Backend::cpu, precision, 1}, s, start);
                const auto two = backends::make_simulation({Backend::cpu, precision, 2}, s, start);
                for (int frame = 0; frame < 8; ++frame) {
                    one->advance();
                    two->advance();
                }
                BOOST_TEST((one->state().particles.position == two->state().particles.position));
                BOOST_TEST((one->state().particles.velocity == two->state().particles.velocity));
                BOOST_TEST((one->state().particles.pressure == two->state().particles.pressure));
            }
        }
    }
}

/// In a longer box all is the same but the pairs through the seam.
BOOST_AUTO_TEST_CASE(lockstep_finds_another_seam)
{
    Scenario right = scenario("box");
    right.particles.count = 9 * 8 * 8;
    Scenario wrong = right;
    wrong.domain.cells_x = 9;
    const SimulationState start = shaken(right);
    Candidate good(right, start, Precision::float_);
    Candidate bad(wrong, start, Precision::float_);
    BOOST_TEST(compare(right, good, 1).passed());
    BOOST_TEST(!compare(right, bad, 1).passed());
}

BOOST_AUTO_TEST_CASE(lockstep_finds_a_wall_that_slips_and_another_swing_of_the_force)
{
    const Scenario right = scenario("womersley_channel");
    const auto finds = [&](auto change) {
        Scenario wrong = right;
        change(wrong);
        Candidate bad(wrong, shaken(right), Precision::double_);
        return !compare(right, bad, 2).passed();
    };
    BOOST_TEST(!finds([](Scenario&) {}));
    BOOST_TEST(finds([](Scenario& s) { s.domain.wall = WallCondition::slip; }));
    BOOST_TEST(finds([](Scenario& s) { s.fluid.gravity_cycle_s *= 1 + 1e-9; }));
}
