// SPDX-License-Identifier: Apache-2.0
// The surfaces that pictures show: on the wall, open at the breach, of the right volume. Bounds follow from
// the grids' cells. No display is needed.
#include "output/pictures/blood_surface.hpp"
#include "output/pictures/coloring.hpp"
#include "output/pictures/wall_surface.hpp"
#include "tests/vessels.hpp"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkTriangle.h>

#include <array>
#include <numbers>

using namespace aneurysm;
using namespace aneurysm::output;
using namespace aneurysm::test;

namespace
{

constexpr double pi = std::numbers::pi;
constexpr double float_rounding = vessel_extent * 0x1p-24; ///< of a coordinate that VTK keeps [m]

using Triangle = std::array<Vec3, 3>;

Vec3 point(vtkPolyData& data, vtkIdType i)
{
    std::array<double, 3> x{};
    data.GetPoint(i, x.data());
    return {x[0], x[1], x[2]};
}

std::vector<Triangle> triangles(vtkPolyData& data)
{
    std::vector<Triangle> result;
    vtkNew<vtkIdList> corners;
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        data.GetCellPoints(i, corners);
        for (vtkIdType k = 2; k < corners->GetNumberOfIds(); ++k) {
            result.push_back({point(data, corners->GetId(0)), point(data, corners->GetId(k - 1)),
                              point(data, corners->GetId(k))});
        }
    }
    return result;
}

/// Area times normal, in the triangle's own sense of rotation.
Vec3 area(const Triangle& t)
{
    return 0.5 * cross(t[1] - t[0], t[2] - t[0]);
}

double total_area(const std::vector<Triangle>& surface)
{
    double sum = 0;
    for (const Triangle& t : surface) {
        sum += length(area(t));
    }
    return sum;
}

/// Of what a closed surface encloses.
double volume(const std::vector<Triangle>& surface)
{
    double sum = 0;
    for (const Triangle& t : surface) {
        sum += dot(area(t), t[0] + t[1] + t[2]) / 9;
    }
    return std::abs(sum);
}

double longest_edge(const std::vector<Triangle>& surface)
{
    double longest = 0;
    for (const Triangle& t : surface) {
        longest = std::max({longest, length(t[1] - t[0]), length(t[2] - t[1]), length(t[0] - t[2])});
    }
    return longest;
}

/// How far a chord lies below a circle.
double sagitta(double chord, double radius)
{
    return chord * chord / (8 * radius);
}

double distance_to(const Vec3& x, const Triangle& t)
{
    vtkNew<vtkTriangle> triangle;
    for (int k = 0; k < 3; ++k) {
        const Vec3& corner = t.at(static_cast<std::size_t>(k));
        triangle->GetPoints()->SetPoint(k, corner.x, corner.y, corner.z);
    }
    const std::array at{x.x, x.y, x.z};
    std::array<double, 3> closest{}, coordinates{}, weights{};
    double square = 0;
    int unused = 0;
    triangle->EvaluatePosition(at.data(), closest.data(), unused, coordinates.data(), square, weights.data());
    return std::sqrt(square);
}

/// Whether every corner that no cut has made lies on the wall of radius `R`, as wall_mesh promises.
bool lies_on_wall(const Vessel& vessel, double R, double cell)
{
    const pictures::WallSurface surface = pictures::wall_surface(vessel, {0.4, std::nullopt}, cell);
    double worst = 0;
    for (vtkIdType i = 0; i < surface.wall->GetNumberOfPoints(); ++i) {
        const Vec3 x = point(*surface.wall, i);
        if (vessel.openings()[vessel.nearest_tube(x)].beyond(x) < -2 * cell) {
            worst = std::max(worst, std::abs(vessel.wall(x, R).value));
        }
    }
    return surface.wall->GetNumberOfPoints() > 10000 && within(worst, 0, 1e-6 * cell + float_rounding);
}

ShownParticles ball_of_particles(double radius, double dx)
{
    ShownParticles ball;
    const int n = static_cast<int>(radius / dx) + 1;
    for (int i = -n; i <= n; ++i) {
        for (int j = -n; j <= n; ++j) {
            for (int k = -n; k <= n; ++k) {
                const Vec3 x = dx * Vec3{i + 0.3, j + 0.1, k - 0.2};
                if (length(x) < radius) {
                    ball.position.push_back(x);
                    ball.kind.push_back(Kind::fluid);
                }
            }
        }
    }
    return ball;
}

