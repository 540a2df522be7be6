// SPDX-License-Identifier: Apache-2.0
// Corners of the particle controller that a run seldom sees: an empty reserve, blood at the far end of a buffer, on the
// planes and on the axis of the inlet. What it makes of each particle is checked on every backend by sec34_open_ends,
// and what a run's ledger says by eq25_bookkeeping.
#include "common/vessel/initial_state.hpp"
#include "common/vessel/sampling.hpp"
#include "reference/controller.hpp"
#include "tests/vessels.hpp"

#include <algorithm>
#include <array>
#include <vector>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

constexpr double dx = 0.12;
constexpr double depth = opening_layers * dx;
constexpr std::array buffers{Kind::inlet, Kind::outlet_1, Kind::outlet_2};

/// An artery with its lattice and controller.
struct Artery {
    Scenario scenario;
    Vessel vessel = make_vessel(scenario);
    Lattice lattice = sample_lattice(vessel, vessel.largest_radius(), dx);
    reference::Controller controller{scenario, vessel, dx, lattice.openings};

    explicit Artery(const Scenario& s = shipped_scenario("quick")) : scenario(s) {}

    const Vec3& outward(std::size_t k) const { return vessel.openings()[k].outward; }
    /// A point on the axis of opening k, `beyond` its plane.
    Vec3 at(std::size_t k, double beyond) const { return vessel.openings()[k].center + beyond * outward(k); }
    bool is_far(std::size_t k, const Vec3& x) const
    {
        return vessel.openings()[k].beyond(x) > (opening_layers - 1) * dx;
    }
};

void add(Particles& p, Kind kind, const Vec3& position, const Vec3& velocity = {})
{
    p.position.push_back(position);
    p.velocity.push_back(velocity);
    p.pressure.push_back(7);
    p.kappa.push_back(7);
    p.drift.push_back(7);
    p.kind.push_back(kind);
}

/// The buffers as sampled, all blood in them with the velocity `inward` into the artery, but for `missing` particles of
/// each far layer; and a reserve.
Particles with_gaps(const Artery& artery, std::size_t missing, double inward, std::size_t reserve)
{
    Particles p;
    for (std::size_t k = 0; k < 3; ++k) {
        std::size_t left_out = 0;
        for (const Vec3& x : artery.lattice.openings[k]) {
            if (left_out < missing && artery.is_far(k, x)) {
                ++left_out;
            } else {
                add(p, buffers[k], x, -inward * artery.outward(k));
            }
        }
    }
    for (std::size_t i = 0; i < reserve; ++i) {
        add(p, Kind::reserve, {});
    }
    return p;
}

std::int64_t count(const Particles& p, Kind kind)
{
    return std::ranges::count(p.kind, kind);
}

/// Whether `exchange` fills the gaps, inlet first, as far as the reserve goes, with blood that moves as its buffer
/// does and has no pressure, counts what it couldn't, and touches nothing else.
template <class Exchange>
bool fills_the_gaps(Exchange exchange, std::size_t reserve)
{
    constexpr std::size_t missing = 3;
    constexpr double v = 2;
    const Artery artery;
    const Particles before = with_gaps(artery, missing, v, reserve);
    Particles p = before;
    Ledger ledger;
    exchange(artery.controller, p, v, ledger);
    std::array<std::vector<Vec3>, 3> free = artery.lattice.openings;
    bool good = true;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const std::size_t k =
            static_cast<std::size_t>(std::ranges::find(buffers, p.kind[i]) - buffers.begin());
        if (k == buffers.size()) {
            continue;
        }
        good = good && std::erase(free.at(k), p.position[i]) == 1;
        if (before.kind[i] == Kind::reserve) {
            good = good && p.pressure[i] == 0 && p.kappa[i] == 0 && p.drift[i] == 0 &&
                   distance(p.velocity[i], -v * artery.outward(k)) <=
                       rounding(static_cast<double>(p.size()) + 10) * v;
        } else {
            good = good && p.kind[i] == before.kind[i] && p.position[i] == before.position[i] &&
                   p.velocity[i] == before.velocity[i] && p.pressure[i] == 7;
        }
    }
    const std::size_t missed = 3 * missing - std::min(reserve, 3 * missing);
    return good && free[0].size() == missing - std::min(reserve, missing) &&
           free[0].size() + free[1].size() + free[2].size() == missed &&
           ledger.missed == static_cast<std::int64_t>(missed) &&
           count(p, Kind::reserve) == static_cast<std::int64_t>(reserve + missed) - 9;
}

} // namespace

BOOST_AUTO_TEST_CASE(far_layers_are_filled_as_far_as_the_reserve_goes)
{
    const auto exchange = [](const auto& controller, Particles& p, double v, Ledger& l) {
        controller.exchange(p, v, l);
    };
    const auto uncounted = [](const auto& controller, Particles& p, double v, Ledger&) {
        Ledger ignored;
        controller.exchange(p, v, ignored);
    };
    const auto with_pressure = [](const auto& controller, Particles& p, double v, Ledger& l) {
        controller.exchange(p, v, l);
        std::ranges::fill(p.pressure, 7);
    };
    for (const std::size_t reserve : {12U, 9U, 4U, 0U}) {
        BOOST_TEST(fills_the_gaps(exchange, reserve));
        BOOST_TEST(fills_the_gaps(uncounted, reserve) == (reserve >= 9));
        BOOST_TEST(fills_the_gaps(with_pressure, reserve) == (reserve == 0));
    }
}

