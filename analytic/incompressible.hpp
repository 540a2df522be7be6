// SPDX-License-Identifier: Apache-2.0
// Oracles of (3): the relaxed Jacobi iteration on a full lattice, where it multiplies every mode by its own
// factor.
#pragma once

#include "analytic/blood_flow.hpp"

namespace aneurysm::analytic
{

/// Eq. (3)  Factor 1/(m^2 sum |grad W|^2) of a full lattice, where sum grad W = 0 [m^8/kg^2].
Estimate dfsph_factor(const Medium& medium);

/// Eq. (3)  g(k) = 1 - omega |G(k)|^2 / sum |grad W|^2: what one iteration leaves of the mode k of the
/// residual [1]. 1 for k = 0 and for the checkerboard, which no pressure can change.
Estimate jacobi_factor(const Lattice& lattice, double omega, const Eigen::Vector3d& k);

/// Eq. (3)  The pressure after n iterations that start from a uniform one, on the mode cos(k.r) of the
/// residual with the amplitude r_0: omega rho_0^2 alpha/dt r_0 (1 - g^n)/(1 - g) [Pa].
Estimate jacobi_pressure(const Medium& medium, double omega, double dt, const Eigen::Vector3d& k, double r_0,
                         int n);

/// Eq. (3)  The largest omega that damps every mode, 2 sum |grad W|^2 / max_k |G(k)|^2: the maximum over the
/// Brillouin zone by a search (gsl_multimin) from the best points of a grid, so the limit is not below the
/// exact one by more than rounding [1].
Estimate relaxation_limit(const Lattice& lattice);

} // namespace aneurysm::analytic
