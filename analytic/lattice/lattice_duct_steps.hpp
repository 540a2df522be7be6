// SPDX-License-Identifier: Apache-2.0
// Flow from rest of a duct on the lattice, in the steps that the particle method takes:
//
//     u' = u + dt (A u + g(t)),   t at the end of the step.
#pragma once

#include "analytic/laminar_flow.hpp"
#include "analytic/lattice/lattice_duct.hpp"

namespace aneurysm::analytic
{

/// The longest dt for which no disturbance of |A| grows, 2 / |A| with the norm of the largest row sum [s].
double largest_step(const DuctOperator& A);

/// The steps one by one, in long double.
Profile step_by_step(const DuctOperator& A, const Drive& drive, double dt, int n);

/// The same for a steady force by powers of the matrix: u_n = (1 + M + ... + M^(n-1)) dt g, M = 1 + dt A, with the sum
/// by doubling, in long double.
Profile step_by_powers(const DuctOperator& A, double g, double dt, int n);

/// How far the same steps by another text may lead away from these [m/s]. In each step it may be off by dt
/// times uncertainty() on the flow, by the roundings of v + dt (F/rho + g), and by those of the phase omega
/// t; and what it is off by, later steps carry on.
double step_uncertainty(const DuctOperator& A, const Drive& drive, double dt, int n, double roundoff,
                        double displacement);

} // namespace aneurysm::analytic
