// SPDX-License-Identifier: Apache-2.0
// Planes y = const of the cubic lattice, its rows, as they slide past each other in a shear flow, and as they
// lie on one another between two walls.
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

/// All values that something takes, rounding aside.
struct Range {
    double least = 0;
    double most = 0;
};

/// Eq. (7)  nu_eff/nu of rows that have slid along x, each by any distance s from its neighbors,
///
///     V sum_{n > 0} (n dx)^2 S_n(s),   S_n(s) = sum over row n of lap W,
///
/// at the density rho_0 [1]. The extremes over a grid of s,
/// widened by what S_n can change between its points.
Range sliding_viscosity_ratio(const Lattice& lattice);

/// Eq. (5)  rho/rho_0 of the same rows, as long as none leaves its plane [1].
Range sliding_density_ratio(const Lattice& lattice);

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

/// What the incompressible solve (3) with beta = 0 makes of rows that all have the velocity v before it.
struct RowPressure {
    Eigen::VectorXd pressure;         ///< by row, from the lower wall up [Pa]
    Eigen::VectorXd velocity;         ///< upwards, after the solve [m/s]
    Eigen::VectorXd rate;             ///< Drho/Dt with it [kg/(m^3 s)]
    double pressure_error = 0;        ///< [Pa]
    double velocity_error = 0;        ///< [m/s]
    double pressure_per_residual = 0; ///< how far p may be off for each 1/s of residual/rho_0 [Pa s]
    double velocity_per_residual = 0; ///< and the velocity [m]
    int null_modes =
        0; ///< independent changes of the pressures, of those rows whose rate is 0, that move nothing
};

/// Eq. (3)  With gamma_n = sum over row n of dW/dy, which is odd in n, and B_ij = gamma_{j - i}:
///
///     a = -m/rho_0^2 B p,   Drho/Dt = -m B v,
///
/// since sum_n gamma_n = 0 takes p_i and v_i out, and ghosts have neither. So the solve finds the p >= 0 with
/// the least |v + dt a|: Drho/Dt = 0 where p > 0, and <= 0 where p = 0. By the method of Lawson and Hanson
/// (Solving Least Squares Problems, 1974); errors from the residuals.
///
/// A row at a wall has free rows on one side only, which can but push it toward the wall, whose ghosts carry
/// no pressure: (3) doesn't hold it on the lattice, to first order in the displacement. With h = dx only next
/// rows couple, so that odd and even rows don't feel each other.
RowPressure row_pressure(const RowColumn& column, double v, double dt);

} // namespace aneurysm::analytic
