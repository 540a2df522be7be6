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

reference::WallTissue tissue(const WallTissue& w)
{
    return {.rho_F = w.rho_F,
            .a = w.a,
            .c = w.c,
            .K_E = w.K_E,
            .A_E = w.A_E,
            .K_C = w.K_C,
            .A_C = w.A_C,
            .m = w.m};
}

class ReferenceEquations final : public Equations
{
public:
    Vec3 momentum_force(double rho, const Vec3& g, const Vec3& F_viscosity,
                        const Vec3& F_pressure) const override
    {
        return reference::momentum_force(rho, g, F_viscosity, F_pressure);
    }
    double kernel_value(KernelName name, double h, double r) const override
    {
        return reference::Kernel(name, h).value(r);
    }
    Vec3 kernel_gradient(KernelName name, double h, const Vec3& x) const override
    {
        return reference::Kernel(name, h).gradient(x);
    }
    double viscosity_laplacian(double h, double r) const override
    {
        return reference::viscosity_laplacian(r, 2 * h);
    }
    double interpolate(KernelName name, double h, const Vec3& r,
                       std::span<const Carrier> carriers) const override
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
    double equation_of_state(double kappa, double rho, double rho_0) const override
    {
        return reference::equation_of_state(kappa, rho, rho_0);
    }
    Vec3 acceleration(double rho, const Vec3& force) const override
    {
        return reference::acceleration(rho, force);
    }

    double wall_stress(double P, double R, double h) const override
    {
        return reference::wall_stress(P, R, h);
    }
    double thickness_differential(double sigma, double h, double R, double dR) const override
    {
        return reference::thickness_differential(sigma, h, R, dR);
    }
    double porosity_differential(double sigma, double R, double dR) const override
    {
        return reference::porosity_differential(sigma, R, dR);
    }
    double stress_of_porosity(double Y, double phi) const override
    {
        return reference::stress_of_porosity(Y, phi);
    }
    double radius_per_pressure(double P, double R, double h, double Y, double sigma,
                               double phi) const override
    {
        return reference::radius_per_pressure(P, R, h, Y, sigma, phi);
    }
    double critical_pressure(double h, double R, double Y, double sigma, double phi) const override
    {
        return reference::critical_pressure(h, R, Y, sigma, phi);
    }
    Vec3 impulse_force(double m, const Vec3& v, double dt) const override
    {
        return reference::impulse_force(m, v, dt);
    }
    Hit impact_force(std::span<const std::int64_t> S, double m, std::span<const double> density,
                     std::span<const Vec3> force) const override
    {
        const reference::Impact impact = reference::impact_force(S, m, density, force);
        return {impact.force, impact.particle};
    }
    bool ruptures(double F_b, double area, double P_c) const override
    {
        return reference::ruptures(F_b, area, P_c);
    }

    double net_wall_force(double F_B, double F_F, double F_P) const override
    {
        return reference::net_wall_force(F_B, F_F, F_P);
    }
    double tissue_force(const WallTissue& wall, double u_t) const override
    {
        return reference::tissue_force(tissue(wall), u_t);
    }
    double fiber_force(const WallTissue& wall, double epsilon) const override
    {
        return reference::fiber_force(tissue(wall), epsilon);
    }
    double strain(double dR, double R) const override { return reference::strain(dR, R); }
    double radius_increment(const WallTissue& wall, double F_B, double R, double dt) const override
    {
        return reference::radius_increment(tissue(wall), F_B, R, dt);
    }
    double thickness_growing(double h, double R, double sigma, double dR) const override
    {
        return reference::thickness_growing(h, R, sigma, dR);
    }
    double thickness_developed(double h, double alpha, double dR, double largest) const override
    {
        return reference::thickness_developed(h, alpha, dR, largest);
    }

    double daughter_radius(double r_0) const override { return reference::daughter_radius(r_0); }

    double inlet_velocity(const Inlet& inlet, double t) const override
    {
        return reference::inlet_velocity(inlet.waveform, inlet.peak_velocity_m_s, inlet.cycle_s, t,
                                         inlet.table_time_s, inlet.table_velocity_m_s);
    }
    double outlet_pressure(double p_const, double rho_0, double v) const override
    {
        return reference::outlet_pressure(p_const, rho_0, v);
    }
    Vec3 outlet_pressure_force(double m_j, double rho_0, double p_const, const Vec3& grad_W) const override
    {
        return reference::outlet_pressure_force(m_j, rho_0, p_const, grad_W);
    }
    Vec3 wall_velocity() const override { return reference::wall_velocity(); }
    WallMotion advance_elastic_wall(const WallMotion& wall, double F_fluid, double k, double m_wall,
                                    double dt) const override
    {
        const auto next = reference::advance_elastic_wall({wall.u, wall.v}, F_fluid, k, m_wall, dt);
        return {next.u, next.v};
    }
    Rebound collide(const Vec3& position, const Vec3& velocity, double depth, const Vec3& n) const override
    {
        const reference::Collision after = reference::collide(position, velocity, depth, n);
        return {after.position, after.velocity};
    }
};

} // namespace

const Equations& reference_equations()
{
    static const ReferenceEquations equations;
    return equations;
}

} // namespace aneurysm::backends
