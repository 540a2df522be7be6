// SPDX-License-Identifier: Apache-2.0
// Section 3.4: the wall as a signed distance function. Its measures are in test_vessel.cpp.
#include "common/vessel/geometry.hpp"
#include "tests/vessels.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

constexpr double fault = 1e-9;

const auto wall = [](const Vessel& vessel, const Vec3& x, double R) { return vessel.wall(x, R); };

/// Distance of x to the straight line from a to b.
double to_segment(const Vec3& x, const Vec3& a, const Vec3& b)
{
    const Vec3 way = b - a;
    const double square = dot(way, way);
    const double t = square > 0 ? std::clamp(dot(x - a, way) / square, 0.0, 1.0) : 0;
    return length(x - a - t * way);
}

/// Distance of x to the axes of tubes and sac, where the wall's distance has its ridges.
double to_ridge(const Vessel& vessel, const Vec3& x, double R)
{
    const Vec3 neck{0, vessel.apex(), 0};
    double nearest = to_segment(x, neck, vessel.dome(R) - Vec3{0, R, 0});
    for (const Opening& o : vessel.openings()) {
        nearest = std::min(nearest, to_segment(x, {}, o.center + vessel_extent * o.outward));
    }
    return nearest;
}

template <class Candidate>
bool gradient_is_the_derivative(Candidate candidate)
{
    Random random(1);
    return for_all_vessels([&](const Scenario& scenario, const Vessel& vessel) {
        const double away = 0.1 * scenario.vessel.radius_m;
        const double delta = 1e-8;
        // f'' is at most 1/rho at the distance rho from an axis.
        // A union of width w adds at most |grad(b - a)|^2 / (2 w) <= 2/w.
        // So (f(+) - f(-)) / (2 delta) is off by at most delta f''/2, and the roundings.
        const double curvature = 1 / (away - delta) + 4 / (scenario.vessel.junction_smoothing_radii * 0.5) +
                                 2 / (scenario.vessel.sac_smoothing_radii * 0.5);
        const double allowed = delta / 2 * curvature + distance_rounding / delta;
        bool equal = true;
        for (int sample = 0; sample < 300; ++sample) {
            const double R = vessel.largest_radius() * random.between(0.4, 1);
            const Vec3 x = random.point(2, {0, vessel.apex(), 0});
            const Vec3 e = random.direction();
            if (to_ridge(vessel, x, R) > away) {
                const double slope =
                    (candidate(vessel, x + delta * e, R).value - candidate(vessel, x - delta * e, R).value) /
                    (2 * delta);
                equal = equal && std::abs(dot(candidate(vessel, x, R).gradient, e) - slope) <= allowed;
            }
        }
        return equal;
    });
}

