// SPDX-License-Identifier: Apache-2.0
// Section 3.4: the particle controller, which keeps the artery full and the number of particles constant.
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "common/vessel/geometry.hpp"

namespace aneurysm::reference
{

/// Moves particles between the artery, its three open ends and the reserve.
///
/// Behind each open end lies a slab of ghosts, D = `opening_layers` dx deep. The inlet's moves as a plug with
/// (25), an outlet's by Newton's law between the blood's pressure and (26). What crosses the end plane
/// outwards joins the slab; what crosses it inwards becomes blood, and a new ghost takes its place exactly D
/// behind it, so that the slab's pattern continues without a gap or an overlap. What leaves the slab at its
/// far side goes to the reserve.
class Controller
{
public:
    /// `patterns`: the three slabs as sampled.
    Controller(const Scenario::Controller& settings, const Vessel& vessel, double dx,
               std::array<std::vector<Vec3>, 3> patterns)
        : settings_(settings), vessel_(&vessel), dx_(dx), patterns_(std::move(patterns))
    {
    }

    /// Gives the inlet's slab its velocity (25).
    void drive_inlet(Particles& particles, double v_inlet) const;

    /// The next outward velocity of outlet k's slab, a body of blood D deep between the pressure p of the
    /// blood before the plane, to the probe's depth, and p_outlet of (26):
    ///
    ///     v' = v + dt (p - p_outlet) / (rho_0 D)                                              [m/s]
    ///
    /// where v is that blood's mean velocity; `previous` if there is none. Without the second term two
    /// outlets share the flow by its inertia alone, and a back-flow through one grows without limit.
    double outlet_velocity(const Particles& particles, std::size_t k, double previous, double p_outlet,
                           double rho_0, double dt) const;

    /// Gives outlet k's slab its velocity. Inwards it moves as a plug. Outwards each ghost keeps the velocity
    /// that it left the artery with and takes part in the slab's acceleration: a plug would crowd what leaves
    /// fast, in mid-tube, and thin out what leaves slowly.
    void drive_outlet(Particles& particles, std::size_t k, double v, double previous) const;

    /// Puts slab k back into its pattern, at rest. Needed whenever it starts to move inwards: what left the
    /// artery one by one is not the even flow that should come back.
    void reset(Particles& particles, std::size_t k, Ledger& ledger) const;

    /// Blood within the piston's reach of the inlet plane is not slower than a forward-moving inlet,
    /// and doesn't cross it backwards: the inlet is a piston. Without this, blood that drifts into the slab
    /// of a resting inlet overlaps its pattern.
    void push_as_piston(Particles& particles, double v_inlet) const;

    /// While outlet k's slab moves inwards, blood doesn't cross its plane outwards.
    void hold_back(Particles& particles, std::size_t k) const;

    /// Carries out the exchange described above, after all have moved: first what leaves the slabs joins the
    /// reserve, then what enters the artery is replaced from it, both in the order of particle indices. A
    /// ghost whose place inside is taken by blood goes back to the far end of the slab instead: two particles
    /// in one place see no pressure gradient between them, and would never part.
    void exchange(Particles& particles, Ledger& ledger) const;

private:
    bool is_taken(const Particles& particles, const Vec3& x) const;
    Vec3 behind(std::size_t k) const; ///< from a ghost of slab k to the place a whole slab behind it [m]
    void leave_slab(Particles& particles, std::size_t k, Ledger& ledger) const;
    void enter_artery(Particles& particles, Ledger& ledger) const;
    void cross_openings(Particles& particles, Ledger& ledger) const;

    Scenario::Controller settings_;
    const Vessel* vessel_;
    double dx_;
    std::array<std::vector<Vec3>, 3> patterns_;
};

} // namespace aneurysm::reference
