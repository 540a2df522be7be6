// SPDX-License-Identifier: Apache-2.0
#include "common/geometry.hpp"

#include "common/portable_math.hpp"

#include <algorithm>
#include <numbers>

namespace aneurysm
{
namespace
{
constexpr double piriform_length = 1.5; ///< neck plane to centre of the pear's body, in R (assumed)
} // namespace

template <>
VesselT<double>::VesselT(const Scenario& scenario, double daughter_radius)
    : shape_(scenario.aneurysm.shape),
      junction_smoothing_(scenario.vessel.junction_smoothing_radii * scenario.vessel.radius_m),
      sac_smoothing_(scenario.vessel.sac_smoothing_radii * scenario.vessel.radius_m)
{
    const double r_0 = scenario.vessel.radius_m;
    const double B = scenario.vessel.angle_deg * std::numbers::pi / 180;
    const Vec3 left{-sine(B), cosine(B), 0};
    const Vec3 right{sine(B), cosine(B), 0};
    const double L_0 = scenario.vessel.parent_length_radii * r_0;
    const double L_1 = scenario.vessel.daughter_length_radii * r_0;
    openings_ = {Opening{{0, -L_0, 0}, {0, -1, 0}, r_0}, Opening{L_1 * left, left, daughter_radius},
                 Opening{L_1 * right, right, daughter_radius}};

    double inside = 0;
    double outside = 2 * (daughter_radius + junction_smoothing_) / sine(B);
    for (int bisection = 0; bisection < 60; ++bisection) {
        apex_ = 0.5 * (inside + outside);
        (tubes({0, apex_, 0}).value < 0 ? inside : outside) = apex_;
    }
    if (!has_sac()) {
        return;
    }
    largest_radius_ = 0.5 * scenario.aneurysm.base_width_radii * r_0;
    neck_ratio_ = scenario.aneurysm.neck_width_radii / scenario.aneurysm.base_width_radii;
    if (shape_ == SacShape::piriform) {
        center_ = piriform_length;
        // From H sin(angle) + neck cos(angle) = R: the flank has the neck's width in the neck plane.
        const double angle =
            arcsine(1 / std::sqrt(piriform_length * piriform_length + neck_ratio_ * neck_ratio_)) -
            arctangent(neck_ratio_, piriform_length);
        cone_sine_ = sine(angle);
        cone_cosine_ = cosine(angle);
    } else {
        center_ = std::sqrt(std::max(0.0, 1 - neck_ratio_ * neck_ratio_));
    }
}

} // namespace aneurysm
