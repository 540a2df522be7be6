// SPDX-License-Identifier: Apache-2.0
// Section 3.4: the particle controller, which moves particles between
// the artery, its open ends and the reserve.
#include "common/vessel/initial_state.hpp"
#include "tests/open_ends.hpp"

using namespace aneurysm;
using namespace aneurysm::test;
using namespace aneurysm::test::open_ends;

BOOST_AUTO_TEST_CASE(a_plug_that_moves_in_and_out_leaves_the_lattice_as_it_was)
{
    const auto holds = [](const Artery& artery) {
        Particles p;
        for (const Vec3& x : artery.lattice.openings[0]) {
            add(p, Kind::inlet, x);
        }
        const std::int64_t slab = count(p, Kind::inlet);
        for (const Vec3& x : artery.lattice.fluid) {
            if (artery.beyond(0, x) > -4.5 * dx) { // more than the plug will draw out
                add(p, Kind::fluid, x);
            }
        }
        const std::vector<Vec3> start = p.position;
        for (std::int64_t k = 0; k < 2 * slab; ++k) {
            add(p, Kind::reserve, {});
        }
        Random random(1);
        Ledger ledger;
        bool good = true;
        double drawn = 0;
        for (int step = 0; step < 60; ++step) {
            const double way = step == 59 ? -drawn : random.between(-3 * dx, 3 * dx) - drawn;
            // no ghost jumps over the slab, nor blood out of it
            for (int part = 0; part < 8; ++part) {
                for (Vec3& x : p.position) {
                    x += way / 8 * artery.opening(0).outward;
                }
                const std::int64_t blood = count(p, Kind::fluid);
                const std::int64_t reserve = count(p, Kind::reserve);
                Ledger now;
                artery.controller.exchange(p, now);
                good = good && count(p, Kind::fluid) - blood == blood_gained(now) && now.missed == 0 &&
                       count(p, Kind::reserve) - reserve == now.recycled - now.inlet_in - now.outlet_in;
                ledger.inlet_in += now.inlet_in;
                ledger.inlet_out += now.inlet_out;
            }
            drawn += way;
        }
        // 480 moves of at most dx, each rounded
        const double allowed = 480 * unit_roundoff * vessel_extent;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const auto same = [&](const Vec3& x) { return distance(x, p.position[i]) <= allowed; };
            good = good && (p.kind[i] == Kind::reserve || std::ranges::count_if(start, same) == 1);
        }
        return good && count(p, Kind::inlet) == slab && ledger.inlet_in > slab && ledger.inlet_out > slab &&
               ledger.inlet_in == ledger.inlet_out;
    };
    check_with_faults(holds, true, false);
}

BOOST_AUTO_TEST_CASE(a_ghost_that_enters_becomes_blood_and_its_successor_lies_one_slab_behind)
{
    const auto holds = [](const Artery& artery) {
        bool good = true;
        for (std::size_t k = 0; k < 3; ++k) {
            Particles p;
            const Vec3 v = -2.5 * artery.opening(k).outward;
            add(p, ghosts[k], artery.at(k, -1e-7, 0.1), v, 77);
            add(p, ghosts[k], artery.at(k, 1e-7, -0.1), v, 77);
            add(p, Kind::reserve, {});
            const Vec3 entered = p.position[0];
            Ledger ledger;
            artery.controller.exchange(p, ledger);
            good =
                good && p.kind[0] == Kind::fluid && p.position[0] == entered && p.velocity[0] == v &&
                p.pressure[0] == unset_pressure && p.kind[1] == ghosts[k] && p.kind[2] == ghosts[k] &&
                distance(p.position[2], entered + depth * artery.opening(k).outward) <= distance_rounding &&
                p.velocity[2] == v && blood_gained(ledger) == 1 && ledger.missed == 0 &&
                ledger.recycled == 0 && (k == 0 ? ledger.inlet_in : ledger.outlet_in) == 1;
        }
        return good;
    };
    check_with_faults(holds, true, true);
}

BOOST_AUTO_TEST_CASE(what_leaves_the_slab_goes_to_the_reserve_and_what_leaves_the_artery_to_the_slab)
{
    const auto holds = [](const Artery& artery) {
        bool good = true;
        for (std::size_t k = 0; k < 3; ++k) {
            Particles p;
            const Vec3 v = 2.5 * artery.opening(k).outward;
            add(p, ghosts[k], artery.at(k, depth + 1e-7), v);
            add(p, ghosts[k], artery.at(k, depth - 1e-7), v);
            add(p, Kind::fluid, artery.at(k, 1e-7), v);
            add(p, Kind::fluid, artery.at(k, -1e-7), v);
            Ledger ledger;
            artery.controller.exchange(p, ledger);
            good = good && p.kind == std::vector{Kind::reserve, ghosts[k], ghosts[k], Kind::fluid} &&
                   ledger.recycled == 1 && blood_gained(ledger) == -1 &&
                   (k == 0 ? ledger.inlet_out : ledger.outlet_out) == 1;
        }
        return good;
    };
    check_with_faults(holds, true, true);
}

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