/// Whether the surface around a ball of particles, made for spacing `taken`, encloses N dx^3 (1 - 3 s^2/A^2):
/// the weights, of variance s^2 = H^2/11 along an axis, round the ball off, which moves the level 1/2 inwards
/// by s^2/A. Allowed: what rows of the lattice do to the level, up to dx/2 in and out, in the second order;
/// and the grid's linear numbers, off by c^2/8 times curvature over slope, 8 (dx/2) / H^2.
bool has_volume_of_its_particles(double taken)
{
    const double A = 8;
    const double cell = 1.0 / 3;
    const ShownParticles ball = ball_of_particles(A, 1);
    const auto surface = triangles(*pictures::blood_surface(ball, taken, nullptr, cell));
    const auto N = static_cast<double>(ball.size());
    const double H = pictures::blood_support;
    const double expected = N * (1 - 3 * H * H / 11 / (A * A));
    const double rows = 3 * 0.25 / (A * A);
    const double grid = 3 / A * (cell * cell / 8) * 8 * 0.5 / (H * H) + 3 * cell * cell / (2 * A * A);
    return within(volume(surface), expected, N * (rows + grid));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_wall_lies_on_the_zero_of_its_distance)
{
    const Scenario s = shipped_scenario("paper_tc1");
    const Vessel vessel = make_vessel(s);
    const double cell = s.vessel.radius_m / 16;
    BOOST_TEST(lies_on_wall(vessel, 0.4, cell));
    BOOST_TEST(!lies_on_wall(vessel, 0.4001, cell));
}

BOOST_AUTO_TEST_CASE(a_pipe_has_the_area_and_volume_of_its_tube)
{
    const Scenario s = shipped_scenario("verify_pipe");
    const Vessel vessel = make_vessel(s);
    const double r = vessel.extent().x / 2;
    const double L = vessel.extent().y;
    const pictures::WallSurface wall = pictures::wall_surface(vessel, {}, r / 16);
    const std::vector<Triangle> surface = triangles(*wall.wall);
    // Corners are on the circle, so all of it lies between r - s and r from the axis.
    const double s_most = sagitta(longest_edge(surface), r) + float_rounding;
    double enclosed = 0; // by the slices, which have no part of the ends
    for (const Triangle& t : surface) {
        const Vec3 sum = t[0] + t[1] + t[2];
        enclosed += dot(area(t), Vec3{sum.x, 0, sum.z}) / 6;
    }
    enclosed = std::abs(enclosed);
    const auto is_tube = [&](double radius) {
        return enclosed <= pi * radius * radius * L * (1 + rounding(1e6)) + float_rounding &&
               enclosed >= pi * (radius - s_most) * (radius - s_most) * L - float_rounding;
    };
    BOOST_TEST(is_tube(r));
    BOOST_TEST(!is_tube(1.01 * r));
    BOOST_TEST(!is_tube(0.99 * r));
    BOOST_TEST(total_area(surface) >= 2 * pi * (r - s_most) * L);
    BOOST_TEST(wall.rim->GetNumberOfCells() == 0);
    BOOST_TEST(wall.ends->GetNumberOfCells() == 2);
}

BOOST_AUTO_TEST_CASE(a_breach_is_a_hole)
{
    for (const SacWidths& sac : table_2) {
        const Scenario s = with_sac(shipped_scenario("base"), sac);
        const Vessel vessel = make_vessel(s);
        const double R = vessel.largest_radius();
        const double cell = s.vessel.radius_m / 12;
        const Breach breach{vessel.dome(R), s.rupture.breach_radius_radii * s.vessel.radius_m};
        const auto nearest = [&](const pictures::WallShape& shape) {
            double least = 1e9;
            for (const Triangle& t : triangles(*pictures::wall_surface(vessel, shape, cell).wall)) {
                least = std::min(least, distance_to(breach.center, t));
            }
            return least;
        };
        BOOST_TEST(nearest({R, breach}) >= breach.radius);
        // The hole's edge is wider by a cell's diagonal at most, and lies lower than the dome.
        const double across = std::sqrt(breach.radius * breach.radius + 3 * cell * cell);
        const double down = R - std::sqrt(R * R - across * across);
        BOOST_TEST(nearest({R, breach}) <= std::sqrt(across * across + down * down) + cell);
        BOOST_TEST(nearest({R, std::nullopt}) < cell);
        const pictures::WallSurface open = pictures::wall_surface(vessel, {R, breach}, cell);
        BOOST_TEST(open.rim->GetNumberOfCells() == 1);
        BOOST_TEST(open.ends->GetNumberOfCells() == 3);
    }
}

