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
struct Names;
template <>
struct Names<KernelName> {
    static constexpr std::array<std::string_view, 2> values{"cubic_spline", "wendland_c2"};
};
template <>
struct Names<PressureModel> {
    static constexpr std::array<std::string_view, 2> values{"dfsph", "eos"};
};
template <>
struct Names<SacShape> {
    static constexpr std::array<std::string_view, 4> values{"none", "hemispherical", "spherical", "piriform"};
};
template <>
struct Names<DomainForm> {
    static constexpr std::array<std::string_view, 6> values{"artery", "box",  "channel",
                                                            "tube",   "duct", "pipe"};
};
template <>
struct Names<WallCondition> {
    static constexpr std::array<std::string_view, 2> values{"no_slip", "slip"};
};
template <>
struct Names<Waveform> {
    static constexpr std::array<std::string_view, 5> values{"sine", "rectified_sine", "raised_sine",
                                                            "constant", "table"};
};
template <class Enum>
std::string_view name_of(Enum value)
{
    return Names<Enum>::values.at(static_cast<std::size_t>(value));
}

// `S` is Scenario or const Scenario; the visitor is called with (Field, member) in the order of the file.

template <class S, class Visitor>
void visit_run(S& s, Visitor& v)
{
    v(Field{"name", {}, setting(), "short name, for file names and titles"}, s.name);
    v(Field{"description", {}, setting(), "what this run is for"}, s.description);
    auto& d = s.domain;
    v(Field{"domain.form",
            {},
            paper("section 3.4", {"artery"}),
            "artery, or for verification box, channel, tube (periodic), duct, pipe (an inlet and an outlet)"},
      d.form);
    v(Field{"domain.spacing_m", from(0).to(1000), paper("set by particles.count", {0}),
            "spacing of the lattice [m]; 0 for the artery"},
      d.spacing_m);
    const Range cells = from(0).to(10000);
    const std::string_view doc = "cells of the lattice in this direction; 0 for the artery";
    v(Field{"domain.cells_x", cells, paper("set by the vessel", {0}), doc}, d.cells_x);
    v(Field{"domain.cells_y", cells, paper("set by the vessel", {0}), doc}, d.cells_y);
    v(Field{"domain.cells_z", cells, paper("set by the vessel", {0}), doc}, d.cells_z);
    v(Field{"domain.wall", {}, paper("(27)", {"no_slip"}), "no_slip, or slip: no viscous force of the wall"},
      d.wall);
    auto& p = s.particles;
    v(Field{"particles.count", from(1).to(1e8), paper("Table 3", {5520, 15456, 40296}),
            "all particles, the reserve included; constant through the run"},
      p.count);
    v(Field{"particles.seed", from(0).to(4294967295.0), assumed(), "seed of the initial jitter"}, p.seed);
    v(Field{"particles.jitter_spacings", from(0).to(0.5), assumed(),
            "amplitude of the initial jitter, in particle spacings"},
      p.jitter_spacings);
    v(Field{"particles.reserve_fraction", from(0).to(0.5), assumed(),
            "part of the count that waits outside for the controller to place it"},
      p.reserve_fraction);
    auto& t = s.time;
    v(Field{"time.frame_s", above(0).to(1), paper("section 3.4", {0.001}), "length of a frame, Delta t [s]"},
      t.frame_s);
    v(Field{"time.frames", from(1).to(1e9), paper("section 3.4", {3000}), "frames of the run"}, t.frames);
    v(Field{"time.substeps", from(1).to(1000), paper("section 3.4", {1}), "flow steps in a frame"},
      t.substeps);
}

