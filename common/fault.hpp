// SPDX-License-Identifier: Apache-2.0
// The test-only hook by which `aneurysm verify --sensitivity` plants faults in both backends, and the places
// where it does. Without the macro ANEURYSM_FAULTS, which production code is never compiled with, the hook is
// its own argument: no instruction, the same bits.
#pragma once

#ifdef ANEURYSM_WITHOUT_FORMULAS
#error "a source with formulas of a backend belongs to sources_with_formulas in verification/CMakeLists.txt"
#endif

#include "common/host_device.hpp"

#include <cstdint>

/// A place is one part of one equation's formula, or of the rules that come with it: name, what kind of part,
/// which backends have it (`optimized`: only that in cuda/), and what it is. A name starts with its equation,
/// or with fig1 (collisions) or sec34 (the particle controller).
#define ANEURYSM_FAULT_PLACES(PLACE)                                                                         \
    PLACE(eq01_gravity, vector, both, "rho g")                                                               \
    PLACE(eq01_viscosity, vector, both, "F^viscosity")                                                       \
    PLACE(eq01_pressure, vector, both, "F^pressure")                                                         \
    PLACE(eq02_term, term, both, "m_j (v_i - v_j) . grad W_ij")                                              \
    PLACE(eq02_velocity, vector, both, "v_i - v_j")                                                          \
    PLACE(eq02_ghosts, term, optimized, "the ghosts' part")                                                  \
    PLACE(eq03_alpha_sum, term, both, "|sum_j m_j grad W_ij|^2 of the DFSPH factor")                         \
    PLACE(eq03_alpha_squares, term, both, "sum_j |m_j grad W_ij|^2 of the DFSPH factor")                     \
    PLACE(eq03_own, term, both, "p_i of the pressure's acceleration")                                        \
    PLACE(eq03_other, term, both, "p_j of the pressure's acceleration")                                      \
    PLACE(eq03_density, factor, both, "rho_0^2 of the pressure's acceleration")                              \
    PLACE(eq03_ghosts, vector, optimized, "the ghosts' part of the pressure's acceleration")                 \
    PLACE(eq03_push, vector, both, "dt a, the pressure's part of the velocity")                              \
    PLACE(eq03_density_error, term, both, "beta (rho_i - rho_0) / dt of the residual")                       \
    PLACE(eq03_rate, term, both, "Drho/Dt of the residual")                                                  \
    PLACE(eq03_response, factor, both, "omega rho_0^2 alpha_i / dt, pressure for a residual")                \
    PLACE(eq03_positive, condition, both, "p > 0")                                                           \
    PLACE(eq03_restart, condition, both, "the momentum leads astray")                                        \
    PLACE(eq03_sequence, term, both, "4 t^2 of the momentum's sequence")                                     \
    PLACE(eq03_theta, factor, both, "theta, the momentum")                                                   \
    PLACE(eq04_term, term, both, "A_j m_j / rho_j W")                                                        \
    PLACE(eq04_density, factor, both, "rho_j")                                                               \
    PLACE(eq04_norm, factor, both, "1/(pi h^3) of the kernel")                                               \
    PLACE(eq04_square, term, both, "3/2 q^2 of the spline's inner piece")                                    \
    PLACE(eq04_cube, term, both, "3/4 q^3 of the spline's inner piece")                                      \
    PLACE(eq04_outer, term, both, "2 - q of the spline's outer piece")                                       \
    PLACE(eq04_inner_edge, limit, both, "q = 1, where the spline's pieces meet")                             \
    PLACE(eq04_support, limit, both, "q = 2, where the kernel ends")                                         \
    PLACE(eq04_wendland, term, both, "1 - q/2 of Wendland's kernel")                                         \
    PLACE(eq04_wendland_line, term, both, "2 q of Wendland's kernel")                                        \
    PLACE(eq04_slope_norm, factor, both, "1/(pi h^3) of the kernel's slope")                                 \
    PLACE(eq04_slope_line, term, both, "-3 q of the slope's inner piece")                                    \
    PLACE(eq04_slope_square, term, both, "9/4 q^2 of the slope's inner piece")                               \
    PLACE(eq04_slope_outer, term, both, "2 - q of the slope's outer piece")                                  \
    PLACE(eq04_slope_wendland, term, both, "1 - q/2 of the slope of Wendland's kernel")                      \
    PLACE(eq05_term, term, both, "m_j W_ij")                                                                 \
    PLACE(eq05_self, term, optimized, "m_i W(0)")                                                            \
    PLACE(eq05_neighbors, count, both, "how many neighbors are found")                                       \
    PLACE(eos_stiffness, factor, both, "kappa")                                                              \
    PLACE(eos_density, term, both, "rho_i")                                                                  \
    PLACE(eos_rest, term, both, "rho_0")                                                                     \
    PLACE(eq06_own, term, both, "p_i")                                                                       \
    PLACE(eq06_other, term, both, "p_j")                                                                     \
    PLACE(eq06_mirror, factor, both, "p_i as the pressure of a ghost")                                       \
    PLACE(eq06_density, factor, both, "rho_j")                                                               \
    PLACE(eq06_gradient, vector, both, "grad W_ij")                                                          \
    PLACE(eq06_ghosts, vector, optimized, "the ghosts' part")                                                \
    PLACE(eq07_viscosity, factor, both, "mu")                                                                \
    PLACE(eq07_density, factor, both, "rho_j")                                                               \
    PLACE(eq07_difference, vector, both, "v_j - v_i")                                                        \
    PLACE(eq07_ghosts, vector, optimized, "v_j - v_i of ghosts")                                             \
    PLACE(eq07_norm, factor, both, "45/(pi H^6) of the viscosity kernel's Laplacian")                        \
    PLACE(eq07_distance, term, both, "H - r of the viscosity kernel's Laplacian")                            \
    PLACE(eq07_support, limit, both, "H, where the viscosity kernel ends")                                   \
    PLACE(eq08_force, factor, both, "P R")                                                                   \
    PLACE(eq08_thickness, factor, both, "2 h")                                                               \
    PLACE(eq09_loss, term, both, "-sigma h dR / R")                                                          \
    PLACE(eq09_radius, factor, both, "R")                                                                    \
    PLACE(eq10_sphere, term, both, "2, of the growing sphere")                                               \
    PLACE(eq10_thinning, term, both, "sigma, of the thinning wall")                                          \
    PLACE(eq10_radius, factor, both, "R")                                                                    \
    PLACE(eq11_yield, factor, both, "-2/3 Y")                                                                \
    PLACE(eq11_logarithm, factor, both, "ln phi")                                                            \
    PLACE(eq11_porosity, factor, both, "phi")                                                                \
    PLACE(eq12_numerator, factor, both, "R / 2h")                                                            \
    PLACE(eq12_strength, term, both, "2 Y (2 - sigma) / (3 R phi)")                                          \
    PLACE(eq12_load, term, both, "P (1 + sigma) / (2 h)")                                                    \
    PLACE(eq13_strength, factor, both, "4 h Y (2 - sigma)")                                                  \
    PLACE(eq13_radius, factor, both, "3 R")                                                                  \
    PLACE(eq13_porosity, factor, both, "phi")                                                                \
    PLACE(eq13_poisson, term, both, "sigma of 1 + sigma")                                                    \
    PLACE(eq14_mass, factor, both, "m")                                                                      \
    PLACE(eq14_velocity, vector, both, "v")                                                                  \
    PLACE(eq14_time, factor, both, "dt")                                                                     \
    PLACE(eq15_force, vector, both, "the force")                                                             \
    PLACE(eq15_density, factor, both, "rho_i")                                                               \
    PLACE(eq15_change, vector, both, "dt a, the change of velocity")                                         \
    PLACE(eq15_way, vector, both, "dt v, the change of place")                                               \
    PLACE(eq16_mass, factor, both, "m")                                                                      \
    PLACE(eq16_density, factor, both, "rho_i")                                                               \
    PLACE(eq16_pressure, vector, both, "F^pressure of the solved pressure")                                  \
    PLACE(eq16_harder, condition, both, "a force is larger than the largest so far")                         \
    PLACE(eq16_band, limit, both, "how far from the wall blood is in S")                                     \
    PLACE(eq16_of_sac, condition, both, "a place belongs to the sac, not to a tube")                         \
    PLACE(eq16_area, factor, both, "the area that makes F_b a pressure")                                     \
    PLACE(eq16_resistance, factor, both, "P_c of the criterion F_b > P_c")                                   \
    PLACE(eq17_blood, term, both, "F_B")                                                                     \
    PLACE(eq17_tissue, term, both, "F_F")                                                                    \
    PLACE(eq17_fibres, term, both, "F_P")                                                                    \
    PLACE(eq18_density, factor, both, "rho_F")                                                               \
    PLACE(eq18_area, factor, both, "a")                                                                      \
    PLACE(eq18_speed, factor, both, "u_t")                                                                   \
    PLACE(eq19_elastin, term, both, "K_E A_E")                                                               \
    PLACE(eq19_collagen, term, both, "K_C A_C")                                                              \
    PLACE(eq19_strain, factor, both, "epsilon")                                                              \
    PLACE(eq20_growth, factor, both, "dR")                                                                   \
    PLACE(eq20_radius, factor, both, "R")                                                                    \
    PLACE(eq21_force, factor, both, "F_B")                                                                   \
    PLACE(eq21_inertia, term, both, "m / dt^2")                                                              \
    PLACE(eq21_tissue, term, both, "rho_F a c / dt")                                                         \
    PLACE(eq21_fibres, term, both, "(K_E A_E + K_C A_C) / R")                                                \
    PLACE(eq21_growth, term, both, "dR, the change of R")                                                    \
    PLACE(eq21_warm_up, count, both, "frames before growth begins")                                          \
    PLACE(eq22_thickness, term, both, "h")                                                                   \
    PLACE(eq22_thinning, term, both, "h/R sigma dR")                                                         \
    PLACE(eq22_radius, factor, both, "R")                                                                    \
    PLACE(eq23_thickness, factor, both, "h")                                                                 \
    PLACE(eq23_thinning, term, both, "alpha min(dR, largest)")                                               \
    PLACE(eq23_cap, limit, both, "the largest dR that thins the wall")                                       \
    PLACE(eq23_developed, limit, both, "R of the full development")                                          \
    PLACE(eq24_radius, factor, both, "r_0")                                                                  \
    PLACE(eq24_root, factor, both, "2^(1/3)")                                                                \
    PLACE(eq25_amplitude, factor, both, "v_0")                                                               \
    PLACE(eq25_phase, factor, both, "2 pi t / T")                                                            \
    PLACE(eq25_table, term, both, "the way from one row of the table to the next")                           \
    PLACE(eq25_slab, vector, both, "the velocity of the inlet's ghosts")                                     \
    PLACE(eq25_reach, limit, both, "how far before the inlet its slab pushes blood")                         \
    PLACE(eq25_piston, vector, both, "what blood before the inlet is sped up by")                            \
    PLACE(eq25_plane, vector, both, "the way back of blood behind the inlet")                                \
    PLACE(eq26_pressure, factor, both, "p_const")                                                            \
    PLACE(eq26_density, factor, both, "rho_0")                                                               \
    PLACE(eq26_gradient, vector, both, "m_j grad W_ij")                                                      \
    PLACE(eq26_dynamic, term, both, "rho_0 v^2 / 2 of blood that comes back")                                \
    PLACE(eq26_comes_back, condition, both, "v < 0")                                                         \
    PLACE(eq26_slab_velocity, term, both, "the mean velocity of the blood before an outlet")                 \
    PLACE(eq26_slab_push, term, both, "dt (p - p_outlet) / (rho_0 D)")                                       \
    PLACE(eq26_slab_change, term, both, "the slab's change of velocity")                                     \
    PLACE(eq26_plane, vector, both, "the way back of blood behind an outlet that flows back")                \
    PLACE(eq27_velocity, nought, both, "v_wall")                                                             \
    PLACE(eq27_mass, factor, both, "m of a ghost")                                                           \
    PLACE(eq28_velocity, term, both, "v")                                                                    \
    PLACE(eq28_fluid, term, both, "F_fluid")                                                                 \
    PLACE(eq28_spring, term, both, "k u")                                                                    \
    PLACE(eq28_mass, factor, both, "m_wall")                                                                 \
    PLACE(eq28_displacement, term, both, "u")                                                                \
    PLACE(eq28_way, term, both, "dt v'")                                                                     \
    PLACE(fig1_depth, vector, both, "the way back to the wall")                                              \
    PLACE(fig1_reflection, vector, both, "2 v.n n, which turns the normal velocity round")                   \
    PLACE(fig1_outwards, condition, both, "v.n > 0")                                                         \
    PLACE(sec34_behind, vector, both, "the place a whole slab behind a ghost")                               \
    PLACE(sec34_entry, limit, both, "how near blood may be to a ghost that enters")

namespace aneurysm
{

/// See ANEURYSM_FAULT_PLACES. Not scoped: `fault(eq22_radius, R)` must not bury the formula that it is in.
enum Place : std::uint8_t {
#define ANEURYSM_PLACE(name, part, backends, text) name, ///< text
    ANEURYSM_FAULT_PLACES(ANEURYSM_PLACE)
#undef ANEURYSM_PLACE
        place_count
};

} // namespace aneurysm

#ifdef ANEURYSM_FAULTS
#include "common/planted_fault.hpp"
#else

namespace aneurysm::reference
{
/// `value`.
template <class T>
ANEURYSM_INLINE constexpr T fault(Place, T value)
{
    return value;
}
} // namespace aneurysm::reference

namespace aneurysm::device
{
/// `value`.
template <class T>
ANEURYSM_INLINE constexpr T fault(Place, T value)
{
    return value;
}
} // namespace aneurysm::device

#endif
