// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario/scenario.hpp"
#include "common/vec3.hpp"
#include "common/wall.hpp"

#include <cstdint>
#include <span>

namespace aneurysm::backends
{

/// A body that (4) interpolates from.
struct Carrier {
    Vec3 position;       ///< [m]
    double mass = 0;     ///< [kg]
    double rho = 0;      ///< [kg/m^3]
    double A = 0;        ///< value of the field
    bool absent = false; ///< in the reserve: takes no part
};

using Inlet = decltype(Scenario::inlet);

/// The scalar equations as one backend computes them, so that a check is written once for all. Arguments and
/// units are those of the functions of the same names in reference/.
struct Equations {
    // Section 3.1: (1), the kernel of (4)-(6), the Laplacian
    // of (7) with the support radius 2 h, (4), EOS; (15)
    Vec3 (*momentum_force)(double rho, const Vec3& g, const Vec3& F_viscosity, const Vec3& F_pressure);
    double (*kernel_value)(KernelName name, double h, double r);
    Vec3 (*kernel_gradient)(KernelName name, double h, const Vec3& x);
    double (*viscosity_laplacian)(double h, double r);
    double (*interpolate)(KernelName name, double h, const Vec3& r, std::span<const Carrier> carriers);
    double (*equation_of_state)(double kappa, double rho, double rho_0);
    Vec3 (*acceleration)(double rho, const Vec3& force);

    // Section 3.2: (8)-(14), (16) and the criterion
    double (*wall_stress)(double P, double R, double h);
    double (*thickness_differential)(double sigma, double h, double R, double dR);
    double (*porosity_differential)(double sigma, double R, double dR);
    double (*stress_of_porosity)(double Y, double phi);
    double (*radius_per_pressure)(double P, double R, double h, double Y, double sigma, double phi);
    double (*critical_pressure)(double h, double R, double Y, double sigma, double phi);
    Vec3 (*impulse_force)(double m, const Vec3& v, double dt);
    Impact (*impact_force)(std::span<const std::int64_t> S, double m, std::span<const double> density,
                           std::span<const Vec3> force);
    double (*wall_load)(double F_b, double M, double m);
    bool (*ruptures)(double F, double area, double P_c);

    // Section 3.3: (17)-(23)
    double (*net_wall_force)(double F_B, double F_F, double F_P);
    double (*tissue_force)(const WallTissue& wall, double u_t);
    double (*fiber_force)(const WallTissue& wall, double epsilon);
    double (*strain)(double dR, double R);
    double (*radius_increment)(const WallTissue& wall, double F_B, double R, double dt);
    double (*thickness_growing)(double h, double R, double sigma, double dR);
    double (*thickness_developed)(double h, double alpha, double dR, double largest);

    // Section 3.4: (24)
    double (*daughter_radius)(double r_0);

    // Section 3.5: (25)-(28) and Fig. 1
    double (*inlet_velocity)(const Inlet& inlet, double t);
    double (*inlet_profile)(InletProfile profile, double r_squared, double radius);
    double (*inlet_ramp)(double ramp, double t);
    /// Of neighbors with the masses m and the gradients grad_W.
    Vec3 (*outlet_pressure_force)(std::span<const double> m, std::span<const Vec3> grad_W, double rho_0,
                                  double p);
    Vec3 (*inflow_force)(double rho_0, double v, double D, const Vec3& outward);
    Vec3 (*wall_velocity)();
    ElasticWall (*advance_elastic_wall)(const ElasticWall& wall, double F_fluid, double k, double m_wall,
                                        double dt);
    Collision (*collide)(const Vec3& position, const Vec3& velocity, double depth, const Vec3& n);
};

/// In double; both backends' scalar equations are double in either precision.
const Equations& reference_equations();
const Equations& device_equations();

} // namespace aneurysm::backends