template <class S, class Visitor>
void visit_flow(S& s, Visitor& v)
{
    auto& f = s.fluid;
    v(Field{"fluid.density_kg_m3", above(0).to(1e5), paper("Table 1", {1050}),
            "density of blood, rho_0 [kg/m^3]"},
      f.density_kg_m3);
    v(Field{"fluid.viscosity_pa_s", from(0).to(1e6), assumed(), "dynamic viscosity, mu [Pa s]"},
      f.viscosity_pa_s);
    v(Field{"fluid.gravity_m_s2", from(-1000).to(1000), assumed(), "gravity, g [m/s^2]"}, f.gravity_m_s2);
    v(Field{"fluid.gravity_cycle_s", from(0).to(1e6), paper("(1)", {0}),
            "cycle T of a force g sin(2 pi t/T) [s]; 0: g is steady"},
      f.gravity_cycle_s);
    auto& k = s.kernel;
    v(Field{"kernel.function", {}, assumed(), "smoothing kernel W"}, k.function);
    v(Field{"kernel.smoothing_length_spacings", from(0.8).to(2), assumed(),
            "smoothing length h in particle spacings; the support radius is 2 h"},
      k.smoothing_length_spacings);
    auto& p = s.pressure;
    v(Field{"pressure.model",
            {},
            paper("section 3.1, (3)", {"dfsph"}),
            "dfsph: density-invariant and divergence-free; eos: equation of state alone"},
      p.model);
    v(Field{"pressure.stiffness_m2_s2", from(0), paper("section 3.1", {1}),
            "stiffness kappa of the equation of state [m^2/s^2]; drives the flow only in model eos"},
      p.stiffness_m2_s2);
    v(Field{"pressure.relaxation", above(0).below(1), assumed(),
            "relaxation omega, the step of the pressure iteration, model dfsph"},
      p.relaxation);
    v(Field{"pressure.density_correction", from(0).to(1), assumed(),
            "part of the density error that one step removes, model dfsph"},
      p.density_correction);
    v(Field{"pressure.tolerance_per_s", above(0), assumed(),
            "largest mean |residual| of (3) as a rate [1/s]"},
      p.tolerance_per_s);
    v(Field{"pressure.max_tolerance_per_s", above(0), assumed(),
            "largest |residual| of a single particle [1/s]"},
      p.max_tolerance_per_s);
    v(Field{"pressure.max_iterations", from(1).to(1e6), assumed(),
            "iterations of one pressure solve at most"},
      p.max_iterations);
    v(Field{"pressure.blow_up_density_ratio", above(1).to(1000), assumed(),
            "the run stops when a density exceeds this times rho_0"},
      p.blow_up_density_ratio);
}

template <class S, class Visitor>
void visit_geometry(S& s, Visitor& v)
{
    auto& w = s.vessel;
    v(Field{"vessel.radius_m", above(0).to(1000), assumed(), "radius of the parent artery, r_0 [m]"},
      w.radius_m);
    v(Field{"vessel.parent_length_radii", from(1).to(1000), assumed(), "length of the parent artery / r_0"},
      w.parent_length_radii);
    v(Field{"vessel.daughter_length_radii", from(1).to(1000), assumed(),
            "length of each daughter's axis / r_0"},
      w.daughter_length_radii);
    v(Field{"vessel.angle_deg", from(15).to(85), paper("Table 1 and Fig. 8", {30, 40, 60, 75}),
            "deflection angle B between each daughter and the parent's axis [degrees]"},
      w.angle_deg);
    v(Field{"vessel.junction_smoothing_radii", from(0).to(2), assumed(),
            "width of the smooth union of the tubes / r_0"},
      w.junction_smoothing_radii);
    v(Field{"vessel.sac_smoothing_radii", from(0).to(2), assumed(),
            "width of the smooth union of tubes and aneurysm / r_0"},
      w.sac_smoothing_radii);
    auto& a = s.aneurysm;
    v(Field{"aneurysm.shape",
            {},
            paper("Table 2; none: Table 3", {"none", "hemispherical", "spherical", "piriform"}),
            "shape of the aneurysm"},
      a.shape);
    v(Field{"aneurysm.neck_width_radii", from(0).to(100), paper("Table 2; 0: no aneurysm", {0, 1.2, 1.6}),
            "width of the neck / r_0"},
      a.neck_width_radii);
    v(Field{"aneurysm.base_width_radii", from(0).to(100), paper("Table 2; 0: no aneurysm", {0, 1.6, 2.4}),
            "width of the fully developed aneurysm / r_0"},
      a.base_width_radii);
    v(Field{"aneurysm.initial_radius_radii", from(0).to(100), paper("0: no aneurysm", {0}),
            "radius R of the aneurysm in frame 0 / r_0"},
      a.initial_radius_radii);
}

