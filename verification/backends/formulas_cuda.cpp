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

device::WallTissue tissue(const WallTissue& w)
{
    Scenario s;
    s.growth.tissue_density_kg_m3 = w.rho_F;
    s.growth.tissue_area_m2 = w.a;
    s.growth.wave_speed_m_s = w.c;
    s.growth.elastin_stiffness_n_m = w.K_E;
    s.growth.elastin_area_m2 = w.A_E;
    s.growth.collagen_stiffness_n_m = w.K_C;
    s.growth.collagen_area_m2 = w.A_C;
    s.growth.wall_mass_kg = w.m;
    return device::WallTissue(s);
}

class DeviceEquations final : public Equations
{
public:
    Vec3 momentum_force(double rho, const Vec3& g, const Vec3& F_viscosity,
                        const Vec3& F_pressure) const override
    {
        return device::momentum_force(rho, g, F_viscosity, F_pressure);
    }
    double kernel_value(KernelName name, double h, double r) const override
    {
        return first(device::Kernel<double>(name, h).value(Lanes<double>(r)));
    }
    Vec3 kernel_gradient(KernelName name, double h, const Vec3& x) const override
    {
        const Lanes<double> r(length(x));
        return first(device::Kernel<double>(name, h).gradient_factor(r)) * x;
    }
    double viscosity_laplacian(double h, double r) const override
    {
        const device::Kernel<double> W(KernelName::cubic_spline, h);
        return first(W.viscosity_laplacian(Lanes<double>(r)));
    }
    /// The device's lists don't have absent bodies in them, and are filled up with a massless one far away.
    double interpolate(KernelName name, double h, const Vec3& r,
                       std::span<const Carrier> carriers) const override
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
    double equation_of_state(double kappa, double rho, double rho_0) const override
    {
        return device::equation_of_state(kappa, rho, rho_0);
    }
    Vec3 acceleration(double rho, const Vec3& force) const override
    {
        return device::acceleration(rho, force);
    }

    double wall_stress(double P, double R, double h) const override { return device::wall_stress(P, R, h); }
    double thickness_differential(double sigma, double h, double R, double dR) const override
    {
        return device::thickness_differential(sigma, h, R, dR);
    }
    double porosity_differential(double sigma, double R, double dR) const override
    {
        return device::porosity_differential(sigma, R, dR);
    }
    double stress_of_porosity(double Y, double phi) const override
    {
        return device::stress_of_porosity(Y, phi);
    }
    double radius_per_pressure(double P, double R, double h, double Y, double sigma,
                               double phi) const override
    {
        return device::radius_per_pressure(P, R, h, Y, sigma, phi);
    }
    double critical_pressure(double h, double R, double Y, double sigma, double phi) const override
    {
        return device::critical_pressure(h, R, Y, sigma, phi);
    }
    Vec3 impulse_force(double m, const Vec3& v, double dt) const override
    {
        return device::impulse_force(m, v, dt);
    }
    /// Particle by particle; the hardest is found pair by pair, as a reduction over threads does, which are
    /// filled up with nobody's hits.
    Hit impact_force(std::span<const std::int64_t> S, double m, std::span<const double> density,
                     std::span<const Vec3> force) const override
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
    bool ruptures(double F_b, double area, double P_c) const override
    {
        return device::ruptures(F_b, area, P_c);
    }

    double net_wall_force(double F_B, double F_F, double F_P) const override
    {
        return device::net_wall_force(F_B, F_F, F_P);
    }
    double tissue_force(const WallTissue& wall, double u_t) const override
    {
        return device::tissue_force(tissue(wall), u_t);
    }
    double fiber_force(const WallTissue& wall, double epsilon) const override
    {
        return device::fiber_force(tissue(wall), epsilon);
    }
    double strain(double dR, double R) const override { return device::strain(dR, R); }
    double radius_increment(const WallTissue& wall, double F_B, double R, double dt) const override
    {
        return device::radius_increment(tissue(wall), F_B, R, dt);
    }
    double thickness_growing(double h, double R, double sigma, double dR) const override
    {
        return device::thickness_growing(h, R, sigma, dR);
    }
    double thickness_developed(double h, double alpha, double dR, double largest) const override
    {
        return device::thickness_developed(h, alpha, dR, largest);
    }

    double daughter_radius(double r_0) const override { return device::daughter_radius(r_0); }

    double inlet_velocity(const Inlet& inlet, double t) const override
    {
        Scenario s;
        s.inlet = inlet;
        return device::inlet_velocity(s, t);
    }
    double outlet_pressure(double p_const, double rho_0, double v) const override
    {
        return device::outlet_pressure(p_const, rho_0, v);
    }
    Vec3 outlet_pressure_force(double m_j, double rho_0, double p_const, const Vec3& grad_W) const override
    {
        return device::outlet_pressure_force(rho_0, p_const, m_j * grad_W);
    }
    Vec3 wall_velocity() const override { return device::wall_velocity<double>(); }
    WallMotion advance_elastic_wall(const WallMotion& wall, double F_fluid, double k, double m_wall,
                                    double dt) const override
    {
        const auto next = device::advance_elastic_wall({wall.u, wall.v}, F_fluid, k, m_wall, dt);
        return {next.u, next.v};
    }
    Rebound collide(const Vec3& position, const Vec3& velocity, double depth, const Vec3& n) const override
    {
        Rebound after{position, velocity};
        device::collide(after.position, after.velocity, depth, n);
        return after;
    }
};

} // namespace

const Equations& device_equations()
{
    static const DeviceEquations equations;
    return equations;
}

} // namespace aneurysm::backends
