// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/particles.hpp"
#include "common/vessel/geometry.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace aneurysm
{

/// Layers of blood in the buffer behind each open end.
constexpr int opening_layers = 3;

/// Particle positions on one cubic lattice of the given spacing, aligned with the parent's axis and the inlet
/// plane; in the inlet's buffer each column is shifted along the axis.
struct Lattice {
    double spacing = 0;                        ///< dx [m]
    std::vector<Vec3> fluid;                   ///< inside the wall
    std::array<std::vector<Vec3>, 3> openings; ///< buffers of inlet and outlets, `opening_layers` deep

    std::size_t size() const
    {
        return fluid.size() + openings[0].size() + openings[1].size() + openings[2].size();
    }
};

/// The lattice of spacing dx in the vessel with a sac of radius R.
Lattice sample_lattice(const Vessel& vessel, double R, double dx);

/// The coarsest lattice that leaves at most `reserve_fraction` of `count` particles over; where whole layers
/// come in at once and that is more than `count`, the finest with fewer. Found by bisection, the same on
/// every machine. \throws InputError (at `particles.count`) when the spacing would not resolve the daughters:
/// count is too few
Lattice sample_count(const Vessel& vessel, double R, std::size_t count, double reserve_fraction,
                     double daughter_radius);

/// A round hole at the top of the sac, open upwards through the whole depth of the wall.
struct Breach {
    Vec3 center;       ///< of the hole, on the wall [m]
    double radius = 0; ///< [m]

    bool contains(const Vec3& x) const
    {
        const Vec3 d = x - center;
        return d.y > -radius && d.x * d.x + d.z * d.z < radius * radius;
    }
};

/// The wall's ghost particles (27) on the fluid's lattice, which hold as much mass as their cell has volume
/// outside the wall: m clamp(1/2 + d/dx, 0, 1) at distance d. So density stays
/// smooth while the wall of the sac moves.
class GhostLattice
{
public:
    /// `support`: how deep the fluid sees into the wall [m].
    GhostLattice(const Vessel& vessel, double R_smallest, double R_largest, double dx, double support,
                 double mass);

    /// Ghosts for a sac of radius R, in a fixed order; none inside the breach.
    WallGhosts at(double R, const std::optional<Breach>& breach) const;

    /// Those that the sac doesn't reach, the same for every R.
    const WallGhosts& fixed() const { return fixed_; }
    /// Where there is a ghost for some R only, or one whose mass depends on R [m].
    const std::vector<Vec3>& near_sac() const { return near_sac_; }

private:
    double fraction(double distance) const;

    const Vessel* vessel_;
    double dx_;
    double support_;
    double mass_;
    WallGhosts fixed_;           ///< out of the sac's reach
    std::vector<Vec3> near_sac_; ///< lattice points whose distance changes with R
};

} // namespace aneurysm