template <class S, class Visitor>
void visit_growth(S& s, Visitor& v)
{
    auto& g = s.growth;
    v(Field{"growth.warm_up_frames", from(0).to(1e9), paper("Fig. 9", {100}), "frames before growth begins"},
      g.warm_up_frames);
    v(Field{"growth.tissue_density_kg_m3", above(0).to(1e5), paper("Table 1", {1000}),
            "density of the tissue fluid, rho_F [kg/m^3]"},
      g.tissue_density_kg_m3);
    v(Field{"growth.tissue_area_m2", from(0), paper("Table 1", {0.01}),
            "area of tissue fluid on the aneurysm, a [m^2]"},
      g.tissue_area_m2);
    v(Field{"growth.wave_speed_m_s", from(0), paper("Table 1", {1500}),
            "wave speed in the tissue fluid, c [m/s]"},
      g.wave_speed_m_s);
    v(Field{"growth.elastin_stiffness_n_m", from(0), paper("Table 1", {800}),
            "stiffness of elastin, K_E [N/m]"},
      g.elastin_stiffness_n_m);
    v(Field{"growth.collagen_stiffness_n_m", from(0), paper("Table 1", {3.52}),
            "stiffness of collagen, K_C [N/m]"},
      g.collagen_stiffness_n_m);
    v(Field{"growth.elastin_area_m2", from(0), paper("Table 1", {20}), "area of elastin, A_E [m^2]"},
      g.elastin_area_m2);
    v(Field{"growth.collagen_area_m2", from(0), paper("Table 1", {10}), "area of collagen, A_C [m^2]"},
      g.collagen_area_m2);
    v(Field{"growth.wall_mass_kg", above(0), assumed(), "mass of the aneurysm's wall in (21), m [kg]"},
      g.wall_mass_kg);
    v(Field{"growth.thinning_intensity_per_m", from(0), paper("Table 1", {1.1}),
            "thinning of the fully developed wall, alpha of (23) [1/m]"},
      g.thinning_intensity_per_m);
    v(Field{"growth.largest_increment_m", above(0), paper("(23)", {0.001}),
            "Delta R in (23) does not exceed this [m]"},
      g.largest_increment_m);
}

template <class S, class Visitor>
void visit_rupture(S& s, Visitor& v)
{
    auto& r = s.rupture;
    v(Field{"rupture.poisson_ratio", above(-1).below(2), paper("Tables 1 and 4", {0.2, 0.3, 0.4, 0.5, 0.6}),
            "Poisson's ratio of the wall, sigma"},
      r.poisson_ratio);
    v(Field{"rupture.porosity", above(0).below(1), paper("Tables 1 and 4", {3e-3, 4e-3, 5e-3, 6e-3}),
            "porosity of the wall, phi"},
      r.porosity);
    v(Field{"rupture.yield_limit_pa", above(0), assumed(), "yield limit of the wall, Y [Pa]"},
      r.yield_limit_pa);
    v(Field{"rupture.thickness_ratio", above(0).to(1), paper("Table 1", {0.025}),
            "initial thickness of the wall h_0 / r_0, zeta"},
      r.thickness_ratio);
    v(Field{"rupture.conversion_area_m2", above(0), assumed(),
            "area that turns the force F_b into the pressure that P_c is compared with [m^2]"},
      r.conversion_area_m2);
    v(Field{"rupture.impact_band_spacings", from(0).to(10), assumed(),
            "S of (16): particles nearer to the aneurysm's wall than this, in spacings, or beyond it"},
      r.impact_band_spacings);
    v(Field{"rupture.breach_radius_radii", above(0).to(100), assumed(), "radius of the breach / r_0"},
      r.breach_radius_radii);
    v(Field{"rupture.recycle_distance_radii", above(0).to(1000), assumed(),
            "blood this far from the breach goes back to the reserve / r_0"},
      r.recycle_distance_radii);
}

