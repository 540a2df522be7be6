// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/blood_surface.hpp"

#include "output/pictures/grid.hpp"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aneurysm::pictures
{
namespace
{

/// Radius of a ball of a particle's volume [spacings].
const double drop_radius = std::cbrt(3 / (4 * std::numbers::pi));

/// Calls visit(i, j, k, r^2) for the grid's points within `range` of x.
template <class Visit>
void for_each_point(const Grid& grid, const Vec3& x, double range, const Visit& visit)
{
    const Vec3 low = x - grid.point(0, 0, 0);
    const auto span = [&](double at, int points) {
        return std::pair(std::max(0, static_cast<int>(std::ceil((at - range) / grid.cell()))),
                         std::min(points - 1, static_cast<int>(std::floor((at + range) / grid.cell()))));
    };
    const auto [i_0, i_1] = span(low.x, grid.extent()[0]);
    const auto [j_0, j_1] = span(low.y, grid.extent()[1]);
    const auto [k_0, k_1] = span(low.z, grid.extent()[2]);
    for (int k = k_0; k <= k_1; ++k) {
        for (int j = j_0; j <= j_1; ++j) {
            for (int i = i_0; i <= i_1; ++i) {
                const Vec3 d = grid.point(i, j, k) - x;
                const double square = dot(d, d);
                if (square < range * range) {
                    visit(i, j, k, square);
                }
            }
        }
    }
}

/// Sums of the weights, about 1 inside the blood.
void add_weights(Grid& grid, const output::ShownParticles& particles, double spacing)
{
    const double H = blood_support * spacing;
    const double most = 315 / (64 * std::numbers::pi * blood_support * blood_support * blood_support);
    for (const Vec3& x : particles.position) {
        for_each_point(grid, x, H, [&](int i, int j, int k, double square) {
            const double rest = 1 - square / (H * H);
            grid.at(i, j, k) += static_cast<float>(most * rest * rest * rest);
        });
    }
}

/// Depth below the surface [m], from the slope that the sum has at a plane one.
double depth_of(double sum, double spacing)
{
    constexpr double slope = 315.0 / 256; // of the weight's integral over planes, in 1/H
    return (sum - 0.5) * blood_support * spacing / slope;
}

/// How far x lies inside of what the lumen allows [m].
double room(const Lumen& lumen, const Vec3& x)
{
    const double in_vessel = -outside(lumen.vessel, lumen.shape, x) - lumen.gap;
    if (!lumen.shape.breach) {
        return in_vessel;
    }
    return std::max(in_vessel, lumen.shape.breach->radius - length(x - lumen.shape.breach->center));
}

/// From sums to minus the depth, inside the lumen.
void keep_inside(Grid& grid, double spacing, const Lumen* lumen)
{
    const auto [n_x, n_y, n_z] = grid.extent();
    for (int k = 0; k < n_z; ++k) {
        for (int j = 0; j < n_y; ++j) {
            for (int i = 0; i < n_x; ++i) {
                float& value = grid.at(i, j, k);
                double depth = depth_of(value, spacing);
                if (lumen != nullptr && value > 0) {
                    depth = std::min(depth + lumen->swell, room(*lumen, grid.point(i, j, k)));
                }
                value = static_cast<float>(-depth);
            }
        }
    }
}

/// The lesser of two distances, rounded where they differ by less than `width`.
double smooth_least(double a, double b, double width)
{
    const double part = std::max(0.0, 1 - std::abs(a - b) / width);
    return std::min(a, b) - part * part * width / 4;
}

/// Blood beyond the wall: each particle is a drop, and those that touch flow into one another.
void add_escaped(Grid& grid, const output::ShownParticles& particles, double spacing)
{
    const double radius = drop_radius * spacing;
    const double width = 0.5 * spacing;
    for (std::size_t n = 0; n < particles.size(); ++n) {
        if (particles.kind[n] == Kind::escaped) {
            for_each_point(
                grid, particles.position[n], radius + width, [&](int i, int j, int k, double square) {
                    float& value = grid.at(i, j, k);
                    value = static_cast<float>(smooth_least(value, std::sqrt(square) - radius, width));
                });
        }
    }
}

Box box_around(const output::ShownParticles& particles, double margin)
{
    Box box{particles.position.at(0), particles.position.at(0)};
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.is_blood(i)) {
            box.include(particles.position[i], margin);
        }
    }
    return box;
}

} // namespace

vtkSmartPointer<vtkPolyData> blood_surface(const output::ShownParticles& particles, double spacing,
                                           const Lumen* lumen, double cell)
{
    if (particles.size() == 0) {
        return vtkSmartPointer<vtkPolyData>::New();
    }
    Grid grid(box_around(particles, spacing + 2 * cell), cell);
    grid.fill([](const Vec3&) { return 0.0; });
    add_weights(grid, particles, spacing);
    keep_inside(grid, spacing, lumen);
    add_escaped(grid, particles, spacing);
    return grid.zero();
}

} // namespace aneurysm::pictures
