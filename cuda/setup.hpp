// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario/scenario.hpp"
#include "common/vessel/initial_state.hpp"

#include <optional>

namespace aneurysm::device
{

/// Everything that is worked out once, on the host and in double: vessel, particles and ghosts as sampled.
struct Setup {
    /// `state`: where a run goes on from; only its spacing is needed.
    /// \throws InputError when the scenario's values can't go together
    Setup(const Scenario& scenario, const std::optional<SimulationState>& state);

    Vessel vessel;
    Lattice lattice;
    double h = 0;             ///< smoothing length [m]
    double particle_mass = 0; ///< rho_0 / sum of W over the lattice [kg]
    GhostLattice ghosts;
};

/// Sum of W over the cubic lattice of spacing dx [1/m^3].
double lattice_kernel_sum(KernelName name, double h, double dx);

/// The largest omega for which the iteration of (3) damps every mode of a full cubic lattice with h/dx =
/// ratio: its momentum holds up to 4/3 of the inverse of the largest eigenvalue.
double relaxation_limit(KernelName name, double ratio);

} // namespace aneurysm::device
