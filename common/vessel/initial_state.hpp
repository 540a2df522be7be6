// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "common/vessel/sampling.hpp"

#include <optional>

namespace aneurysm
{

/// R at frame 0 [m]
double initial_radius(const Scenario& scenario);

/// As many particles as the scenario's count leaves beside the reserve, or the lattice of a known spacing.
/// \throws InputError when the count is too few
Lattice sample(const Scenario& scenario, const Vessel& vessel, double daughter_radius,
               std::optional<double> spacing);

/// Frame 0 before the blood has settled: the lattice, jittered by the scenario's seed, at rest.
SimulationState initial_state(const Scenario& scenario, const Lattice& lattice, double particle_mass);

/// The wall's ghosts for every radius that the sac can take in a run. `support`: how deep the fluid sees [m].
GhostLattice ghost_lattice(const Scenario& scenario, const Vessel& vessel, double dx, double support,
                           double particle_mass);

} // namespace aneurysm
