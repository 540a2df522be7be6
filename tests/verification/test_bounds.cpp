// SPDX-License-Identifier: Apache-2.0
// The rounding bounds of the comparisons, against the same formulas in float: none is exceeded, and none is
// so wide that it says nothing.
#include "cuda/kernel_function.hpp"
#include "reference/kernel_function.hpp"
#include "tests/vessels.hpp"
#include "verification/bounds/inexact.hpp"
#include "verification/bounds/kernel.hpp"
#include "verification/bounds/opening.hpp"
#include "verification/bounds/wall.hpp"

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

const bounds::Rounding in_float(0x1p-24);

/// Largest measured / allowed of many.
struct Worst {
    double ratio = 0;

    void add(double measured, double units)
    {
        const double allowed = in_float.absolute(units);
        ratio = std::max(ratio, measured <= allowed ? measured / std::max(allowed, 1e-300) : 1e9);
    }
    /// Not exceeded, and not 1000 times too wide.
    bool fits() const
    {
        BOOST_TEST_MESSAGE("    measured / allowed " << ratio);
        return ratio <= 1 && ratio >= 1e-3;
    }
};

Vec3T<float> narrow(const Vec3& x)
{
    return {static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)};
}
Vec3 wide(const Vec3T<float>& x)
{
    return {x.x, x.y, x.z};
}

/// Pairs of float places, as particles have them; `scale_of_h` is a fault of the float kernel.
bool kernel_fits(KernelName name, double scale_of_h)
{
    const double h = 0.1287;
    const bounds::KernelBounds bounds(name, h);
    const reference::Kernel kernel(name, h);
    const device::Kernel<float> single(name, h * scale_of_h);
    const auto first = [](const device::Lanes<float>& lanes) { return lanes.v[0]; };
    Random random(1);
    Worst value;
    Worst gradient;
    Worst laplacian;
    for (int n = 0; n < 20000; ++n) {
        const Vec3T<float> a = narrow(random.point(2));
        const Vec3T<float> b = narrow(wide(a) + random.point(2.5 * h));
        const Vec3 x = wide(a) - wide(b);
        const double r = length(x);
        const device::Lanes<float> r_float(length(a - b));
        const bounds::PairBounds pair = bounds.of(r, 0);
        const Vec3T<float> slope = first(single.gradient_factor(r_float)) * (a - b);
        value.add(std::abs(first(single.value(r_float)) - kernel.value(r)), pair.W.error);
        gradient.add(length(wide(slope) - kernel.gradient(x)), pair.grad_W.error);
        laplacian.add(
            std::abs(first(single.viscosity_laplacian(r_float)) - reference::viscosity_laplacian(r, 2 * h)),
            pair.lap_W.error);
    }
    const std::array fit{value.fits(), gradient.fits(), laplacian.fits()};
    return fit[0] && fit[1] && fit[2];
}

/// Points around the wall of every vessel; `radius_scale` is a fault of the float vessel's sac.
bool wall_fits(double radius_scale)
{
    Worst value;
    Worst gradient;
    Worst plane;
    Random random(2);
    for_all_vessels([&](const Scenario& scenario, const Vessel& vessel) {
        const VesselT<float> single(vessel);
        const bounds::WallBounds bounds(vessel, scenario, in_float);
        const auto R = static_cast<float>(0.7 * vessel.largest_radius());
        for (int n = 0; n < 500; ++n) {
            const Vec3T<float> x = narrow(random.point(2));
            if (std::abs(vessel.wall(wide(x), R).value) > 0.2) {
                continue;
            }
            const bounds::InexactDistance d = bounds.wall(bounds::inexact(wide(x), 0), bounds::rounded(R));
            const DistanceT<float> s = single.wall(x, static_cast<float>(R * radius_scale));
            value.add(std::abs(s.value - d.value.value), d.value.error);
            gradient.add(length(wide(s.gradient) - bounds::value_of(d.gradient)),
                         bounds::error_of(d.gradient));
            const bounds::Inexact beyond = bounds.beyond(1, bounds::inexact(wide(x), 0));
            plane.add(std::abs(single.openings()[1].beyond(x) - beyond.value), beyond.error);
        }
        return true;
    });
    const std::array fit{value.fits(), gradient.fits(), plane.fits()};
    return fit[0] && fit[1] && fit[2];
}

} // namespace

BOOST_AUTO_TEST_CASE(bounds_of_the_kernels_hold_in_float)
{
    for (const KernelName name : {KernelName::cubic_spline, KernelName::wendland_c2}) {
        BOOST_TEST(kernel_fits(name, 1));
        BOOST_TEST(!kernel_fits(name, 1 + 1e-4));
    }
}

