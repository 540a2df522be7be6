// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario.hpp"
#include "common/vec3.hpp"

#include <array>
#include <vector>

namespace aneurysm
{

/// Signed distance to a wall, negative inside the lumen, and its gradient, which points outwards.
struct Distance {
    double value = 0; ///< [m]
    Vec3 gradient;    ///< of length 1, but a little less where surfaces are blended
};

/// An open end of the artery.
struct Opening {
    Vec3 center;       ///< where the tube's axis meets the end plane [m]
    Vec3 outward;      ///< unit vector along the axis, out of the artery
    double radius = 0; ///< [m]

    /// How far x lies beyond the end plane [m]; negative inside.
    double beyond(const Vec3& x) const { return dot(x - center, outward); }
};

/// The branching artery with a sac at its apex, as a signed distance function (section 3.4, Table 2, Fig. 6).
///
/// The parent tube comes up along +y from the inlet to the origin; two equal daughters leave it in the x-y
/// plane at the angle B to +y. The sac is a body of revolution around +y that scales with its radius R. Its
/// neck plane lies at the apex, where the wall between the daughters crosses the y axis:
///   hemispherical, spherical: the part above the neck plane of a sphere of radius R that the plane cuts in a
///   circle
///                             of the neck's width;
///   piriform:                 a cone from the neck's width into a sphere of radius R, 1.5 R higher up
///   (assumed: the
///                             paper gives no length).
/// Tubes and sac are joined by polynomial smooth unions. Radii are plain numbers: Murray's law is the
/// caller's.
class Vessel
{
public:
    Vessel(const Scenario& scenario, double daughter_radius);

    /// Distance to the tubes alone [m].
    Distance tubes(const Vec3& x) const;
    /// Distance to the sac alone, at radius R [m]. Only with a sac.
    Distance sac(const Vec3& x, double R) const;
    /// Distance to the whole wall [m]. R is ignored without a sac.
    Distance wall(const Vec3& x, double R) const;

    bool has_sac() const { return shape_ != SacShape::none; }
    double apex() const { return apex_; }                     ///< y of the neck plane [m]
    double largest_radius() const { return largest_radius_; } ///< R of the fully developed sac [m]
    Vec3 dome(double R) const;                                ///< the sac's highest point [m]

    /// 0: inlet; 1, 2: outlets at -x and +x.
    const std::array<Opening, 3>& openings() const { return openings_; }
    /// The tube whose wall or axis is nearest to x; the only opening that x can be beyond.
    std::size_t nearest_tube(const Vec3& x) const;
    /// Whether x is on the artery's side of its nearest tube's end plane.
    bool between_openings(const Vec3& x) const;

private:
    Distance tube(std::size_t k, const Vec3& x) const;
    double body_center_height(double R) const;

    SacShape shape_;
    double parent_radius_;
    double junction_smoothing_;
    double sac_smoothing_;
    std::array<Opening, 3> openings_;
    double neck_ratio_ = 0; ///< neck half width / R
    double largest_radius_ = 0;
    double cone_angle_ = 0; ///< of the pear's flank against its axis [rad]
    double apex_ = 0;
};

/// Smooth union of two distances: their minimum, blended where they differ by less than `width`.
Distance smooth_union(const Distance& a, const Distance& b, double width);

} // namespace aneurysm
