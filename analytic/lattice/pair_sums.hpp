// SPDX-License-Identifier: Apache-2.0
// Oracles of section 3.1 for any cloud of particles: the same sums over all pairs, without a neighbor
// search, with the kernel's text of analytic/kernel_function.hpp.
#pragma once

#include "analytic/lattice/lattice.hpp"

#include <vector>

namespace aneurysm::analytic
{

/// Particles in a periodic cube. A `free` one is moved by forces; the others are ghosts.
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
};

// Each error bounds the rounding of any text of the same sum: n additions, and for each term 32 u, and 8 u of
// the cube's edge through the difference of positions, of the kernel's (slope's, Laplacian's) largest value.

/// Eq. (2)  sum_j m_j (v_i - v_j).grad W_ij [kg/(m^3 s)].
Estimate pair_density_rate(const Cloud& cloud, std::size_t i);

/// Eq. (4)  sum_j A_j m_j/rho_j W(r - r_j), A the pressure; not periodic [Pa].
Estimate pair_interpolation(const Cloud& cloud, const Eigen::Vector3d& r);

/// Eq. (5)  sum_j m_j W_ij [kg/m^3].
Estimate pair_density(const Cloud& cloud, std::size_t i);

/// Eq. (2)  As the time derivative of (5): the imaginary part of sum_j m_j W(|x_ij + i t v_ij|) over t, with
/// a t so small that t^2 is nothing (complex step). No gradient is written down. The error is that of the
/// sums above, with 64 u more for the terms of the kernels' powers, six times the largest slope, 16 roundings
/// on each [kg/(m^3 s)].
Estimate pair_density_slope(const Cloud& cloud, std::size_t i);

/// Eq. (6)  -sum_j m_j (p_i + p_j)/(2 rho_j) grad W_ij, p_j = p_i for ghosts [N/m^3].
VectorEstimate pair_pressure_force(const Cloud& cloud, std::size_t i);

/// Eq. (7)  mu sum_j m_j (v_j - v_i)/rho_j lap W_ij [N/m^3].
VectorEstimate pair_viscosity_force(const Cloud& cloud, double mu, std::size_t i);

/// Eq. (3)  -sum_j m_j (p_i + p_j)/rho_0^2 grad W_ij, p_j = 0 for ghosts: the adjoint of (2) [m/s^2].
VectorEstimate pair_pressure_acceleration(const Cloud& cloud, double rho_0, std::size_t i);

/// Eq. (3)  1/(|sum_j m_j grad W_ij|^2 + sum_{j free} |m_j grad W_ij|^2) [m^8/kg^2].
Estimate pair_dfsph_factor(const Cloud& cloud, std::size_t i);

/// Who is within the support of i, itself left out.
std::vector<std::size_t> pair_neighbors(const Cloud& cloud, std::size_t i);

} // namespace aneurysm::analytic
