// SPDX-License-Identifier: Apache-2.0
// Section 3.5: boundary conditions, (25)-(28), and the collision handling of Fig. 1.
#pragma once

#include "common/portable_math.hpp"
#include "common/scenario/scenario.hpp"
#include "common/wall.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aneurysm::reference
{

/// Periodic, piecewise linear through the scenario's table.
inline double table_velocity(const std::vector<double>& time, const std::vector<double>& velocity, double T,
                             double t)
{
    const double s = std::max(t - T * std::floor(t / T), 0.0); // rounding can take it below 0
    const auto after = std::upper_bound(time.begin(), time.end(), s);
    const auto k = static_cast<std::size_t>(after - time.begin());
    const double t_0 = time[k - 1];
    const double t_1 = k < time.size() ? time[k] : T;
    const double v_1 = k < time.size() ? velocity[k] : velocity[0];
    return velocity[k - 1] + (v_1 - velocity[k - 1]) * ((s - t_0) / (t_1 - t_0));
}

/// Eq. (25)  Velocity of the inlet's ghost particles, along the parent's axis into the artery:
///
///     v_inlet = v_0 sin(2 pi t / T)                                                           [m/s]
///
/// as printed (`sine`); the other waveforms are the scenario's choice.
inline double inlet_velocity(Waveform waveform, double v_0, double T, double t,
                             const std::vector<double>& table_time,
                             const std::vector<double>& table_velocity_m_s)
{
    const double sine = aneurysm::sine(2 * std::numbers::pi * t / T);
    switch (waveform) {
    case Waveform::sine:
        return v_0 * sine;
    case Waveform::rectified_sine:
        return v_0 * std::abs(sine);
    case Waveform::raised_sine:
        return v_0 * (1 + sine) / 2;
    case Waveform::constant:
        return v_0;
    case Waveform::table:
        return table_velocity(table_time, table_velocity_m_s, T, t);
    }
    return 0;
}

/// Pressure in an outlet whose slab moves outwards with v: p_const while blood leaves; while it comes back,
/// p_const is the pressure of the blood at rest that it comes from, so that the inflow brings no energy of
/// its own. A static pressure would feed any inflow, and the daughters' flows would run away from each other.
inline double outlet_pressure(double p_const, double rho_0, double v)
{
    return v < 0 ? p_const - 0.5 * rho_0 * v * v : p_const;
}

/// Eq. (26)  Force per volume of an outlet ghost j, which carries p_outlet = p_const, on its neighbor i:
///
///     F = -m_j / rho_0 p_const grad W_ij                                                      [N/m^3]
inline Vec3 outlet_pressure_force(double m_j, double rho_0, double p_const, const Vec3& grad_W)
{
    return -m_j / rho_0 * p_const * grad_W;
}

/// Eq. (27)  Velocity of the wall's ghost particles: no slip.
///
///     v_wall = 0                                                                              [m/s]
constexpr Vec3 wall_velocity()
{
    return Vec3{};
}

/// Eq. (28)  m_wall d^2u/dt^2 = F_fluid - k u, one symplectic Euler step:
///
///     v' = v + dt (F_fluid - k u) / m_wall,   u' = u + dt v'
///
/// stable for dt sqrt(k / m_wall) < 2, which the scenario's check demands.
inline ElasticWall advance_elastic_wall(const ElasticWall& wall, double F_fluid, double k, double m_wall,
                                        double dt)
{
    const double force = F_fluid - k * wall.u;
    const double v = wall.v + dt * force / m_wall;
    return {wall.u + dt * v, v};
}

/// Fig. 1  A particle that is `depth` beyond the wall is put back onto it; the velocity component along the
/// outward normal n is turned round if it points outwards, the tangential one kept.
inline Collision collide(const Vec3& position, const Vec3& velocity, double depth, const Vec3& n)
{
    const double outward = dot(velocity, n);
    const Vec3 turned = velocity - 2 * outward * n;
    return {position - depth * n, outward > 0 ? turned : velocity};
}

} // namespace aneurysm::reference
