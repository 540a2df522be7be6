// SPDX-License-Identifier: Apache-2.0
#include "verification/checks/pressure_level.hpp"

#include "analytic/boundary.hpp"
#include "analytic/laminar_flow.hpp"

#include <algorithm>

namespace aneurysm::checks
{

double ramp(const Scenario& s, double t)
{
    const double rest = s.inlet.ramp_s > 0 ? std::max(0.0, 1 - t / s.inlet.ramp_s) : 0;
    return 1 - rest * rest * (3 - 2 * rest);
}

double inlet_velocity(const Scenario& s, double t)
{
    const auto& inlet = s.inlet;
    return ramp(s, t) *
           analytic::waveform_velocity(inlet.waveform, inlet.peak_velocity_m_s, inlet.cycle_s, t).value;
}

double pull(const Scenario& s, const std::vector<Tube>& tubes, double t)
{
    const double dt = s.time.frame_s;
    const double rho = s.fluid.density_kg_m3;
    const double v = inlet_velocity(s, t);
    const double slowing = std::max(0.0, inlet_velocity(s, t - dt) - v) / dt;
    const double back = std::max(0.0, -v);
    double sum = rho * v * v;
    for (const Tube& tube : tubes) {
        const analytic::Duct pipe{analytic::Section::pipe, tube.radius, s.fluid.viscosity_pa_s / rho};
        const double mean_of_unit = analytic::developed_velocity(pipe, {1, 0}, 0, 0).value / 2;
        sum += rho * tube.length * tube.share * (slowing + back / mean_of_unit);
    }
    return sum;
}

} // namespace aneurysm::checks