BOOST_AUTO_TEST_CASE(nothing_is_filled_where_a_buffer_moves_outwards_or_blood_is_near)
{
    const Artery artery;
    const auto filled = [&](Particles p, double v_inlet) {
        Ledger ledger;
        const auto reserve = count(p, Kind::reserve);
        artery.controller.exchange(p, v_inlet, ledger);
        return reserve - count(p, Kind::reserve);
    };
    BOOST_TEST(filled(with_gaps(artery, 3, 2, 20), 2) == 9);
    BOOST_TEST(filled(with_gaps(artery, 3, -2, 20), -2) == 0);
    BOOST_TEST(filled(with_gaps(artery, 3, -2, 20), 2) == 3); // the inlet alone moves inwards
    BOOST_TEST(filled(with_gaps(artery, 3, 0, 20), 0) == 9);  // at rest is not outwards
    const double refill = artery.scenario.controller.refill_distance_spacings;
    for (const double away : {0.99 * refill, 1.01 * refill}) {
        // blood of the buffer beside the one place that is free; other neighbors are a whole spacing away
        Particles p = with_gaps(artery, 0, 2, 5);
        const auto far = static_cast<std::size_t>(
            std::ranges::find_if(p.position, [&](const Vec3& x) { return artery.is_far(1, x); }) -
            p.position.begin());
        p.position[far] += away * dx * -artery.outward(1);
        BOOST_TEST(filled(p, 2) == (away < refill ? 0 : 1));
    }
}

BOOST_AUTO_TEST_CASE(blood_changes_hands_on_the_planes_and_leaves_at_the_far_end)
{
    const Artery artery;
    for (const std::size_t k : {0U, 1U, 2U}) {
        Particles p;
        add(p, buffers[k], artery.at(k, -0.01));         // inwards
        add(p, Kind::fluid, artery.at(k, 0.01));         // outwards
        add(p, buffers[k], artery.at(k, depth + 0.001)); // out at the far end
        add(p, buffers[k], artery.at(k, depth - 0.001), artery.outward(k));
        add(p, Kind::escaped, artery.at(k, 0.01)); // not the ends'
        for (const std::size_t other : {1U, 2U}) { // all buffers move outwards, so that none is filled
            add(p, buffers[other], artery.at(other, 0.5 * depth), 2.0 * artery.outward(other));
        }
        Ledger ledger;

        artery.controller.exchange(p, -1, ledger);

        const std::vector expected{Kind::fluid,   buffers[k],     Kind::reserve, buffers[k],
                                   Kind::escaped, Kind::outlet_1, Kind::outlet_2};
        BOOST_TEST((p.kind == expected));
        const auto here = [&](bool at_inlet) { return (k == 0) == at_inlet ? 1 : 0; };
        BOOST_TEST(ledger.inlet_in == here(true));
        BOOST_TEST(ledger.inlet_out == here(true));
        BOOST_TEST(ledger.outlet_in == here(false));
        BOOST_TEST(ledger.outlet_out == here(false));
        BOOST_TEST(ledger.recycled == 1);
        BOOST_TEST(ledger.missed == 0);
        // a driven particle has no pressure of its own before it is free
        BOOST_TEST(p.pressure[0] == (k == 0 ? unset_pressure : 7));
    }
}

BOOST_AUTO_TEST_CASE(an_empty_buffer_is_filled_by_its_whole_far_layer)
{
    const Artery artery;
    Particles p;
    for (std::size_t i = 0; i < 1000; ++i) {
        add(p, Kind::reserve, {});
    }
    Ledger ledger;

    artery.controller.exchange(p, 1, ledger);

    for (const std::size_t k : {0U, 1U, 2U}) {
        BOOST_TEST(artery.controller.buffer_velocity(p, k) == (k == 0 ? -1 : 0));
        BOOST_TEST(count(p, buffers[k]) ==
                   std::ranges::count_if(artery.lattice.openings[k],
                                         [&](const Vec3& x) { return artery.is_far(k, x); }));
    }
    BOOST_TEST(ledger.missed == 0);
}

namespace
{

/// Velocities into the artery of blood at these parts of the radius from the inlet's axis, over (25).
std::vector<double> profile_at(InletProfile profile, const std::vector<double>& parts)
{
    constexpr double v_inlet = 3;
    Scenario scenario = shipped_scenario("quick");
    scenario.inlet.profile = profile;
    const Artery artery(scenario);
    Particles p;
    for (const double part : parts) {
        add(p, Kind::inlet, artery.at(0, 0.1) + Vec3{part * artery.vessel.openings()[0].radius, 0, 0});
    }
    artery.controller.drive_inlet(p, v_inlet);
    std::vector<double> found;
    for (const Vec3& v : p.velocity) {
        found.push_back(dot(v, -artery.outward(0)) / v_inlet);
    }
    return found;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_inlet_moves_as_a_plug_or_a_parabola_of_the_same_mean)
{
    const std::vector<double> parts{0, 0.5, 1, 1.1};
    BOOST_TEST(profile_at(InletProfile::plug, parts) == std::vector<double>(4, 1));
    BOOST_TEST(profile_at(InletProfile::parabolic, parts) == (std::vector<double>{2, 1.5, 0, 0}));
}
