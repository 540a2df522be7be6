// SPDX-License-Identifier: Apache-2.0
#include "output/wall_mesh.hpp"

#include "output/vtk.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numbers>
#include <utility>

namespace aneurysm::output
{
namespace
{

using Triangle = std::array<std::int64_t, 3>;

/// How far x is beyond the plane of its open end [m].
double beyond_ends(const Vessel& vessel, const Vec3& x)
{
    return vessel.openings()[vessel.nearest_tube(x)].beyond(x);
}

/// Positive inside a hole that is wider than the breach by as much as the middle of an edge, or of a
/// triangle, can lie nearer to its axis than the ends.
double inside_hole(const Breach& breach, double cell, const Vec3& x)
{
    const double half_edge = std::sqrt(3.0) * cell; // its ends are in cells that touch
    const double radius = std::sqrt(breach.radius * breach.radius + half_edge * half_edge);
    const Vec3 d = x - breach.center;
    return d.y > -breach.radius ? radius - std::sqrt(d.x * d.x + d.z * d.z) : -radius;
}

/// Finds the surface by surface nets (Gibson 1998): each cell of a grid that the surface passes has a corner,
/// each edge of the grid that it crosses a quad between the corners of the four cells around.
class Net
{
public:
    using Function = std::function<Distance(const Vec3&)>;

    Net(const Box& box, double cell, Function distance)
        : low_(box.low), cell_(cell), distance_(std::move(distance))
    {
        const Vec3 size = box.high - box.low;
        points_ = {1 + whole(size.x), 1 + whole(size.y), 1 + whole(size.z)};
        inside_.reserve(index(points_) + 1);
        for (Place p{}; p[2] < points_[2]; ++p[2]) {
            for (p[1] = 0; p[1] < points_[1]; ++p[1]) {
                for (p[0] = 0; p[0] < points_[0]; ++p[0]) {
                    inside_.push_back(distance_(at(p, 0)).value < 0);
                }
            }
        }
        add_corners();
        add_triangles();
    }

    WallMesh take() { return std::move(mesh_); }

private:
    using Place = std::array<std::size_t, 3>; ///< of a point, or of the cell above it in all directions