template <class S, class Visitor>
void visit_boundaries(S& s, Visitor& v)
{
    v(Field{"elastic_wall.mass_kg", above(0), assumed(), "mass of the elastic wall, m_wall of (28) [kg]"},
      s.elastic_wall.mass_kg);
    v(Field{"elastic_wall.stiffness_n_m", above(0), assumed(),
            "stiffness of the elastic wall, k of (28) [N/m]"},
      s.elastic_wall.stiffness_n_m);
    auto& i = s.inlet;
    v(Field{"inlet.waveform", {}, paper("(25)", {"sine"}), "inlet velocity over the cycle"}, i.waveform);
    v(Field{"inlet.peak_velocity_m_s", above(0).to(1e5), assumed(), "peak velocity at the inlet, v_0 [m/s]"},
      i.peak_velocity_m_s);
    v(Field{"inlet.cycle_s", above(0).to(1000), paper("section 3.4", {0.8}), "cycle of the heart, T [s]"},
      i.cycle_s);
    v(Field{"inlet.table_time_s", from(0).to(1000), paper("empty: not used", {0}),
            "times of waveform table, from 0, rising, below the cycle [s]"},
      i.table_time_s);
    v(Field{"inlet.table_velocity_m_s", from(-1e5).to(1e5), paper("empty: not used", {0}),
            "velocities of waveform table, one for each time, linear between [m/s]"},
      i.table_velocity_m_s);
    v(Field{"outlet.pressure_pa", from(0), assumed(), "pressure at the outlets, p_const of (26) [Pa]"},
      s.outlet.pressure_pa);
    auto& c = s.controller;
    v(Field{"controller.probe_depth_spacings", above(0).to(100), assumed(),
            "an outlet's slab moves with the blood that is nearer to its plane than this, in spacings"},
      c.probe_depth_spacings);
    v(Field{"controller.piston_reach_spacings", from(0).to(100), assumed(),
            "the inlet's slab pushes the blood that is nearer to its plane than this, in spacings"},
      c.piston_reach_spacings);
    v(Field{"controller.closest_entry_spacings", from(0).to(1), assumed(),
            "a ghost doesn't become blood where blood is nearer than this, in spacings"},
      c.closest_entry_spacings);
    auto& b = s.settling;
    v(Field{"settling.rounds", from(0).to(1e6), assumed(),
            "rounds at most in which the lattice of frame 0 is pushed apart and loses what doesn't fit"},
      b.rounds);
    v(Field{"settling.steps", from(1).to(1e6), assumed(), "steps of such a round"}, b.steps);
    v(Field{"settling.max_iterations", from(1).to(1e6), assumed(),
            "iterations of one pressure solve in it at most"},
      b.max_iterations);
    v(Field{"settling.density_correction", above(0).to(1), assumed(),
            "part of the density error that one step of it removes"},
      b.density_correction);
    v(Field{"output.particles_every_frames", from(0).to(1e9), setting(),
            "frames between particle files; 0: none"},
      s.output.particles_every_frames);
    v(Field{"output.checkpoint_every_frames", from(0).to(1e9), setting(),
            "frames between checkpoints; 0: only at the end"},
      s.output.checkpoint_every_frames);
}

template <class S, class Visitor>
void visit(S& s, Visitor&& v)
{
    visit_run(s, v);
    visit_flow(s, v);
    visit_geometry(s, v);
    visit_growth(s, v);
    visit_rupture(s, v);
    visit_boundaries(s, v);
}

} // namespace aneurysm::fields
