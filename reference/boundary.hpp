// SPDX-License-Identifier: Apache-2.0
// Section 3.5: boundary conditions, (25)-(28), and the collision handling of Fig. 1.
#pragma once

#include "common/portable_math.hpp"
#include "common/scenario/scenario.hpp"
#include "common/wall.hpp"
#include "reference/neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

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

/// Eq. (25)  Velocity of the inlet's blood, along the parent's axis into the artery:
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

/// Velocity over the inlet's section at the distance r from its axis, over the mean (25): a plug, or
/// Poiseuille's parabola.
inline double inlet_profile(InletProfile profile, double r_squared, double radius)
{
    const double q = r_squared / (radius * radius);
    return profile == InletProfile::plug ? 1 : std::max(0.0, 2 * (1 - q));
}

/// The part of (25) that a start in the time `ramp` lets through at time t, 0 to 1, with a continuous slope.
inline double inlet_ramp(double ramp, double t)
{
    const double s = ramp > 0 ? std::clamp(t / ramp, 0.0, 1.0) : 1;
    return s * s * (3 - 2 * s);
}

/// Eq. (26)  Force per volume on blood i in an outlet's buffer by the pressure p beyond its far end, which
/// stands in for the neighbors that are missing there:
///
///     F = 2 p sum_j m_j / rho_0 grad W_ij                                                     [N/m^3]
inline Vec3 outlet_pressure_force(const Bodies& b, std::span<const Neighbor> neighbors, double rho_0,
                                  double p)
{
    Vec3 sum;
    for (const Neighbor& n : neighbors) {
        sum += b.mass[n.j] / rho_0 * n.grad_W;
    }
    return 2 * p * sum;
}

/// Force per volume on the blood of a buffer of depth D that moves outwards with the mean velocity v. While it
/// comes back, (26) is the pressure of the blood at rest that it comes from, so that the inflow brings no
/// energy of its own: the pressure falls by rho v^2 / 2 over the buffer. A static pressure would feed any
/// inflow, and the daughters' flows would run away from each other.                           [N/m^3]
inline Vec3 inflow_force(double rho_0, double v, double D, const Vec3& outward)
{
    return v < 0 ? 0.5 * rho_0 * v * v / D * outward : Vec3{};
}

/// Eq. (27)  Velocity of the wall.
///
///     v_wall = 0                                                                              [m/s]
constexpr Vec3 wall_velocity()
{
    return Vec3{};
}

/// Velocity of the wall's ghosts in (7) by (27): such that blood and ghosts together have the wall's velocity
/// on the wall itself (Adami, Hu and Adams 2012),
///
///     v_j = 2 v_wall - sum_i v_i W_ij / sum_i W_ij                                             [m/s]
///
/// over the blood i. By body; that of blood is its own.
inline std::vector<Vec3> no_slip_velocity(const Bodies& b, const Neighbors& neighbors)
{
    std::vector<Vec3> v = b.velocity;
    std::vector<Vec3> weighted(b.size());
    std::vector<double> weights(b.size(), 0);
    for (std::size_t i = 0; i < b.size(); ++i) {
        for (const Neighbor& n : neighbors.of(i)) {
            if (b.wall(n.j)) {
                weighted[n.j] += n.W * b.velocity[i];
                weights[n.j] += n.W;
            }
        }
    }
    for (std::size_t j = 0; j < b.size(); ++j) {
        if (weights[j] > 0) {
            v[j] = 2.0 * b.velocity[j] - weighted[j] / weights[j];
        }
    }
    return v;
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
