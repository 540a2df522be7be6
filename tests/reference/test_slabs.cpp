// SPDX-License-Identifier: Apache-2.0
// Sections 3.4 and 3.5: what moves the slabs of ghosts behind the open ends, and their pattern.
#include "tests/open_ends.hpp"

using namespace aneurysm;
using namespace aneurysm::test;
using namespace aneurysm::test::open_ends;
using reference::Controller;

BOOST_AUTO_TEST_CASE(inlet_slab_moves_with_the_velocity_of_eq25)
{
    const Artery artery;
    for (const double v : {2.5, -0.5}) {
        Particles p;
        add(p, Kind::inlet, artery.at(0, 0.1), {1, 2, 3});
        add(p, Kind::outlet_1, artery.at(1, 0.1), {1, 2, 3});
        add(p, Kind::fluid, artery.at(0, -0.1), {1, 2, 3});

        artery.controller.drive_inlet(p, v);

        BOOST_TEST((p.velocity[0] == Vec3{0, v, 0}));
        BOOST_TEST((p.velocity[1] == Vec3{1, 2, 3}));
        BOOST_TEST((p.velocity[2] == Vec3{1, 2, 3}));
    }
}

BOOST_AUTO_TEST_CASE(outlet_slab_accelerates_by_newtons_law)
{
    const auto holds = [](const Artery& artery) {
        const double rho_0 = 1050;
        const double dt = 1e-3;
        const double p_outlet = 3e5;
        bool good = true;
        for (const std::size_t k : {1U, 2U}) {
            const Vec3& n = artery.opening(k).outward;
            Particles p;
            Random random(k);
            double speed = 0;
            double pressure = 0;
            for (int i = 0; i < 10; ++i) {
                const double v = random.between(-5, 5);
                const double deep = i == 0 ? 2 * dx - 1e-7 : random.between(0, 2 * dx);
                const double blood_pressure = random.between(-1e5, 1e6);
                add(p, Kind::fluid, artery.at(k, -deep), v * n + Vec3{0, 0, 1}, blood_pressure);
                speed += v / 10;
                pressure += std::max(0.0, blood_pressure) / 10; // negative: not solved for yet
            }
            add(p, Kind::fluid, artery.at(k, -2 * dx - 1e-7), 100.0 * n, 1e9); // too far up
            add(p, Kind::fluid, artery.at(3 - k, -dx), 100.0 * n, 1e9);        // in the other daughter
            add(p, ghosts[k], artery.at(k, 0.1), 100.0 * n, 1e9);
            const double expected = speed + dt * (pressure - p_outlet) / (rho_0 * depth);
            const double found = artery.controller.outlet_velocity(p, k, 0.7, p_outlet, rho_0, dt);
            // 30 roundings of sums below 5 and 1e6 dt / (rho_0 D) < 3
            good = good && within(found, expected, rounding(30) * (5 + 3)) &&
                   artery.controller.outlet_velocity(Particles{}, k, 0.7, p_outlet, rho_0, dt) == 0.7;
        }
        return good;
    };
    check_with_faults(holds, true, true);
}

BOOST_AUTO_TEST_CASE(outlet_slab_moves_in_as_a_plug_and_out_one_by_one)
{
    const Artery artery;
    const Vec3& n = artery.opening(2).outward;
    const auto driven = [&](double own, double v, double previous) {
        Particles p;
        add(p, Kind::outlet_2, artery.at(2, 0.1), own * n + Vec3{0, 0, 0.5});
        add(p, Kind::outlet_1, artery.at(1, 0.1), {1, 2, 3});
        artery.controller.drive_outlet(p, 2, v, previous);
        BOOST_TEST((p.velocity[1] == Vec3{1, 2, 3}));
        return p.velocity[0];
    };
    const double allowed = rounding(8) * 5;

    BOOST_TEST(distance(driven(3, -0.4, 0.1), -0.4 * n) <= allowed);
    BOOST_TEST(distance(driven(3, 1.5, 1.2), (3 + 0.3) * n) <= allowed);
    BOOST_TEST(distance(driven(0.2, 0.5, 1.2), Vec3{}) <= allowed); // 0.2 - 0.7: not inwards
}

namespace
{

/// The slabs in disorder, a particle of blood, and a reserve.
Particles disorder(const Artery& artery, std::size_t reserve)
{
    Random random(9);
    Particles p;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i + 5 < artery.lattice.openings[k].size(); ++i) {
            add(p, ghosts[k], artery.at(k, random.between(0, depth)), random.direction());
        }
    }
    add(p, Kind::fluid, artery.at(0, -1), {1, 2, 3});
    for (std::size_t i = 0; i < reserve; ++i) {
        add(p, Kind::reserve, {});
    }
    return p;
}

} // namespace

BOOST_AUTO_TEST_CASE(reset_restores_the_pattern_of_one_slab)
{
    const auto holds = [](auto reset) {
        const Artery artery;
        bool good = true;
        for (std::size_t k = 0; k < 3; ++k) {
            for (const std::size_t reserve : {8U, 5U, 2U}) { // 5 are missing in each slab
                Particles p = disorder(artery, reserve);
                const Particles before = p;
                Ledger ledger;
                reset(artery.controller, p, k, ledger);
                std::vector<Vec3> pattern = artery.lattice.openings[k];
                std::size_t in_place = 0;
                for (std::size_t i = 0; i < p.size(); ++i) {
                    if (p.kind[i] == ghosts[k]) {
                        in_place += std::erase(pattern, p.position[i]);
                        good = good && p.velocity[i] == Vec3{};
                    } else if (p.kind[i] != Kind::reserve) {
                        good = good && p.kind[i] == before.kind[i] && p.position[i] == before.position[i] &&
                               p.velocity[i] == before.velocity[i];
                    }
                }
                const std::size_t missed = reserve < 5 ? 5 - reserve : 0;
                good = good && pattern.size() == missed && ledger.missed == std::int64_t(missed) &&
                       in_place == artery.lattice.openings[k].size() - missed &&
                       count(p, Kind::reserve) == std::int64_t(reserve + missed) - 5;
            }
        }
        return good;
    };
    const auto reset = [](const Controller& c, Particles& p, std::size_t k, Ledger& l) { c.reset(p, k, l); };
    BOOST_TEST(holds(reset));
    BOOST_TEST(!holds(
        [&](const Controller& c, Particles& p, std::size_t k, Ledger& l) { reset(c, p, (k + 1) % 3, l); }));
    BOOST_TEST(!holds([&](const Controller& c, Particles& p, std::size_t k, Ledger& l) {
        reset(c, p, k, l);
        p.position[static_cast<std::size_t>(std::ranges::find(p.kind, ghosts[k]) - p.kind.begin())].x +=
            1e-15;
    }));
    BOOST_TEST(!holds([&](const Controller& c, Particles& p, std::size_t k, Ledger&) {
        Ledger ignored;
        reset(c, p, k, ignored);
    }));
}
