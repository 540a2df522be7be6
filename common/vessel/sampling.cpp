// SPDX-License-Identifier: Apache-2.0
#include "common/vessel/sampling.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace aneurysm
{
namespace
{
/// How deep a lattice point must lie inside the wall to hold a particle, in spacings. With 0 the lattice has
/// as many particles as the lumen has volume for, which is 1 % more than fit between curved walls; with 0.08
/// they just fit.
constexpr double seeding_inset = 0.08;

/// Lattice points i of an axis, at low + (i + 1/2) dx.
struct Axis {
    std::int64_t begin = 0;
    std::int64_t end = 0;
    double low = 0; ///< [m]

    double at(std::int64_t i, double dx) const { return low + (static_cast<double>(i) + 0.5) * dx; }
};
using Axes = std::array<Axis, 3>;

/// The lattice points that can lie within `reach` of the artery or its open ends.
Axes artery_axes(const Vessel& vessel, double R, double dx, double reach)
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
    // Cells below the inlet plane are whole, so that the inlet's buffer continues the fluid's lattice.
    const double below = std::ceil(margin / dx) + 1;
    const double y_0 = openings[0].center.y - below * dx;
    const auto cells = [&](double extent) {
        return static_cast<std::int64_t>(std::ceil((extent + margin) / dx)) + 1;
    };
    return {Axis{-cells(high.x), cells(high.x), 0}, Axis{0, cells(high.y - y_0), y_0},
            Axis{-cells(high.z), cells(high.z), 0}};
}

/// Of the other forms: a periodic direction has its cells once, the others go on behind walls and open ends.
Axes straight_axes(const Vessel& vessel, double dx, double reach)
{
    const auto more = static_cast<std::int64_t>(std::ceil(reach / dx)) + opening_layers;
    const bool round = vessel.form() == DomainForm::tube || vessel.form() == DomainForm::pipe;
    const auto axis = [&](double extent, double period, double low) {
        const auto cells = static_cast<std::int64_t>(std::llround(extent / dx));
        return period > 0 ? Axis{0, cells, low} : Axis{-more, cells + more, low};
    };
    const Vec3& extent = vessel.extent();
    const Vec3& period = vessel.period();
    return {axis(extent.x, period.x, round ? -extent.x / 2 : 0), axis(extent.y, period.y, 0),
            axis(extent.z, period.z, round ? -extent.z / 2 : 0)};
}

template <class Visit>
void for_each_lattice_point(const Vessel& vessel, double R, double dx, double reach, const Visit& visit)
{
    const bool artery = vessel.form() == DomainForm::artery;
    const auto [x, y, z] = artery ? artery_axes(vessel, R, dx, reach) : straight_axes(vessel, dx, reach);
    for (std::int64_t k = z.begin; k < z.end; ++k) {
        for (std::int64_t j = y.begin; j < y.end; ++j) {
            for (std::int64_t i = x.begin; i < x.end; ++i) {
                visit(Vec3{x.at(i, dx), y.at(j, dx), z.at(k, dx)});
            }
        }
    }
}

/// Puts the columns of the inlet's buffer out of phase, each shifted along the axis by a part of dx that differs
/// from its neighbors': a lattice would send a whole layer through the inlet at once. The parts are Roberts's R2
/// sequence, 1/q and 1/q^2 with q^3 = q + 1, from 0 on: a part of -1/2 would leave a particle on the plane itself.
void dephase(std::vector<Vec3>& buffer, const Opening& inlet, double dx)
{
    const double depth = opening_layers * dx;
    for (Vec3& x : buffer) {
        const double turns =
            0.7548776662466927 * std::floor(x.x / dx) + 0.5698402909980532 * std::floor(x.z / dx);
        const double beyond = inlet.beyond(x);
        double shifted = beyond + (turns - std::round(turns)) * dx;
        shifted += shifted <= 0 ? depth : 0;
        shifted -= shifted >= depth ? depth : 0;
        x += (shifted - beyond) * inlet.outward;
    }
}

} // namespace

Lattice sample_lattice(const Vessel& vessel, double R, double dx)
{
    Lattice lattice;
    lattice.spacing = dx;
    for_each_lattice_point(vessel, R, dx, 0, [&](const Vec3& x) {
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
    dephase(lattice.openings[0], vessel.openings()[0], dx);
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
    for_each_lattice_point(vessel, R_largest, dx, support, [&](const Vec3& x) {
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
