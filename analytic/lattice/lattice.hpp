// SPDX-License-Identifier: Apache-2.0
// Sums over the cubic lattice. On it every SPH sum multiplies a plane wave by a number, its symbol; the
// symbol is a finite sum over the lattice points within the support, or by Poisson's formula a sum of the
// kernel's Fourier transform over the reciprocal lattice.
#pragma once

#include "analytic/gsl.hpp"
#include "common/scenario/scenario.hpp"

#include <Eigen/Core>

namespace aneurysm::analytic
{

struct Lattice {
    KernelName kernel = KernelName::cubic_spline;
    double h = 0;  ///< smoothing length; the support radius is 2 h [m]
    double dx = 0; ///< spacing [m]

    double cell() const { return dx * dx * dx; } ///< [m^3]
};

/// A vector and the bound of the error of each of its components.
struct VectorEstimate {
    Eigen::Vector3d value = Eigen::Vector3d::Zero();
    double error = 0;
};

// Direct sums over the n points x within the support. Each error bounds the rounding of any text of the
// kernel: n additions, 40 u of the kernel and 88 u of the phase (k.x < 22 for 2 h <= 4 dx) on every term, and
// 16 u of the kernel's (slope's, Laplacian's) largest value, since 2 - q cancels near the support's end.

/// Eq. (5)  sum_x W(x); times m it is the lattice's density [1/m^3].
Estimate kernel_sum(const Lattice& lattice);

/// Eq. (6)  G(k) = sum_x grad W(x) sin(k.x) [1/m^4]; times a cell it tends to -k.
VectorEstimate gradient_sum(const Lattice& lattice, const Eigen::Vector3d& k);

/// Eq. (6)  b of a linear field: its gradient comes out 1 + b times
/// too large, -dx^3 sum_x x dW/dx = 1 + b [1].
Estimate gradient_floor(const Lattice& lattice);

/// Eq. (3)  sum_x |grad W(x)|^2 [1/m^8].
Estimate gradient_square_sum(const Lattice& lattice);

/// Eq. (7)  sum_x lap W(x) (1 - cos k.x) of Mueller's kernel [1/m^5]; times a cell it tends to k^2.
Estimate viscosity_sum(const Lattice& lattice, const Eigen::Vector3d& k);

/// The strength beta of shifts -beta dx^2 sum_j m_j/rho_0 grad W_ij from which on a disorder of the lattice grows: a
/// wave u of displacements is shifted by -beta A u with A = dx^2 sum_x (1 - cos k.x) hess W(x) / sum_x W(x), so it is 2
/// over the largest eigenvalue of A over the Brillouin zone, on a grid of it; the Hessian by differences. To 1e-3 [1].
double shift_limit(const Lattice& lattice);

// The same by Poisson's formula, sum_x f(x) e^{-ik.x} = dx^-3 sum_m fhat(k + 2 pi m/dx).

/// Eq. (5) by Poisson's formula over shells |m|^2 < 200^2, each with the number of its lattice points. The
/// error bounds the rest, int 4 pi t^2 B(t) dt with |What| <= B.
Estimate kernel_sum_by_poisson(const Lattice& lattice);

/// Eq. (6) by Poisson's formula over |m| < 40, G(k) = -dx^-3 sum_m q What(q), q = k + 2 pi m/dx. The
/// transform falls like q^-5 (q^-6 for Wendland's), so the error is about 1e-2 (1e-4) of 1/dx^4; it is
/// bounded as above.
VectorEstimate gradient_sum_by_poisson(const Lattice& lattice, const Eigen::Vector3d& k);

/// Eq. (7) by Poisson's formula. The transform falls only like q^-3, so lap W is smoothed by a Gaussian of
/// eps = 0.025 dx, and what that changes is put back: A eps^2/r for 0 < r < H and
/// -A (eps/sqrt(2 pi) - eps^2/(2 H)) at r = H, where A = -d lap W/dr. Exact to erfc if no other lattice point
/// is nearer to H than 7.5 eps. \throws std::invalid_argument when one is
Estimate viscosity_sum_by_poisson(const Lattice& lattice, const Eigen::Vector3d& k);

} // namespace aneurysm::analytic