BOOST_AUTO_TEST_CASE(bounds_of_the_geometry_hold_in_float)
{
    BOOST_TEST(wall_fits(1));
    BOOST_TEST(!wall_fits(1 + 1e-4));
}

BOOST_AUTO_TEST_CASE(bounds_follow_every_operation)
{
    const bounds::Inexact a = bounds::rounded(3);
    const bounds::Inexact b = bounds::rounded(-2);
    BOOST_TEST((a + b).error == 3 + 2 + 1);
    BOOST_TEST((a - b).error == 3 + 2 + 5);
    BOOST_TEST((a * b).error == 6 + 6 + 6);
    BOOST_TEST((a / b).error == (3 + 1.5 * 2) / 2 + 1.5);
    BOOST_TEST(bounds::norm({a, bounds::Inexact{}, bounds::Inexact{4, 0}}).error == 3 + 3 * 5);
}

BOOST_AUTO_TEST_CASE(bounds_leave_decisions_open_within_rounding_only)
{
    const double u = in_float.absolute(1);
    BOOST_TEST((bounds::is_positive({2 * u, 1}, in_float) == bounds::Truth::yes));
    BOOST_TEST((bounds::is_positive({-2 * u, 1}, in_float) == bounds::Truth::no));
    BOOST_TEST((bounds::is_positive({0.5 * u, 1}, in_float) == bounds::Truth::open));
    BOOST_TEST((bounds::is_positive({0, 0}, in_float) == bounds::Truth::open));
    BOOST_TEST(((bounds::Truth::open && bounds::Truth::no) == bounds::Truth::no));
    BOOST_TEST(((bounds::Truth::open && bounds::Truth::yes) == bounds::Truth::open));
    BOOST_TEST(((!bounds::Truth::open) == bounds::Truth::open));
}

namespace
{

/// Two particles at the first outlet, before and after an exchange.
struct AtTheOutlet {
    Scenario scenario = shipped_scenario("quick");
    Vessel vessel = make_vessel(scenario);
    bounds::WallBounds wall{vessel, scenario, in_float};
    bounds::OpeningBounds openings{scenario, wall, 0.1, in_float};
    Particles before;
    Particles after;
    bounds::ParticleErrors errors{2};

    /// `beyond`: how far outside the plane [m].
    AtTheOutlet(double beyond, Kind first, Kind second)
    {
        const Opening& end = vessel.openings()[1];
        before.position = {end.center + beyond * end.outward, end.center + 0.15 * end.outward};
        before.velocity.resize(2);
        before.pressure.resize(2);
        before.kind = {first, second};
        after = before;
    }
};

} // namespace

BOOST_AUTO_TEST_CASE(bounds_let_blood_on_the_plane_be_a_ghost_or_not)
{
    AtTheOutlet on(0, Kind::fluid, Kind::outlet_1);
    on.openings.exchange(on.before, on.after, on.errors);
    BOOST_TEST((on.errors.other_kind[0] == Kind::outlet_1));
    BOOST_TEST(!on.errors.other_kind[1].has_value());
    BOOST_TEST(on.errors.other_counts.outlet_out == 1);
    BOOST_TEST(!on.errors.exchange_open);
    AtTheOutlet inside(-1e-5, Kind::fluid, Kind::outlet_1);
    inside.openings.exchange(inside.before, inside.after, inside.errors);
    BOOST_TEST(!inside.errors.other_kind[0].has_value());
}

BOOST_AUTO_TEST_CASE(bounds_leave_open_what_a_ghost_on_the_plane_does)
{
    AtTheOutlet on(0, Kind::outlet_1, Kind::outlet_1);
    on.openings.exchange(on.before, on.after, on.errors);
    BOOST_TEST(on.errors.exchange_open);
    AtTheOutlet outside(1e-5, Kind::outlet_1, Kind::outlet_1);
    outside.openings.exchange(outside.before, outside.after, outside.errors);
    BOOST_TEST(!outside.errors.exchange_open);
}

BOOST_AUTO_TEST_CASE(bounds_of_a_new_ghost_are_those_of_the_one_that_it_follows)
{
    AtTheOutlet e(-0.01, Kind::outlet_1, Kind::inlet); // the second has left the inlet's slab
    e.after.kind = {Kind::fluid, Kind::outlet_1};
    e.after.position[1] = e.before.position[0] + 0.3 * e.vessel.openings()[1].outward;
    e.errors.velocity = {7, 1};
    e.errors.position = {5, 1};
    e.openings.exchange(e.before, e.after, e.errors);
    BOOST_TEST(e.errors.velocity[1] == 7);
    BOOST_TEST(e.errors.position[1] > 5);
}
