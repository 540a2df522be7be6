// SPDX-License-Identifier: Apache-2.0
// The inlet's velocities with 50 digits.
#pragma once

#include "common/scenario/scenario.hpp"

#include <vector>

namespace aneurysm::analytic
{

/// A velocity, and how far rounding of the angle may take it: x |dv/dx|.
struct WaveformValue {
    double value = 0;             ///< [m/s]
    double angle_times_slope = 0; ///< [m/s]
};

/// Eq. (25)  v_0 times sin x, |sin x|, cos^2(pi/4 - x/2), 1; x = 2 pi t/T.
/// \throws std::invalid_argument for a table
WaveformValue exact_waveform(Waveform waveform, double v_0, double T, double t);

/// Eq. (25)  A table as a sum of hats: entry k counts from 1 at its time down to 0 at the neighbors', which
/// are those of the next and the last cycle for the last and the first entry [m/s].
double hat_sum(const std::vector<double>& time, const std::vector<double>& velocity, double T, double t);

} // namespace aneurysm::analytic
