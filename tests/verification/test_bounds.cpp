// SPDX-License-Identifier: Apache-2.0
// The rounding bounds of the comparisons, against the same formulas in float: none is exceeded, and none is
// so wide that it says nothing.
#include "common/vessel/sampling.hpp"
#include "cuda/kernel_function.hpp"
#include "reference/kernel_function.hpp"
#include "tests/vessels.hpp"
#include "verification/bounds/inexact.hpp"
#include "verification/bounds/kernel.hpp"
#include "verification/bounds/mean.hpp"
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

/// Means with weights as those of a ghost at the edge of sight: some are nearly 0. `scale` is a fault of the
/// float mean.
bool mean_fits(float scale)
{
    const reference::Kernel kernel(KernelName::cubic_spline, 0.1);
    const bounds::KernelBounds bounds(KernelName::cubic_spline, 0.1);
    Random random(3);
    Worst worst;
    for (int n = 0; n < 2000; ++n) {
        bounds::WeightedMean<double> mean;
        std::vector<std::pair<bounds::Inexact, double>> terms;
        float sum = 0;
        float weights = 0;
        for (int k = 0; k < 4; ++k) {
            const auto r = static_cast<float>(random.between(0.15, 0.2));
            const auto x = static_cast<float>(random.between(-1, 1));
            const float w =
                device::Kernel<float>(KernelName::cubic_spline, 0.1F).value(device::Lanes<float>(r)).v[0];
            terms.emplace_back(bounds.of(r, 0).W, x);
            sum += w * x;
            weights += w;
        }
        for (const auto& [w, x] : terms) {
            mean.add(w, x);
        }
        for (const auto& [w, x] : terms) {
            mean.compare(w, x, 0);
        }
        worst.add(std::abs(scale * sum / weights - mean.value()), mean.error(in_float));
    }
    return worst.fits();
}

} // namespace

BOOST_AUTO_TEST_CASE(bounds_of_a_weighted_mean_hold_in_float)
{
    BOOST_TEST(mean_fits(1));
    BOOST_TEST(!mean_fits(1 + 1e-4F));
}

BOOST_AUTO_TEST_CASE(bounds_of_a_mean_that_may_have_no_member_cover_that)
{
    bounds::WeightedMean<double> mean;
    mean.add({1e-9, 1}, 5);
    mean.compare({1e-9, 1}, 5, 0);
    BOOST_TEST(in_float.absolute(mean.error(in_float)) >= 5);
}

namespace
{

/// Two particles at the first outlet, before and after an exchange.
struct AtTheOutlet {
    Scenario scenario = shipped_scenario("quick");
    Vessel vessel = make_vessel(scenario);
    Opening end = vessel.openings()[1];
    bounds::WallBounds wall{vessel, scenario, in_float};
    bounds::OpeningBounds openings{scenario, wall, dx, in_float};
    Particles before;
    Particles after;
    bounds::ParticleErrors errors{2};
    static constexpr double dx = 0.1;
    static constexpr double t = 0.1;

    /// `beyond`: how far outside the plane the first is [m]; both move with `velocity`, outwards [m/s].
    AtTheOutlet(double beyond, Kind first, double velocity)
    {
        before.position = {end.center + beyond * end.outward, end.center + 0.15 * end.outward};
        before.velocity.assign(2, velocity * end.outward);
        before.pressure.resize(2);
        before.kind = {first, Kind::outlet_1};
        after = before;
    }
    void exchange() { openings.exchange(before, after, t, errors); }
};

/// A place of the far layer of the first outlet's buffer.
Vec3 far_place(const AtTheOutlet& e)
{
    const std::vector<Vec3> pattern = sample_lattice(e.vessel, 0, AtTheOutlet::dx).openings[1];
    return *std::ranges::max_element(pattern, {}, [&](const Vec3& x) { return e.end.beyond(x); });
}

/// Whether rounding decides what is placed when the second particle is this far from a place.
bool is_place_open(double distance)
{
    AtTheOutlet e(0.05, Kind::outlet_1, -1);
    e.before.position[1] = far_place(e) + distance * Vec3{0, 0, 1};
    e.after = e.before;
    e.exchange();
    return e.errors.exchange_open;
}

} // namespace

BOOST_AUTO_TEST_CASE(bounds_let_blood_on_the_plane_join_the_buffer_or_not)
{
    AtTheOutlet on(0, Kind::fluid, 1);
    on.exchange();
    BOOST_TEST((on.errors.other_kind[0] == Kind::outlet_1));
    BOOST_TEST(!on.errors.other_kind[1].has_value());
    BOOST_TEST(on.errors.other_counts.outlet_out == 1);
    BOOST_TEST(!on.errors.exchange_open);
    AtTheOutlet inside(-1e-5, Kind::fluid, 1);
    inside.exchange();
    BOOST_TEST(!inside.errors.other_kind[0].has_value());
}

BOOST_AUTO_TEST_CASE(bounds_let_blood_of_a_buffer_on_the_plane_join_the_artery_or_not)
{
    AtTheOutlet on(0, Kind::outlet_1, 1);
    on.after.kind[0] = Kind::fluid;
    on.exchange();
    BOOST_TEST((on.errors.other_kind[0] == Kind::outlet_1));
    BOOST_TEST(on.errors.other_counts.outlet_in == 1);
    AtTheOutlet outside(1e-5, Kind::outlet_1, 1);
    outside.exchange();
    BOOST_TEST(!outside.errors.other_kind[0].has_value());
}

BOOST_AUTO_TEST_CASE(bounds_leave_open_what_depends_on_blood_at_the_far_end)
{
    const auto is_open = [](double beyond) {
        AtTheOutlet e(beyond, Kind::outlet_1, 1);
        e.exchange();
        return e.errors.exchange_open;
    };
    BOOST_TEST(is_open(opening_layers * AtTheOutlet::dx));
    BOOST_TEST(!is_open(opening_layers * AtTheOutlet::dx - 1e-5));
}

BOOST_AUTO_TEST_CASE(bounds_leave_open_whether_a_place_is_filled)
{
    const double reach = shipped_scenario("quick").controller.refill_distance_spacings * AtTheOutlet::dx;
    BOOST_TEST(is_place_open(reach));
    BOOST_TEST(!is_place_open(reach + 1e-5));
    BOOST_TEST(!is_place_open(reach - 1e-5));
}

BOOST_AUTO_TEST_CASE(bounds_leave_open_what_a_buffer_at_rest_does)
{
    AtTheOutlet e(0.05, Kind::outlet_1, 0);
    e.errors.velocity = {1, 1};
    e.exchange();
    BOOST_TEST(e.errors.exchange_open);
}

BOOST_AUTO_TEST_CASE(bounds_of_what_is_placed_are_those_of_its_buffer)
{
    AtTheOutlet e(0.05, Kind::reserve, -1);
    e.after.kind[0] = Kind::outlet_1;
    e.after.position[0] = far_place(e);
    e.errors.velocity = {0, 7};
    e.errors.position = {0, 1};
    e.exchange();
    BOOST_TEST(e.errors.velocity[0] > 7);
    BOOST_TEST(e.errors.velocity[0] < 7 + 20);
    BOOST_TEST(e.errors.position[0] >= length(e.after.position[0]));
}