    std::size_t whole(double length) const { return static_cast<std::size_t>(std::ceil(length / cell_)); }
    std::size_t index(const Place& p) const { return (p[2] * points_[1] + p[1]) * points_[0] + p[0]; }
    Vec3 at(const Place& p, double shift) const
    {
        const auto along = [&](std::size_t axis) { return cell_ * (static_cast<double>(p[axis]) + shift); };
        return low_ + Vec3{along(0), along(1), along(2)};
    }
    /// The wall's point near x.
    Vec3 on_wall(Vec3 x) const
    {
        constexpr int most = 20; // each step leaves about the square of its distance
        Distance d = distance_(x);
        for (int step = 0; step < most && std::abs(d.value) > 1e-6 * cell_; ++step) {
            x -= d.value / dot(d.gradient, d.gradient) * d.gradient;
            d = distance_(x);
        }
        return x;
    }
    /// Calls `visit` for all places but those at the far sides of the grid.
    template <class Visit>
    void for_cells(const Visit& visit) const
    {
        for (Place p{}; p[2] + 1 < points_[2]; ++p[2]) {
            for (p[1] = 0; p[1] + 1 < points_[1]; ++p[1]) {
                for (p[0] = 0; p[0] + 1 < points_[0]; ++p[0]) {
                    visit(p);
                }
            }
        }
    }
    void add_corners()
    {
        corner_.assign(inside_.size(), -1);
        for_cells([&](const Place& p) {
            int count = 0;
            for (std::size_t k = 0; k < 8; ++k) {
                count += inside_[index({p[0] + k % 2, p[1] + k / 2 % 2, p[2] + k / 4})] ? 1 : 0;
            }
            if (count != 0 && count != 8) {
                corner_[index(p)] = static_cast<std::int64_t>(mesh_.corners.size());
                mesh_.corners.push_back(on_wall(at(p, 0.5)));
            }
        });
    }
    void add_triangles()
    {
        for_cells([&](const Place& p) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t b = (axis + 1) % 3;
                const std::size_t c = (axis + 2) % 3;
                Place next = p;
                ++next[axis];
                if (p[b] > 0 && p[c] > 0 && inside_[index(p)] != inside_[index(next)]) {
                    add_quad(p, b, c, inside_[index(p)]);
                }
            }
        });
    }
    /// Between the cells around the edge at p; `outwards`: the edge leads out of the vessel.
    void add_quad(const Place& p, std::size_t b, std::size_t c, bool outwards)
    {
        const auto corner = [&](std::size_t down_b, std::size_t down_c) {
            Place q = p;
            q[b] -= down_b;
            q[c] -= down_c;
            return corner_[index(q)];
        };
        std::array<std::int64_t, 4> quad{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        if (!outwards) {
            std::swap(quad[1], quad[3]);
        }
        const auto diagonal = [&](std::size_t i) {
            return length(mesh_.corners[static_cast<std::size_t>(quad[i])] -
                          mesh_.corners[static_cast<std::size_t>(quad[i + 2])]);
        };
        const std::size_t first = diagonal(0) <= diagonal(1) ? 0 : 1;
        mesh_.triangles.push_back({quad[first], quad[first + 1], quad[first + 2]});
        mesh_.triangles.push_back({quad[first + 2], quad[(first + 3) % 4], quad[first]});
    }

    Vec3 low_;
    double cell_;
    Function distance_;
    Place points_{};
    std::vector<bool> inside_;         ///< by point
    std::vector<std::int64_t> corner_; ///< by cell; -1: the surface doesn't pass it
    WallMesh mesh_;
};

/// The part of a mesh where the function is negative.
class Cut
{
public:
    Cut(const WallMesh& mesh, const std::function<double(const Vec3&)>& function) : mesh_(mesh)
    {
        for (const Vec3& x : mesh.corners) {
            values_.push_back(function(x));
        }
        for (const Triangle& t : mesh.triangles) {
            add(t);
        }
    }

    WallMesh take() { return std::move(rest_); }

private:
    double value(std::int64_t corner) const { return values_[static_cast<std::size_t>(corner)]; }
    Vec3 place(std::int64_t corner) const { return mesh_.corners[static_cast<std::size_t>(corner)]; }

    void add(const Triangle& t)
    {
        std::vector<std::int64_t> left;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int64_t a = t[i];
            const std::int64_t b = t[(i + 1) % 3];
            if (value(a) < 0) {
                left.push_back(number({a, a}));
            }
            if ((value(a) < 0) != (value(b) < 0)) {
                left.push_back(number(std::minmax(a, b)));
            }
        }
        for (std::size_t i = 2; i < left.size(); ++i) {
            rest_.triangles.push_back({left[0], left[i - 1], left[i]});
        }
    }
    /// Of a corner that stays, or of the one between a corner that stays and one that goes.
    std::int64_t number(std::pair<std::int64_t, std::int64_t> ends)
    {
        const auto [entry, is_new] = numbers_.try_emplace(ends, std::int64_t(rest_.corners.size()));
        if (is_new) {
            const auto [a, b] = ends;
            const double s = a == b ? 0 : value(a) / (value(a) - value(b));
            rest_.corners.push_back((1 - s) * place(a) + s * place(b));
        }
        return entry->second;
    }

    const WallMesh& mesh_;
    std::vector<double> values_;
    std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> numbers_;
    WallMesh rest_;
};

} // namespace

void Box::include(const Vec3& x, double margin)
{
    low = {std::min(low.x, x.x - margin), std::min(low.y, x.y - margin), std::min(low.z, x.z - margin)};
    high = {std::max(high.x, x.x + margin), std::max(high.y, x.y + margin), std::max(high.z, x.z + margin)};
}

