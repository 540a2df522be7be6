// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vec3.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace aneurysm
{

/// What a particle is doing. Only `fluid` and `escaped` are moved by forces.
enum class Kind : std::uint8_t {
    reserve,  ///< waits outside for the controller; takes part in nothing
    fluid,    ///< blood in the artery
    escaped,  ///< blood beyond the breach
    inlet,    ///< inlet ghost: moves with (25)
    outlet_1, ///< ghost of the first daughter's open end, (26)
    outlet_2, ///< ghost of the second daughter's open end, (26)
};

constexpr bool is_free(Kind kind)
{
    return kind == Kind::fluid || kind == Kind::escaped;
}

/// All particles of a run; index = identity, for the whole run. Every array has size() entries.
struct Particles {
    double mass = 0;              ///< of each [kg]
    std::vector<Vec3> position;   ///< [m]
    std::vector<Vec3> velocity;   ///< [m/s]
    std::vector<double> pressure; ///< of the last solve, its warm start [Pa]
    std::vector<Kind> kind;

    std::size_t size() const { return position.size(); }
};

/// Ghost particles of the wall, (27): at rest. Rebuilt whenever the wall moves.
struct WallGhosts {
    std::vector<Vec3> position; ///< [m]
    std::vector<double> mass;   ///< particle mass times the part of its cell that is outside the wall [kg]

    std::size_t size() const { return position.size(); }
};

} // namespace aneurysm
