// SPDX-License-Identifier: Apache-2.0
// The sums of pair_sums.hpp once more, from what defines the kernels:
// each term from the B-spline's recursion, Wendland's integral and differences,
// over every periodic image by itself, added up with 50 digits.
#pragma once

#include "analytic/lattice/pair_sums.hpp"

namespace aneurysm::analytic
{

/// All sums of one particle. An error bounds what is lost where a term is rounded to double.
struct ExactPairs {
    Estimate density_rate;           ///< Eq. (2) [kg/(m^3 s)]
    Estimate density;                ///< Eq. (5) [kg/m^3]
    Estimate density_ahead;          ///< Eq. (5), when all have moved by `time` times their velocity [kg/m^3]
    Estimate mean;                   ///< Shepard's mean of the pressures [Pa]
    VectorEstimate no_slip_velocity; ///< Eq. (27) [m/s]
    VectorEstimate outlet_force;     ///< Eq. (26) with p = rho_0/2, which is sum_j m_j grad W_ij [N/m^3]
    VectorEstimate pressure_force;   ///< Eq. (6) [N/m^3]
    VectorEstimate viscosity_force;  ///< Eq. (7) [N/m^3]
    VectorEstimate pressure_acceleration; ///< Eq. (3) [m/s^2]
    Estimate dfsph_factor;                ///< Eq. (3) [m^8/kg^2]
    std::size_t neighbors = 0;            ///< itself left out
};

/// Of particle i. Differences of the cloud's positions, before and after they move, and its period must be exact in
/// double.
ExactPairs exact_pairs(const Cloud& cloud, double mu, double rho_0, double time, std::size_t i);

} // namespace aneurysm::analytic