/// The gradient's length is 1, or less where surfaces are blended. `R`: of the sac.
template <class Candidate>
bool gradient_has_length_one(Candidate candidate)
{
    Random random(2);
    return for_all_vessels([&](const Scenario& scenario, const Vessel& vessel) {
        bool good = true;
        for (int sample = 0; sample < 300; ++sample) {
            const double R = vessel.largest_radius() * random.between(0.4, 1);
            const Vec3 x = random.point(3, {0, vessel.apex(), 0});
            const double blended = length(candidate(vessel, x, R).gradient);
            const double apart = std::abs(vessel.sac(x, R).value - vessel.tubes(x).value);
            const bool in_sac = vessel.sac(x, R).value < vessel.tubes(x).value &&
                                apart >= scenario.vessel.sac_smoothing_radii * scenario.vessel.radius_m;
            // a unit vector by root and division, turned and blended: 20 roundings
            good = good && blended <= 1 + rounding(20) && (!in_sac || blended >= 1 - rounding(20));
        }
        return good;
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(gradient_is_the_derivative_of_the_distance)
{
    BOOST_TEST(gradient_is_the_derivative(wall));
    BOOST_TEST(!gradient_is_the_derivative([](const Vessel& vessel, const Vec3& x, double R) {
        Distance d = vessel.wall(x, R);
        d.gradient = (1 + 1e-5) * d.gradient;
        return d;
    }));
    BOOST_TEST(!gradient_is_the_derivative([](const Vessel& vessel, const Vec3& x, double R) {
        return Distance{vessel.wall(x, R).value, vessel.tubes(x).gradient}; // the sac's is forgotten
    }));
}

BOOST_AUTO_TEST_CASE(gradient_has_length_one_or_less_where_blended)
{
    BOOST_TEST(gradient_has_length_one(wall));
    for (const double error : {fault, -fault}) {
        BOOST_TEST(!gradient_has_length_one([&](const Vessel& vessel, const Vec3& x, double R) {
            Distance d = vessel.wall(x, R);
            d.gradient = (1 + error) * d.gradient;
            return d;
        }));
    }
}

BOOST_AUTO_TEST_CASE(smooth_union_lies_just_below_the_minimum)
{
    const auto holds = [](auto united) {
        Random random(3);
        bool good = true;
        for (int sample = 0; sample < 3000; ++sample) {
            const Distance a{random.between(-1, 1), random.direction()};
            const Distance b{random.between(-1, 1), random.direction()};
            const double width = random.between(0, 0.5);
            const double below = std::min(a.value, b.value) - united(a, b, width).value;
            // the blend lowers the minimum by (width - |a - b|)^2 / (4 width); 12 operations on at most 2.5
            const double overlap = std::max(0.0, width - std::abs(a.value - b.value));
            good = good && within(below, overlap * overlap / (4 * width), 2.5 * rounding(12)) &&
                   within(united(a, b, width).value, united(b, a, width).value, 2.5 * rounding(24));
        }
        const Distance same{0.3, {1, 0, 0}};
        return good && within(united(same, same, 0.2).value, 0.3 - 0.2 / 4, rounding(12)) &&
               united(same, {0.2, {0, 1, 0}}, 0).value == 0.2;
    };
    BOOST_TEST(holds(smooth_union<double>));
    BOOST_TEST(!holds([](const Distance& a, const Distance& b, double width) {
        return smooth_union(a, b, width * (1 + fault));
    }));
    BOOST_TEST(!holds([](const Distance& a, const Distance& b, double) { // no blend
        return a.value < b.value ? a : b;
    }));
}

BOOST_AUTO_TEST_CASE(smooth_union_blends_the_gradients_as_its_value)
{
    // Of two planes the union is quadratic within the blend, where central differences are exact up to the
    // rounding of 20 operations on at most 3.
    const auto holds = [](auto united) {
        Random random(4);
        const double delta = 1e-3;
        const double width = 0.4;
        bool good = true;
        for (int sample = 0; sample < 3000; ++sample) {
            const Vec3 n_a = random.direction();
            const Vec3 n_b = random.direction();
            const Vec3 e = random.direction();
            const double a = random.between(-1, 1);
            const double b = a + random.between(-1, 1) * (width - 2 * delta);
            const auto at = [&](double t) {
                return united(Distance{a + t * dot(n_a, e), n_a}, Distance{b + t * dot(n_b, e), n_b}, width);
            };
            const double slope = (at(delta).value - at(-delta).value) / (2 * delta);
            good = good && std::abs(dot(at(0).gradient, e) - slope) <= 3 * rounding(20) / delta;
        }
        return good;
    };
    BOOST_TEST(holds(smooth_union<double>));
    BOOST_TEST(!holds([](const Distance& a, const Distance& b, double width) {
        Distance d = smooth_union(a, b, width);
        d.gradient += fault * a.gradient;
        return d;
    }));
}

namespace
{

/// A curve in the half plane (distance from the axis,
/// height) that makes a surface when turned round the axis.
using Profile = std::vector<std::array<double, 2>>;
constexpr int samples = 4000;

void add_arc(Profile& profile, double height, double radius, double from, double to)
{
    for (int k = 0; k <= samples; ++k) {
        const double angle = from + (to - from) * k / samples;
        profile.push_back({radius * std::cos(angle), height + radius * std::sin(angle)});
    }
}

/// The sac's surface above its neck plane (height 0), with the widths of Table 2 at radius R.
Profile sac_profile(const SacWidths& sac, double R)
{
    const double neck = R * sac.neck / sac.base;
    Profile profile;
    if (sac.shape != SacShape::piriform) {
        const double height = std::sqrt(std::max(0.0, R * R - neck * neck));
        add_arc(profile, height, R, -std::atan2(height, neck), std::numbers::pi / 2);
        return profile;
    }
    // The outer tangent from the neck's edge to the sphere of radius R, 1.5 R higher up.
    const double height = 1.5 * R;
    const double far = std::hypot(neck, height);
    const double tangent = std::sqrt(far * far - R * R);
    const double to_center = std::atan2(height, -neck);
    const double flank = to_center - std::asin(R / far);
    for (int k = 0; k < samples; ++k) {
        const double t = tangent * k / samples;
        profile.push_back({neck + t * std::cos(flank), t * std::sin(flank)});
    }
    add_arc(profile, height, R, flank - std::numbers::pi / 2, std::numbers::pi / 2);
    return profile;
}

/// The least distance to the samples, and how far two of them are apart. Not found: next to the neck, where
/// the profile ends.
struct Nearest {
    double distance = 1e300;
    bool found = false;
};
Nearest search(const Profile& profile, double across, double height)
{
    Nearest nearest;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        const double d = std::hypot(profile[k][0] - across, profile[k][1] - height);
        if (d < nearest.distance) {
            nearest = {d, k > 1};
        }
    }
    return nearest;
}

template <class Candidate>
bool sac_is_the_nearest_surface(Candidate candidate)
{
    return for_all_vessels([&](const Scenario& scenario, const Vessel& vessel) {
        const SacWidths sac{scenario.aneurysm.shape, scenario.aneurysm.neck_width_radii,
                            scenario.aneurysm.base_width_radii};
        const double R = 0.7 * vessel.largest_radius();
        const Profile profile = sac_profile(sac, R);
        const double step = 4 * R / samples; // no arc turns by more than 4, no flank is longer than 4 R
        Random random(5);
        bool good = true;
        for (int sample = 0; sample < 20; ++sample) {
            const Vec3 x = random.point(3 * R);
            const Nearest nearest = search(profile, std::hypot(x.x, x.z), x.y);
            const double D = nearest.distance;
            // A sample at most step/2 from the foot of the perpendicular, on a convex curve whose curvature
            // is at most 1/R, is at most at sqrt(D^2 + (step/2)^2 (1 + D/R)).
            const double over = step * step / 4 * (1 + D / R) / D;
            const double value = std::abs(candidate(vessel, x + Vec3{0, vessel.apex(), 0}, R));
            good = good && (!nearest.found ||
                            (value <= D + distance_rounding && value >= D - over - distance_rounding));
        }
        return good;
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(distance_to_the_sac_is_that_of_its_nearest_point)
{
    const auto sac = [](const Vessel& vessel, const Vec3& x, double R) { return vessel.sac(x, R).value; };
    BOOST_TEST(sac_is_the_nearest_surface(sac));
    for (const double error : {1e-4, -1e-4}) {
        BOOST_TEST(!sac_is_the_nearest_surface(off_by(error, sac)));
        BOOST_TEST(!sac_is_the_nearest_surface(
            [&](const Vessel& vessel, const Vec3& x, double R) { return sac(vessel, x, R * (1 + error)); }));
    }
}
