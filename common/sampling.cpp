// SPDX-License-Identifier: Apache-2.0
#include "common/sampling.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm
{
namespace
{
/// How deep a lattice point must lie inside the wall to hold a particle, in spacings. With 0 the lattice has
/// as many particles as the lumen has volume for, which is 1 % more than fit between curved walls; with 0.08
/// they just fit.
constexpr double seeding_inset = 0.08;

/// Integer bounds of the lattice points that can lie within `reach` of the lumen or its open ends.
struct Bounds {
    std::int64_t x = 0; ///< -x .. x - 1
    std::int64_t y = 0; ///< 0 .. y - 1, from `opening_layers` plus reach below the inlet plane
    std::int64_t z = 0; ///< -z .. z - 1
    double y_0 = 0;     ///< lower edge of the first cell [m]
};

Bounds bounds(const Vessel& vessel, double R, double dx, double reach)
{
    const auto& openings = vessel.openings();
    const double margin = reach + opening_layers * dx;
    Vec3 high{openings[0].radius, 0, openings[0].radius};
    for (const Opening& o : openings) {
        const Vec3 end = o.center + margin * o.outward;
        high.x = std::max(high.x, std::abs(end.x) + o.radius);
        high.y = std::max(high.y, end.y + o.radius);
    }
    if (vessel.has_sac()) {
        high = {std::max(high.x, R), std::max(high.y, vessel.dome(R).y), std::max(high.z, R)};
    }
    // Cells below the inlet plane are whole, so that the inlet's ghosts continue the fluid's lattice.
    const double below = std::ceil(margin / dx) + 1;
    const double y_0 = openings[0].center.y - below * dx;
    const auto cells = [&](double extent) {
        return static_cast<std::int64_t>(std::ceil((extent + margin) / dx)) + 1;
    };
    return {cells(high.x), cells(high.y - y_0), cells(high.z), y_0};
}

template <class Visit>
void for_each_lattice_point(const Bounds& b, double dx, const Visit& visit)
{
    for (std::int64_t k = -b.z; k < b.z; ++k) {
        for (std::int64_t j = 0; j < b.y; ++j) {
            for (std::int64_t i = -b.x; i < b.x; ++i) {
                visit(Vec3{(static_cast<double>(i) + 0.5) * dx, b.y_0 + (static_cast<double>(j) + 0.5) * dx,
                           (static_cast<double>(k) + 0.5) * dx});
            }
        }
    }
}

} // namespace

Lattice sample_lattice(const Vessel& vessel, double R, double dx)
{
    Lattice lattice;
    lattice.spacing = dx;
    for_each_lattice_point(bounds(vessel, R, dx, 0), dx, [&](const Vec3& x) {
        if (vessel.wall(x, R).value >= -seeding_inset * dx) {
            return;
        }
        const std::size_t end = vessel.nearest_tube(x);
        const double beyond = vessel.openings()[end].beyond(x);
        if (beyond <= 0) {
            lattice.fluid.push_back(x);
        } else if (beyond < opening_layers * dx) {
            lattice.openings[end].push_back(x);
        }
    });
    return lattice;
}

Lattice sample_count(const Vessel& vessel, double R, std::size_t count, double reserve_fraction,
                     double daughter_radius)
{
    const auto beside_reserve = [&](std::size_t all) {
        return static_cast<std::size_t>(static_cast<double>(all) * (1 - reserve_fraction));
    };
    // At least two layers of particles on each side of a daughter's axis, else the lattice holds no flow.
    const double coarsest = 0.5 * daughter_radius;
    const std::size_t wanted = beside_reserve(count);
    if (const std::size_t least = sample_lattice(vessel, R, coarsest).size(); least > wanted) {
        std::size_t needed = count;
        while (beside_reserve(needed) < least) {
            ++needed;
        }
        throw InputError("particles.count", std::to_string(count) + " is too few for this vessel",
                         "needed: at least " + std::to_string(needed) +
                             " so that the spacing is at most half a daughter's radius");
    }
    double fine = coarsest;
    while (sample_lattice(vessel, R, fine).size() < wanted) {
        fine *= 0.7;
    }
    double coarse = std::min(fine / 0.7, coarsest);
    for (int bisection = 0; bisection < 30; ++bisection) {
        const double middle = 0.5 * (fine + coarse);
        (sample_lattice(vessel, R, middle).size() < wanted ? coarse : fine) = middle;
    }
    Lattice lattice = sample_lattice(vessel, R, fine);
    return lattice.size() <= count ? lattice : sample_lattice(vessel, R, coarse);
}

GhostLattice::GhostLattice(const Vessel& vessel, double R_smallest, double R_largest, double dx,
                           double support, double mass)
    : vessel_(&vessel), dx_(dx), support_(support), mass_(mass)
{
    for_each_lattice_point(bounds(vessel, R_largest, dx, support), dx, [&](const Vec3& x) {
        const double nearest = vessel.wall(x, R_largest).value;
        const double farthest = vessel.wall(x, R_smallest).value;
        const Opening& end = vessel.openings()[vessel.nearest_tube(x)];
        if (nearest >= support_ || farthest <= -0.5 * dx || end.beyond(x) > opening_layers * dx + support_) {
            return;
        }
        if (nearest < farthest) {
            near_sac_.push_back(x);
        } else if (fraction(nearest) > 0) {
            fixed_.position.push_back(x);
            fixed_.mass.push_back(mass_ * fraction(nearest));
        }
    });
}

double GhostLattice::fraction(double distance) const
{
    return std::clamp(0.5 + distance / dx_, 0.0, 1.0);
}

WallGhosts GhostLattice::at(double R, const std::optional<Breach>& breach) const
{
    WallGhosts ghosts = fixed_;
    for (const Vec3& x : near_sac_) {
        const double distance = vessel_->wall(x, R).value;
        if (distance < support_ && fraction(distance) > 0 && !(breach && breach->contains(x))) {
            ghosts.position.push_back(x);
            ghosts.mass.push_back(mass_ * fraction(distance));
        }
    }
    return ghosts;
}

} // namespace aneurysm
