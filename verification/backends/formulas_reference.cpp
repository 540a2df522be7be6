// SPDX-License-Identifier: Apache-2.0
#include "reference/bifurcation.hpp"
#include "reference/blood_flow.hpp"
#include "reference/boundary.hpp"
#include "reference/growth.hpp"
#include "reference/kernel_function.hpp"
#include "reference/rupture.hpp"
#include "verification/backends/formulas.hpp"

namespace aneurysm::backends
{
namespace
{

double interpolate(KernelName name, double h, const Vec3& r, std::span<const Carrier> carriers)
{
    reference::Bodies bodies;
    std::vector<double> rho;
    std::vector<double> A;
    for (const Carrier& c : carriers) {
        bodies.position.push_back(c.position);
        bodies.mass.push_back(c.mass);
        bodies.role.push_back(c.absent ? reference::Role::absent : reference::Role::free);
        rho.push_back(c.rho);
        A.push_back(c.A);
    }
    return reference::interpolate(bodies, rho, A, reference::Kernel(name, h), r);
}

double inlet_velocity(const Inlet& inlet, double t)
{
    return reference::inlet_velocity(inlet.waveform, inlet.peak_velocity_m_s, inlet.cycle_s, t,
                                     inlet.table_time_s, inlet.table_velocity_m_s);
}

Vec3 outlet_pressure_force(std::span<const double> m, std::span<const Vec3> grad_W, double rho_0, double p)
{
    reference::Bodies bodies;
    bodies.mass.assign(m.begin(), m.end());
    std::vector<reference::Neighbor> neighbors(m.size());
    for (std::size_t j = 0; j < m.size(); ++j) {
        neighbors[j].j = j;
        neighbors[j].grad_W = grad_W[j];
    }
    return reference::outlet_pressure_force(bodies, neighbors, rho_0, p);
}

} // namespace

const Equations& reference_equations()
{
    static constexpr Equations equations{
        .momentum_force = reference::momentum_force,
        .kernel_value = [](KernelName name, double h,
                           double r) { return reference::Kernel(name, h).value(r); },
        .kernel_gradient = [](KernelName name, double h,
                              const Vec3& x) { return reference::Kernel(name, h).gradient(x); },
        .viscosity_laplacian = [](double h, double r) { return reference::viscosity_laplacian(r, 2 * h); },
        .interpolate = interpolate,
        .equation_of_state = reference::equation_of_state,
        .acceleration = reference::acceleration,
        .wall_stress = reference::wall_stress,
        .thickness_differential = reference::thickness_differential,
        .porosity_differential = reference::porosity_differential,
        .stress_of_porosity = reference::stress_of_porosity,
        .radius_per_pressure = reference::radius_per_pressure,
        .critical_pressure = reference::critical_pressure,
        .impulse_force = reference::impulse_force,
        .impact_force = reference::impact_force,
        .wall_load = reference::wall_load,
        .ruptures = reference::ruptures,
        .net_wall_force = reference::net_wall_force,
        .tissue_force = reference::tissue_force,
        .fiber_force = reference::fiber_force,
        .strain = reference::strain,
        .radius_increment = reference::radius_increment,
        .thickness_growing = reference::thickness_growing,
        .thickness_developed = reference::thickness_developed,
        .daughter_radius = reference::daughter_radius,
        .inlet_velocity = inlet_velocity,
        .inlet_profile = reference::inlet_profile,
        .inlet_ramp = reference::inlet_ramp,
        .outlet_pressure_force = outlet_pressure_force,
        .inflow_force = reference::inflow_force,
        .wall_velocity = reference::wall_velocity,
        .advance_elastic_wall = reference::advance_elastic_wall,
        .collide = reference::collide,
    };
    return equations;
}

} // namespace aneurysm::backends
