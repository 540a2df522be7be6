// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/ghost.hpp"

#include "common/error.hpp"
#include "common/vessel/initial_state.hpp"

#include <algorithm>

namespace aneurysm::bounds
{
namespace
{

/// Wider than the rounding of any distance: 100 operations on the largest coordinate.
double widest(const Vessel& vessel, const Rounding& rounding)
{
    double extent = 2 * length(vessel.extent());
    for (std::size_t k = 0; k < vessel.openings().size(); ++k) {
        const Opening& end = vessel.openings().at(k);
        extent = std::max(extent, vessel.is_open(k) ? length(end.center) + 2 * end.radius : 0);
    }
    return rounding.absolute(100 * extent);
}

} // namespace

Truth contains(const Breach& breach, const InexactVec& x, const Rounding& rounding)
{
    const InexactVec d = x - rounded(breach.center);
    const Inexact radius = rounded(breach.radius);
    return is_positive(d.y + radius, rounding) &&
           is_positive(radius * radius - (d.x * d.x + d.z * d.z), rounding);
}

GhostBounds::GhostBounds(const Scenario& scenario, const WallBounds& wall, double dx, double support,
                         double mass, const Rounding& rounding)
    : wall_(&wall), dx_(dx), support_(support), mass_(mass), rounding_(rounding),
      margin_(widest(wall.vessel(), rounding)),
      candidates_(ghost_lattice(scenario, wall.vessel(), dx, support + margin_, mass))
{
}

/// Whether rounding decides if there is a ghost at x.
bool GhostBounds::may_differ(const InexactVec& x, const Inexact& distance, const reference::Wall& wall) const
{
    const bool at_edge = is_positive(rounded(support_) - distance, rounding_) == Truth::open;
    return at_edge || (wall.breach && contains(*wall.breach, x, rounding_) == Truth::open);
}

/// Of clamp(1/2 + d/dx, 0, 1).
double GhostBounds::fraction_error(const Inexact& distance) const
{
    const Inexact fraction = Inexact{0.5, 0} + distance / rounded(dx_);
    const bool clamped = is_positive(fraction - Inexact{1, 0}, rounding_) == Truth::yes;
    return clamped ? 0 : fraction.error;
}

InexactGhosts GhostBounds::at(const reference::Wall& wall) const
{
    InexactGhosts result{wall.ghosts, {}, {}};
    const Inexact R = rounded(wall.radius);
    const auto add = [&](const Vec3& place, double mass, bool present) {
        const InexactVec x = rounded(place);
        const Inexact distance = wall_->wall(x, R).value;
        const bool open = may_differ(x, distance, wall);
        if (!present && !open) {
            return;
        }
        if (!present) {
            result.ghosts.position.push_back(place);
            result.ghosts.mass.push_back(0);
        }
        result.position_error.push_back(length(place));
        result.mass_error.push_back(open ? rounding_.units(mass_)
                                         : mass_ * fraction_error(distance) + 2 * mass);
    };
    for (std::size_t k = 0; k < wall.ghosts.size(); ++k) {
        add(wall.ghosts.position[k], wall.ghosts.mass[k], true);
    }
    std::optional<Breach> breach = wall.breach;
    if (breach) {
        breach->radius -= margin_;
    }
    // Both lists follow the lattice; points are the same up to rounding.
    const WallGhosts all = candidates_.at(wall.radius, breach);
    std::size_t next = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (next < wall.ghosts.size() && length(all.position[k] - wall.ghosts.position[next]) < 0.5 * dx_) {
            ++next;
        } else {
            add(all.position[k], all.mass[k], false);
        }
    }
    if (next != wall.ghosts.size()) {
        throw Error("wall bounds", "a ghost of the reference was not found on the lattice",
                    "verification/bounds/ghost.cpp must follow common/vessel/sampling.cpp");
    }
    return result;
}

} // namespace aneurysm::bounds
