// SPDX-License-Identifier: Apache-2.0
#include "common/vessel/geometry.hpp"

#include "common/portable_math.hpp"

#include <algorithm>
#include <numbers>

namespace aneurysm
{
namespace
{
constexpr double piriform_length = 1.5; ///< neck plane to center of the pear's body, in R (assumed)
} // namespace

template <>
void VesselT<double>::make_straight(const Scenario& scenario)
{
    const auto& d = scenario.domain;
    extent_ = d.spacing_m * Vec3{static_cast<double>(d.cells_x), static_cast<double>(d.cells_y),
                                 static_cast<double>(d.cells_z)};
    const bool round = form_ == DomainForm::tube || form_ == DomainForm::pipe;
    const bool open = form_ == DomainForm::duct || form_ == DomainForm::pipe;
    period_ = {round ? 0 : extent_.x, open || form_ == DomainForm::channel ? 0 : extent_.y,
               round ? 0 : extent_.z};
    const double radius = open ? extent_.x / 2 : 0;
    const Vec3 axis{round ? 0 : extent_.x / 2, 0, round ? 0 : extent_.z / 2};
    const Vec3 up{0, 1, 0};
    openings_ = {Opening{axis - (open ? 0 : nowhere) * up, -up, radius},
                 Opening{axis + (open ? extent_.y : nowhere) * up, up, radius}, Opening{nowhere * up, up, 0}};
}

template <>
VesselT<double>::VesselT(const Scenario& scenario, double daughter_radius)
    : form_(scenario.domain.form), shape_(scenario.aneurysm.shape),
      junction_smoothing_(scenario.vessel.junction_smoothing_radii * scenario.vessel.radius_m),
      sac_smoothing_(scenario.vessel.sac_smoothing_radii * scenario.vessel.radius_m)
{
    if (form_ != DomainForm::artery) {
        make_straight(scenario);
        return;
    }
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
