// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vec3.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace aneurysm
{

/// What a particle is doing. Forces move all but the inlet's buffer.
enum class Kind : std::uint8_t {
    reserve,  ///< waits outside for the controller; takes part in nothing
    fluid,    ///< blood in the artery
    escaped,  ///< blood beyond the breach
    inlet,    ///< blood before the inlet, in its buffer: moves with (25)
    outlet_1, ///< blood beyond the first daughter's open end, in its buffer, (26)
    outlet_2, ///< blood beyond the second daughter's open end, in its buffer, (26)
};

/// Whether forces move it.
constexpr bool is_free(Kind kind)
{
    return kind != Kind::reserve && kind != Kind::inlet;
}

/// Pressure of a particle that has just become free: the next solve starts from its neighbors' mean. A power of two,
/// so that it is the same in single precision [Pa].
constexpr double unset_pressure = -0x1p100;

/// All particles of a run; index = identity, for the whole run. Every array has size() entries.
struct Particles {
    double mass = 0;              ///< of each [kg]
    std::vector<Vec3> position;   ///< [m]
    std::vector<Vec3> velocity;   ///< [m/s]
    std::vector<double> pressure; ///< p of the last solve, its warm start [Pa]
    std::vector<double> kappa;    ///< potential of the last correction of the density, its warm start [Pa]
    /// What the last step's straight ways added to the density beyond dt Drho/Dt [kg/m^3]
    std::vector<double> drift;
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
