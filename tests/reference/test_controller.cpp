// SPDX-License-Identifier: Apache-2.0
// Corners of the particle controller that a run seldom sees: an empty reserve, motion across an end's axis, and what
// isn't an end's own. What it makes of each particle is checked on every backend by sec34_open_ends, and what a run's
// ledger says by eq25_bookkeeping.
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
constexpr std::array ghosts{Kind::inlet, Kind::outlet_1, Kind::outlet_2};

/// An artery with its lattice and controller.
struct Artery {
    Vessel vessel = make_vessel(shipped_scenario("quick"));
    Lattice lattice = sample_lattice(vessel, vessel.largest_radius(), dx);
    reference::Controller controller{shipped_scenario("quick").controller, vessel, dx, lattice.openings};

    const Vec3& outward(std::size_t k) const { return vessel.openings()[k].outward; }
    /// A point on the axis of opening k, `beyond` its plane.
    Vec3 at(std::size_t k, double beyond) const { return vessel.openings()[k].center + beyond * outward(k); }
};

void add(Particles& p, Kind kind, const Vec3& position, const Vec3& velocity = {})
{
    p.position.push_back(position);
    p.velocity.push_back(velocity);
    p.pressure.push_back(0);
    p.kind.push_back(kind);
}

/// The slabs in disorder, a particle of blood, and a reserve; `missing` ghosts of each slab's pattern aren't there.
Particles disorder(const Artery& artery, std::size_t missing, std::size_t reserve)
{
    Random random(9);
    Particles p;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i + missing < artery.lattice.openings[k].size(); ++i) {
            add(p, ghosts[k], artery.at(k, random.between(0, opening_layers * dx)), random.direction());
        }
    }
    add(p, Kind::fluid, artery.at(0, -1), {1, 2, 3});
    for (std::size_t i = 0; i < reserve; ++i) {
        add(p, Kind::reserve, {});
    }
    return p;
}

/// Whether `reset` puts slab k back to its pattern, as far as the reserve goes, and touches nothing else.
template <class Reset>
bool restores_the_pattern(Reset reset, std::size_t k, std::size_t reserve)
{
    const Artery artery;
    constexpr std::size_t missing = 5;
    Particles p = disorder(artery, missing, reserve);
    const Particles before = p;
    Ledger ledger;
    reset(artery.controller, p, k, ledger);
    std::vector<Vec3> pattern = artery.lattice.openings[k];
    bool good = true;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == ghosts[k]) {
            good = good && std::erase(pattern, p.position[i]) == 1 && p.velocity[i] == Vec3{};
        } else if (p.kind[i] != Kind::reserve) {
            good = good && p.kind[i] == before.kind[i] && p.position[i] == before.position[i] &&
                   p.velocity[i] == before.velocity[i];
        }
    }
    const std::size_t missed = reserve < missing ? missing - reserve : 0;
    return good && pattern.size() == missed && ledger.missed == static_cast<std::int64_t>(missed) &&
           std::ranges::count(p.kind, Kind::reserve) == static_cast<std::int64_t>(reserve + missed - missing);
}

} // namespace

BOOST_AUTO_TEST_CASE(an_empty_reserve_is_counted_and_the_blood_enters_all_the_same)
{
    const Artery artery;
    Particles p;
    add(p, Kind::inlet, artery.at(0, -0.01));
    Ledger ledger;

    artery.controller.exchange(p, ledger);

    BOOST_TEST((p.kind[0] == Kind::fluid));
    BOOST_TEST(ledger.missed == 1);
    BOOST_TEST(ledger.inlet_in == 1);
}

BOOST_AUTO_TEST_CASE(reset_restores_the_pattern_of_one_slab_as_far_as_the_reserve_goes)
{
    const auto reset = [](const auto& controller, Particles& p, std::size_t k, Ledger& l) {
        controller.reset(p, k, l);
    };
    const auto of_another = [](const auto& controller, Particles& p, std::size_t k, Ledger& l) {
        controller.reset(p, (k + 1) % 3, l);
    };
    const auto uncounted = [](const auto& controller, Particles& p, std::size_t k, Ledger&) {
        Ledger ignored;
        controller.reset(p, k, ignored);
    };
    for (std::size_t k = 0; k < 3; ++k) {
        for (const std::size_t reserve : {8U, 5U, 2U}) {
            BOOST_TEST(restores_the_pattern(reset, k, reserve));
            BOOST_TEST(!restores_the_pattern(of_another, k, reserve));
            BOOST_TEST(restores_the_pattern(uncounted, k, reserve) == (reserve >= 5));
        }
    }
}

BOOST_AUTO_TEST_CASE(ends_hold_only_their_own_blood_and_leave_it_its_motion_across)
{
    const Artery artery;
    const Vec3 across{0, 0, -0.2};
    Particles p;
    for (const std::size_t k : {0U, 1U, 2U}) {
        add(p, Kind::fluid, artery.at(k, 0.01), 3.0 * artery.outward(k) + across);
    }
    add(p, Kind::escaped, artery.at(0, 0.01), 3.0 * artery.outward(0));
    const Particles before = p;
    const auto is_held = [&](std::size_t i, double speed) {
        return distance(p.position[i], artery.at(i, 0)) <= distance_rounding &&
               distance(p.velocity[i], speed * artery.outward(i) + across) <= rounding(8) * 4;
    };
    const auto is_untouched = [&](std::size_t i) {
        return p.position[i] == before.position[i] && p.velocity[i] == before.velocity[i];
    };

    artery.controller.hold_back(p, 1);
    BOOST_TEST(is_held(1, 0));
    BOOST_TEST((is_untouched(0) && is_untouched(2) && is_untouched(3)));

    artery.controller.push_as_piston(p, 4);
    BOOST_TEST(is_held(0, -4));
    BOOST_TEST((is_untouched(2) && is_untouched(3)));
}
