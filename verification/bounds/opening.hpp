// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario/scenario.hpp"
#include "verification/bounds/particle_errors.hpp"
#include "verification/bounds/wall.hpp"

#include "common/frame.hpp"

namespace aneurysm::bounds
{

/// Rounding of what happens at the three open ends: (25), the outlets' slabs, and the controller of section
/// 3.4 (docs/bounds.md, B27).
class OpeningBounds
{
public:
    OpeningBounds(const Scenario& scenario, const WallBounds& wall, double dx, const Rounding& rounding);

    /// (25) at time t [m/s]. Time, argument and sine are computed in double, then rounded once.
    Inexact inlet_velocity(double t) const;

    /// What drives the slabs: from the state at the beginning of a step to the one with driven slabs.
    void drive(const SimulationState& begun, const SimulationState& driven, double t,
               ParticleErrors& errors) const;
    /// The piston and the holding back of blood.
    void hold(const SimulationState& moved, double t, ParticleErrors& errors) const;
    /// The exchange, from the state after collisions to the one after it.
    void exchange(const Particles& before, const Particles& after, ParticleErrors& errors) const;
    /// Escaped blood that returns to the reserve at the end of a frame: `after`.
    void recycle(const Particles& before, const Particles& after, const Vec3& breach, double support,
                 ParticleErrors& errors) const;

private:
    Inexact outlet_velocity(const SimulationState& begun, std::size_t k, double e_previous,
                            const ParticleErrors& errors) const;
    void drive_outlet(const SimulationState& begun, const SimulationState& driven, std::size_t k,
                      ParticleErrors& errors) const;
    void push(const Particles& p, const Inexact& v_inlet, ParticleErrors& errors) const;
    void hold_back(const Particles& p, std::size_t k, ParticleErrors& errors) const;
    void cross(const Particles& before, const Particles& after, std::size_t i, ParticleErrors& errors) const;
    bool may_enter_or_leave(const Particles& p, std::size_t i, const ParticleErrors& errors) const;
    bool is_taken_open(const Particles& p, std::size_t i, const ParticleErrors& errors) const;

    const Scenario* scenario_;
    const WallBounds* wall_;
    double dx_;
    double dt_;
    Rounding rounding_;
};

} // namespace aneurysm::bounds
