// SPDX-License-Identifier: Apache-2.0
#include "common/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aneurysm
{
namespace
{
constexpr double piriform_length = 1.5; ///< neck plane to centre of the pear's body, in R (assumed)

Distance sphere(const Vec3& x, const Vec3& center, double radius)
{
    const Vec3 offset = x - center;
    const double r = length(offset);
    return {r - radius, r > 0 ? offset / r : Vec3{0, 1, 0}};
}

/// Convex hull of two spheres on the y axis: radius r_0 at height y_0, r_1 at y_0 + H. `angle`: of the flank.
Distance round_cone(const Vec3& x, double y_0, double r_0, double H, double r_1, double angle)
{
    const double across = std::hypot(x.x, x.z);
    const double along = x.y - y_0;
    // Height at which the normal of the flank through x starts on the axis.
    const double foot = along + across * std::tan(angle);
    if (foot <= 0) {
        return sphere(x, {0, y_0, 0}, r_0);
    }
    if (foot >= H) {
        return sphere(x, {0, y_0 + H, 0}, r_1);
    }
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const Vec3 radial = across > 0 ? Vec3{x.x / across, 0, x.z / across} : Vec3{1, 0, 0};
    return {across * c - along * s - r_0, Vec3{c * radial.x, -s, c * radial.z}};
}

} // namespace

Distance smooth_union(const Distance& a, const Distance& b, double width)
{
    if (width <= 0 || std::abs(a.value - b.value) >= width) {
        return a.value < b.value ? a : b;
    }
    const double s = 0.5 + 0.5 * (b.value - a.value) / width;
    // d value / d s vanishes for this s, so the gradient is the same blend.
    return {b.value + (a.value - b.value) * s - width * s * (1 - s), s * a.gradient + (1 - s) * b.gradient};
}

Vessel::Vessel(const Scenario& scenario, double daughter_radius)
    : shape_(scenario.aneurysm.shape), parent_radius_(scenario.vessel.radius_m),
      junction_smoothing_(scenario.vessel.junction_smoothing_radii * parent_radius_),
      sac_smoothing_(scenario.vessel.sac_smoothing_radii * parent_radius_)
{
    const double r_0 = parent_radius_;
    const double B = scenario.vessel.angle_deg * std::numbers::pi / 180;
    const Vec3 left{-std::sin(B), std::cos(B), 0};
    const Vec3 right{std::sin(B), std::cos(B), 0};
    const double L_0 = scenario.vessel.parent_length_radii * r_0;
    const double L_1 = scenario.vessel.daughter_length_radii * r_0;
    openings_ = {Opening{{0, -L_0, 0}, {0, -1, 0}, r_0}, Opening{L_1 * left, left, daughter_radius},
                 Opening{L_1 * right, right, daughter_radius}};

    double inside = 0;
    double outside = 2 * (daughter_radius + junction_smoothing_) / std::sin(B);
    for (int bisection = 0; bisection < 60; ++bisection) {
        apex_ = 0.5 * (inside + outside);
        (tubes({0, apex_, 0}).value < 0 ? inside : outside) = apex_;
    }
    if (has_sac()) {
        largest_radius_ = 0.5 * scenario.aneurysm.base_width_radii * r_0;
        neck_ratio_ = scenario.aneurysm.neck_width_radii / scenario.aneurysm.base_width_radii;
        // From H sin(angle) + neck cos(angle) = R: the flank has the neck's width in the neck plane.
        cone_angle_ = std::asin(1 / std::hypot(piriform_length, neck_ratio_)) -
                      std::atan2(neck_ratio_, piriform_length);
    }
}

/// A tube is a half-infinite cylinder with a spherical end at the origin; the openings only cut the blood.
Distance Vessel::tube(std::size_t k, const Vec3& x) const
{
    const Vec3& axis = openings_[k].outward;
    return sphere(x, std::max(0.0, dot(x, axis)) * axis, openings_[k].radius);
}

Distance Vessel::tubes(const Vec3& x) const
{
    return smooth_union(tube(0, x), smooth_union(tube(1, x), tube(2, x), junction_smoothing_),
                        junction_smoothing_);
}

double Vessel::body_center_height(double R) const
{
    return apex_ + (shape_ == SacShape::piriform
                        ? piriform_length * R
                        : R * std::sqrt(std::max(0.0, 1 - neck_ratio_ * neck_ratio_)));
}

Distance Vessel::sac(const Vec3& x, double R) const
{
    if (shape_ == SacShape::piriform) {
        const double r_neck = neck_ratio_ * R * std::cos(cone_angle_);
        return round_cone(x, apex_, r_neck, piriform_length * R, R, cone_angle_);
    }
    return sphere(x, {0, body_center_height(R), 0}, R);
}

Distance Vessel::wall(const Vec3& x, double R) const
{
    return has_sac() ? smooth_union(tubes(x), sac(x, R), sac_smoothing_) : tubes(x);
}

Vec3 Vessel::dome(double R) const
{
    return {0, body_center_height(R) + R, 0};
}

std::size_t Vessel::nearest_tube(const Vec3& x) const
{
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < openings_.size(); ++k) {
        if (tube(k, x).value < tube(nearest, x).value) {
            nearest = k;
        }
    }
    return nearest;
}

bool Vessel::between_openings(const Vec3& x) const
{
    return openings_[nearest_tube(x)].beyond(x) <= 0;
}

} // namespace aneurysm
