// SPDX-License-Identifier: Apache-2.0
// The named numbers of a frame and of a state: the columns of frames.csv, the attributes of checkpoints, and
// what is hashed. The sizes make sure that no new member is forgotten.
#pragma once

#include "common/frame.hpp"

#include <array>
#include <string_view>

namespace aneurysm::output
{

/// As the files spell them.
inline constexpr std::array<std::string_view, 4> phase_names{"warm-up", "growing", "fully developed",
                                                             "ruptured"};
inline std::string_view name_of(Phase phase)
{
    return phase_names.at(static_cast<std::size_t>(phase));
}

static_assert(sizeof(Ledger) == 7 * sizeof(double));
template <class L, class Visitor>
void visit_ledger(L& ledger, Visitor&& v)
{
    v("inlet_in", ledger.inlet_in);
    v("inlet_out", ledger.inlet_out);
    v("outlet_out", ledger.outlet_out);
    v("outlet_in", ledger.outlet_in);
    v("escaped", ledger.escaped);
    v("recycled", ledger.recycled);
    v("missed", ledger.missed);
}

static_assert(sizeof(AneurysmState) == 6 * sizeof(double));
template <class A, class Visitor>
void visit_aneurysm(A& aneurysm, Visitor&& v)
{
    v("phase", aneurysm.phase);
    v("radius_m", aneurysm.radius);
    v("thickness_m", aneurysm.thickness);
    v("displacement_m", aneurysm.displacement);
    v("wall_velocity_m_s", aneurysm.wall_velocity);
    v("rupture_frame", aneurysm.rupture_frame);
}

static_assert(sizeof(FrameRecord) == 31 * sizeof(double) + sizeof(Ledger));
template <class Record, class Visitor>
void visit_record(Record& r, Visitor&& v)
{
    v("frame", r.frame);
    v("time_s", r.time);
    v("phase", r.phase);
    v("inlet_velocity_m_s", r.inlet_velocity);
    v("outlet_velocity_m_s", r.outlet_velocity);
    v("impact_force_n", r.impact_force);
    v("impact_force_eos_n", r.impact_force_eos);
    v("wall_load_n", r.wall_load);
    v("impact_count", r.impact_count);
    v("impact_particle", r.impact_particle);
    v("radius_m", r.radius);
    v("thickness_m", r.thickness);
    v("critical_pressure_pa", r.critical_pressure);
    v("displacement_m", r.displacement);
    v("iterations", r.iterations);
    v("corrections", r.corrections);
    v("density_error_mean", r.density_error_mean);
    v("density_error_max", r.density_error_max);
    v("density_error_min", r.density_error_min);
    v("density_error_max_ends", r.density_error_max_ends);
    v("divergence_mean_per_s", r.divergence_mean);
    v("divergence_max_per_s", r.divergence_max);
    v("residual_mean_per_s", r.residual_mean);
    v("residual_max_per_s", r.residual_max);
    v("kinetic_energy_j", r.kinetic_energy);
    v("speed_max_m_s", r.speed_max);
    v("fluid", r.fluid);
    v("active", r.active);
    v("total", r.total);
    v("outside", r.outside);
    v("collisions", r.collisions);
    visit_ledger(r.ledger, v);
}

} // namespace aneurysm::output
