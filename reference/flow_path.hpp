// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vessel/geometry.hpp"

namespace aneurysm::reference
{

/// The way from the inlet to an outlet as a row of straight tubes that share the flow.
struct FlowPath {
    double inertia = 0;  ///< sum of L A_inlet / A: a pressure of rho inertia dv/dt speeds the inlet up [m]
    double friction = 0; ///< sum of 8 L A_inlet / (A r^2), Hagen and Poiseuille's drop over mu v [1/m]
};

/// Of a vessel, by the places of its openings.
inline FlowPath flow_path(const Scenario& scenario, const Vessel& vessel)
{
    const double r_0 = vessel.openings()[0].radius;
    FlowPath path;
    const auto add = [&](double length, double area_ratio, double radius) {
        path.inertia += length * area_ratio;
        path.friction += 8 * length * area_ratio / (radius * radius);
    };
    if (vessel.form() != DomainForm::artery) {
        add(vessel.extent().y, 1, r_0);
        return path;
    }
    const double r = vessel.openings()[1].radius;
    add(scenario.vessel.parent_length_radii * scenario.vessel.radius_m, 1, r_0);
    add(scenario.vessel.daughter_length_radii * scenario.vessel.radius_m, r_0 * r_0 / (2 * r * r), r);
    return path;
}

} // namespace aneurysm::reference
