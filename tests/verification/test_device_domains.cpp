// SPDX-License-Identifier: Apache-2.0
// The optimized backend in the straight domains that verification runs in: every frame against the reference
// in lockstep, and the same bits on any number of threads.
#include "output/frames.hpp"
#include "tests/verification/candidates.hpp"

#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>

#include <numbers>

using namespace aneurysm;
using namespace aneurysm::test;
namespace data = boost::unit_test::data;
BOOST_TEST_DONT_PRINT_LOG_VALUE(aneurysm::Precision)

namespace
{

/// Scenarios verify_*.
const char* const domains[] = {"box", "channel", "slip_channel", "womersley_channel", "tube", "duct", "pipe"};
constexpr Precision precisions[] = {Precision::double_, Precision::float_};

Scenario scenario(const std::string& name)
{
    return shipped_scenario("verify_" + name);
}

/// Off the lattice and with waves of velocity that carry blood through all seams.
SimulationState shaken(const Scenario& s)
{
    SimulationState state = reference::Simulation(s).state();
    const Vec3 edges = make_vessel(s).extent();
    Random random(5);
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        Vec3& x = state.particles.position[i];
        const bool blood = state.particles.kind[i] == Kind::fluid;
        const double across = std::sin(2 * std::numbers::pi * x.y / edges.y);
        const double along = std::sin(2 * std::numbers::pi * x.x / edges.x);
        state.particles.velocity[i] = blood ? Vec3{2 * across, along, -2 * across} : Vec3{};
        x += random.point(blood ? 0.1 * state.spacing : 0);
    }
    return state;
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

/// Two steps a frame, so that errors pass through seams, too.
BOOST_DATA_TEST_CASE(domains_pass_in_lockstep_and_on_two_threads_when_blood_goes_through_seams,
                     data::make(domains) * data::make(precisions), domain, precision)
{
    Scenario s = scenario(domain);
    s.time.substeps = 2;
    const SimulationState start = shaken(s);
    const Vec3 box = make_vessel(s).period();
    const auto one = backends::make_simulation({Backend::cpu, precision, 1}, s, start);
    const auto two = backends::make_simulation({Backend::cpu, precision, 2}, s, start);
    constexpr int frames = 8;
    for (int frame = 0; frame < frames; ++frame) {
        two->advance();
    }

    BOOST_TEST(lockstep(s, *one, frames).passed());
    BOOST_TEST((through_seams(start, one->state()) > 0) == (length(box) > 0));
    BOOST_TEST(in_box(one->state(), box));
    BOOST_TEST(output::state_hash(one->state()) == output::state_hash(two->state()));
}

/// The duct's blood is exchanged by then; the other domains' first frames lockstep_domains checks.
BOOST_DATA_TEST_CASE(a_duct_passes_in_lockstep_from_the_start, data::make(precisions), precision)
{
    const Scenario s = scenario("duct");
    const auto candidate =
        backends::make_simulation({Backend::cpu, precision}, s, reference::Simulation(s).state());
    BOOST_TEST(lockstep(s, *candidate, 150).passed());
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
    BOOST_TEST(lockstep(right, good, 1).passed());
    BOOST_TEST(!lockstep(right, bad, 1).passed());
}

BOOST_AUTO_TEST_CASE(lockstep_finds_a_wall_that_slips_and_another_swing_of_the_force)
{
    const Scenario right = scenario("womersley_channel");
    const auto finds = [&](auto change) {
        Scenario wrong = right;
        change(wrong);
        Candidate bad(wrong, shaken(right), Precision::double_);
        return !lockstep(right, bad, 2).passed();
    };
    BOOST_TEST(!finds([](Scenario&) {}));
    BOOST_TEST(finds([](Scenario& s) { s.domain.wall = WallCondition::slip; }));
    BOOST_TEST(finds([](Scenario& s) { s.fluid.gravity_cycle_s *= 1 + 1e-9; }));
}
