// SPDX-License-Identifier: Apache-2.0
// Flow along a straight duct whose particles stay on the cubic lattice: columns along the axis move as one,
// so that (7) and (15) become a matrix,
//
//     du_a/dt = sum_b c_ab (u_b - u_a) + g(t),   c_ab = mu m_b/(rho_a rho_b) sum_k lap W(x_ab, k dx),
//
// over the other columns and the wall's ghosts, whose density is rho_0 and whose velocity is that which makes the blood's
// vanish on the wall, u_b = -sum_a u_a w_ab / sum_a w_ab with w_ab = sum_k W(x_ab, k dx). The sums run over the lattice
// points k dx of a column. What the particle method makes of the duct is then known to rounding.
#pragma once

#include "analytic/lattice/column_sum.hpp"

#include <Eigen/Dense>

#include <vector>

namespace aneurysm::analytic
{

/// Numbers by pair of columns, and by column and all of the wall; in the matrix of du/dt times u_b - u_a, where the
/// ghosts' u_b are means of the blood's.
struct Couplings {
    Eigen::MatrixXd between; ///< symmetric, 0 on the diagonal
    Eigen::VectorXd wall;

    /// max_a ( sum_b between_ab |u_b - u_a| + 2 wall_a max |u| )
    double largest_sum(const Eigen::VectorXd& velocity) const;
};

/// The matrix A.
class DuctOperator
{
public:
    explicit DuctOperator(const LatticeDuct& duct);

    const Eigen::MatrixXd& matrix() const { return A_; }        ///< of du/dt [1/s]
    const Eigen::VectorXd& density() const { return density_; } ///< Eq. (5), by column [kg/m^3]

    /// What another text of du/dt, which sums over all neighbors of a particle, may add to the couplings.
    /// \param roundoff      of its arithmetic [1]
    /// \param displacement  by which its distances may be off [m]
    /// \return [1/s]
    Couplings uncertainty(double roundoff, double displacement) const;

    /// Bound of the largest row sum of |A^-1|: a steady flow under a force of at most 1 is no faster [s].
    /// From an inverse X by LU, |X| / (1 - |1 - A X|).
    double time_scale() const { return time_scale_; }

private:
    void set_density(const LatticeDuct& duct);
    void set_couplings(const LatticeDuct& duct);
    void set_ghosts(const LatticeDuct& duct);
    void set_time_scale();

    Eigen::MatrixXd A_;
    Eigen::VectorXd density_;
    Couplings couplings_;
    Couplings of_rounding_;       ///< uncertainty per roundoff
    Couplings of_distance_;       ///< and per displacement [1/(s m)]
    double neighbors_ = 0;        ///< most particles within one's support
    double density_rounding_ = 0; ///< largest relative uncertainty of a density per roundoff
    double density_distance_ = 0; ///< and per displacement [1/m]
    double time_scale_ = 0;
};

/// Velocities by column, and the bound of each one's error, as the flow of exactly the given matrix [m/s].
struct Profile {
    Eigen::VectorXd value;
    double error = 0;
};

/// Eq. (7) and Eq. (15) at rest with a constant g: A u = -g by GSL's LU decomposition; the error is what
/// A u + g differs from 0, times time_scale.
Profile steady_flow(const DuctOperator& A, double g);
/// The same by Eigen's QR decomposition.
Profile steady_flow_by_qr(const DuctOperator& A, double g);

} // namespace aneurysm::analytic
