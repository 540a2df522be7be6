// SPDX-License-Identifier: Apache-2.0
// Flow along a straight duct whose columns slide past one another, each as a whole: what the particle method
// makes of a fast flow there as long as no pressure acts,
//
//     rho_a = sum_b m_b S_ab(W),   du_a/dt = sum_b mu m_b/(rho_a rho_b) S_ab(lap W) (u_b - u_a) + g(t),
//     S_ab(f) = sum_k f(x_b - x_a, s_b - s_a + k dx),   u' = u + dt du/dt,   s' = s + dt u',
//
// with ghosts at rest, s = 0 and rho_0.
#pragma once

#include "analytic/laminar_flow.hpp"
#include "analytic/lattice/column_sum.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>

namespace aneurysm::analytic
{

class SlidingDuct
{
public:
    explicit SlidingDuct(const LatticeDuct& duct);

    /// Eq. (5), Eq. (7) and Eq. (15)  One step, from rest on; the force is that of its end.
    void step(const Drive& drive, double dt);

    const Eigen::VectorXd& velocity() const { return states_.back().velocity; } ///< by column [m/s]
    const Eigen::VectorXd& slid() const { return states_.back().slid; }         ///< from the start [m]
    Eigen::VectorXd density() const { return densities(slid()).value; }         ///< [kg/m^3]

    /// Bound of how far any velocity of the same steps by another text may be from these [m/s], to first
    /// order: what each step's roundings, times its linearized successors, add up to with the worst signs,
    ///
    ///     sum_k |dv_n/dv_k| eta_k + |dv_n/ds_k| theta_k.
    ///
    /// \param roundoff  of the other text's arithmetic [1]
    /// \param extent    of its coordinates, which it rounds [m]
    double error(double roundoff, double extent) const;

private:
    struct State {
        Eigen::VectorXd velocity;
        Eigen::VectorXd slid;
        double dt = 0; ///< of the step that led here, as the rest
        double force = 0;
        double phase = 0;
    };
    /// A column within reach of another, or a ghost.
    struct Neighbor {
        Eigen::Index b = -1; ///< -1: a ghost's
        Column column;       ///< relative to the other one's place
    };
    struct Densities {
        Eigen::VectorXd value;
        Eigen::SparseMatrix<double> per_slide; ///< d rho_a/d s_b
        double of_rounding = 0;                ///< relative, of any, per roundoff
        double of_distance = 0;                ///< and per displacement
    };
    /// du/dt without the force, linearized.
    struct Friction {
        Eigen::VectorXd value;
        Eigen::SparseMatrix<double> per_velocity;
        Eigen::SparseMatrix<double> per_slide;
        Eigen::VectorXd of_rounding;
        Eigen::VectorXd of_distance;
    };
    Densities densities(const Eigen::VectorXd& slid) const;
    Friction friction(const State& state) const;
    Eigen::MatrixXd rows_of_identity() const;

    LatticeDuct duct_;
    RadialKernel W_;
    RadialKernel lap_W_;
    std::vector<std::vector<Neighbor>> neighbors_;
    std::vector<State> states_;
};

} // namespace aneurysm::analytic
