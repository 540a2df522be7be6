// SPDX-License-Identifier: Apache-2.0
// What the checks of both solves of (3) have in common.
#pragma once

#include "common/guards.hpp"
#include "verification/checks/box.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace aneurysm::checks
{

inline constexpr double omega = 0.4;
inline constexpr double never = 1e11; ///< a tolerance that stops nothing [1/s]

/// A box in which nothing but the pressure acts, and no density is corrected.
inline Scenario solve_scenario(KernelName kernel)
{
    Scenario s = box_scenario(kernel);
    s.fluid.viscosity_pa_s = 0;
    s.pressure.relaxation = omega;
    s.pressure.density_correction = 0;
    s.pressure.max_tolerance_per_s = never;
    return s;
}

/// Pressures may fall to -p: the level is 0, and no absolute pressure is below that.
inline Scenario with_tension(Scenario s, double p)
{
    s.outlet.pressure_pa = p;
    s.outlet.level_margin = 0;
    return s;
}

/// A scenario whose density is corrected, but for beta by neither solve's iterations.
inline Scenario without_iterations(Scenario s, double beta)
{
    s.pressure.density_correction = beta;
    s.pressure.tolerance_per_s = s.pressure.max_tolerance_per_s = never;
    s.pressure.correction_tolerance_per_s = s.pressure.correction_max_tolerance_per_s = never;
    return s;
}

/// The lowest kappa of blood of this density: nothing pulls it beside a void.
inline double lowest_kappa(double density, double rho_0)
{
    return density < guards::void_density * rho_0 ? 0 : std::numeric_limits<double>::lowest();
}

/// Shifts of a cloud, and the largest of their errors [m].
struct Shifts {
    std::vector<Eigen::Vector3d> way;
    double error = 0;

    /// These and other ways together.
    std::vector<Eigen::Vector3d> and_ways(std::vector<Eigen::Vector3d> other) const
    {
        std::ranges::transform(other, way, other.begin(), std::plus<>());
        return other;
    }
};
/// Of those that flow freely and have no void beside them.
inline Shifts shifts_of(const Scenario& s, const analytic::Cloud& cloud, const std::vector<Kind>& kind)
{
    const double rho_0 = s.fluid.density_kg_m3;
    Shifts shifts{std::vector<Eigen::Vector3d>(cloud.position.size(), Eigen::Vector3d::Zero()), 0};
    for (std::size_t i = 0; i < kind.size(); ++i) {
        if (kind[i] == Kind::fluid && cloud.density[i] >= guards::void_density * rho_0) {
            const auto shift = analytic::pair_shift(cloud, rho_0, s.domain.spacing_m, s.pressure.shifting, i);
            shifts.way[i] = shift.value;
            shifts.error = std::max(shifts.error, shift.error);
        }
    }
    return shifts;
}

inline constexpr const char* of_drift =
    "the bounds of both sums (5) and dt times that of (2), for oracle and subject, + gamma_4 of all three";

/// What the ways have added to the density of i beyond dt Drho/Dt against what `found` says [kg/m^3].
inline void compare_drift(const Probe& probe, Quantity& quantity, double found, const analytic::Cloud& cloud,
                          const std::vector<Eigen::Vector3d>& way, double dt, std::size_t i)
{
    const auto rho = analytic::pair_density(cloud, i);
    const auto ahead = analytic::pair_density_ahead(cloud, way, i);
    const auto rate = analytic::pair_density_rate(cloud, i);
    quantity.within(found, ahead.value - rho.value - dt * rate.value,
                    both(ahead.error + rho.error + dt * rate.error, probe.roundoff()) +
                        probe.gamma(4) * (ahead.value + rho.value + dt * std::abs(rate.value)),
                    "particle " + std::to_string(i));
}

/// Each velocity times dt [m].
inline std::vector<Eigen::Vector3d> ways_of(const analytic::Cloud& cloud, double dt)
{
    std::vector<Eigen::Vector3d> way;
    for (const Eigen::Vector3d& v : cloud.velocity) {
        way.emplace_back(dt * v);
    }
    return way;
}

} // namespace aneurysm::checks
