// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/vessel/slices.hpp"
#include "cuda/executor/lanes.hpp"
#include "cuda/kernel_function.hpp"

namespace aneurysm::device
{

/// The grid of cells that holds every body: as wide as the support in y and z, half of that in x, along which
/// bodies are read in a row. Beyond its edge the outermost cells go on. y is the slowest index: along it the
/// artery is longest, so that neighbors are near in memory. In a periodic direction the cells fill the box,
/// and the first is the last one's neighbor.
template <class Real>
struct Grid {
    Vec3T<Real> low;       ///< corner of cell 0 [m]
    Vec3T<Real> per_width; ///< cells in a meter
    Index x_cells = 0;
    Index y_cells = 0;
    Index z_cells = 0;
    Index x_period = 0; ///< in cells; 0: not periodic
    Index y_period = 0;
    Index z_period = 0;

    ANEURYSM_HD Index cells() const { return x_cells * y_cells * z_cells; }
    ANEURYSM_HD static Index along(Real offset, Real per_width, Index cells)
    {
        const Real c = offset * per_width;
        return c >= 1 ? (c < static_cast<Real>(cells) ? static_cast<Index>(c) : cells - 1) : 0; // NaN: 0
    }
    ANEURYSM_HD Index x_cell(Real x) const { return along(x - low.x, per_width.x, x_cells); }
    ANEURYSM_HD Index y_cell(Real y) const { return along(y - low.y, per_width.y, y_cells); }
    ANEURYSM_HD Index z_cell(Real z) const { return along(z - low.z, per_width.z, z_cells); }
    ANEURYSM_HD Index index(Index x, Index y, Index z) const { return (y * z_cells + z) * x_cells + x; }
    ANEURYSM_HD Index cell(const Vec3T<Real>& r) const
    {
        return index(x_cell(r.x), y_cell(r.y), z_cell(r.z));
    }
};

/// What stays the same through a run. SI units.
template <class Real>
struct Constants {
    Kernel<Real> kernel;
    VesselT<Real> vessel;
    Grid<Real> grid;
    PressureModel model;
    Index particles = 0;
    Index walls = 0;        ///< ghosts of the wall, as many as it ever has
    SlicesT<Real> slices{}; ///< in which the pressure's solve starts; without any it doesn't
    bool is_periodic = false;
    bool slips = false; ///< the wall exerts no viscous force
    Real dx = 0;
    Real dt = 0; ///< of a flow step
    Real mass = 0;
    Real rho_0 = 0;
    Real mu = 0;
    Real kappa = 0;    ///< of the equation of state
    Real omega = 0;    ///< of the pressure's iteration
    Real shifting = 0; ///< beta of the shifts
    Real blow_up_ratio = 0;
    Real impact_band = 0;      ///< [m]
    Real refill_distance = 0;  ///< a place in a buffer's far layer is filled where blood is farther away [m]
    Real open_end = 0;         ///< nearer to an open end than this is not interior [m]
    Real recycle_distance = 0; ///< [m]
    Real breach_radius = 0;    ///< [m]
    double p_const = 0;        ///< of (26) [Pa]
    InletProfile profile = InletProfile::plug;
    bool rebounds = false;         ///< elastically, Fig. 1; else only the place changes
    bool corrects_density = false; ///< else only the velocity's divergence is kept
    bool balances_gravity = false; ///< by the pressure of blood at rest, while the wall is whole

    static constexpr Real far_away = 1e6; ///< [m]

    /// The body that fills up lists: far away, without mass.
    ANEURYSM_HD Index null_body() const { return particles; }
    ANEURYSM_HD Index first_wall() const { return particles + 1; }
    ANEURYSM_HD Index bodies() const { return particles + 1 + walls; }
};

/// Lists of neighbors in blocks of eight, filled up with the null body. Those of body i are the blocks
/// begin[i] to begin[i + 1] - 1.
struct Lists {
    Index* begin = nullptr;  ///< [particles + 1], in blocks
    Index* blocks = nullptr; ///< [particles], how many
    Index* body = nullptr;   ///< [8 * capacity]
    Index capacity = 0;      ///< blocks that `body` has room for
};

/// What went wrong in a frame, first step first, then the lowest particle.
enum class Fault : std::int32_t { none, density, moved_too_far, displacement, lists_full };

/// What a frame carries beside its arrays.
struct Scene {
    AneurysmState aneurysm;
    Ledger ledger;
    double outlet_velocity[2]; ///< outward [m/s]

