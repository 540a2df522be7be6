// SPDX-License-Identifier: Apache-2.0
// Section 3.4 and Table 2: the wall of the generated vessel, measured where tubes and sac meet. The measures of each
// alone eq24_tubes and table2_sacs check.
#include "common/vessel/geometry.hpp"
#include "tests/vessels.hpp"

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

constexpr double fault = 1e-11;

const auto wall = [](const Vessel& vessel, const Vec3& x, double R) { return vessel.wall(x, R).value; };
const auto tubes = [](const Vessel& vessel, const Vec3& x) { return vessel.tubes(x).value; };

/// Where the surface lies at height y above the neck plane, along z at x = 0.
template <class Surface>
double half_width(Surface surface, const Vessel& vessel, double R, double y)
{
    const auto along_z = [&](double z) { return surface(vessel, Vec3{0, vessel.apex() + y, z}, R); };
    return crossing(along_z, 0, 3 * R);
}

/// The largest half width above the neck plane, by a search that narrows an interval of 3 R to 1e-8 R.
template <class Surface>
double largest_half_width(Surface surface, const Vessel& vessel, double R)
{
    double low = 0;
    double high = 3 * R;
    const auto width = [&](double y) {
        // on the axis above the dome there is no surface
        return surface(vessel, Vec3{0, vessel.apex() + y, 0}, R) < 0 ? half_width(surface, vessel, R, y) : 0;
    };
    while (high - low > 1e-8 * R) {
        const double third = (high - low) / 3;
        if (width(low + third) < width(high - third)) {
            low += third;
        } else {
            high -= third;
        }
    }
    return std::max(width(0), width(0.5 * (low + high)));
}

/// The largest e for which a union of width w with another surface at t passes zero where the sac's distance
/// is e: the root of e = (w - t + e)^2 / (4 w), since the union lies that much below its minimum.
double blend_excess(double t, double w)
{
    const double g = std::max(0.0, w - t);
    return g * g / (2 * w - g + 2 * std::sqrt(w * (w - g)));
}

