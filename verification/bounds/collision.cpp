// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/collision.hpp"

#include "common/guards.hpp"
#include "verification/bounds/ghost.hpp"

namespace aneurysm::bounds
{
namespace
{
/// The same vector, whose components may also be where `other` is.
InexactVec covering(const InexactVec& a, const InexactVec& other, const Rounding& rounding)
{
    const auto component = [&](const Inexact& x, const Inexact& y) {
        return Inexact{x.value, std::max(x.error, rounding.units(std::abs(y.value - x.value)) + y.error)};
    };
    return {component(a.x, other.x), component(a.y, other.y), component(a.z, other.z)};
}

} // namespace

/// All attempts of a particle that is beyond the wall. An attempt that only one of the two may make is
/// covered by the error of the one before.
CollisionBounds::Path CollisionBounds::follow(const InexactVec& x, const InexactVec& v,
                                              const Inexact& R) const
{
    Path path{x, v};
    InexactDistance d = wall_->wall(x, R);
    for (int k = 0; k < guards::collision_attempts; ++k) {
        const Truth beyond = is_positive(d.value, rounding_);
        if (beyond == Truth::no) {
            break;
        }
        const Inexact slope = norm(d.gradient);
        const InexactVec n = d.gradient / slope;
        const Inexact outward = dot(path.velocity, n);
        const InexactVec back = path.position - d.value / slope * n;
        const InexactVec reflected = path.velocity - Inexact{2, 0} * outward * n;
        const Truth turned = rebound_ == Rebound::elastic ? is_positive(outward, rounding_) : Truth::no;
        InexactVec velocity = turned == Truth::no ? path.velocity : reflected;
        if (turned == Truth::open) {
            velocity = outward.value > 0 ? covering(reflected, path.velocity, rounding_)
                                         : covering(path.velocity, reflected, rounding_);
        }
        if (beyond == Truth::open) {
            const bool taken = d.value.value > 0;
            path.position =
                taken ? covering(back, path.position, rounding_) : covering(path.position, back, rounding_);
            path.velocity = taken ? covering(velocity, path.velocity, rounding_)
                                  : covering(path.velocity, velocity, rounding_);
            d = wall_->wall(path.position, R);
            break; // within rounding of the wall: any further attempt stays there
        }
        path.any = true;
        path.position = back;
        path.velocity = velocity;
        d = wall_->wall(path.position, R);
    }
    path.outside = is_positive(d.value - Inexact{guards::outside<double> * dx_, 0}, rounding_);
    return path;
}

void CollisionBounds::bound_one(std::size_t i, const Particles& p, const reference::Wall& wall,
                                ParticleErrors& errors, CollisionCounts& counts) const
{
    const Inexact R = rounded(wall.radius);
    const InexactVec x = inexact(p.position[i], errors.position[i]);
    const Truth beyond = is_positive(wall_->wall(x, R).value, rounding_);
    if (beyond == Truth::no) {
        return;
    }
    const Truth inside = !wall_->is_beyond_nearest(x, {});
    const Truth out = wall.breach ? contains(*wall.breach, x, rounding_) : Truth::no;
    const Truth escapes = beyond && inside && out;
    if (escapes == Truth::open) {
        const Vessel& vessel = wall_->vessel();
        const bool escaped = vessel.wall(p.position[i], wall.radius).value > 0 &&
                             vessel.between_openings(p.position[i]) && wall.breach->contains(p.position[i]);
        errors.may_become(i, escaped ? Kind::fluid : Kind::escaped, &Ledger::escaped);
    }
    const Truth collides = beyond && inside && !out;
    if (collides == Truth::no) {
        return;
    }
    const InexactVec v = inexact(p.velocity[i], errors.velocity[i]);
    const Path path = follow(x, v, R);
    counts.collisions_certain += collides == Truth::yes ? 1 : 0;
    ++counts.collisions_possible;
    counts.outside_certain += collides == Truth::yes && path.outside == Truth::yes ? 1 : 0;
    counts.outside_possible += path.outside != Truth::no ? 1 : 0;
    if (collides == Truth::yes) {
        errors.position[i] = error_of(path.position);
        errors.velocity[i] = error_of(path.velocity);
        return;
    }
    const double jump = rounding_.units(length(value_of(path.velocity) - p.velocity[i]));
    errors.open[i] = errors.open[i] || jump > errors.velocity[i];
    errors.position[i] = std::max(errors.position[i], error_of(path.position)) +
                         rounding_.units(length(value_of(path.position) - p.position[i]));
    errors.velocity[i] = std::max(errors.velocity[i], error_of(path.velocity)) + jump;
}

CollisionCounts CollisionBounds::bound(const Particles& p, const reference::Wall& wall,
                                       ParticleErrors& errors) const
{
    CollisionCounts counts;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::fluid) {
            bound_one(i, p, wall, errors, counts);
        }
    }
    return counts;
}

} // namespace aneurysm::bounds
