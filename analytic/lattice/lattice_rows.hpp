// SPDX-License-Identifier: Apache-2.0
// Planes y = const of the cubic lattice, its rows, in a shear flow, and as they lie on one another between
// two walls.
#pragma once

#include "analytic/lattice/lattice.hpp"

#include <Eigen/Dense>

namespace aneurysm::analytic
{

/// Eq. (7)  What a linear shear flow on the resting lattice feels, as a part of the viscosity: the limit of
/// viscosity_sum(k)/k^2 for k -> 0, times a particle's volume V = m/rho,
///
///     nu_eff/nu = V/6 sum_x r^2 lap W(x)                                                      [1]
Estimate viscosity_ratio(const Lattice& lattice);

/// Eq. (7)  How much a row leaves of what a wall does to a steady shear flow besides moving its zero: the
/// largest |z| < 1 with sum_n S_n(0) (z^n + z^-n - 2) = 0, n > 0. Divided by (z - 1)^2/z that is a
/// polynomial, solved by gsl_poly_complex_solve; 0 where only next rows couple [1].
double wall_layer_ratio(const Lattice& lattice);

/// Rows at rest between two walls, on a lattice that goes on beyond them as ghosts.
struct RowColumn {
    Lattice lattice;
    double rho_0 = 0; ///< [kg/m^3]
    int rows = 0;
};

/// What the incompressible solve (3) makes of rows that all have the velocity v before it.
struct RowPressure {
    Eigen::VectorXd pressure;         ///< by row, from the lower wall up; the part without null modes [Pa]
    Eigen::VectorXd velocity;         ///< upwards, after the solve [m/s]
    Eigen::VectorXd rate;             ///< Drho/Dt with it [kg/(m^3 s)]
    double pressure_error = 0;        ///< [Pa]
    double velocity_error = 0;        ///< [m/s]
    double pressure_per_residual = 0; ///< how far p may be off for each 1/s of residual/rho_0 [Pa s]
    double velocity_per_residual = 0; ///< and the velocity [m]
    int null_modes = 0;               ///< independent changes of the pressures that move nothing
};

/// Eq. (3)  With gamma_n = sum over row n of dW/dy, which is odd in n, and C_ij = gamma_{j - i} between rows, its
/// diagonal such that each row of C adds up to 0:
///
///     a = -m/rho_0^2 C p,   Drho/Dt = m C^T v,
///
/// since ghosts are mirror images, p_j = p_i and v_j = -v_i, and sum_n gamma_n = 0. A pressure that is the same in all
/// rows moves nothing, so that no bound keeps p from what has the least |v + dt a|, where Drho/Dt = 0. Errors from the
/// residuals.
///
/// With h = dx only next rows couple: p_{i+1} - p_{i-1} moves row i, p_1 - p_0 the lowest one.
RowPressure row_pressure(const RowColumn& column, double v, double dt);

} // namespace aneurysm::analytic
