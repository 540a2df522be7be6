// SPDX-License-Identifier: Apache-2.0
// Section 3.1: the incompressible pressure (3).
#pragma once

#include "reference/blood_flow.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace aneurysm::reference
{

struct IncompressibleSettings {
    double rho_0 = 0;              ///< [kg/m^3]
    double relaxation = 0;         ///< omega, below relaxation_limit()
    double density_correction = 0; ///< beta: part of the density error that one step removes
    double tolerance = 0;          ///< for the mean |residual| / rho_0 [1/s]
    double max_tolerance = 0;      ///< for the largest |residual| / rho_0 [1/s]
    std::int64_t max_iterations = 0;
};

/// How the solve ended. All over free bodies, divided by rho_0 [1/s].
struct IncompressibleReport {
    std::int64_t iterations = 0;
    double residual_mean = 0; ///< of (3) where the pressure can act: p > 0, or compressed
    double residual_max = 0;
    double divergence_mean = 0; ///< |Drho/Dt|, which is rho |div v|, of the new velocity
    double divergence_max = 0;
};

/// Pressure acceleration in its momentum-conserving form, which is the adjoint of (2), so that the solve
/// below is a symmetric problem. A ghost adds its neighbor's pressure once (p_j = 0):
///
///     a_i = -sum_j m_j (p_i + p_j) / rho_0^2 grad W_ij                                        [m/s^2]
inline Vec3 pressure_acceleration(const Bodies& b, std::span<const Neighbor> neighbors,
                                  std::span<const double> p, double rho_0, std::size_t i)
{
    Vec3 a;
    for (const Neighbor& n : neighbors) {
        const double p_j = b.free(n.j) ? p[n.j] : 0;
        a += -b.mass[n.j] * (p[i] + p_j) / (rho_0 * rho_0) * n.grad_W;
    }
    return a;
}

/// DFSPH factor (Bender and Koschier 2015), the inverse of how (2) at i answers to p_i, up to -dt / rho_0^2;
/// 0 for a body without neighbors:
///
///     alpha_i = 1 / ( |sum_j m_j grad W_ij|^2 + sum_{j free} |m_j grad W_ij|^2 )               [m^8/kg^2]
double dfsph_factor(const Bodies& b, std::span<const Neighbor> neighbors);

/// Eq. (3)  Drho/Dt = 0 and div v = 0, in one coupled solve as in the paper's references 30 and 31: pressures
/// p >= 0 and the velocity v = v* + dt a(p) such that
///
///     beta (rho_i - rho_0) / dt + Drho_i/Dt(v) = 0   (<= 0 where p_i = 0: blood does not pull)
///
/// by the accelerated projected gradient method (Nesterov 1983) with restarts (O'Donoghue and Candes 2015),
/// from the pressures given (the last step's) as y and p_old, and t = 1. One iteration is
///
///     p_i    = max(0, y_i + omega rho_0^2 alpha_i residual_i / dt)
///     t     <- 1  if  sum_i (y_i - p_i) (p_i - p_old_i) / alpha_i > 0       (the momentum leads astray)
///     t'     = (1 + sqrt(1 + 4 t^2)) / 2,   theta = (t - 1) / t'
///     y_i    = max(0, p_i + theta (p_i - p_old_i));   p_old <- p,   t <- t'
///
/// with the residual of y; the y whose residual is within the tolerances is the solution. Spray, whose
/// alpha_i is out of all proportion, has no pressure and doesn't count.
///
/// With beta = 1 the density is rho_0 after the step, with beta = 0 the velocity is divergence-free.
///
/// \param b          bodies; their velocity is v*, before the pressure acts
/// \param p          pressure by body, in and out [Pa]
/// \param a          pressure acceleration by body, out; 0 for ghosts [m/s^2]
IncompressibleReport solve_incompressibility(const Bodies& b, const Neighbors& neighbors,
                                             std::span<const double> rho, double dt,
                                             const IncompressibleSettings& settings, std::span<double> p,
                                             std::span<Vec3> a);

/// How far a velocity v is from divergence-free, as above; the rest of the report is 0.
IncompressibleReport divergence_report(const Bodies& b, const Neighbors& neighbors, std::span<const Vec3> v,
                                       double rho_0);

/// The omega below which the iteration of (3) damps every mode of a full
/// cubic lattice with h/dx = ratio, for each theta:
///
///     4/3 / max_k lambda,   lambda(k) = alpha m^2 |sum_j grad W_j exp(-i k.r_j)|^2.
///
/// A step without momentum multiplies a mode's error by g = 1 - omega lambda <= 1, an iteration by the roots
/// of z^2 - (1 + theta) g z + theta g = 0. These are inside the unit circle while the left side is positive
/// at z = -1, which is 1 + (1 + 2 theta) g > 0; theta tends to 1, so that g must not be less than -1/3.
double relaxation_limit(KernelName kernel, double ratio);

/// Sum of W over the cubic lattice of spacing dx; rho_0 / this is the particle mass that makes the lattice's
/// density rho_0 [1/m^3].
double lattice_kernel_sum(const Kernel& kernel, double dx);

} // namespace aneurysm::reference
