// SPDX-License-Identifier: Apache-2.0
#include "common/scenario/limits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace aneurysm
{

double estimated_spacing(const Scenario& scenario)
{
    if (scenario.domain.form != DomainForm::artery) {
        return scenario.domain.spacing_m;
    }
    const auto& v = scenario.vessel;
    // Two equal daughters of half the parent's radius cubed: r_1^2 = 2^(-2/3) r_0^2.
    const double daughters = 2 * std::pow(2.0, -2.0 / 3.0) * v.daughter_length_radii;
    const double volume = std::numbers::pi * (v.parent_length_radii + daughters) * std::pow(v.radius_m, 3);
    const double active =
        static_cast<double>(scenario.particles.count) * (1 - scenario.particles.reserve_fraction);
    return std::cbrt(volume / active);
}

double largest_inlet_velocity(const Scenario& scenario)
{
    if (scenario.inlet.waveform != Waveform::table) {
        return scenario.inlet.peak_velocity_m_s;
    }
    double largest = 0;
    for (const double v : scenario.inlet.table_velocity_m_s) {
        largest = std::max(largest, std::abs(v));
    }
    return largest;
}

double largest_inlet_speed(const Scenario& scenario)
{
    const double over_mean = scenario.inlet.profile == InletProfile::parabolic ? 2 : 1;
    return over_mean * largest_inlet_velocity(scenario);
}

StepLimits step_limits(const Scenario& scenario, double dx)
{
    constexpr double never = std::numeric_limits<double>::infinity();
    const double h = scenario.kernel.smoothing_length_spacings * dx;
    const double speed = largest_inlet_speed(scenario);
    StepLimits limits;
    limits.convective = speed > 0 ? 0.5 * dx / (2.5 * speed) : never;
    limits.viscous = scenario.fluid.viscosity_pa_s > 0
                         ? 0.125 * h * h * scenario.fluid.density_kg_m3 / scenario.fluid.viscosity_pa_s
                         : never;
    limits.acoustic = scenario.pressure.model == PressureModel::eos
                          ? 0.4 * h / std::sqrt(scenario.pressure.stiffness_m2_s2)
                          : never;
    return limits;
}

} // namespace aneurysm
