// SPDX-License-Identifier: Apache-2.0
// One iteration of a solve of (3) from known potentials, over all pairs.
#pragma once

#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"

namespace aneurysm::checks
{

/// How the bound of its potentials follows.
inline constexpr const char* of_one_iteration =
    "omega rho_0^2/dt times the bounds of the residual's sums times alpha, of (2) also through dt times those of the "
    "potential's acceleration, and of alpha's sums times the residual, for oracle and subject, + gamma_12 of all terms";

class OneIteration
{
public:
    /// \param cloud     with the potentials that it starts from as `pressure`, and the velocities before they act
    /// \param of_start  error of these velocities [m/s]
    OneIteration(const Probe& probe, const Scenario& s, analytic::Cloud cloud, double of_start = 0);

    /// What (3) leaves over at body i before it, and how far the subject's may be from it [kg/(m^3 s)].
    /// \param source  what the density adds to the residual; its error bounds the rounding of any text in double
    analytic::Estimate residual(std::size_t i, const analytic::Estimate& source) const;

    /// The potential of body i after it, and how far the subject's may be from it [Pa].
    analytic::Estimate potential(std::size_t i, const analytic::Estimate& source, double lowest) const;

private:
    const Probe* probe_;
    analytic::Cloud moved_;   ///< with the velocities after the potentials have acted
    double of_velocity_ = 0;  ///< error of these [m/s]
    double per_residual_ = 0; ///< omega rho_0^2/dt
};

} // namespace aneurysm::checks
