// SPDX-License-Identifier: Apache-2.0
// Section 3.1: incompressible blood, (3), in its two parts: the pressure, which keeps the velocity free of
// divergence, and the correction of the density, which moves particles and leaves their velocity alone.
#pragma once

#include "common/vessel/slices.hpp"
#include "reference/blood_flow.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace aneurysm::reference
{

/// How bodies of given velocity, the wall's ghosts and the inlet's blood, take part in a solve.
enum class Given : std::uint8_t {
    mirrors, ///< as mirror images: pressure p_i and velocity 2 v_j - v_i, so that each counts twice
    at_rest, ///< as what they are: without a pressure of their own
};

/// One problem of the form (3): potentials p and the velocity v = v* + dt a(p) such that
///
///     source_i + Drho_i/Dt(v) = 0,  p_i >= lowest_i      (<= 0 where p_i = lowest_i)          [kg/(m^3 s)]
///
/// for each free body i. v* is the bodies' velocity.
struct IncompressibleProblem {
    /// Free ones and given ones.
    const Bodies* bodies = nullptr;
    /// Of each body.
    const Neighbors* neighbors = nullptr;
    /// What those that aren't free do.
    Given given = Given::mirrors;
    double rho_0 = 0;               ///< [kg/m^3]
    double dt = 0;                  ///< [s]
    std::span<const double> source; ///< by body [kg/(m^3 s)]
    std::span<const double> lowest; ///< by body [Pa]
    /// In which the solve starts, see slices.hpp; without any it starts from p alone.
    Slices slices;
};

/// When the solve of (3) stops, and how large its steps are.
struct IncompressibleSettings {
    double relaxation = 0;    ///< omega, below relaxation_limit()
    double tolerance = 0;     ///< for the mean |residual| / rho_0 [1/s]
    double max_tolerance = 0; ///< for the largest |residual| / rho_0 [1/s]
    /// Then it stops, whatever the residual is.
    std::int64_t max_iterations = 0;
};

/// How the solve ended. All over free bodies, divided by rho_0 [1/s].
struct IncompressibleReport {
    /// How many it took.
    std::int64_t iterations = 0;
    double residual_mean = 0; ///< of (3) where the pressure can act
    /// The largest.
    double residual_max = 0;
    double divergence_mean = 0; ///< |Drho/Dt|, which is rho |div v|, of the new velocity
    /// The largest.
    double divergence_max = 0;
};

/// How often the gradient at a neighbor j counts for what is not free: 2 for a mirror image.
inline double weight(const Bodies& b, Given given, std::size_t j)
{
    return given == Given::mirrors && !b.free(j) ? 2 : 1;
}

/// Eq. (2)  Drho/Dt = -rho div v, as the time derivative of (5), in which mirror images count twice:
///
///     Drho_i/Dt = sum_j w_j m_j (v_i - v_j) . grad W_ij                                       [kg/(m^3 s)]
double density_rate(const IncompressibleProblem& problem, std::span<const Vec3> v, std::size_t i);

/// Pressure acceleration in its momentum-conserving form, which is the adjoint of the rate above, so that the
/// solve is a symmetric problem; p_j = p_i for a mirror image, p_j = 0 for what is at rest:
///
///     a_i = -sum_j m_j (p_i + p_j) / rho_0^2 grad W_ij                                        [m/s^2]
Vec3 pressure_acceleration(const IncompressibleProblem& problem, std::span<const double> p, std::size_t i);

/// DFSPH factor (Bender and Koschier 2015), the inverse of how the rate at i answers to p_i, up to
/// -dt / rho_0^2; 0 for a body without neighbors:
///
///     alpha_i = 1 / ( |sum_j w_j m_j grad W_ij|^2 + sum_{j free} |m_j grad W_ij|^2 )           [m^8/kg^2]
double dfsph_factor(const IncompressibleProblem& problem, std::size_t i);

/// Eq. (3)  Solves it by the accelerated projected gradient method (Nesterov 1983) with restarts (O'Donoghue and
/// Candes 2015), from the p given as y and p_old, and t = 1. One iteration is
///
///     p_i    = max(lowest_i, y_i + omega rho_0^2 alpha_i residual_i / dt)
///     t     <- 1  if  sum_i (y_i - p_i) (p_i - p_old_i) / alpha_i > 0       (the momentum leads astray)
///     t'     = (1 + sqrt(1 + 4 t^2)) / 2,   theta = (t - 1) / t'
///     y_i    = max(lowest_i, p_i + theta (p_i - p_old_i));   p_old <- p,   t <- t'
///
/// Where the problem has slices and p is no solution, it starts from p and a constant in each slice.
///
/// with the residual of y; the y whose residual is within the tolerances is the solution. Spray, whose
/// alpha_i is out of all proportion, has no pressure and doesn't count.
///
/// \param p   potential by body, in and out [Pa]
/// \param a   acceleration by body, out; 0 for what is not free [m/s^2]
IncompressibleReport solve_incompressibility(const IncompressibleProblem& problem,
                                             const IncompressibleSettings& settings, std::span<double> p,
                                             std::span<Vec3> a);

/// How far a velocity v is from divergence-free, as above; the rest of the report is 0.
IncompressibleReport divergence_report(const IncompressibleProblem& problem, std::span<const Vec3> v);

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
