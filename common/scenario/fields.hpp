// SPDX-License-Identifier: Apache-2.0
// The one table of a scenario's values; reader, writer, checks and schema all visit it.
#pragma once

#include "common/scenario/scenario.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace aneurysm::fields
{

using namespace std::string_view_literals;

/// The numbers that a field allows (of an array: each of its members).
struct Range {
    double low = 0;
    double high = 0;
    bool low_open = false;
    bool high_open = false;

    constexpr bool contains(double x) const
    {
        return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
    }
    constexpr Range to(double x) const { return {low, x, low_open, false}; }
    constexpr Range below(double x) const { return {low, x, low_open, true}; }
};

/// Larger numbers than this describe nothing here and could overflow on the way.
constexpr double huge = 1e12;
constexpr Range from(double x)
{
    return {x, huge, false, false};
}
constexpr Range above(double x)
{
    return {x, huge, true, false};
}

/// Where a value comes from. A value that is not among the paper's needs a reason in `assumed`.
struct Origin {
    enum class Kind { paper, assumed, setting };
    Kind kind = Kind::assumed;
    std::string_view where;              ///< in the paper
    std::vector<double> numbers;         ///< the paper's values; of an array: its allowed lengths
    std::vector<std::string_view> names; ///< the paper's choices

    bool gives(double x) const { return std::find(numbers.begin(), numbers.end(), x) != numbers.end(); }
    bool gives(std::string_view x) const { return std::find(names.begin(), names.end(), x) != names.end(); }
};

inline Origin paper(std::string_view where, std::initializer_list<double> numbers)
{
    return {Origin::Kind::paper, where, numbers, {}};
}
inline Origin paper(std::string_view where, std::initializer_list<std::string_view> names)
{
    return {Origin::Kind::paper, where, {}, names};
}
/// The paper gives no value: each needs a reason.
inline Origin assumed()
{
    return {};
}
/// Doesn't touch the result: needs no reason.
inline Origin setting()
{
    return {Origin::Kind::setting, {}, {}, {}};
}

struct Field {
    std::string_view path; ///< "group.key", or "key" at the top
    Range range;
    Origin origin;
    std::string_view doc;
};

/// The JSON names of an enumeration's values, in their order.
template <class Enum>
constexpr std::array<std::string_view, 0> names{};
template <>
inline constexpr std::array names<KernelName>{"cubic_spline"sv, "wendland_c2"sv};
template <>
inline constexpr std::array names<PressureModel>{"dfsph"sv, "eos"sv};
template <>
inline constexpr std::array names<SacShape>{"none"sv, "hemispherical"sv, "spherical"sv, "piriform"sv};
template <>
inline constexpr std::array names<DomainForm>{"artery"sv, "box"sv, "channel"sv, "tube"sv, "duct"sv, "pipe"sv};
template <>
inline constexpr std::array names<WallCondition>{"no_slip"sv, "slip"sv};
template <>
inline constexpr std::array names<Waveform>{"sine"sv, "rectified_sine"sv, "raised_sine"sv, "constant"sv,
                                            "table"sv};
template <>
inline constexpr std::array names<InletProfile>{"plug"sv, "parabolic"sv};
template <>
inline constexpr std::array names<Rebound>{"elastic"sv, "none"sv};
template <>
inline constexpr std::array names<PressureStart>{"last"sv, "slices"sv};
template <class Enum>
std::string_view name_of(Enum value)
{
    return names<Enum>.at(static_cast<std::size_t>(value));
}

// A row is v(member, path, range, origin, doc); the rows are in the order of the file. `S` is Scenario or const
// Scenario.

template <class S, class Row>
void visit_run(S& s, const Row& v)
{
    v(s.name, "name", {}, setting(), "short name, for file names and titles");
    v(s.description, "description", {}, setting(), "what this run is for");
    auto& d = s.domain;
    v(d.form, "domain.form", {}, paper("section 3.4", {"artery"}),
      "artery, or for verification box, channel, tube (periodic), duct, pipe (an inlet and an outlet)");
    v(d.spacing_m, "domain.spacing_m", from(0).to(1000), paper("set by particles.count", {0}),
      "spacing of the lattice [m]; 0 for the artery");
    const Range cells = from(0).to(10000);
    const std::string_view doc = "cells of the lattice in this direction; 0 for the artery";
    v(d.cells_x, "domain.cells_x", cells, paper("set by the vessel", {0}), doc);
    v(d.cells_y, "domain.cells_y", cells, paper("set by the vessel", {0}), doc);
    v(d.cells_z, "domain.cells_z", cells, paper("set by the vessel", {0}), doc);
    v(d.wall, "domain.wall", {}, paper("(27)", {"no_slip"}),
      "no_slip, or slip: no viscous force of the wall");
    auto& p = s.particles;
    v(p.count, "particles.count", from(1).to(1e8), paper("Table 3", {5520, 15456, 40296}),
      "all particles, the reserve included; constant through the run");
    v(p.seed, "particles.seed", from(0).to(4294967295.0), assumed(), "seed of the initial jitter");
    v(p.jitter_spacings, "particles.jitter_spacings", from(0).to(0.5), assumed(),
      "amplitude of the initial jitter, in particle spacings");
    v(p.reserve_fraction, "particles.reserve_fraction", from(0).to(0.5), assumed(),
      "part of the count that waits outside for the controller to place it");
    auto& t = s.time;
    v(t.frame_s, "time.frame_s", above(0).to(1), paper("section 3.4", {0.001}),
      "length of a frame, Delta t [s]");
    v(t.frames, "time.frames", from(1).to(1e9), paper("section 3.4", {3000}), "frames of the run");
    v(t.substeps, "time.substeps", from(1).to(1000), paper("section 3.4", {1}), "flow steps in a frame");
}

template <class S, class Row>
void visit_flow(S& s, const Row& v)
{
    auto& f = s.fluid;
    v(f.density_kg_m3, "fluid.density_kg_m3", above(0).to(1e5), paper("Table 1", {1050}),
      "density of blood, rho_0 [kg/m^3]");
    v(f.viscosity_pa_s, "fluid.viscosity_pa_s", from(0).to(1e6), assumed(), "dynamic viscosity, mu [Pa s]");
    v(f.gravity_m_s2, "fluid.gravity_m_s2", from(-1000).to(1000), assumed(),
      "gravity, g [m/s^2]; between open ends, while the wall is whole, pressure balances it");
    v(f.gravity_cycle_s, "fluid.gravity_cycle_s", from(0).to(1e6), paper("(1)", {0}),
      "cycle T of a force g sin(2 pi t/T) [s]; 0: g is steady");
    auto& k = s.kernel;
    v(k.function, "kernel.function", {}, assumed(), "smoothing kernel W");
    v(k.smoothing_length_spacings, "kernel.smoothing_length_spacings", from(0.8).to(2), assumed(),
      "smoothing length h in particle spacings; the support radius is 2 h");
    auto& p = s.pressure;
    v(p.model, "pressure.model", {}, paper("section 3.1, (3)", {"dfsph"}),
      "dfsph: density-invariant and divergence-free; eos: equation of state alone");
    v(p.stiffness_m2_s2, "pressure.stiffness_m2_s2", from(0), paper("section 3.1", {1}),
      "stiffness kappa of the equation of state [m^2/s^2]; drives the flow only in model eos");
    v(p.relaxation, "pressure.relaxation", above(0).below(1), assumed(),
      "relaxation omega, the step of the pressure iteration, model dfsph");
    v(p.start, "pressure.start", {}, assumed(),
      "what the pressure's solve starts from: last: the last step's pressure; slices: and a constant in each slice across "
      "the parent artery, where there are open ends; model dfsph");
    v(p.density_correction, "pressure.density_correction", from(0).to(1), assumed(),
      "part of the density error that one step removes, 0: density isn't corrected; model dfsph");
    v(p.shifting, "pressure.shifting", from(0).to(0.25), assumed(),
      "strength of the shifts by which a step spreads particles evenly, in squares of a spacing, 0: none; where the "
      "density is corrected");
    v(p.correction_tolerance_per_s, "pressure.correction_tolerance_per_s", above(0), assumed(),
      "largest mean |residual| of the density's correction as a rate [1/s]");
    v(p.correction_max_tolerance_per_s, "pressure.correction_max_tolerance_per_s", above(0), assumed(),
      "largest |residual| of a single particle in the density's correction [1/s]");
    v(p.correction_max_iterations, "pressure.correction_max_iterations", from(1).to(1e6), assumed(),
      "iterations of one correction of the density at most");
    v(p.tolerance_per_s, "pressure.tolerance_per_s", above(0), assumed(),
      "largest mean |residual| of (3) as a rate [1/s]");
    v(p.max_tolerance_per_s, "pressure.max_tolerance_per_s", above(0), assumed(),
      "largest |residual| of a single particle [1/s]");
    v(p.max_iterations, "pressure.max_iterations", from(1).to(1e6), assumed(),
      "iterations of one pressure solve at most");
    v(p.blow_up_density_ratio, "pressure.blow_up_density_ratio", above(1).to(1000), assumed(),
      "the run stops when a density exceeds this times rho_0");
}

template <class S, class Row>
void visit_geometry(S& s, const Row& v)
{
    auto& w = s.vessel;
    v(w.radius_m, "vessel.radius_m", above(0).to(1000), assumed(), "radius of the parent artery, r_0 [m]");
    v(w.parent_length_radii, "vessel.parent_length_radii", from(1).to(1000), assumed(),
      "length of the parent artery / r_0");
    v(w.daughter_length_radii, "vessel.daughter_length_radii", from(1).to(1000), assumed(),
      "length of each daughter's axis / r_0");
    v(w.angle_deg, "vessel.angle_deg", from(15).to(85), paper("Table 1 and Fig. 8", {30, 40, 60, 75}),
      "deflection angle B between each daughter and the parent's axis [degrees]");
    v(w.junction_smoothing_radii, "vessel.junction_smoothing_radii", from(0).to(2), assumed(),
      "width of the smooth union of the tubes / r_0");
    v(w.sac_smoothing_radii, "vessel.sac_smoothing_radii", from(0).to(2), assumed(),
      "width of the smooth union of tubes and aneurysm / r_0");
    auto& a = s.aneurysm;
    v(a.shape, "aneurysm.shape", {},
      paper("Table 2; none: Table 3", {"none", "hemispherical", "spherical", "piriform"}),
      "shape of the aneurysm");
    v(a.neck_width_radii, "aneurysm.neck_width_radii", from(0).to(100),
      paper("Table 2; 0: no aneurysm", {0, 1.2, 1.6}), "width of the neck / r_0");
    v(a.base_width_radii, "aneurysm.base_width_radii", from(0).to(100),
      paper("Table 2; 0: no aneurysm", {0, 1.6, 2.4}), "width of the fully developed aneurysm / r_0");
    v(a.initial_radius_radii, "aneurysm.initial_radius_radii", from(0).to(100), paper("0: no aneurysm", {0}),
      "radius R of the aneurysm in frame 0 / r_0");
}

template <class S, class Row>
void visit_growth(S& s, const Row& v)
{
    auto& g = s.growth;
    v(g.warm_up_frames, "growth.warm_up_frames", from(0).to(1e9), paper("Fig. 9", {100}),
      "frames before growth begins");
    v(g.tissue_density_kg_m3, "growth.tissue_density_kg_m3", above(0).to(1e5), paper("Table 1", {1000}),
      "density of the tissue fluid, rho_F [kg/m^3]");
    v(g.tissue_area_m2, "growth.tissue_area_m2", from(0), paper("Table 1", {0.01}),
      "area of tissue fluid on the aneurysm, a [m^2]");
    v(g.wave_speed_m_s, "growth.wave_speed_m_s", from(0), paper("Table 1", {1500}),
      "wave speed in the tissue fluid, c [m/s]");
    v(g.elastin_stiffness_n_m, "growth.elastin_stiffness_n_m", from(0), paper("Table 1", {800}),
      "stiffness of elastin, K_E [N/m]");
    v(g.collagen_stiffness_n_m, "growth.collagen_stiffness_n_m", from(0), paper("Table 1", {3.52}),
      "stiffness of collagen, K_C [N/m]");
    v(g.elastin_area_m2, "growth.elastin_area_m2", from(0), paper("Table 1", {20}),
      "area of elastin, A_E [m^2]");
    v(g.collagen_area_m2, "growth.collagen_area_m2", from(0), paper("Table 1", {10}),
      "area of collagen, A_C [m^2]");
    v(g.wall_mass_kg, "growth.wall_mass_kg", above(0), assumed(),
      "mass of the aneurysm's wall in (21), m [kg]");
    v(g.thinning_intensity_per_m, "growth.thinning_intensity_per_m", from(0), paper("Table 1", {1.1}),
      "thinning of the fully developed wall, alpha of (23) [1/m]");
    v(g.largest_increment_m, "growth.largest_increment_m", above(0), paper("(23)", {0.001}),
      "Delta R in (23) does not exceed this [m]");
}

template <class S, class Row>
void visit_rupture(S& s, const Row& v)
{
    auto& r = s.rupture;
    v(r.poisson_ratio, "rupture.poisson_ratio", above(-1).below(2),
      paper("Tables 1 and 4", {0.2, 0.3, 0.4, 0.5, 0.6}), "Poisson's ratio of the wall, sigma");
    v(r.porosity, "rupture.porosity", above(0).below(1), paper("Tables 1 and 4", {3e-3, 4e-3, 5e-3, 6e-3}),
      "porosity of the wall, phi");
    v(r.yield_limit_pa, "rupture.yield_limit_pa", above(0), assumed(), "yield limit of the wall, Y [Pa]");
    v(r.thickness_ratio, "rupture.thickness_ratio", above(0).to(1), paper("Table 1", {0.025}),
      "initial thickness of the wall h_0 / r_0, zeta");
    v(r.impact_mass_kg, "rupture.impact_mass_kg", above(0), assumed(),
      "blood that strikes the wall with the acceleration of the particle of F_b, (16): its force moves and breaks the "
      "wall [kg]");
    v(r.conversion_area_m2, "rupture.conversion_area_m2", above(0), assumed(),
      "area that turns that force into the pressure that P_c is compared with [m^2]");
    v(r.impact_band_spacings, "rupture.impact_band_spacings", from(0).to(10), assumed(),
      "S of (16): particles nearer to the aneurysm's wall than this, in spacings, or beyond it");
    v(r.breach_radius_radii, "rupture.breach_radius_radii", above(0).to(100), assumed(),
      "radius of the breach / r_0");
    v(r.recycle_distance_radii, "rupture.recycle_distance_radii", above(0).to(1000), assumed(),
      "blood this far from the breach goes back to the reserve / r_0");
}

template <class S, class Row>
void visit_boundaries(S& s, const Row& v)
{
    v(s.elastic_wall.mass_kg, "elastic_wall.mass_kg", above(0), assumed(),
      "mass of the elastic wall, m_wall of (28) [kg]");
    v(s.elastic_wall.stiffness_n_m, "elastic_wall.stiffness_n_m", above(0), assumed(),
      "stiffness of the elastic wall, k of (28) [N/m]");
    v(s.collision.rebound, "collision.rebound", {}, paper("Fig. 1", {"elastic"}),
      "velocity of blood that is put back into the artery: elastic, its outward component turned round; none, as it was");
    auto& i = s.inlet;
    v(i.waveform, "inlet.waveform", {}, paper("(25)", {"sine"}), "inlet velocity over the cycle");
    v(i.profile, "inlet.profile", {}, paper("(25)", {"plug"}),
      "velocity over the inlet: plug, the same everywhere; parabolic, 0 at the wall and twice (25) on the axis");
    v(i.ramp_s, "inlet.ramp_s", from(0).to(1000), paper("(25)", {0}),
      "time in which the inlet's velocity rises smoothly from 0 to (25) [s]");
    v(i.peak_velocity_m_s, "inlet.peak_velocity_m_s", above(0).to(1e5), assumed(),
      "peak velocity at the inlet, v_0 [m/s]");
    v(i.cycle_s, "inlet.cycle_s", above(0).to(1000), paper("section 3.4", {0.8}),
      "cycle of the heart, T [s]");
    v(i.table_time_s, "inlet.table_time_s", from(0).to(1000), paper("empty: not used", {0}),
      "times of waveform table, from 0, rising, below the cycle [s]");
    v(i.table_velocity_m_s, "inlet.table_velocity_m_s", from(-1e5).to(1e5), paper("empty: not used", {0}),
      "velocities of waveform table, one for each time, linear between [m/s]");
    v(s.outlet.pressure_pa, "outlet.pressure_pa", from(0), assumed(),
      "pressure at the outlets, p_const of (26) [Pa]");
    v(s.outlet.level_margin, "outlet.level_margin", from(0).to(1000), assumed(),
      "the level of the pressure is this times what keeps the blood from tearing, p_const at most");
    auto& c = s.controller;
    v(c.refill_distance_spacings, "controller.refill_distance_spacings", above(0).to(1), assumed(),
      "a place in the far layer of an open end's buffer is filled when no blood is nearer than this, in spacings");
    auto& b = s.settling;
    v(b.pushing_rounds, "settling.pushing_rounds", from(0).to(1e6), assumed(),
      "rounds before those in which blood is only pushed apart and off the walls");
    v(b.max_iterations, "settling.max_iterations", from(1).to(1e6), assumed(),
      "iterations of a round at most");
    v(b.rounds, "settling.rounds", from(0).to(1e6), assumed(),
      "rounds at most in which the density of the lattice of frame 0 is corrected");
    v(b.density_correction, "settling.density_correction", above(0).to(1), assumed(),
      "part of the density error that one round removes");
    v(s.output.particles_every_frames, "output.particles_every_frames", from(0).to(1e9), setting(),
      "frames between particle files; 0: none");
    v(s.output.checkpoint_every_frames, "output.checkpoint_every_frames", from(0).to(1e9), setting(),
      "frames between checkpoints; 0: only at the end");
}

/// Calls the visitor with (Field, member) for each value.
template <class S, class Visitor>
void visit(S& s, Visitor&& visitor)
{
    const auto row = [&visitor](auto& member, std::string_view path, const Range& range, const Origin& origin,
                                std::string_view doc) {
        visitor(Field{path, range, origin, doc}, member);
    };
    visit_run(s, row);
    visit_flow(s, row);
    visit_geometry(s, row);
    visit_growth(s, row);
    visit_rupture(s, row);
    visit_boundaries(s, row);
}

} // namespace aneurysm::fields
