// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/particles.hpp"

#include <array>
#include <cstdint>

namespace aneurysm
{

/// Section 3.2 and 3.3: what the aneurysm is doing.
enum class Phase : std::uint8_t { warm_up, growing, fully_developed, ruptured };

/// The sac and its wall: all that (8)-(23) and (28) carry from frame to frame.
struct AneurysmState {
    Phase phase = Phase::warm_up;
    double radius = 0;               ///< R [m]
    double thickness = 0;            ///< h [m]
    double displacement = 0;         ///< u of (28) [m]
    double wall_velocity = 0;        ///< du/dt [m/s]
    std::int64_t rupture_frame = -1; ///< -1: not ruptured
};

/// Particles moved by the controller (section 3.4), counted from frame 0. [particles]
struct Ledger {
    std::int64_t inlet_in = 0;   ///< inlet buffer -> artery
    std::int64_t inlet_out = 0;  ///< artery -> inlet buffer (back-flow)
    std::int64_t outlet_out = 0; ///< artery -> outlet zones
    std::int64_t outlet_in = 0;  ///< outlet zones -> artery (back-flow)
    std::int64_t escaped = 0;    ///< passed the breach
    std::int64_t recycled = 0;   ///< returned to the reserve
    std::int64_t missed = 0;     ///< placements that found the reserve empty
};

/// One row of frames.csv.
struct FrameRecord {
    std::int64_t frame = 0;
    double time = 0; ///< [s]
    Phase phase = Phase::warm_up;
    double inlet_velocity = 0;         ///< (25) [m/s]
    double outlet_velocity = 0;        ///< mean of both zones, outward [m/s]
    double impact_force = 0;           ///< F_b, (16) [N]
    double impact_force_eos = 0;       ///< (16) by (6) and the equation of state, a diagnostic [N]
    double wall_load = 0;              ///< F_b for the mass that strikes the wall; moves and breaks it [N]
    std::int64_t impact_count = 0;     ///< particles in S
    std::int64_t impact_particle = -1; ///< which one attains the maximum; -1: S is empty
    double radius = 0;                 ///< R [m]
    double thickness = 0;              ///< h [m]
    double critical_pressure = 0;      ///< P_c, (13) [Pa]
    double displacement = 0;           ///< u, (28) [m]
    std::int64_t iterations = 0;       ///< of the pressure solve, all substeps
    std::int64_t corrections = 0;      ///< iterations of the density's correction, all substeps
    double density_error_mean = 0;     ///< mean of max(rho/rho_0 - 1, 0) over the fluid
    double density_error_max = 0;      ///< largest rho/rho_0 - 1 at least an artery radius from the open ends
    double density_error_min = 0;      ///< smallest rho/rho_0 - 1 there
    double density_error_max_ends = 0; ///< largest rho/rho_0 - 1 nearer to an open end
    double divergence_mean = 0;        ///< mean |div v| after the solve [1/s]
    double divergence_max = 0;         ///< largest |div v| after the solve [1/s]
    double residual_mean = 0;          ///< mean |residual| of (3) when the solve stopped [1/s]
    double residual_max = 0;           ///< largest |residual| [1/s]
    double kinetic_energy = 0;         ///< of the fluid [J]
    double speed_max = 0;              ///< [m/s]
    std::int64_t fluid = 0;            ///< particles in the artery
    std::int64_t active = 0;           ///< fluid + inlet buffer + outlet zones + escaped
    std::int64_t total = 0;            ///< active + reserve; constant
    std::int64_t outside = 0; ///< fluid particles beyond the wall after collision handling, breach excluded
    std::int64_t collisions = 0; ///< particles put back by collision handling in this frame
    Ledger ledger;
};

/// Everything that a run needs to go on to the same bits; a checkpoint holds it and the scenario.
struct SimulationState {
    std::int64_t frame = 0; ///< frames done
    double spacing = 0;     ///< dx [m]
    Particles particles;
    AneurysmState aneurysm;
    Ledger ledger;
    std::array<double, 2> outlet_velocity{}; ///< mean of the outlets' buffers, outward [m/s]
};

} // namespace aneurysm
