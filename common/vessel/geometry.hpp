// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/host_device.hpp"
#include "common/scenario/scenario.hpp"
#include "common/vec3.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace aneurysm
{

/// Signed distance to a wall, negative inside the lumen, and its gradient, which points outwards.
template <class Real>
struct DistanceT {
    Real value = 0;       ///< [m]
    Vec3T<Real> gradient; ///< of length 1, but a little less where surfaces are blended
};
using Distance = DistanceT<double>;

/// An open end of the artery.
template <class Real>
struct OpeningT {
    Vec3T<Real> center;  ///< where the tube's axis meets the end plane [m]
    Vec3T<Real> outward; ///< unit vector along the axis, out of the artery
    Real radius = 0;     ///< [m]

    /// How far x lies beyond the end plane [m]; negative inside.
    ANEURYSM_HD Real beyond(const Vec3T<Real>& x) const { return dot(x - center, outward); }
};
using Opening = OpeningT<double>;

/// Smooth union of two distances: their minimum, blended where they differ by less than `width`.
template <class Real>
ANEURYSM_HD DistanceT<Real> smooth_union(const DistanceT<Real>& a, const DistanceT<Real>& b, Real width)
{
    if (width <= 0 || std::abs(a.value - b.value) >= width) {
        return a.value < b.value ? a : b;
    }
    const Real half = Real(1) / 2;
    const Real s = half + half * (b.value - a.value) / width;
    // d value / d s vanishes for this s, so the gradient is the same blend.
    return {b.value + (a.value - b.value) * s - width * s * (1 - s), s * a.gradient + (1 - s) * b.gradient};
}

/// The branching artery with a sac at its apex, as a signed distance function (section 3.4, Table 2, Fig. 6).
///
/// The parent tube comes up along +y from the inlet to the origin; two equal daughters leave it in the x-y
/// plane at the angle B to +y. The sac is a body of revolution around +y that scales with its radius R. Its
/// neck plane lies at the apex, where the wall between the daughters crosses the y axis:
///   hemispherical, spherical: the part above the neck plane of a sphere of radius R that the plane cuts
///                             in a circle of the neck's width;
///   piriform:                 a cone from the neck's width into a sphere of radius R, 1.5 R higher up
///                             (assumed: the paper gives no length).
/// Tubes and sac are joined by polynomial smooth unions. In the other forms of a domain the tubes are two
/// plates, one straight tube, or no wall at all, whose distance is -nowhere; x and z of a tube are 0 on its
/// axis, all other coordinates begin at 0. An end that isn't open is nowhere. Radii are plain numbers:
/// Murray's law is the caller's. Every function that takes a place needs only + - * / and roots, so that it
/// gives the same bits on a CPU and on a GPU.
template <class Real>
class VesselT
{
public:
    using Vector = Vec3T<Real>;
    static constexpr Real nowhere = 1e6; ///< farther away than anything is [m]

    VesselT(const Scenario& scenario, double daughter_radius);

    /// The same vessel in another precision.
    template <class Other>
    explicit VesselT(const VesselT<Other>& v)
        : form_(v.form_), shape_(v.shape_), junction_smoothing_(static_cast<Real>(v.junction_smoothing_)),
          sac_smoothing_(static_cast<Real>(v.sac_smoothing_)), neck_ratio_(static_cast<Real>(v.neck_ratio_)),
          largest_radius_(static_cast<Real>(v.largest_radius_)), center_(static_cast<Real>(v.center_)),
          cone_sine_(static_cast<Real>(v.cone_sine_)), cone_cosine_(static_cast<Real>(v.cone_cosine_)),
          apex_(static_cast<Real>(v.apex_))
    {
        const auto vector = [](const Vec3T<Other>& a) {
            return Vector{static_cast<Real>(a.x), static_cast<Real>(a.y), static_cast<Real>(a.z)};
        };
        extent_ = vector(v.extent_);
        period_ = vector(v.period_);
        for (std::size_t k = 0; k < 3; ++k) {
            const OpeningT<Other>& o = v.openings_[k];
            openings_[k] = {vector(o.center), vector(o.outward), static_cast<Real>(o.radius)};
        }
    }

    /// Distance to the tubes alone [m].
    ANEURYSM_HD DistanceT<Real> tubes(const Vector& x) const
    {
        return form_ == DomainForm::artery
                   ? smooth_union(tube(0, x), smooth_union(tube(1, x), tube(2, x), junction_smoothing_),
                                  junction_smoothing_)
                   : straight_wall(x);
    }
    /// Distance to the sac alone, at radius R [m]. Only with a sac.
    ANEURYSM_HD DistanceT<Real> sac(const Vector& x, Real R) const
    {
        return shape_ == SacShape::piriform ? pear(x, R) : sphere(x, {0, center_height(R), 0}, R);
    }
    /// Distance to the whole wall [m]. R is ignored without a sac.
    ANEURYSM_HD DistanceT<Real> wall(const Vector& x, Real R) const
    {
        return has_sac() ? smooth_union(tubes(x), sac(x, R), sac_smoothing_) : tubes(x);
    }

    ANEURYSM_HD DomainForm form() const { return form_; }
    /// Edges of the lattice's cells, from the seam, wall or open end at one side to that at the other; not of
    /// an artery [m].
    ANEURYSM_HD const Vector& extent() const { return extent_; }
    /// Edge of the box in each direction in which it repeats itself, else 0 [m].
    ANEURYSM_HD const Vector& period() const { return period_; }
    /// x, or where it is once more within the periodic box, from 0 to less than its edge; x isn't more than a
    /// box away from it.
    ANEURYSM_HD Vector wrapped(const Vector& x) const
    {
        return {wrapped(x.x, period_.x), wrapped(x.y, period_.y), wrapped(x.z, period_.z)};
    }

    ANEURYSM_HD bool has_sac() const { return shape_ != SacShape::none; }
    ANEURYSM_HD Real apex() const { return apex_; } ///< y of the neck plane [m]
    /// R of the fully developed sac [m]
    ANEURYSM_HD Real largest_radius() const { return largest_radius_; }
    /// The sac's highest point [m]
    ANEURYSM_HD Vector dome(Real R) const { return {0, center_height(R) + R, 0}; }

    /// 0: inlet; 1, 2: outlets at -x and +x.
    ANEURYSM_HD const std::array<OpeningT<Real>, 3>& openings() const { return openings_; }
    ANEURYSM_HD bool is_open(std::size_t k) const { return openings_[k].radius > 0; }
    /// The tube whose wall or axis is nearest to x; the only opening that x can be beyond.
    ANEURYSM_HD std::size_t nearest_tube(const Vector& x) const
    {
        if (form_ != DomainForm::artery) {
            return x.y > extent_.y / 2 ? 1 : 0;
        }
        std::size_t nearest = 0;
        Real least = tube(0, x).value;
        for (std::size_t k = 1; k < 3; ++k) {
            const Real distance = tube(k, x).value;
            if (distance < least) {
                least = distance;
                nearest = k;
            }
        }
        return nearest;
    }
    /// Whether x is on the artery's side of its nearest tube's end plane.
    ANEURYSM_HD bool between_openings(const Vector& x) const
    {
        return openings_[nearest_tube(x)].beyond(x) <= 0;
    }

private:
    template <class Other>
    friend class VesselT;

    void make_straight(const Scenario& scenario);
    /// Two plates, a round tube, or nothing.
    ANEURYSM_HD DistanceT<Real> straight_wall(const Vector& x) const
    {
        if (form_ == DomainForm::channel) {
            const Real above = x.y - extent_.y;
            return -x.y > above ? DistanceT<Real>{-x.y, {0, -1, 0}} : DistanceT<Real>{above, {0, 1, 0}};
        }
        if (form_ == DomainForm::tube || form_ == DomainForm::pipe) {
            return sphere({x.x, 0, x.z}, {}, extent_.x / 2);
        }
        return {-nowhere, {}};
    }
    ANEURYSM_HD static Real wrapped(Real x, Real period)
    {
        const Real y = x < 0 ? x + period : x;
        return period > 0 && y >= period ? y - period : y; // rounding may have led to the very edge
    }
    ANEURYSM_HD static DistanceT<Real> sphere(const Vector& x, const Vector& center, Real radius)
    {
        const Vector offset = x - center;
        const Real r = length(offset);
        return {r - radius, r > 0 ? offset / r : Vector{0, 1, 0}};
    }
    /// A tube is a half-infinite cylinder with a spherical end at
    /// the origin; the openings only cut the blood.
    ANEURYSM_HD DistanceT<Real> tube(std::size_t k, const Vector& x) const
    {
        const Vector& axis = openings_[k].outward;
        const Real along = dot(x, axis);
        return sphere(x, (along > 0 ? along : Real(0)) * axis, openings_[k].radius);
    }
    ANEURYSM_HD Real center_height(Real R) const { return apex_ + center_ * R; }

    /// Convex hull of two spheres on the y axis: the neck's at the apex, and one of radius R above it.
    ANEURYSM_HD DistanceT<Real> pear(const Vector& x, Real R) const
    {
        const Real r_neck = neck_ratio_ * R * cone_cosine_;
        const Real H = center_ * R;
        const Real across = std::sqrt(x.x * x.x + x.z * x.z);
        const Real along = x.y - apex_;
        // Height at which the normal of the flank through x starts on the axis.
        const Real foot = along + across * (cone_sine_ / cone_cosine_);
        if (foot <= 0) {
            return sphere(x, {0, apex_, 0}, r_neck);
        }
        if (foot >= H) {
            return sphere(x, {0, apex_ + H, 0}, R);
        }
        const Vector radial = across > 0 ? Vector{x.x / across, 0, x.z / across} : Vector{1, 0, 0};
        return {across * cone_cosine_ - along * cone_sine_ - r_neck,
                Vector{cone_cosine_ * radial.x, -cone_sine_, cone_cosine_ * radial.z}};
    }

    DomainForm form_;
    Vector extent_{};
    Vector period_{};
    SacShape shape_;
    Real junction_smoothing_;
    Real sac_smoothing_;
    std::array<OpeningT<Real>, 3> openings_;
    Real neck_ratio_ = 0; ///< neck half width / R
    Real largest_radius_ = 0;
    Real center_ = 0;    ///< height of the sac's body above the neck plane, in R
    Real cone_sine_ = 0; ///< of the angle of the pear's flank against its axis
    Real cone_cosine_ = 1;
    Real apex_ = 0;
};

using Vessel = VesselT<double>;

} // namespace aneurysm
