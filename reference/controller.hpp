// SPDX-License-Identifier: Apache-2.0
// Section 3.4: the particle controller, which keeps the artery full and the number of particles constant.
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "common/vessel/geometry.hpp"

namespace aneurysm::reference
{

/// Moves particles between the artery, the buffers at its three open ends and the reserve.
///
/// Behind each open end lies a buffer of blood, D = `opening_layers` dx deep. The inlet's moves with (25), an
/// outlet's as forces move it. What crosses the end plane outwards joins the buffer, what crosses it inwards
/// the artery. What leaves the buffer at its far end goes to the reserve; while the buffer moves inwards, its
/// far layer is filled from there, at the places of the lattice that have become free.
class Controller
{
public:
    /// `patterns`: the three buffers as sampled.
    Controller(const Scenario& scenario, const Vessel& vessel, double dx,
               std::array<std::vector<Vec3>, 3> patterns)
        : scenario_(&scenario), vessel_(&vessel), dx_(dx), patterns_(std::move(patterns))
    {
    }

    /// Gives the inlet's buffer its velocity, (25).
    void drive_inlet(Particles& particles, double v_inlet) const;

    /// Mean outward velocity of buffer k; 0 when it is empty [m/s].
    double buffer_velocity(const Particles& particles, std::size_t k) const;

    /// Carries out the exchange described above, after all have moved: what leaves, what crosses, and then
    /// what is filled, each in the order of indices. `v_inlet`: (25)
    void exchange(Particles& particles, double v_inlet, Ledger& ledger) const;

private:
    Vec3 inlet_velocity_of(const Vec3& x, double v_inlet) const;
    void leave(Particles& particles, std::size_t k, Ledger& ledger) const;
    void enter_artery(Particles& particles, Ledger& ledger) const;
    void leave_artery(Particles& particles, Ledger& ledger) const;
    void fill(Particles& particles, std::size_t k, double v_inlet, Ledger& ledger) const;
    bool is_free(const Particles& particles, std::size_t k, const Vec3& x) const;

    const Scenario* scenario_;
    const Vessel* vessel_;
    double dx_;
    std::array<std::vector<Vec3>, 3> patterns_;
};

} // namespace aneurysm::reference