    FrameRecord record;
    double fill_velocity[3]; ///< of the open ends' buffers as they are filled, outward [m/s]
    double solve_t;          ///< the momentum's sequence, see (3)
    double solve_theta;      ///< its factor
    Index solving;           ///< 1: (3) is not met yet
    Index solve_iterations;
    Index slicing; ///< 1: the solve is to start in slices
    Fault fault;
    Index fault_particle;
    double fault_value;
    Index blood_blocks; ///< that the lists of this frame wanted, at most in one step
    Index wall_blocks;
};

/// What the particles of a slice of the vessel add to its equation and to those of the slices below and above, see
/// slices.hpp; b: their acceleration by a potential of 1 in a slice [kg/(m^3 s Pa)].
struct SliceSums {
    double own = 0;   ///< of dt rho_0^2 |b_own|^2
    double below = 0; ///< of dt rho_0^2 |b_below|^2
    double above = 0;
    double with_below = 0; ///< of dt rho_0^2 b_own . b_below
    double with_above = 0;
    double residual = 0; ///< [kg/(m^3 s)]
};
/// The equation of a slice.
struct SliceRow {
    double diagonal = 0;
    double beside = 0;  ///< of this and the next slice
    double right = 0;   ///< or, in the end, the slice's constant [Pa]
    double inverse = 0; ///< of the pivot
};

/// What the host hands over for each flow step: what needs a sine.
struct StepInput {
    double inlet_velocity; ///< (25) at the end of the step [m/s]
    double level;          ///< of the pressure while the wall is whole [Pa]
    Vec3 gravity;          ///< the body force g at the end of the step [m/s^2]
};

/// What is known of a cell once and for all: that the wall's ghosts can be seen from it, and that no place in it
/// is within the impact band of the wall or beyond it, however small the sac.
enum CellProperty : Index { near_wall = 1, deep_inside = 2 };

/// All arrays in device memory. `id`: by a particle's identity, through the whole run; `sorted`: blood by the
/// order of cells, then the reserve.
template <class Real>
struct Fields {
    Constants<Real> c;
    Scene* scene = nullptr;
    const StepInput* inputs = nullptr; ///< [flow steps]
    Index step = 0;                    ///< flow step in the frame

    // by id, [particles]
    Row<Real>* position = nullptr; ///< w: not used [m]
    Row<Real>* velocity = nullptr; ///< w: not used [m/s]
    Real* pressure = nullptr;      ///< [Pa]
    Real* kappa = nullptr;         ///< potential of the density's correction [Pa]
    Real* drift = nullptr;         ///< what the last straight ways added to the density [kg/m^3]
    Kind* kind = nullptr;
    Real* density = nullptr;         ///< [kg/m^3]
    Real* solved_pressure = nullptr; ///< [flow steps * particles] [Pa]
    Real* solved_kappa = nullptr;    ///< the same [Pa]
    Index* event = nullptr;          ///< what the controller did, a bit for each Event

    // bodies: particles, sorted; the null body; the wall's ghosts, by cell
    Row<Real>* body_position = nullptr; ///< w: mass [m, kg]
    Row<Real>* body_velocity = nullptr; ///< w: density of blood; of a wall's ghost that of (27)
    Real* body_x = nullptr; ///< the same places again, for the search; massless walls are far away
    Real* body_y = nullptr;
    Real* body_z = nullptr;

