// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace aneurysm::verification
{

/// How far the candidate's particles can be from the reference's while both make the same frame.
struct ParticleErrors {
    explicit ParticleErrors(std::size_t count)
        : position(count, 0), velocity(count, 0), density(count, 0), pressure(count, 0), open(count, false)
    {
    }

    std::vector<double> position;            ///< [U m]
    std::vector<double> velocity;            ///< [U m/s]
    std::vector<double> density;             ///< of the last step [U kg/m^3]
    std::vector<double> pressure;            ///< 0 where it was given [U Pa]
    std::array<double, 2> outlet_velocity{}; ///< [U m/s]
    /// By particle: a decision about it lies within its rounding; the bounds above cover both outcomes.
    std::vector<bool> open;
    /// The same for a decision that many particles depend on: what the controller placed where.
    bool exchange_open = false;
    /// The same for one that all of the frame depends on: an open end's reset, rupture.
    bool frame_open = false;
};

} // namespace aneurysm::verification