/// Neck and base of Table 2 on the whole wall, when the sac is fully developed. Near the neck plane the tubes may
/// widen it.
template <class Surface>
bool wall_has_the_widths_of_table_2(Surface surface)
{
    return for_all_vessels([&](const Scenario& scenario, const Vessel& vessel) {
        const double r_0 = scenario.vessel.radius_m;
        const double neck = 0.5 * scenario.aneurysm.neck_width_radii * r_0;
        const double base = 0.5 * scenario.aneurysm.base_width_radii * r_0;
        const double R = vessel.largest_radius();
        // further up and further out the tubes are farther away
        const double excess = blend_excess(vessel.tubes({0, vessel.apex(), neck}).value,
                                           scenario.vessel.sac_smoothing_radii * r_0);
        const double neck_found = half_width(surface, vessel, R, 0);
        const double base_found = largest_half_width(surface, vessel, R);
        BOOST_TEST_MESSAGE("    angle " << scenario.vessel.angle_deg << " neck " << 2 * neck_found / r_0
                                        << " base " << 2 * base_found / r_0 << " excess " << excess / r_0);
        return neck_found >= neck - 2 * distance_rounding &&
               neck_found <= neck + excess / 0.5 + 2 * distance_rounding &&
               base_found >= base - 2 * distance_rounding &&
               base_found <= base + excess + 2 * distance_rounding;
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(table_2_gives_neck_and_base_width_of_the_whole_wall)
{
    BOOST_TEST(wall_has_the_widths_of_table_2(wall));
    for (const double error : {fault, -fault}) {
        BOOST_TEST(!wall_has_the_widths_of_table_2(
            [&](const Vessel& vessel, const Vec3& x, double R) { return wall(vessel, x, R * (1 + error)); }));
    }
    BOOST_TEST(!wall_has_the_widths_of_table_2([](const Vessel& vessel, const Vec3& x, double R) {
        return wall(vessel, x - Vec3{0, 0.1 * R, 0}, R); // not on the neck plane
    }));
}

BOOST_AUTO_TEST_CASE(apex_and_dome_are_where_tubes_and_wall_cross_the_axis)
{
    const auto holds = [](double fault_of_apex, double fault_of_dome) {
        return for_all_vessels([&](const Scenario& scenario, const Vessel& vessel) {
            const double R = 0.9 * vessel.largest_radius();
            const double apex = vessel.apex() * (1 + fault_of_apex);
            const double top = vessel.dome(R * (1 + fault_of_dome)).y;
            const double low = -scenario.vessel.parent_length_radii * scenario.vessel.radius_m;
            bool good = true;
            for (int k = 0; k < 100; ++k) { // lumen all the way up, and none above
                good = good && tubes(vessel, {0, low + (apex - low) * k / 100, 0}) < 0 &&
                       tubes(vessel, {0, apex + (k + 1) * 0.05, 0}) > 0;
            }
            // between steep daughters their blend reaches up to the dome
            const double excess = blend_excess(
                tubes(vessel, {0, top, 0}), scenario.vessel.sac_smoothing_radii * scenario.vessel.radius_m);
            const auto along_y = [&](double y) { return wall(vessel, {0, y, 0}, R); };
            const double found = crossing(along_y, top - R, top + R);
            return good && within(tubes(vessel, {0, apex, 0}), 0, distance_rounding) &&
                   found >= top - distance_rounding && found <= top + excess + distance_rounding;
        });
    };
    BOOST_TEST(holds(0, 0));
    BOOST_TEST(
        !holds(fault, 0)); // at 15 degrees the distance along the axis grows with sin 15, 1/4 of the way
    BOOST_TEST(!holds(0, fault));
}

BOOST_AUTO_TEST_CASE(wall_is_its_own_mirror_image)
{
    const auto holds = [](auto surface) {
        Random random(7);
        return for_all_vessels([&](const Scenario&, const Vessel& vessel) {
            bool good = true;
            for (int sample = 0; sample < 200; ++sample) {
                const Vec3 x = random.point(4);
                const double R = vessel.largest_radius() * random.between(0.4, 1);
                const double d = surface(vessel, x, R);
                // in z the same operations; in x the daughters change places
                good = good && surface(vessel, Vec3{x.x, x.y, -x.z}, R) == d &&
                       std::abs(surface(vessel, Vec3{-x.x, x.y, x.z}, R) - d) <= 2 * distance_rounding;
            }
            return good;
        });
    };
    BOOST_TEST(holds(wall));
    for (const Vec3& shift : {Vec3{fault, 0, 0}, Vec3{0, 0, fault}}) {
        BOOST_TEST(!holds(
            [&](const Vessel& vessel, const Vec3& x, double R) { return wall(vessel, x + shift, R); }));
    }
}

namespace
{

/// Distance to the axis of tube k, from the branching point through its opening and on.
double to_axis(const Vessel& vessel, std::size_t k, const Vec3& x)
{
    const Vec3& axis = vessel.openings()[k].outward;
    return dot(x, axis) > 0 ? length(cross(x, axis)) : length(x);
}

} // namespace

BOOST_AUTO_TEST_CASE(every_point_belongs_to_its_nearest_tube_and_is_cut_off_at_its_opening_alone)
{
    const auto holds = [](auto nearest_tube, auto between_openings) {
        Random random(8);
        return for_all_vessels([&](const Scenario&, const Vessel& vessel) {
            const auto surface = [&](std::size_t k, const Vec3& x) {
                return to_axis(vessel, k, x) - vessel.openings()[k].radius;
            };
            bool good = between_openings(vessel, vessel.dome(vessel.largest_radius()));
            for (int sample = 0; sample < 1000; ++sample) {
                const Vec3 x = random.point(5);
                const std::size_t k = nearest_tube(vessel, x);
                for (std::size_t other = 0; other < 3; ++other) {
                    good = good && surface(k, x) <= surface(other, x) + 2 * distance_rounding;
                }
                const Opening& o = vessel.openings()[k];
                good = good && between_openings(vessel, x) == (dot(x, o.outward) <= dot(o.center, o.outward));
            }
            return good;
        });
    };
    const auto nearest = [](const Vessel& vessel, const Vec3& x) { return vessel.nearest_tube(x); };
    const auto between = [](const Vessel& vessel, const Vec3& x) { return vessel.between_openings(x); };
    BOOST_TEST(holds(nearest, between));
    const auto by_quadrant = [](const Vessel&, const Vec3& x) {
        const std::size_t daughter = x.x < 0 ? 1 : 2;
        return x.y < 0 ? 0 : daughter;
    };
    BOOST_TEST(!holds(by_quadrant, between));
    BOOST_TEST(!holds(nearest, [](const Vessel& vessel, const Vec3& x) { // the second daughter has no end
        return vessel.nearest_tube(x) == 2 || vessel.between_openings(x);
    }));
}
