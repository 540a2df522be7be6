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

/// The part of (25) that a start in the time `ramp` lets through at time t, 0 to 1, with a continuous slope.
inline double inlet_ramp(double ramp, double t)
{
    if (!(ramp > 0 && t < ramp)) {
        return 1;
    }
    const double s = t > 0 ? t / ramp : 0;
    return s * s * (3 - 2 * s);
}

/// The waveform of (25) [m/s]. On the host, once a step: a sine need not have the same bits on a GPU.
inline double inlet_waveform(const Scenario& scenario, double t)
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

/// Eq. (25)  Velocity of the inlet's blood, along the parent's axis into the artery, after the start:
///
///     v_inlet = v_0 sin(2 pi t / T)                                                           [m/s]
inline double inlet_velocity(const Scenario& scenario, double t)
{
    return inlet_ramp(scenario.inlet.ramp_s, t) * inlet_waveform(scenario, t);
}

/// Velocity over the inlet's section at the distance r from its axis, over the mean (25): a plug, or
/// Poiseuille's parabola.
template <class Real>
ANEURYSM_HD Real inlet_profile(InletProfile profile, Real r_squared, Real radius)
{
    const Real parabola = 2 * (1 - r_squared / (radius * radius));
    return profile == InletProfile::plug ? 1 : (parabola > 0 ? parabola : 0);
}

/// Eq. (26)  Force per volume on blood i in an outlet's buffer by the pressure p beyond its far end, which
/// stands in for the neighbors that are missing there; `gradient`: sum of m_j grad W_ij over all:
///
///     F = 2 p / rho_0 sum_j m_j grad W_ij                                                     [N/m^3]
template <class Real>
ANEURYSM_HD Vec3T<Real> outlet_pressure_force(const Vec3T<Real>& gradient, Real rho_0, Real p)
{
    return 2 * p / rho_0 * gradient;
}

/// Force per volume on the blood of a buffer of depth D that comes back with the mean velocity v < 0: the
/// pressure beyond is that of blood at rest, which falls by rho v^2 / 2 over the buffer.       [N/m^3]
template <class Real>
ANEURYSM_HD Vec3T<Real> inflow_force(Real rho_0, Real v, Real D, const Vec3T<Real>& outward)
{
    return v < 0 ? Real(0.5) * rho_0 * v * v / D * outward : Vec3T<Real>{};
}

/// Eq. (27)  Velocity of the wall.
///
///     v_wall = 0                                                                              [m/s]
template <class Real>
ANEURYSM_HD Vec3T<Real> wall_velocity()
{
    return Vec3T<Real>{};
}

/// Velocity of a wall's ghost in (7) by (27), such that blood and ghosts together have the wall's velocity on
/// the wall itself (Adami, Hu and Adams 2012); `mean`: that of the blood around it:
///
///     v_j = 2 v_wall - sum_i v_i W_ij / sum_i W_ij                                             [m/s]
template <class Real>
ANEURYSM_HD Vec3T<Real> no_slip_velocity(const Vec3T<Real>& wall, const Vec3T<Real>& mean)
{
    return Real(2) * wall - mean;
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
