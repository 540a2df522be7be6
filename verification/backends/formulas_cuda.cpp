// SPDX-License-Identifier: Apache-2.0
#include "cuda/bifurcation.hpp"
#include "cuda/blood_flow.hpp"
#include "cuda/boundary.hpp"
#include "cuda/growth.hpp"
#include "cuda/kernel_function.hpp"
#include "cuda/rupture.hpp"
#include "verification/backends/formulas.hpp"

#include <bit>
#include <vector>

namespace aneurysm::backends
{
namespace
{

using device::Index;
using device::Lanes;

/// The device's lists don't have absent bodies in them, and are filled up with a massless one far away.
double interpolate(KernelName name, double h, const Vec3& r, std::span<const Carrier> carriers)
{
    constexpr double far_away = device::Constants<double>::far_away;
    std::vector<device::Row<double>> bodies;
    std::vector<device::Row<double>> values;
    for (const Carrier& c : carriers) {
        if (!c.absent) {
            bodies.push_back(device::row(c.position, c.mass));
            values.push_back({c.A, c.rho, 0, 0});
        }
    }
    while (bodies.size() % device::lane_count != 0) {
        bodies.push_back({far_away, far_away, far_away, 0});
        values.push_back({0, 1, 0, 0});
    }
    return device::interpolate(device::Kernel<double>(name, h), r, bodies.data(), values.data(),
                               static_cast<Index>(bodies.size()), device::Lane{});
}

/// Particle by particle; the hardest is found pair by pair, as a reduction over threads does, which are
/// filled up with nobody's hits.
Impact impact_force(std::span<const std::int64_t> S, double m, std::span<const double> density,
                    std::span<const Vec3> force)
{
    std::vector<device::Impact> hits(std::bit_ceil(S.size()));
    for (std::size_t i = 0; i < S.size(); ++i) {
        const auto k = static_cast<std::size_t>(S[i]);
        const double F = device::impact_force(m, density[k], force[k]);
        hits[i] = {F, F, static_cast<Index>(S[i]), 1};
    }
    for (std::size_t half = hits.size() / 2; half > 0; half /= 2) {
        for (std::size_t i = 0; i < half; ++i) {
            hits[i] += hits[i + half];
        }
    }
    return {hits[0].force, hits[0].particle};
}

double inlet_velocity(const Inlet& inlet, double t)
{
    Scenario s;
    s.inlet = inlet;
    return device::inlet_velocity(s, t);
}

Vec3 outlet_pressure_force(std::span<const double> m, std::span<const Vec3> grad_W, double rho_0, double p)
{
    Vec3 gradient;
    for (std::size_t j = 0; j < m.size(); ++j) {
        gradient += m[j] * grad_W[j];
    }
    return device::outlet_pressure_force(gradient, rho_0, p);
}

Collision collide(const Vec3& position, const Vec3& velocity, double depth, const Vec3& n)
{
    Collision after{position, velocity};
    device::collide(after.position, after.velocity, depth, n);
    return after;
}

} // namespace

const Equations& device_equations()
{
    static constexpr Equations equations{
        .momentum_force = device::momentum_force<double>,
        .kernel_value =
            [](KernelName name, double h, double r) {
                return first(device::Kernel<double>(name, h).value(Lanes<double>(r)));
            },
        .kernel_gradient =
            [](KernelName name, double h, const Vec3& x) {
                return first(device::Kernel<double>(name, h).gradient_factor(Lanes<double>(length(x)))) * x;
            },
        .viscosity_laplacian =
            [](double h, double r) {
                return first(device::Kernel<double>(KernelName::cubic_spline, h)
                                 .viscosity_laplacian(Lanes<double>(r)));
            },
        .interpolate = interpolate,
        .equation_of_state = [](double kappa, double rho,
                                double rho_0) { return device::equation_of_state(kappa, rho, rho_0); },
        .acceleration = device::acceleration<double>,
        .wall_stress = device::wall_stress,
        .thickness_differential = device::thickness_differential,
        .porosity_differential = device::porosity_differential,
        .stress_of_porosity = device::stress_of_porosity,
        .radius_per_pressure = device::radius_per_pressure,
        .critical_pressure = device::critical_pressure,
        .impulse_force = device::impulse_force<double>,
        .impact_force = impact_force,
        .wall_load = device::wall_load,
        .ruptures = device::ruptures,
        .net_wall_force = device::net_wall_force,
        .tissue_force = device::tissue_force,
        .fiber_force = device::fiber_force,
        .strain = device::strain,
        .radius_increment = device::radius_increment,
        .thickness_growing = device::thickness_growing,
        .thickness_developed = device::thickness_developed,
        .daughter_radius = device::daughter_radius,
        .inlet_velocity = inlet_velocity,
        .inlet_profile = device::inlet_profile<double>,
        .inlet_ramp = device::inlet_ramp,
        .outlet_pressure_force = outlet_pressure_force,
        .inflow_force = device::inflow_force<double>,
        .wall_velocity = device::wall_velocity<double>,
        .advance_elastic_wall = device::advance_elastic_wall,
        .collide = collide,
    };
    return equations;
}

} // namespace aneurysm::backends
