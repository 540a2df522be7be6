// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "verification/backends/make_simulation.hpp"
#include "verification/comparison/comparison.hpp"
#include "verification/comparison/lockstep.hpp"

#include <cstdint>
#include <string>

namespace aneurysm::comparison
{

struct FreeRunSettings {
    std::int64_t frames = 0;
    int members = 8;           ///< of the ensemble, at least 3
    int windows = 10;          ///< of equal length, over which quantities are averaged
    double false_alarm = 1e-3; ///< probability that a correct candidate fails, all quantities and windows
};

/// The candidate and an ensemble of reference runs, all free from the same state.
///
/// Particles part: SPH flow is chaotic. What must agree is what averages: F_b, R, h, P_c, momentum and
/// kinetic energy, each as a mean over windows, and the frame of rupture. If the candidate computes the same
/// model, it is one more member of the ensemble; of each quantity it must lie in the interval that holds a
/// further member of a normal sample but for the probability false_alarm / (quantities * windows)
/// (Bonferroni), plus the one-frame rounding of the quantity itself.
///
/// For that the members must be disturbed as the candidate is, from the first frame on, also while their
/// spread is still that of rounding. They start one ulp of the candidate's precision apart, and after every
/// frame each particle's place and velocity, and the wall's state, are moved at random by about what rounding
/// does to the candidate in that frame: the bound of compare_lockstep, over the root of the number of terms of a
/// sum, whose roundings are independent. So are the tolerances of the solve of (3), by the rounding of its
/// residual: one iteration more or less moves more than any rounding of a place. That is still rather too much
/// than too little for early spreads; late ones are the flow's own.
///
/// Distances between particles are only reported.
/// \param candidate  at the state that all start from
ComparisonResult compare_free(const Scenario& scenario, Simulation& candidate,
                              const FreeRunSettings& settings, const AfterFrame& after_frame);

/// How many standard deviations a further member of a normal sample of `members`, at least 2, is at most away
/// from their mean, but for the probability `alpha` (two-sided): t_{members-1, 1-alpha/2} sqrt(1 + 1/members).
double prediction_factor(int members, double alpha);

} // namespace aneurysm::comparison