BOOST_AUTO_TEST_CASE(a_ghost_whose_place_is_taken_goes_to_the_far_end_of_the_slab)
{
    const auto holds = [](const Artery& artery) {
        bool good = true;
        for (const double gap : {0.7 * dx - 1e-8, 0.7 * dx + 1e-8}) {
            for (std::size_t k = 0; k < 3; ++k) {
                Particles p;
                const Vec3 ghost = artery.at(k, -0.01);
                add(p, ghosts[k], ghost);
                add(p, Kind::fluid, artery.at(k, -0.01, gap));
                add(p, Kind::reserve, {});
                Ledger ledger;
                artery.controller.exchange(p, ledger);
                const bool taken = gap < 0.7 * dx;
                const std::size_t follower = taken ? 0 : 2;
                good = good && p.kind[0] == (taken ? ghosts[k] : Kind::fluid) &&
                       p.kind[2] == (taken ? Kind::reserve : ghosts[k]) &&
                       blood_gained(ledger) == (taken ? 0 : 1) &&
                       distance(p.position[follower], ghost + depth * artery.opening(k).outward) <=
                           distance_rounding;
            }
        }
        return good;
    };
    check_with_faults(holds, true, false);
}

BOOST_AUTO_TEST_CASE(inlet_pushes_as_a_piston_within_its_reach)
{
    const double reach = 0.3 * dx;
    const auto holds = [&](const Artery& artery) {
        const Vec3 in = -artery.opening(0).outward;
        const Vec3 across{0.3, 0, -0.2};
        const auto pushed = [&](Kind kind, double beyond, double speed, double v_inlet) {
            Particles p;
            add(p, kind, artery.at(0, beyond), speed * in + across);
            artery.controller.push_as_piston(p, v_inlet);
            return std::array{dot(p.velocity[0], in), artery.beyond(0, p.position[0]),
                              distance(p.velocity[0] - dot(p.velocity[0], in) * in, across)};
        };
        const auto is = [](const std::array<double, 3>& found, double speed, double beyond) {
            return within(found[0], speed, rounding(8) * 5) && within(found[1], beyond, distance_rounding) &&
                   found[2] <= rounding(8);
        };
        return is(pushed(Kind::fluid, -reach + 1e-8, 1, 4), 4, -reach + 1e-8) &&
               is(pushed(Kind::fluid, -reach - 1e-8, 1, 4), 1, -reach - 1e-8) &&
               is(pushed(Kind::fluid, -0.01, 5, 4), 5, -0.01) && is(pushed(Kind::fluid, 0.01, -3, 4), 4, 0) &&
               is(pushed(Kind::fluid, 0.01, 5, 4), 5, 0) && is(pushed(Kind::fluid, 0.01, -3, -4), -3, 0.01) &&
               is(pushed(Kind::escaped, 0.01, -3, 4), -3, 0.01) &&
               is(pushed(Kind::inlet, 0.01, 1, 4), 1, 0.01);
    };
    check_with_faults(holds, true, true);
}

BOOST_AUTO_TEST_CASE(blood_is_held_back_at_an_outlet_that_flows_in)
{
    const auto holds = [](const Artery& artery) {
        bool good = true;
        for (const std::size_t k : {1U, 2U}) {
            const Vec3& n = artery.opening(k).outward;
            const Vec3 across{0, 0, -0.2};
            Particles p;
            add(p, Kind::fluid, artery.at(k, 0.01), 3.0 * n + across);  // stopped and put back
            add(p, Kind::fluid, artery.at(k, 0.01), -3.0 * n + across); // put back, turns in already
            add(p, Kind::fluid, artery.at(k, -0.01), 3.0 * n + across); // still inside
            add(p, Kind::fluid, artery.at(3 - k, 0.01), 3.0 * n);       // at the other outlet
            const Particles before = p;
            artery.controller.hold_back(p, k);
            const double v_rounding = rounding(8) * 4;
            good = good && distance(p.position[0], artery.at(k, 0)) <= distance_rounding &&
                   distance(p.velocity[0], across) <= v_rounding &&
                   distance(p.position[1], artery.at(k, 0)) <= distance_rounding &&
                   p.velocity[1] == before.velocity[1] && p.position[2] == before.position[2] &&
                   p.velocity[2] == before.velocity[2] && p.position[3] == before.position[3] &&
                   p.velocity[3] == before.velocity[3];
        }
        return good;
    };
    check_with_faults(holds, false, true);
}
