// SPDX-License-Identifier: Apache-2.0
// Oracles of (3): the accelerated iteration on a full lattice, where it acts on every wave by itself but for
// the restarts, and for two bodies, where it is one of a single number.
#pragma once

#include "analytic/blood_flow.hpp"

#include <span>
#include <vector>

namespace aneurysm::analytic
{

/// Eq. (3)  Factor 1/(m^2 sum |grad W|^2) of a full lattice, where sum grad W = 0 [m^8/kg^2].
Estimate dfsph_factor(const Medium& medium);

/// Eq. (3)  g(k) = 1 - omega |G(k)|^2 / sum |grad W|^2: what a step without momentum leaves of the error of
/// the mode k [1]. 1 for k = 0 and for the checkerboard, which no pressure can change.
Estimate step_factor(const Lattice& lattice, double omega, const Eigen::Vector3d& k);

/// The wave cos(k.r) of the residual before the iteration.
struct ResidualWave {
    Eigen::Vector3d k;
    double residual = 0;      ///< amplitude, with the pressures at the start [kg/(m^3 s)]
    double mean_square = 0.5; ///< of cos(k.r) over the lattice; 1 where it is 1 or -1 everywhere
};

/// Amplitudes of waves after n = 0, 1, 2, ... iterations: [n][wave].
struct Iteration {
    std::vector<std::vector<Estimate>> pressure; ///< y, from its uniform start on [Pa]
    std::vector<std::vector<Estimate>> residual; ///< [kg/(m^3 s)]
    std::vector<double> theta;                   ///< of each iteration
    int restarts = 0;                            ///< those that changed t
    double reach = 0;                            ///< no pressure is further from the start than this [Pa]
    double margin = 0; ///< all tests for a restart come out the same if the differences of pressures in them
                       ///< are off by less than this in the quadratic mean [Pa]
};

/// Eq. (3)  The accelerated iteration from a uniform pressure, so high that none reaches 0: with
/// s = omega rho_0^2 alpha/dt r_0 an amplitude y goes to p = g y + s and on to p + theta (p - p_old); the
/// test for a restart is sum over the waves of <cos^2> (y - p) (p - p_old) > 0. The waves' k must differ, and
/// not by sign alone.
Iteration accelerated_waves(const Medium& medium, double omega, double dt,
                            std::span<const ResidualWave> waves, int n);

/// Eq. (3)  What errors of 1 in each p and in each y of an iteration with these theta and the factor g become
/// at most in any y, the sum of their magnitudes [1]. With -|g| all of them add up, which bounds them where
/// pressures reach 0, too.
double error_gain(std::span<const double> theta, double g);

/// Eq. (3)  Two equal free bodies and nobody else, with equal pressures and residuals. A pressure changes the
/// distance from both sides and is met by both: g = 1 - 2 omega.
struct TwoBodies {
    KernelName kernel = KernelName::cubic_spline;
    double h = 0;        ///< [m]
    double distance = 0; ///< [m]
    double mass = 0;     ///< [kg]
    double rho_0 = 0;    ///< [kg/m^3]
    double pressure = 0; ///< at the start [Pa]
    double residual = 0; ///< without pressure [kg/(m^3 s)]
    double lowest = 0;   ///< of the pressures [Pa]
};

/// Eq. (3)  The pressure y of two bodies after 0 to n iterations, p and y not below `lowest`. The field `pressure`
/// counts from 0.
Iteration accelerated_two_bodies(const TwoBodies& bodies, double omega, double dt, int n);

/// Eq. (3)  The larger root's magnitude of z^2 - (1 + theta) g z + theta g = 0, by which an iteration with
/// constant theta multiplies an error [1].
double largest_root(double theta, double g);

/// Eq. (3)  The largest omega with g(k) >= -1/3 for every mode, 4/3 sum |grad W|^2 / max_k |G(k)|^2: the
/// maximum over the Brillouin zone by a search (gsl_multimin) from the best points of a grid, so the limit is
/// not below the exact one by more than rounding [1].
Estimate relaxation_limit(const Lattice& lattice);

} // namespace aneurysm::analytic
