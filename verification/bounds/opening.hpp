// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "verification/bounds/particle_errors.hpp"
#include "verification/bounds/wall.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace aneurysm::bounds
{

/// Rounding of what happens at the three open ends: (25), the level of the pressure, the outlets' buffers,
/// and the controller of section 3.4 (docs/bounds.md, B27).
class OpeningBounds
{
public:
    OpeningBounds(const Scenario& scenario, const WallBounds& wall, double dx, const Rounding& rounding);

    /// (25) at time t [m/s]. Time, argument and sine are computed in double, then rounded once.
    Inexact inlet_velocity(double t) const;
    /// Of the pressure at time t, computed in double, then rounded once [Pa].
    Inexact level(Phase phase, double t) const;
    /// What the pressure is not below then [Pa].
    Inexact lowest_pressure(Phase phase, double t) const;

    /// The buffers' velocities at the beginning of a step.
    void drive(const SimulationState& driven, double t, ParticleErrors& errors) const;
    /// Whether rounding decides if the correction may pull on blood in a buffer.
    bool far_layers_open(const Particles& driven, const ParticleErrors& errors) const;
    /// The exchange, from the state after collisions to the one after it.
    void exchange(const Particles& before, const Particles& after, double t, ParticleErrors& errors) const;
    /// Escaped blood that returns to the reserve at the end of a frame: `after`.
    void recycle(const Particles& before, const Particles& after, const Vec3& breach, double support,
                 ParticleErrors& errors) const;

private:
    double inlet_velocity_in_double(double t) const;
    Inexact inlet_speed(const InexactVec& x, const Inexact& v_inlet) const;
    Inexact buffer_velocity(const Particles& p, std::size_t k, const std::vector<Truth>& member,
                            const ParticleErrors& errors) const;
    void cross(const Particles& before, const Particles& after, std::size_t i, ParticleErrors& errors) const;
    void leave_buffer(const Particles& before, const Particles& after, std::size_t i, std::size_t k,
                      ParticleErrors& errors) const;
    void fill(const Particles& before, const Particles& after, std::size_t k, double t,
              ParticleErrors& errors) const;
    Truth is_filled(const Vec3& place, std::size_t k, const Particles& p, const std::vector<Truth>& member,
                    const ParticleErrors& errors) const;

    const Scenario* scenario_;
    const WallBounds* wall_;
    double dx_;
    double dt_;
    Rounding rounding_;
    std::array<std::vector<Vec3>, 3> patterns_;
};

} // namespace aneurysm::bounds
