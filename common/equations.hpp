// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace aneurysm
{

/// How sure the reading of a printed formula is.
enum class Status {
    printed,       ///< as printed
    reconstructed, ///< signs or fractions restored; the deviation says why
    assumed,       ///< the paper leaves a rule open; the deviation says which
};

/// The place of an equation's function in the runs of the backends; a guard looks for its calls.
enum class Use {
    used,    ///< runs call it
    part,    ///< a part of (21): the reference writes (21) in one line, the others call its parts
    nominal, ///< no run depends on it: only checks call it
};

/// One row per equation of the paper. `function` is its one function in `reference/`; guards hold the table
/// against the sources, the oracles in `analytic/` and the tests.
struct Equation {
    std::string_view id;      ///< "1" .. "28", or "EOS"
    std::string_view section; ///< of the paper
    std::string_view title;
    std::string_view function; ///< in namespace aneurysm::reference
    Status status;
    std::string_view deviation; ///< what the paper prints, leaves open or gets wrong; empty: nothing
    Use use = Use::used;
};

inline constexpr std::array<Equation, 29> equations{{
    {"1", "3.1", "momentum of an incompressible Newtonian fluid", "momentum_force", Status::reconstructed,
     "the sign of the pressure gradient is lost in print; restored from the text"},
    {"2", "3.1", "conservation of mass", "density_rate", Status::reconstructed,
     "printed with the divergence sign lost; the discrete form is the time derivative of (5)"},
    {"3", "3.1", "density-invariant and divergence-free", "solve_incompressibility", Status::reconstructed,
     "the paper gives no algorithm: the pressure frees the velocity of divergence, and a second solve of the "
     "same form corrects the density by moving the particles, not their velocity"},
    {"4", "3.1", "kernel interpolation", "interpolate", Status::assumed,
     "the paper names no kernel: cubic spline or Wendland C2", Use::nominal},
    {"5", "3.1", "density summation", "density", Status::printed, ""},
    {"6", "3.1", "pressure force", "pressure_force", Status::reconstructed,
     "minus sign restored. The printed mean (p_i + p_j)/2 converges to HALF the pressure gradient; kept "
     "literally, and proved by its lattice symbol"},
    {"7", "3.1", "viscosity force", "viscosity_force", Status::reconstructed,
     "printed with v_i - v_j, which would feed energy; (v_j - v_i) as in the paper's reference 15. The "
     "Laplacian is that of reference 15's viscosity kernel: the cubic spline's own is negative for r < h"},
    {"EOS", "3.1", "equation of state", "equation_of_state", Status::printed,
     "with the paper's stiffness of 1 the blood collapses; a driving stiffness is the scenario's. Runs that "
     "solve (3) only record the F_b that follows from it"},
    {"8", "3.2", "Laplace's law", "wall_stress", Status::printed, "", Use::nominal},
    {"9", "3.2", "Poisson's relation of thickness and radius", "thickness_differential",
     Status::reconstructed, "minus sign restored: the wall thins as it grows", Use::nominal},
    {"10", "3.2", "porosity and wall volume", "porosity_differential", Status::reconstructed,
     "minus sign restored: (12) follows from (8)-(11) only with it", Use::nominal},
    {"11", "3.2", "wall stress and porosity", "stress_of_porosity", Status::reconstructed,
     "minus sign restored: the stress is positive for a porosity below 1", Use::nominal},
    {"12", "3.2", "radius and pressure", "radius_per_pressure", Status::reconstructed, "fractions restored",
     Use::nominal},
    {"13", "3.2", "critical pressure", "critical_pressure", Status::reconstructed,
     "the zero of the denominator of (12)"},
    {"14", "3.2", "impulse and momentum", "impulse_force", Status::printed, "", Use::nominal},
    {"15", "3.2", "acceleration of a particle", "acceleration", Status::printed, ""},
    {"16", "3.2", "largest impact force on the wall", "impact_force", Status::reconstructed,
     "the norm is implied; S is empty in some frames, which counts as no impact. The paper compares this "
     "force with a pressure: the scenario's conversion area makes the units honest"},
    {"17", "3.3", "forces on the wall", "net_wall_force", Status::reconstructed, "minus signs restored",
     Use::nominal},
    {"18", "3.3", "resistance of the tissue fluid", "tissue_force", Status::printed, "", Use::part},
    {"19", "3.3", "resistance of elastin and collagen", "fiber_force", Status::printed,
     "the printed stress equals the strain, without a modulus", Use::part},
    {"20", "3.3", "strain of the wall", "strain", Status::printed, "", Use::part},
    {"21", "3.3", "growth of the radius", "radius_increment", Status::reconstructed,
     "one backward-Euler step from rest: it has no limit as the time step goes to 0, so the time step is a "
     "model parameter"},
    {"22", "3.3", "thinning while growing", "thickness_growing", Status::reconstructed,
     "minus sign restored"},
    {"23", "3.3", "thinning when fully developed", "thickness_developed", Status::reconstructed,
     "minus sign restored. The intensity has the unit 1/m, which Table 1 leaves out"},
    {"24", "3.4", "Murray's law", "daughter_radius", Status::printed, ""},
    {"25", "3.5", "pulsatile inlet velocity", "inlet_velocity", Status::printed,
     "as printed the flow turns round in half of each cycle and its net transport is 0; a scenario can "
     "choose another waveform, a profile over the inlet and a smooth start"},
    {"26", "3.5", "constant outlet pressure", "outlet_pressure_force", Status::printed,
     "the paper gives no value; while the wall is whole, the pressure is as high as the flow can pull it down, "
     "p_const at most. While blood comes back in, it comes from blood at rest, whose pressure falls by rho "
     "v^2/2 on the way"},
    {"27", "3.5", "no-slip wall", "wall_velocity", Status::printed,
     "on the wall itself; behind it the ghosts' velocity in (7) is extrapolated"},
    {"28", "3.5", "elastic aneurysm wall", "advance_elastic_wall", Status::reconstructed,
     "minus sign restored; mass and stiffness are not given"},
}};

} // namespace aneurysm
