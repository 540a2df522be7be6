// SPDX-License-Identifier: Apache-2.0
// Oracles of section 3.1 for any cloud of particles: the same sums over all pairs, without a neighbor
// search, with the kernel's text of analytic/kernel_function.hpp.
#pragma once

#include "analytic/lattice/lattice.hpp"

#include <vector>

namespace aneurysm::analytic
{

/// How bodies that forces don't move take part in (3): as mirror images, with the pressure p_i of their neighbor and
/// the velocity 2 v_j - v_i, or as what they are, without a pressure.
enum class Given { mirrors, at_rest };

/// Particles in a periodic cube. A `free` one is moved by forces; the others, ghosts and the inlet's blood, are
/// given.
struct Cloud {
    KernelName kernel = KernelName::cubic_spline;
    double h = 0;      ///< [m]
    double period = 0; ///< edge of the cube; more than 4 h [m]
    std::vector<Eigen::Vector3d> position;
    std::vector<Eigen::Vector3d> velocity;
    std::vector<double> mass;
    std::vector<double> density;
    std::vector<double> pressure;
    std::vector<bool> free;
    Given given = Given::mirrors;
};

// Each error bounds the rounding of any text of the same sum: n additions, and for each term 32 u, and 8 u of
// the cube's edge through the difference of positions, of the kernel's (slope's, Laplacian's) largest value.

/// Eq. (2)  sum_j w_j m_j (v_i - v_j).grad W_ij, w_j = 2 for mirror images, else 1 [kg/(m^3 s)].
Estimate pair_density_rate(const Cloud& cloud, std::size_t i);

/// Eq. (4)  sum_j A_j m_j/rho_j W(r - r_j), A the pressure; not periodic [Pa].
Estimate pair_interpolation(const Cloud& cloud, const Eigen::Vector3d& r);

/// Eq. (5)  sum_j m_j W_ij [kg/m^3].
Estimate pair_density(const Cloud& cloud, std::size_t i);

/// Eq. (5)  sum_j m_j W(r_ij + way_i - way_j) over those that are neighbors before they go their ways, which are known to
/// way_error [kg/m^3].
Estimate pair_density_ahead(const Cloud& cloud, const std::vector<Eigen::Vector3d>& way, std::size_t i,
                            double way_error = 0);

/// Shift -beta dx^2 sum_j m_j/rho_0 grad W_ij [m].
VectorEstimate pair_shift(const Cloud& cloud, double rho_0, double dx, double beta, std::size_t i);

/// Shepard's mean sum_j A_j W_ij / sum_j W_ij over the bodies that have an A and a mass [A].
Estimate pair_mean(const Cloud& cloud, const std::vector<double>& A, std::size_t i);

/// Eq. (27)  -sum_i v_i W_ij / sum_i W_ij over the free bodies i that see the ghost j of a wall at rest, whose
/// velocity it has in (7) [m/s]; 0 where none does. An error of W_ij counts by how far v_i is from the mean; it is
/// 32 u of the kernel's terms, and its slope times 8 u of the cube's edge.
VectorEstimate pair_no_slip_velocity(const Cloud& cloud, std::size_t j);

/// Eq. (2)  As the time derivative of (5): the imaginary part of sum_j m_j W(|x_ij + i t v_ij|) over t, with
/// a t so small that t^2 is nothing (complex step), where v_ij of a mirror image is 2 (v_i - v_j). No gradient is
/// written down. The error is that of the sums above, with 64 u more for the terms of the kernels' powers, six times the largest slope, 16 roundings
/// on each [kg/(m^3 s)].
Estimate pair_density_slope(const Cloud& cloud, std::size_t i);

/// Eq. (6)  -sum_j m_j (p_i + p_j)/(2 rho_j) grad W_ij, p_j = p_i for what is given [N/m^3].
VectorEstimate pair_pressure_force(const Cloud& cloud, std::size_t i);

/// Eq. (7)  mu sum_j m_j (v_j - v_i)/rho_j lap W_ij [N/m^3].
VectorEstimate pair_viscosity_force(const Cloud& cloud, double mu, std::size_t i);

/// Eq. (26)  2 p sum_j m_j/rho_0 grad W_ij [N/m^3].
VectorEstimate pair_outlet_force(const Cloud& cloud, double rho_0, double p, std::size_t i);

/// Eq. (3)  -sum_j m_j (p_i + p_j)/rho_0^2 grad W_ij, p_j = p_i for mirror images and 0 for what is at rest: the
/// adjoint of (2) [m/s^2].
VectorEstimate pair_pressure_acceleration(const Cloud& cloud, double rho_0, std::size_t i);

/// Eq. (3)  1/(|sum_j w_j m_j grad W_ij|^2 + sum_{j free} |m_j grad W_ij|^2) [m^8/kg^2].
Estimate pair_dfsph_factor(const Cloud& cloud, std::size_t i);

/// Who is within the support of i, itself left out.
std::vector<std::size_t> pair_neighbors(const Cloud& cloud, std::size_t i);

} // namespace aneurysm::analytic
