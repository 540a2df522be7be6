// SPDX-License-Identifier: Apache-2.0
// Section 3.5: boundary conditions, (25)-(28), and the collision handling of Fig. 1.
#pragma once

#include "common/portable_math.hpp"
#include "common/scenario/scenario.hpp"
#include "common/wall.hpp"
#include "cuda/executor/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace aneurysm::device
{

/// Periodic, piecewise linear through the scenario's table.
inline double table_velocity(const Scenario& scenario, double phase)
{
    const auto& time = scenario.inlet.table_time_s;
    const auto& velocity = scenario.inlet.table_velocity_m_s;
    const auto next = std::upper_bound(time.begin(), time.end(), phase);
    const auto k = static_cast<std::size_t>(next - time.begin());
    const double t_1 = next != time.end() ? *next : scenario.inlet.cycle_s;
    const double v_1 = next != time.end() ? velocity[k] : velocity[0];
    const double part = (phase - time[k - 1]) / (t_1 - time[k - 1]);
    return velocity[k - 1] + (v_1 - velocity[k - 1]) * part;
}

/// Eq. (25)  Velocity of the inlet's ghost particles, along the parent's axis into the artery:
///
///     v_inlet = v_0 sin(2 pi t / T)                                                           [m/s]
///
/// On the host, once a step: a sine need not have the same bits on a GPU.
inline double inlet_velocity(const Scenario& scenario, double t)
{
    const double v_0 = scenario.inlet.peak_velocity_m_s;
    const double T = scenario.inlet.cycle_s;
    const double sine = aneurysm::sine(2 * std::numbers::pi * t / T);
    switch (scenario.inlet.waveform) {
    case Waveform::sine:
        return v_0 * sine;
    case Waveform::rectified_sine:
        return v_0 * std::abs(sine);
    case Waveform::raised_sine:
        return v_0 * (1 + sine) / 2;
    case Waveform::constant:
        return v_0;
    case Waveform::table:
        return table_velocity(scenario, std::max(t - T * std::floor(t / T), 0.0)); // rounding can go below 0
    }
    return 0;
}

/// Pressure in an outlet whose slab moves outwards with v: p_const while blood leaves, the pressure of blood
/// at rest while it comes back [Pa].
ANEURYSM_HD inline double outlet_pressure(double p_const, double rho_0, double v)
{
    return v < 0 ? p_const - 0.5 * rho_0 * v * v : p_const;
}

/// Eq. (26)  Force per volume of outlet ghosts j, which carry p_outlet = p_const, on their neighbor i:
///
///     F = -m_j / rho_0 p_const grad W_ij                                                      [N/m^3]
template <class Number>
ANEURYSM_HD Vec3T<Number> outlet_pressure_force(const Number& rho_0, const Number& p_const,
                                                const Vec3T<Number>& m_grad_W)
{
    return (Number(0) - p_const / rho_0) * m_grad_W;
}

/// Eq. (27)  Velocity of the wall's ghost particles: no slip.
///
///     v_wall = 0                                                                              [m/s]
template <class Real>
ANEURYSM_HD Vec3T<Real> wall_velocity()
{
    return Vec3T<Real>{};
}

/// Eq. (28)  m_wall d^2u/dt^2 = F_fluid - k u, one symplectic Euler step:
///
///     v' = v + dt (F_fluid - k u) / m_wall,   u' = u + dt v'
ANEURYSM_HD inline ElasticWall advance_elastic_wall(const ElasticWall& wall, double F_fluid, double k,
                                                    double m_wall, double dt)
{
    const double force = F_fluid - k * wall.u;
    const double v = wall.v + dt * force / m_wall;
    return {wall.u + dt * v, v};
}

/// Fig. 1  A particle that is `depth` beyond the wall is put back onto it; the velocity component along the
/// outward normal n is turned round if it points outwards, the tangential one kept.
template <class Real>
ANEURYSM_HD void collide(Vec3T<Real>& position, Vec3T<Real>& velocity, Real depth, const Vec3T<Real>& n)
{
    const Real outward = dot(velocity, n);
    position -= depth * n;
    if (outward > 0) {
        velocity -= 2 * outward * n;
    }
}

} // namespace aneurysm::device
