// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/flow.hpp"
#include "verification/bounds/particle_errors.hpp"
#include "verification/bounds/wall.hpp"

#include <cstdint>

namespace aneurysm::bounds
{

/// How many particles certainly, and at most, were put back or stayed outside.
struct CollisionCounts {
    std::int64_t collisions_certain = 0;
    std::int64_t collisions_possible = 0;
    std::int64_t outside_certain = 0;
    std::int64_t outside_possible = 0;
};

/// Rounding of collision handling (Fig. 1) and of the way out through the breach (docs/bounds.md, B26).
class CollisionBounds
{
public:
    CollisionBounds(const WallBounds& wall, double dx, Rebound rebound, const Rounding& rounding)
        : wall_(&wall), dx_(dx), rebound_(rebound), rounding_(rounding)
    {
    }

    /// `p`: before the handling.
    CollisionCounts bound(const Particles& p, const reference::Wall& wall, ParticleErrors& errors) const;

private:
    struct Path {
        InexactVec position;
        InexactVec velocity;
        bool any = false;          ///< whether both agree on a collision
        Truth outside = Truth::no; ///< after the last attempt
    };
    Path follow(const InexactVec& x, const InexactVec& v, const Inexact& R) const;
    void bound_one(std::size_t i, const Particles& p, const reference::Wall& wall, ParticleErrors& errors,
                   CollisionCounts& counts) const;

    const WallBounds* wall_;
    double dx_;
    Rebound rebound_;
    Rounding rounding_;
};

} // namespace aneurysm::bounds
