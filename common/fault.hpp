// SPDX-License-Identifier: Apache-2.0
// The test-only hook by which `aneurysm verify --sensitivity` plants faults in both backends, and the places
// where it does. Without the macro ANEURYSM_FAULTS, which production code is never compiled with, the hook is
// its own argument: no instruction, the same bits.
#pragma once

#include "common/host_device.hpp"

#include <cstdint>

/// A place is one part of one equation's formula, or of the rules that come with it: name, what kind of part,
/// and what it is. A name starts with its equation.
#define ANEURYSM_FAULT_PLACES(PLACE)                                                                         \
    PLACE(eq04_norm, factor, "1/(pi h^3) of the kernel")                                                     \
    PLACE(eq04_square, term, "3/2 q^2 of the spline's inner piece")                                          \
    PLACE(eq04_cube, term, "3/4 q^3 of the spline's inner piece")                                            \
    PLACE(eq04_outer, term, "2 - q of the spline's outer piece")                                             \
    PLACE(eq04_inner_edge, limit, "q = 1, where the spline's pieces meet")                                   \
    PLACE(eq04_support, limit, "q = 2, where the kernel ends")                                               \
    PLACE(eq04_wendland, term, "1 - q/2 of Wendland's kernel")                                               \
    PLACE(eq04_wendland_line, term, "2 q of Wendland's kernel")                                              \
    PLACE(eq04_slope_norm, factor, "1/(pi h^3) of the kernel's slope")                                       \
    PLACE(eq04_slope_line, term, "-3 q of the slope's inner piece")                                          \
    PLACE(eq04_slope_square, term, "9/4 q^2 of the slope's inner piece")                                     \
    PLACE(eq04_slope_outer, term, "2 - q of the slope's outer piece")                                        \
    PLACE(eq04_slope_wendland, term, "1 - q/2 of the slope of Wendland's kernel")                            \
    PLACE(eq07_norm, factor, "45/(pi H^6) of the viscosity kernel's Laplacian")                              \
    PLACE(eq07_distance, term, "H - r of the viscosity kernel's Laplacian")                                  \
    PLACE(eq07_support, limit, "H, where the viscosity kernel ends")                                         \
    PLACE(eq08_force, factor, "P R")                                                                         \
    PLACE(eq08_thickness, factor, "2 h")                                                                     \
    PLACE(eq09_loss, term, "-sigma h dR / R")                                                                \
    PLACE(eq09_radius, factor, "R")                                                                          \
    PLACE(eq10_sphere, term, "2, of the growing sphere")                                                     \
    PLACE(eq10_thinning, term, "sigma, of the thinning wall")                                                \
    PLACE(eq10_radius, factor, "R")                                                                          \
    PLACE(eq11_yield, factor, "-2/3 Y")                                                                      \
    PLACE(eq11_logarithm, factor, "ln phi")                                                                  \
    PLACE(eq11_porosity, factor, "phi")                                                                      \
    PLACE(eq12_numerator, factor, "R / 2h")                                                                  \
    PLACE(eq12_strength, term, "2 Y (2 - sigma) / (3 R phi)")                                                \
    PLACE(eq12_load, term, "P (1 + sigma) / (2 h)")                                                          \
    PLACE(eq13_strength, factor, "4 h Y (2 - sigma)")                                                        \
    PLACE(eq13_radius, factor, "3 R")                                                                        \
    PLACE(eq13_porosity, factor, "phi")                                                                      \
    PLACE(eq13_poisson, term, "sigma of 1 + sigma")                                                          \
    PLACE(eq14_mass, factor, "m")                                                                            \
    PLACE(eq14_velocity, term, "v")                                                                          \
    PLACE(eq14_time, factor, "dt")                                                                           \
    PLACE(eq16_area, factor, "the area that makes F_b a pressure")                                           \
    PLACE(eq16_resistance, factor, "P_c of the criterion F_b > P_c")                                         \
    PLACE(eq17_blood, term, "F_B")                                                                           \
    PLACE(eq17_tissue, term, "F_F")                                                                          \
    PLACE(eq17_fibres, term, "F_P")                                                                          \
    PLACE(eq18_density, factor, "rho_F")                                                                     \
    PLACE(eq18_area, factor, "a")                                                                            \
    PLACE(eq18_speed, factor, "u_t")                                                                         \
    PLACE(eq19_elastin, term, "K_E A_E")                                                                     \
    PLACE(eq19_collagen, term, "K_C A_C")                                                                    \
    PLACE(eq19_strain, factor, "epsilon")                                                                    \
    PLACE(eq20_growth, factor, "dR")                                                                         \
    PLACE(eq20_radius, factor, "R")                                                                          \
    PLACE(eq21_force, factor, "F_B")                                                                         \
    PLACE(eq21_inertia, term, "m / dt^2")                                                                    \
    PLACE(eq21_tissue, term, "rho_F a c / dt")                                                               \
    PLACE(eq21_fibres, term, "(K_E A_E + K_C A_C) / R")                                                      \
    PLACE(eq22_thickness, term, "h")                                                                         \
    PLACE(eq22_thinning, term, "h/R sigma dR")                                                               \
    PLACE(eq22_radius, factor, "R")                                                                          \
    PLACE(eq23_thickness, factor, "h")                                                                       \
    PLACE(eq23_thinning, term, "alpha min(dR, largest)")                                                     \
    PLACE(eq23_cap, limit, "the largest dR that thins the wall")                                             \
    PLACE(eq24_radius, factor, "r_0")                                                                        \
    PLACE(eq24_root, factor, "2^(1/3)")                                                                      \
    PLACE(eq25_amplitude, factor, "v_0")                                                                     \
    PLACE(eq25_phase, factor, "2 pi t / T")                                                                  \
    PLACE(eq25_table, term, "the way from one row of the table to the next")                                 \
    PLACE(eq26_pressure, factor, "p_const")                                                                  \
    PLACE(eq26_density, factor, "rho_0")                                                                     \
    PLACE(eq26_gradient, term, "m_j grad W_ij")                                                              \
    PLACE(eq26_dynamic, term, "rho_0 v^2 / 2 of blood that comes back")                                      \
    PLACE(eq26_comes_back, condition, "v < 0")                                                               \
    PLACE(eq27_velocity, nought, "v_wall")                                                                   \
    PLACE(eq28_velocity, term, "v")                                                                          \
    PLACE(eq28_fluid, term, "F_fluid")                                                                       \
    PLACE(eq28_spring, term, "k u")                                                                          \
    PLACE(eq28_mass, factor, "m_wall")                                                                       \
    PLACE(eq28_displacement, term, "u")                                                                      \
    PLACE(eq28_way, term, "dt v'")                                                                           \
    PLACE(fig1_depth, term, "the way back to the wall")                                                      \
    PLACE(fig1_reflection, term, "2 v.n n, which turns the normal velocity round")                           \
    PLACE(fig1_outwards, condition, "v.n > 0")

namespace aneurysm
{

/// See ANEURYSM_FAULT_PLACES. Not scoped: `fault(eq22_radius, R)` must not bury the formula that it is in.
enum Place : std::uint8_t {
#define ANEURYSM_PLACE(name, part, text) name, ///< text
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
