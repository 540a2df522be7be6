// SPDX-License-Identifier: Apache-2.0
// An artery with its controller, for the tests of its open ends.
#pragma once

#include "common/vessel/sampling.hpp"
#include "reference/controller.hpp"
#include "tests/support.hpp"
#include "tests/vessels.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace aneurysm::test::open_ends
{

inline constexpr double dx = 0.12;
inline constexpr double depth = opening_layers * dx;
inline constexpr double fault = 1e-6;
inline constexpr std::array ghosts{Kind::inlet, Kind::outlet_1, Kind::outlet_2};

/// A vessel, its lattice, and a controller. Faulty ones: that takes spacings or lengths to be larger.
struct Artery {
    Vessel vessel;
    Lattice lattice;
    Vessel seen; ///< by the controller
    reference::Controller controller;

    explicit Artery(double wrong_spacing = 0, double wrong_length = 0)
        : vessel(make_vessel(shipped_scenario("quick"))),
          lattice(sample_lattice(vessel, vessel.largest_radius(), dx)), seen(longer(wrong_length)),
          controller(shipped_scenario("quick").controller, seen, dx * (1 + wrong_spacing), lattice.openings)
    {
    }
    Artery(const Artery&) = delete;
    Artery& operator=(const Artery&) = delete;

    static Vessel longer(double by)
    {
        Scenario scenario = shipped_scenario("quick");
        scenario.vessel.parent_length_radii *= 1 + by;
        scenario.vessel.daughter_length_radii *= 1 + by;
        return make_vessel(scenario);
    }

    const Opening& opening(std::size_t k) const { return vessel.openings()[k]; }
    /// A point on the axis of opening k, `beyond` its plane, `aside` of the axis.
    Vec3 at(std::size_t k, double beyond, double aside = 0) const
    {
        return opening(k).center + beyond * opening(k).outward + Vec3{0, 0, aside};
    }
    double beyond(std::size_t k, const Vec3& x) const { return opening(k).beyond(x); }
};

inline void add(Particles& p, Kind kind, const Vec3& position, const Vec3& velocity = {}, double pressure = 0)
{
    p.position.push_back(position);
    p.velocity.push_back(velocity);
    p.pressure.push_back(pressure);
    p.kind.push_back(kind);
}

inline std::int64_t count(const Particles& p, Kind kind)
{
    return std::ranges::count(p.kind, kind);
}

/// What a ledger says about the number of blood particles; `escaped` is the flow's.
inline std::int64_t blood_gained(const Ledger& l)
{
    return l.inlet_in - l.inlet_out + l.outlet_in - l.outlet_out - l.escaped;
}

/// Whether claim(artery) holds with a good controller and fails with each of the faulty ones.
template <class Claim>
void check_with_faults(Claim claim, bool sees_spacing, bool sees_length)
{
    BOOST_TEST(claim(Artery()));
    for (const double error : {fault, -fault}) {
        BOOST_TEST((!sees_spacing || !claim(Artery(error, 0))));
        BOOST_TEST((!sees_length || !claim(Artery(0, error))));
    }
}

} // namespace aneurysm::test::open_ends
