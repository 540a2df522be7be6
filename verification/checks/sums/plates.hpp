// SPDX-License-Identifier: Apache-2.0
// Disturbed blood between two plates, and the cloud that an oracle sees: the blood and the plates' ghosts.
#pragma once

#include "analytic/lattice/pair_sums.hpp"
#include "verification/checks/checks.hpp"

#include <vector>

namespace aneurysm::checks
{

/// data/scenarios/verify_channel.json with few rows and no force; the cloud's cube holds up to 4 rows and their
/// ghosts.
Scenario plates(int rows = 3);

/// Each particle up to a quarter of a spacing from its place, with velocities up to 0.5 m/s.
SimulationState disturbed(const Probe& probe, const Scenario& s);

/// The blood, and two layers of the wall's ghosts on either side: lattice points with a particle's mass, at
/// rest, of the rest density.
analytic::Cloud cloud_of(const Scenario& s, const SimulationState& state, const std::vector<double>& density);

} // namespace aneurysm::checks