BOOST_AUTO_TEST_CASE(blood_has_the_volume_of_its_particles)
{
    BOOST_TEST(has_volume_of_its_particles(1));
    BOOST_TEST(!has_volume_of_its_particles(1.05));
}

BOOST_AUTO_TEST_CASE(a_drop_has_the_volume_of_a_particle)
{
    ShownParticles drop;
    drop.position = {{0.01, 0.02, 0.03}};
    drop.kind = {Kind::escaped};
    const double cell = 1.0 / 8;
    const double radius = std::cbrt(3 / (4 * pi));
    const auto surface = triangles(*pictures::blood_surface(drop, 1, nullptr, cell));
    // Corners are off by the distance's bend along a grid's edge, triangles lie below them.
    const double corner = sagitta(cell, radius - cell);
    const double below = sagitta(longest_edge(surface), radius);
    BOOST_TEST(within(volume(surface), 1, 3 * (corner + below) / radius));
    drop.kind = {Kind::fluid}; // too little for a surface
    BOOST_TEST(pictures::blood_surface(drop, 1, nullptr, cell)->GetNumberOfCells() == 0);
}

BOOST_AUTO_TEST_CASE(blood_stays_inside_the_wall_but_for_the_breach)
{
    const Scenario s = shipped_scenario("base");
    const Vessel vessel = make_vessel(s);
    const double R = vessel.largest_radius();
    const Breach breach{vessel.dome(R), s.rupture.breach_radius_radii * s.vessel.radius_m};
    const double dx = 0.2 * s.vessel.radius_m;
    ShownParticles blood = ball_of_particles(3 * s.vessel.radius_m, dx); // fills the junction and more
    const double cell = dx / 2;
    const auto farthest = [&](const pictures::WallShape& shape) {
        const pictures::Lumen lumen{vessel, shape, 0.1 * dx, 0};
        double most = -1e9;
        const auto surface = pictures::blood_surface(blood, dx, &lumen, cell);
        for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i) {
            most = std::max(most, pictures::outside(vessel, shape, point(*surface, i)));
        }
        return most;
    };
    // Linear between two points of the grid, a distance is off by its bend, at most 2 / blend.
    const double bend = cell * cell / 8 * (2 / (s.vessel.sac_smoothing_radii * s.vessel.radius_m));
    BOOST_TEST(farthest({R, std::nullopt}) <= -0.1 * dx + bend + float_rounding);
    BOOST_TEST(farthest({R, breach}) > 0.5 * breach.radius);
}

BOOST_AUTO_TEST_CASE(colors_span_round_numbers)
{
    ShownParticles blood = ball_of_particles(8, 1);
    for (std::size_t i = 0; i < blood.size(); ++i) {
        blood.velocity.push_back({0, 9.3 * static_cast<double>(i) / static_cast<double>(blood.size()), 0});
        blood.pressure.push_back(i == 0 ? 1e9 : 41000); // one in thousands does not count
    }
    pictures::RangeFinder speed(pictures::Quantity::speed);
    speed.add(blood);
    BOOST_TEST(speed.range().low == 0);
    BOOST_TEST(speed.range().high == 10);
    pictures::RangeFinder pressure(pictures::Quantity::pressure);
    pressure.add(blood);
    BOOST_TEST(pressure.range().low <= 41);
    BOOST_TEST(pressure.range().high >= 41);
    BOOST_TEST(pressure.range().high < 42);
    BOOST_TEST(pressure.range().low < pressure.range().high);
}
