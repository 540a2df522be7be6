// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vessel/geometry.hpp"
#include "verification/bounds/inexact.hpp"

namespace aneurysm::bounds
{

/// A signed distance and its gradient with their rounding.
struct InexactDistance {
    Inexact value;       ///< [m]
    InexactVec gradient; ///< [1]
};

/// Rounding of the geometry in common/vessel/geometry.hpp operation by operation, with its constants rounded
/// once. Places come with the error that they have already.
class WallBounds
{
public:
    WallBounds(const Vessel& vessel, const Scenario& scenario, const Rounding& rounding);

    /// Distance to the wall at radius R. \throws Error when it isn't that of Vessel::wall
    InexactDistance wall(const InexactVec& x, const Inexact& R) const;
    InexactDistance tubes(const InexactVec& x) const;
    InexactDistance sac(const InexactVec& x, const Inexact& R) const;
    /// How far x lies beyond end k's plane [m].
    Inexact beyond(std::size_t k, const InexactVec& x) const;
    /// Whether tube k is the nearest to x.
    Truth is_nearest(std::size_t k, const InexactVec& x) const;
    /// Whether x is more than `threshold` [m] beyond the end plane of its nearest tube.
    Truth is_beyond_nearest(const InexactVec& x, const Inexact& threshold) const;

    const Vessel& vessel() const { return *vessel_; }

private:
    InexactDistance tube(std::size_t k, const InexactVec& x) const;
    InexactDistance straight_wall(const InexactVec& x) const;
    InexactDistance blend(const InexactDistance& a, const InexactDistance& b, double width) const;
    InexactDistance pear(const InexactVec& x, const Inexact& R) const;

    const Vessel* vessel_;
    Rounding rounding_;
    double junction_smoothing_;
    double sac_smoothing_;
    double neck_ratio_ = 0;
    bool is_pear_;
};

} // namespace aneurysm::bounds
