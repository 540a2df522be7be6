// SPDX-License-Identifier: Apache-2.0
// Numbers that guard the arithmetic, the same in all backends. None is a choice of the model: each has to be
// just large or small enough for what it guards.
#pragma once

namespace aneurysm::guards
{

/// A body whose factor in (3) is this many times the smallest is spray, a drop with one or two others at the
/// edge of its sight. Pressure can hardly move it and would be without bound; it has none. In 600 frames of
/// paper_tc1 the ratio was at most 21.
constexpr double spray = 1000;

/// Times that a particle beyond the wall is put back in a step at most: where surfaces are blended, one step
/// along the gradient may not reach the wall.
constexpr int collision_attempts = 8;

/// A particle counts as outside when it is farther beyond the wall than what rounding leaves of a collision,
/// in spacings; for float and for double.
template <class Real>
constexpr Real outside = sizeof(Real) == sizeof(float) ? Real(1e-4) : Real(1e-9);

/// Part of rho_0 below which blood has a void beside it: its density may rise again, and nothing pulls it.
/// The density of a body in a full neighborhood stays above 0.95.
constexpr double void_density = 0.87;

/// Thickness of the slices in which the pressure's solve starts, in supports: so that a body sees two slices at most.
constexpr int slice_supports = 2;

/// Part of its diagonal below which a pivot of the slices' equations is nothing but rounding.
constexpr double smallest_pivot = 1e-6;

/// Layers at the far end of a buffer whose neighborhoods are not full, as wide as the support.
constexpr int open_layers = 2;

/// Spacings that a round of settling moves a particle at most: the lattice's first errors are large, and the
/// operators are those of the round's start.
constexpr double settling_move = 0.1;

} // namespace aneurysm::guards
