// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace aneurysm::bounds
{

/// How far the candidate's particles can be from the reference's while both make the same frame.
struct ParticleErrors {
    explicit ParticleErrors(std::size_t count)
        : position(count, 0), velocity(count, 0), density(count, 0), pressure(count, 0), drift(count, 0),
          open(count, false), other_kind(count)
    {
    }

    /// Rounding decides whether particle i is of this kind instead, and one is counted more or fewer.
    void may_become(std::size_t i, Kind kind, std::int64_t Ledger::*count)
    {
        open[i] = true;
        other_kind[i] = kind;
        ++(other_counts.*count);
    }

    std::vector<double> position;            ///< [U m]
    std::vector<double> velocity;            ///< [U m/s]
    std::vector<double> density;             ///< of the last step [U kg/m^3]
    std::vector<double> pressure;            ///< 0 where it was given [U Pa]
    std::vector<double> drift;               ///< [U kg/m^3]
    std::array<double, 2> outlet_velocity{}; ///< [U m/s]
    /// By particle: a decision about it lies within its rounding; the bounds above cover both outcomes.
    std::vector<bool> open;
    /// By particle: the kind that it may have instead, since rounding decides, and how far the counts may be
    /// apart by all of them.
    std::vector<std::optional<Kind>> other_kind;
    Ledger other_counts;
    /// The same for a decision that many particles depend on: what the controller placed where.
    bool exchange_open = false;
    /// The same for one that all of the frame depends on: rupture, where nothing pulls.
    bool frame_open = false;
};

} // namespace aneurysm::bounds
