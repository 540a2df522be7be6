// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/wall.hpp"

#include "common/error.hpp"

#include <array>
#include <string>

namespace aneurysm::bounds
{
namespace
{

InexactDistance sphere(const InexactVec& x, const InexactVec& center, const Inexact& radius)
{
    const InexactVec offset = x - center;
    const Inexact r = norm(offset);
    if (!(r.value > 0)) {
        return {r - radius, inexact({0, 1, 0}, 0)};
    }
    return {r - radius, offset / r};
}

} // namespace

WallBounds::WallBounds(const Vessel& vessel, const Scenario& scenario, const Rounding& rounding)
    : vessel_(&vessel), rounding_(rounding),
      junction_smoothing_(scenario.vessel.junction_smoothing_radii * scenario.vessel.radius_m),
      sac_smoothing_(scenario.vessel.sac_smoothing_radii * scenario.vessel.radius_m),
      is_pear_(scenario.aneurysm.shape == SacShape::piriform)
{
    if (vessel.has_sac()) {
        neck_ratio_ = scenario.aneurysm.neck_width_radii / scenario.aneurysm.base_width_radii;
    }
}

InexactDistance WallBounds::tube(std::size_t k, const InexactVec& x) const
{
    const Opening& end = vessel_->openings()[k];
    const InexactVec axis = rounded(end.outward);
    const Inexact along = dot(x, axis);
    // max(along, 0) moves by no more than `along`.
    return sphere(x, Inexact{std::max(along.value, 0.0), along.error} * axis, rounded(end.radius));
}

/// Where both sides of a sharp edge are possible the gradient may be either.
InexactDistance WallBounds::blend(const InexactDistance& a, const InexactDistance& b, double width) const
{
    const Inexact way = b.value - a.value;
    if (width <= 0 || std::abs(way.value) >= width) {
        InexactDistance nearer = way.value > 0 ? a : b;
        if (width <= 0 && is_positive(way, rounding_) == Truth::open) {
            nearer.gradient = inexact(value_of(nearer.gradient), rounding_.units(2));
            nearer.value.error = std::max(a.value.error, b.value.error);
        }
        return nearer;
    }
    const Inexact w = rounded(width);
    const Inexact s = Inexact{0.5, 0} + Inexact{0.5, 0} * way / w;
    const Inexact rest = Inexact{1, 0} - s;
    const double value = b.value.value - way.value * s.value - width * s.value * rest.value;
    // The derivative of the value by s vanishes: it moves by the same blend of both errors; its own
    // operations round terms of at most |b|, |b - a| and width / 4.
    const double error = s.value * a.value.error + rest.value * b.value.error +
                         4 * (std::abs(b.value.value) + std::abs(way.value) + width / 4);
    return {{value, error}, s * a.gradient + rest * b.gradient};
}

/// Two plates, a round tube, or nothing.
InexactDistance WallBounds::straight_wall(const InexactVec& x) const
{
    const Vec3& edges = vessel_->extent();
    switch (vessel_->form()) {
    case DomainForm::channel: {
        const Inexact below = -x.y;
        const Inexact above = x.y - rounded(edges.y);
        return below.value > above.value ? InexactDistance{below, inexact({0, -1, 0}, 0)}
                                         : InexactDistance{above, inexact({0, 1, 0}, 0)};
    }
    case DomainForm::tube:
    case DomainForm::pipe:
        return sphere({x.x, Inexact{}, x.z}, inexact({}, 0), rounded(edges.x / 2));
    default:
        return {rounded(-Vessel::nowhere), inexact({}, 0)};
    }
}

InexactDistance WallBounds::tubes(const InexactVec& x) const
{
    if (vessel_->form() != DomainForm::artery) {
        return straight_wall(x);
    }
    return blend(tube(0, x), blend(tube(1, x), tube(2, x), junction_smoothing_), junction_smoothing_);
}

InexactDistance WallBounds::sac(const InexactVec& x, const Inexact& R) const
{
    if (is_pear_) {
        return pear(x, R);
    }
    // The center of the sphere lies R below the dome; both are computed as apex + c R.
    const Inexact apex = rounded(vessel_->apex());
    const Inexact c = rounded((vessel_->dome(R.value).y - R.value - apex.value) / R.value);
    return sphere(x, {Inexact{}, apex + c * R, Inexact{}}, R);
}

/// The flank's angle is that between the axis and the common tangent of the two spheres.
InexactDistance WallBounds::pear(const InexactVec& x, const Inexact& R) const
{
    const double H_ratio = (vessel_->dome(R.value).y - R.value - vessel_->apex()) / R.value;
    const double angle = std::asin(1 / std::hypot(H_ratio, neck_ratio_)) - std::atan2(neck_ratio_, H_ratio);
    const Inexact c = rounded(std::cos(angle));
    const Inexact s = rounded(std::sin(angle));
    const Inexact r_neck = rounded(neck_ratio_) * R * c;
    const Inexact H = rounded(H_ratio) * R;
    const Inexact apex = rounded(vessel_->apex());
    const Inexact across = norm({x.x, Inexact{}, x.z});
    const Inexact along = x.y - apex;
    const Inexact foot = along + across * (s / c);
    if (foot.value <= 0) {
        return sphere(x, {Inexact{}, apex, Inexact{}}, r_neck);
    }
    if (foot.value >= H.value) {
        return sphere(x, {Inexact{}, apex + H, Inexact{}}, R);
    }
    const bool off_axis = across.value > 0;
    const InexactVec radial = off_axis ? InexactVec{x.x / across, Inexact{}, x.z / across}
                                       : InexactVec{Inexact{1, 0}, Inexact{}, Inexact{}};
    return {across * c - along * s - r_neck, {c * radial.x, -s, c * radial.z}};
}

InexactDistance WallBounds::wall(const InexactVec& x, const Inexact& R) const
{
    const InexactDistance d = vessel_->has_sac() ? blend(tubes(x), sac(x, R), sac_smoothing_) : tubes(x);
    const double expected = vessel_->wall(value_of(x), R.value).value;
    // Both are computed in double: 2^-53 each.
    if (!(std::abs(d.value.value - expected) <= 1.01 * 0x1p-52 * d.value.error)) {
        throw Error("wall bounds",
                    "another distance than the vessel's, by " + std::to_string(d.value.value - expected) +
                        " m",
                    "verification/bounds/wall.cpp must follow common/vessel/geometry.hpp");
    }
    return d;
}

Inexact WallBounds::beyond(std::size_t k, const InexactVec& x) const
{
    const Opening& end = vessel_->openings()[k];
    return dot(x - rounded(end.center), rounded(end.outward));
}

Truth WallBounds::is_nearest(std::size_t k, const InexactVec& x) const
{
    if (vessel_->form() != DomainForm::artery) {
        const Truth upper = is_positive(x.y - rounded(vessel_->extent().y / 2), rounding_);
        return k == 0 ? !upper : k == 1 ? upper : Truth::no;
    }
    const Inexact own = tube(k, x).value;
    Truth nearest = Truth::yes;
    for (std::size_t other = 0; other < 3; ++other) {
        if (other != k) {
            nearest = nearest && is_positive(tube(other, x).value - own, rounding_);
        }
    }
    return nearest;
}

Truth WallBounds::is_beyond_nearest(const InexactVec& x, const Inexact& threshold) const
{
    std::array<Truth, 3> beyond{};
    for (std::size_t k = 0; k < 3; ++k) {
        beyond.at(k) = is_positive(this->beyond(k, x) - threshold, rounding_);
    }
    if (beyond[0] == beyond[1] && beyond[1] == beyond[2]) {
        return beyond[0];
    }
    bool yes = false;
    bool no = false;
    for (std::size_t k = 0; k < 3; ++k) {
        if (is_nearest(k, x) != Truth::no) {
            yes = yes || beyond.at(k) != Truth::no;
            no = no || beyond.at(k) != Truth::yes;
        }
    }
    return yes && no ? Truth::open : (yes ? Truth::yes : Truth::no);
}

} // namespace aneurysm::bounds
