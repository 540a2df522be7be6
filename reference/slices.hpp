// SPDX-License-Identifier: Apache-2.0
// The start of the pressure's solve: a constant in each slice across the parent artery. What changes a flow from end to
// end is there at once, where iterations carry it by a spacing or two each.
#pragma once

#include "reference/incompressible.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace aneurysm::reference
{

/// The number of body i's slice.
inline std::size_t slice_of(const IncompressibleProblem& problem, std::size_t i)
{
    return static_cast<std::size_t>(problem.slices.at(problem.bodies->position[i].y));
}

/// The constants e_c, one for the members of each slice, after which the residuals of its members add up to 0. With
/// b_ic, the acceleration of i by a potential that is 1 at the members of c and 0 elsewhere, and since rate and acceleration are
/// adjoint,
///
///     dt rho_0^2 sum_d (sum_i b_ic . b_id) e_d = sum_{i in c} residual_i                      [kg/(m^3 s)]
///
/// \param member    by body: whether its potential is to change
/// \param residual  by body, of the potential so far
/// \return          e by slice; 0 without members [Pa]
std::vector<double> slice_potentials(const IncompressibleProblem& problem, const std::vector<bool>& member,
                                     std::span<const double> residual);

} // namespace aneurysm::reference
