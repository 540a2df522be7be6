// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vec3.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace aneurysm
{

enum class KernelName { cubic_spline, wendland_c2 };
enum class PressureModel { dfsph, eos };
enum class SacShape { none, hemispherical, spherical, piriform };
enum class Waveform { sine, rectified_sine, raised_sine, constant, table };
enum class InletProfile { plug, parabolic };
/// What a collision with the wall does to the velocity.
enum class Rebound { elastic, none };
/// What the pressure's solve starts from: the last step's pressure, or that and a constant in each slice of the vessel.
enum class PressureStart { last, slices };
/// What the blood flows in. All but the artery are for verification: lattices of `cells` on straight axes.
enum class DomainForm {
    artery,  ///< the paper's branching artery
    box,     ///< no wall, periodic in x, y and z
    channel, ///< between two plates across y; periodic in x and z
    tube,    ///< round, along y, in which it is periodic
    duct,    ///< no wall, along y from an inlet to one outlet; periodic in x and z
    pipe,    ///< round, along y from an inlet to one outlet
};
enum class WallCondition {
    no_slip, ///< (27)
    slip,    ///< the wall exerts no viscous force
};

/// One simulation, complete: every number in SI units (the paper's own), none with a hidden default.
/// JSON keys are the member names with their unit; `data/scenario.schema.json` lists them all.
struct Scenario {
    std::string name;
    std::string description;

    struct {
        DomainForm form = DomainForm::artery;
        double spacing_m = 0;     ///< of the lattice; artery: 0, its number of particles sets it
        std::int64_t cells_x = 0; ///< of the lattice between walls, open ends or periodic seams; artery: 0
        std::int64_t cells_y = 0;
        std::int64_t cells_z = 0;
        WallCondition wall = WallCondition::no_slip;
    } domain;

    struct {
        std::int64_t count = 0; ///< all particles, reserve included; constant through the run (section 3.4)
        std::int64_t seed = 0;  ///< of the initial jitter
        double jitter_spacings = 0;  ///< amplitude of the initial jitter, in particle spacings
        double reserve_fraction = 0; ///< part of `count` that waits outside for the controller to place it
    } particles;

    struct {
        double frame_s = 0;        ///< Delta t, one frame
        std::int64_t frames = 0;   ///< length of the run
        std::int64_t substeps = 0; ///< flow steps in a frame
    } time;

    struct {
        double density_kg_m3 = 0;   ///< rho_0
        double viscosity_pa_s = 0;  ///< mu
        Vec3 gravity_m_s2;          ///< g
        double gravity_cycle_s = 0; ///< T: the force is g sin(2 pi t/T); 0: steady
    } fluid;

    struct {
        KernelName function = KernelName::cubic_spline;
        double smoothing_length_spacings = 0; ///< h / dx; the support radius is 2 h
    } kernel;

    struct {
        PressureModel model = PressureModel::dfsph;
        double stiffness_m2_s2 = 0; ///< kappa of the equation of state; drives the flow only in model `eos`
        double relaxation = 0;      ///< omega, the step of the pressure iteration, model `dfsph`
        PressureStart start = PressureStart::last;
        double density_correction = 0; ///< beta: part of the density error that one step removes, 0 to 1
        double shifting = 0; ///< beta of the particles' shifts, beside the correction of the density
        double correction_tolerance_per_s = 0;     ///< as the next two, for the correction of the density
        double correction_max_tolerance_per_s = 0; ///< [1/s]
        std::int64_t correction_max_iterations = 0;
        double tolerance_per_s = 0;     ///< largest mean |residual| of (3) as a rate [1/s]
        double max_tolerance_per_s = 0; ///< largest |residual| of a single particle [1/s]
        std::int64_t max_iterations = 0;
        double blow_up_density_ratio = 0; ///< a run stops when a density exceeds this times rho_0
    } pressure;

    struct {
        double radius_m = 0; ///< r_0, radius of the parent artery
        double parent_length_radii = 0;
        double daughter_length_radii = 0;
        double angle_deg = 0;                ///< B, between each daughter and the parent's axis
        double junction_smoothing_radii = 0; ///< width of the smooth union of the tubes
        double sac_smoothing_radii = 0;      ///< width of the smooth union of tubes and sac
    } vessel;

    struct {
        SacShape shape = SacShape::none;
        double neck_width_radii = 0;     ///< Table 2, in artery radii
        double base_width_radii = 0;     ///< Table 2, in artery radii; half of it is the largest R
        double initial_radius_radii = 0; ///< R at frame 0, in artery radii
    } aneurysm;

    struct {
        std::int64_t warm_up_frames = 0;
        double tissue_density_kg_m3 = 0;     ///< rho_F
        double tissue_area_m2 = 0;           ///< a
        double wave_speed_m_s = 0;           ///< c
        double elastin_stiffness_n_m = 0;    ///< K_E
        double collagen_stiffness_n_m = 0;   ///< K_C
        double elastin_area_m2 = 0;          ///< A_E
        double collagen_area_m2 = 0;         ///< A_C
        double wall_mass_kg = 0;             ///< m of (21)
        double thinning_intensity_per_m = 0; ///< alpha of (23)
        double largest_increment_m = 0;      ///< Delta R of (23) does not exceed this
    } growth;

    struct {
        double poisson_ratio = 0;   ///< sigma
        double porosity = 0;        ///< phi
        double yield_limit_pa = 0;  ///< Y
        double thickness_ratio = 0; ///< zeta: h_0 / r_0
        double impact_mass_kg = 0;  ///< blood that strikes the wall with the acceleration of F_b's particle
        double conversion_area_m2 = 0;   ///< turns that force into the pressure that P_c is compared with
        double impact_band_spacings = 0; ///< S of (16): blood nearer to the sac's wall, or beyond it
        double breach_radius_radii = 0;
        double recycle_distance_radii = 0; ///< blood this far from the breach goes back to the reserve
    } rupture;

    struct {
        double mass_kg = 0;       ///< m_wall of (28)
        double stiffness_n_m = 0; ///< k of (28)
    } elastic_wall;

    struct {
        Rebound rebound = Rebound::elastic;
    } collision;

    struct {
        Waveform waveform = Waveform::sine;
        double ramp_s = 0;                      ///< the velocity rises smoothly from 0 in this time
        double peak_velocity_m_s = 0;           ///< v_0
        double cycle_s = 0;                     ///< T
        std::vector<double> table_time_s;       ///< waveform `table`: from 0, rising, below T; periodic
        std::vector<double> table_velocity_m_s; ///< as many as times
        InletProfile profile = InletProfile::plug;
    } inlet;

    struct {
        double pressure_pa = 0;  ///< p_const
        double level_margin = 0; ///< the level of the pressure is this times what keeps blood from tearing
    } outlet;

    struct Controller {
        double refill_distance_spacings = 0; ///< a buffer's far layer is filled where blood is farther away
    } controller;

    struct {
        std::int64_t pushing_rounds = 0; ///< that only push blood apart
        std::int64_t rounds = 0;         ///< of the whole correction behind them, at most
        std::int64_t max_iterations = 0; ///< of a round
        double density_correction = 0;   ///< beta of a round
    } settling;

    struct {
        std::int64_t particles_every_frames = 0;  ///< VTK files; 0: none
        std::int64_t checkpoint_every_frames = 0; ///< 0: only at the end
    } output;

    /// JSON path -> why, for each value that the paper doesn't give.
    std::map<std::string, std::string> assumed;
};

/// Reads a scenario and the files that it builds on (`"base": "file.json"`, relative to it; later values
/// win). \throws InputError that names file, JSON path, value and what is allowed
Scenario read_scenario(const std::filesystem::path& file);

/// The complete scenario as JSON text, without `base`: what a run records.
std::string to_json(const Scenario& scenario);

/// The inverse of to_json, for checkpoints and tests. `origin` stands in messages for the file.
Scenario parse_scenario(const std::string& json, const std::string& origin);

/// JSON Schema (2020-12) of a scenario file, from the same table as the reader.
std::string scenario_schema();

/// Refuses values that contradict one another. Called by the readers above.
/// \throws InputError
void validate(const Scenario& scenario, const std::string& origin);

/// 64-bit FNV-1a of to_json, as 16 hex digits.
std::string scenario_hash(const Scenario& scenario);

} // namespace aneurysm
