// SPDX-License-Identifier: Apache-2.0
// The level of the pressure, on the host, once a step.
#pragma once

#include "common/vessel/geometry.hpp"
#include "cuda/boundary.hpp"

#include <algorithm>

namespace aneurysm::device
{

/// How a straight tube of length L and radius r, through which the part `share` of the inlet's flow goes, resists: its
/// pressure drops by rho inertia dv/dt + mu friction v, with the velocity v at the inlet of radius r_0.
struct TubeResistance {
    double inertia = 0;  ///< [m]
    double friction = 0; ///< Hagen and Poiseuille's [1/m]

    TubeResistance(double L, double r, double r_0, double share)
    {
        const double faster = share * (r_0 / r) * (r_0 / r);
        inertia = L * faster;
        friction = 8 * L * faster / (r * r);
    }
};

/// The level that keeps blood from tearing while the wall is whole, see reference::Flow::level [Pa]
inline double pressure_level(const Scenario& s, const Vessel& vessel, double t)
{
    if (!vessel.is_open(1)) {
        return 0; // nothing pulls
    }
    if (s.pressure.model == PressureModel::eos) {
        return s.outlet.pressure_pa;
    }
    const double r_0 = vessel.openings()[0].radius;
    const bool branches = vessel.form() == DomainForm::artery;
    const double r_k = branches ? vessel.openings()[1].radius : r_0;
    const double length = branches ? s.vessel.parent_length_radii * s.vessel.radius_m : vessel.extent().y;
    const TubeResistance parent(length, r_0, r_0, 1);
    const TubeResistance daughter(s.vessel.daughter_length_radii * s.vessel.radius_m, r_k, r_0, 0.5);
    const double dt = s.time.frame_s / static_cast<double>(s.time.substeps);
    const double v = inlet_velocity(s, t);
    const double slowing = std::max(inlet_velocity(s, t - dt) - v, 0.0) / dt;
    const double backward = std::max(-v, 0.0);
    double pull = s.fluid.density_kg_m3 * v * v;
    for (const TubeResistance& tube : {parent, daughter}) {
        pull += s.fluid.density_kg_m3 * tube.inertia * slowing +
                s.fluid.viscosity_pa_s * tube.friction * backward;
        if (!branches) {
            break;
        }
    }
    return std::min(s.outlet.level_margin * pull, s.outlet.pressure_pa);
}

} // namespace aneurysm::device