    // sorted, [particles + 1]
    Index* key = nullptr;
    Index* sorted_key = nullptr;
    Index* order = nullptr;               ///< id
    Index* start = nullptr;               ///< [cells + 2] first body of each key
    Index* is_driven = nullptr;           ///< 1: moves with (25)
    Real* body_drift = nullptr;           ///< `drift`
    const Index* wall_start = nullptr;    ///< [cells + 1]
    const Index* cell_property = nullptr; ///< [cells] a sum of CellProperty
    const Row<Real>* wall_position =
        nullptr; ///< [walls] by cell; w: mass where the sac doesn't reach, else -1
    Lists blood{};
    Lists walls{};
    Real* gradient = nullptr; ///< m_j grad W_ij of blood, [24 * blocks]; null: computed when needed
    Row<Real>* blood_gradient = nullptr;  ///< sum of m_j grad W_ij over blood; w: sum of their squares
    Row<Real>* wall_gradient = nullptr;   ///< the same over the wall's ghosts; w: squares of free blood alone
    Row<Real>* driven_gradient = nullptr; ///< the same over driven blood; w: sum of m_j grad W_ij . v_j
    Row<Real>* force = nullptr;           ///< (7) [N/m^3]
    Row<Real>* acceleration = nullptr;    ///< of the blood's own pressure [m/s^2]
    Row<Real>* solved_velocity = nullptr; ///< at the end of the step [m/s]
    Row<Real>* shift = nullptr;           ///< to where its neighbors lie evenly around a particle [m]
    Row<Real>* correction = nullptr;      ///< what the density's correction moves by in dt [m/s]

    // of a solve of (3), sorted, [particles + 1]
    Real* p = nullptr;            ///< where (3) is evaluated [Pa]
    Real* p_old = nullptr;        ///< before the momentum [Pa]
    Real* lowest = nullptr;       ///< that p may be [Pa]
    Real* alpha = nullptr;        ///< DFSPH factor
    Real* source = nullptr;       ///< the part of (3) that the velocity doesn't change [kg/(m^3 s)]
    Real* response = nullptr;     ///< pressure that an iteration answers a residual with [m^2/s]
    Real* rate = nullptr;         ///< Drho/Dt [kg/(m^3 s)]
    Row<Real>* mirrors = nullptr; ///< what given bodies add to the gradient at i, beyond their place in the
                                  ///< lists; w: sum of the same times v_j
    Index* is_given = nullptr;    ///< 1: no unknown of this solve
    Index* slice = nullptr;       ///< that holds the particle
    Real* member = nullptr;       ///< 1: its potential takes part in the start in slices; 0
    Row<Real>* slice_response =
        nullptr; ///< dt rho_0^2 times |b_own|^2, b_own . b_other, |b_other|^2; residual of a
                 ///< member; shares its memory with correction
    SliceSums* slice_sums = nullptr; ///< [slices]
    SliceRow* slice_row = nullptr;   ///< [slices]
    Real* impact = nullptr;          ///< [N]; -1: doesn't touch the sac
    Real* impact_eos = nullptr;

    // the controller's
    const Row<Real>* pattern = nullptr; ///< the three buffers as sampled
    Index pattern_begin[4] = {0, 0, 0, 0};
    Index* in_reserve = nullptr;   ///< [particles] 1: yes; shares its memory with key
    Index* reserve_rank = nullptr; ///< [particles + 1]
    Index* reserve = nullptr;      ///< [particles] ids
    Index* to_fill = nullptr;      ///< [places of the pattern] 1: yes
    Index* fill_rank = nullptr;    ///< [places of the pattern + 1]

    ANEURYSM_HD bool is_whole() const { return scene->aneurysm.phase != Phase::ruptured; }
    /// g of (1) in this step: what the pressure of blood at rest doesn't balance [m/s^2]
    ANEURYSM_HD Vec3T<Real> gravity() const
    {
        const Vec3& g = inputs[step].gravity;
        return c.balances_gravity && is_whole()
                   ? Vec3T<Real>{}
                   : Vec3T<Real>{static_cast<Real>(g.x), static_cast<Real>(g.y), static_cast<Real>(g.z)};
    }
    /// Of the pressure, see reference::Flow::level [Pa]
    ANEURYSM_HD double level() const { return is_whole() ? inputs[step].level : c.p_const; }
    ANEURYSM_HD Index places() const { return pattern_begin[3]; }
    ANEURYSM_HD bool has(const Vec3T<Real>& x, CellProperty property) const
    {
        return (cell_property[c.grid.cell(x)] & property) != 0;
    }
    /// Sorted bodies that are blood; behind them the reserve.
    ANEURYSM_HD Index blood_count() const { return start[c.grid.cells()]; }
};

} // namespace aneurysm::device