Box box_of(const Vessel& vessel, double R)
{
    const Vec3& first = vessel.openings()[0].center;
    Box box{first, first};
    for (std::size_t k = 0; k < 3; ++k) {
        if (vessel.is_open(k)) {
            const auto& [center, axis, radius] = vessel.openings()[k];
            const auto across = [radius = radius](double along) {
                return radius * std::sqrt(std::max(0.0, 1 - along * along));
            };
            const Vec3 disc{across(axis.x), across(axis.y), across(axis.z)};
            box.include(center - disc);
            box.include(center + disc);
        }
    }
    if (vessel.has_sac()) {
        box.include(vessel.dome(R) - Vec3{0, R, 0}, R);
    }
    return box;
}

WallShape wall_shape(const Vessel& vessel, double radius, bool ruptured, double breach_radius)
{
    WallShape shape{radius, std::nullopt};
    if (ruptured) {
        shape.breach = Breach{vessel.dome(radius), breach_radius};
    }
    return shape;
}

WallMesh wall_mesh(const Vessel& vessel, const WallShape& shape, double cell)
{
    Box box = box_of(vessel, shape.radius);
    box.include(box.low, 3 * cell);
    box.include(box.high, 3 * cell);
    WallMesh mesh = Net(box, cell, [&](const Vec3& x) { return vessel.wall(x, shape.radius); }).take();
    mesh = Cut(mesh, [&](const Vec3& x) { return beyond_ends(vessel, x); }).take();
    if (shape.breach) {
        mesh = Cut(mesh, [&](const Vec3& x) { return inside_hole(*shape.breach, cell, x); }).take();
    }
    return mesh;
}

std::vector<Vec3> rim_of(const Opening& opening)
{
    constexpr int count = 96;
    const Vec3& axis = opening.outward;
    const Vec3 other = std::abs(axis.z) < 0.5 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 u = cross(other, axis) / length(cross(other, axis));
    const Vec3 v = cross(axis, u);
    std::vector<Vec3> corners;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        corners.push_back(opening.center + opening.radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return corners;
}

std::vector<Vec3> rim_of_breach(const Vessel& vessel, const WallShape& shape)
{
    const Breach& breach = shape.breach.value();
    Vec3 x = breach.center + Vec3{breach.radius, 0, 0};
    for (int step = 0; step < 8; ++step) { // down to the wall, by Newton's method
        const Distance d = vessel.wall(x, shape.radius);
        x.y -= d.value / d.gradient.y;
    }
    return rim_of({{breach.center.x, x.y, breach.center.z}, {0, 1, 0}, breach.radius});
}

void write_wall(const std::filesystem::path& file, const Vessel& vessel, const WallShape& shape)
{
    constexpr double cells = 8; // in an artery radius: chords are at most 1 % of it off
    const WallMesh mesh = wall_mesh(vessel, shape, vessel.openings()[0].radius / cells);
    Surface surface;
    surface.points = mesh.corners;
    const auto add = [&](const auto& corners, WallPart part) {
        surface.corners.insert(surface.corners.end(), corners.begin(), corners.end());
        surface.ends.push_back(static_cast<std::int64_t>(surface.corners.size()));
        surface.part.push_back(static_cast<std::uint8_t>(part));
    };
    for (const Triangle& t : mesh.triangles) {
        add(t, WallPart::wall);
    }
    const auto add_disc = [&](const std::vector<Vec3>& around, WallPart part) {
        std::vector<std::int64_t> numbers;
        for (const Vec3& x : around) {
            numbers.push_back(static_cast<std::int64_t>(surface.points.size()));
            surface.points.push_back(x);
        }
        add(numbers, part);
    };
    if (shape.breach) {
        add_disc(rim_of_breach(vessel, shape), WallPart::breach);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        add_disc(rim_of(vessel.openings()[k]),
                 static_cast<WallPart>(static_cast<std::size_t>(WallPart::inlet) + k));
    }
    write_vtk(file, surface, "0 wall, 1 breach, 2 inlet, 3 and 4 outlets");
}

} // namespace aneurysm::output
