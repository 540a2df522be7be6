// SPDX-License-Identifier: Apache-2.0
// The paper's relations as they are meant, unsolved, with 50 digits: each function takes an answer and says
// how far the relation's terms are from adding up, over half the sum of their magnitudes. That is the error
// of the answer, times its share in the terms, and of nothing else. A relation of forces or energies stands
// here where the paper gives a formula for the answer.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace aneurysm::analytic
{

/// Eq. (EOS)  p = kappa (rho - rho_0), with the densities' difference taken first.
double state_imbalance(double kappa, double rho, double rho_0, double p);

/// Eq. (8)  P pi R^2 = Sigma 2 pi R h.
double laplace_imbalance(double P, double R, double h, double Sigma);

/// Eq. (9)  dh/h = -sigma dR/R.
double thinning_imbalance(double sigma, double h, double R, double dR, double dh);

/// Eq. (10)  dphi = -dV/V of the volume V = 4 pi R^2 h, which is differenced along (9).
double porosity_imbalance(double sigma, double R, double dR, double dphi);

/// Eq. (11) turned over: phi = exp(-3 Sigma/(2 Y)); an error of Sigma counts |ln phi| times.
double porous_stress_imbalance(double Y, double phi, double Sigma);

/// A wall's state, (8)-(13).
struct WallState {
    double P = 0;     ///< pressure [Pa]
    double R = 0;     ///< radius [m]
    double h = 0;     ///< thickness [m]
    double Y = 0;     ///< yield limit [Pa]
    double sigma = 0; ///< Poisson's ratio
    double phi = 0;   ///< porosity
};

/// Eq. (12) before it is solved, and with dP = 0 Eq. (13): the stress that (8) gains by dP, dR and the
/// thinning (9) is that which (11) gains by (10).
double wall_law_imbalance(const WallState& wall, double dR, double dP);

/// Section 3.2's criterion: (F - P_c area)/(P_c area) of the load F, exactly.
double excess(double F, double area, double P_c);

/// The wall's load F of (16): F m = F_b M.
double load_imbalance(double F_b, double M, double m, double F);

/// Eq. (14)  F dt = m v, of one component.
double impulse_imbalance(double m, double v, double dt, double F);

/// Eq. (15)  rho a = F, of one component.
double acceleration_imbalance(double rho, double F, double a);

/// Eq. (16)  (rho F_b)^2 = m^2 |F|^2 of the hardest hit; an error of F_b counts twice.
double hit_imbalance(double m, double rho, const Eigen::Vector3d& F, double F_b);

/// Eq. (17)  F_T + F_F + F_P = F_B.
double wall_force_imbalance(double F_B, double F_F, double F_P, double F_T);

/// Eq. (18)  Power F_F u_t = energy that a plane wave of speed u_t takes along in a second, rho_F u_t^2/2 of
/// motion and as much of compression in the volume a c.
double radiated_power_imbalance(double rho_F, double a, double c, double u_t, double F_F);

/// What resists the growth, (18) and (19).
struct Tissue {
    double rho_F = 0; ///< [kg/m^3]
    double a = 0;     ///< [m^2]
    double c = 0;     ///< [m/s]
    double K_E = 0;   ///< [N/m]
    double A_E = 0;   ///< [m^2]
    double K_C = 0;   ///< [N/m]
    double A_C = 0;   ///< [m^2]
    double m = 0;     ///< [kg]
};

/// Eq. (19)  Work F_P epsilon/2 of a force that rises in proportion = energy of both fibers.
double fiber_work_imbalance(const Tissue& tissue, double epsilon, double F_P);

/// Eq. (20)  epsilon R = dR.
double strain_imbalance(double dR, double R, double epsilon);

/// Eq. (21)  F_B against the momentum m dR/dt taken up in dt and each resistance, (17)-(20).
double growth_imbalance(const Tissue& tissue, double F_B, double R, double dt, double dR);

/// Eq. (22)  h' - h = -h sigma dR/R.
double thinning_step_imbalance(double h, double R, double sigma, double dR, double h_new);

/// Eq. (23)  h' - h = -h alpha dR, where dR has been cut down to `largest`.
double developed_step_imbalance(double h, double alpha, double dR, double largest, double h_new);

/// Eq. (24)  r_0^3 = sum of the daughters' r^3; an error of all r counts three times.
double murray_imbalance(double r_0, const std::vector<double>& daughters);

/// Eq. (26)  F rho_0 = 2 p sum_j m_j dW_j/dx, of one component.
double outlet_force_imbalance(const std::vector<double>& m, double rho_0, double p,
                              const std::vector<double>& dW_dx, double F);

/// Work over the depth D of a buffer = energy of the blood that comes back through it from rest, F D = rho_0 v^2/2.
double inflow_imbalance(double rho_0, double v, double D, double F);

/// Eq. (28)  F - k u - m (u_after - 2 u + u_before)/dt^2, which symplectic Euler steps make 0 [N].
double oscillator_residual(double m, double k, double F, double dt, double u_before, double u,
                           double u_after);

/// Eq. (28)  u_after - u - dt v_after, 0 for the same steps [m].
double displacement_residual(double dt, double u, double u_after, double v_after);

/// What a collision must make 0.
struct CollisionResidual {
    double normal = 0;     ///< n.(v' + v), or n.(v' - v) of a particle that leaves the wall [m/s]
    double tangential = 0; ///< largest component of v' - v but for its part along n [m/s]
    double place = 0;      ///< largest component of r - r' - depth n [m]
};

/// Fig. 1  n is made a unit vector first.
CollisionResidual collision_residual(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity,
                                     double depth, const Eigen::Vector3d& n,
                                     const Eigen::Vector3d& position_after,
                                     const Eigen::Vector3d& velocity_after);

} // namespace aneurysm::analytic
