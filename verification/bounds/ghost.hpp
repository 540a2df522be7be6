// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vessel/sampling.hpp"
#include "reference/flow.hpp"
#include "verification/bounds/wall.hpp"

#include <vector>

namespace aneurysm::bounds
{

/// The wall's ghosts as the two may see them: those of the reference, then those that only the candidate may
/// have, with mass 0.
struct InexactGhosts {
    WallGhosts ghosts;
    std::vector<double> position_error; ///< [U m]
    std::vector<double> mass_error;     ///< [U kg]
};

/// Rounding of the wall's ghosts (27), of their mass and of whether they are there (docs/bounds.md, B25).
class GhostBounds
{
public:
    GhostBounds(const Scenario& scenario, const WallBounds& wall, double dx, double support, double mass,
                const Rounding& rounding);

    InexactGhosts at(const reference::Wall& wall) const;

private:
    bool may_differ(const InexactVec& x, const Inexact& distance, const reference::Wall& wall) const;
    double fraction_error(const Inexact& distance) const;

    const WallBounds* wall_;
    double dx_;
    double support_;
    double mass_;
    Rounding rounding_;
    double margin_; ///< wider than any rounding of a distance [m]
    GhostLattice candidates_;
};

/// Breach::contains.
Truth contains(const Breach& breach, const InexactVec& x, const Rounding& rounding);

} // namespace aneurysm::bounds
