// SPDX-License-Identifier: Apache-2.0
// Flow from rest of a duct on the lattice, in the steps that the particle method takes:
//
//     u' = u + dt (A u + g(t)),   t at the end of the step.
#pragma once

#include "analytic/laminar_flow.hpp"
#include "analytic/lattice/lattice_duct.hpp"

namespace aneurysm::analytic
{

/// The steps in closed form: with A v = -lambda v, 1 = sum b v, q = 1 - dt lambda and z = e^(i omega dt) the
/// modes v have the amplitudes
///
///     c_n = g b (1 - q^n)/lambda                            if g is steady
///     c_n = dt g b Im( z (z^n - q^n)/(z - q) )              if it is g sin(omega t).
class DuctModes
{
public:
    /// Eigenvectors by gsl_eigen_symmv.
    explicit DuctModes(const DuctOperator& A);

    /// After n steps. The error is that of the amplitudes, and by how much the modes fail to be modes or to
    /// add up to 1, times what such a disturbance lasts. \throws std::invalid_argument when 1 + dt A has
    /// negative elements: disturbances might grow
    Profile after(const Drive& drive, double dt, int n) const;

    const Eigen::VectorXd& rates() const { return rates_; } ///< lambda, falling [1/s]
    double largest_step() const { return 2 / rates_(0); }   ///< dt below which no mode grows [s]

private:
    Eigen::VectorXd rates_;
    Eigen::MatrixXd modes_;
    Eigen::VectorXd parts_;     ///< b
    Eigen::VectorXd residuals_; ///< largest |A v + lambda v| of each mode
    double parts_error_ = 0;    ///< largest |1 - sum b v|
    double largest_diagonal_ = 0;
    double time_scale_ = 0;
};

/// The steps one by one, in long double.
Profile step_by_step(const DuctOperator& A, const Drive& drive, double dt, int n);

/// How far the same steps by another text may lead away from these [m/s]. In each step it may be off by dt
/// times uncertainty() on the flow, by the roundings of v + dt (F/rho + g), and by those of the phase omega
/// t: the sum of all, or the largest times what it lasts.
double step_uncertainty(const DuctOperator& A, const Drive& drive, double dt, int n, double roundoff,
                        double displacement);

} // namespace aneurysm::analytic
