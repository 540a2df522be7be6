// SPDX-License-Identifier: Apache-2.0
// The checks by level and subject, and how they are registered.
#pragma once

#include "verification/suite/check.hpp"

namespace aneurysm::checks
{

using namespace suite; // a check is written in the suite's words

/// All checks, by level and then in the order of the paper.
const std::vector<Check>& all_checks();

using Names = std::vector<std::string_view>;
using Run = void (*)(Probe&);

/// Row of the suite for an equation at one particle, wall or time (L0), as each backend computes it.
Check formula_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run);
/// Row for sums over particles, seen through one frame (L1).
Check sum_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run);
/// Row for a flow whose discrete answer is known (L2).
Check flow_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run);
/// Row for a flow that tends to a continuous solution (L3); too long for --quick.
Check limit_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run);
/// Row for the same run in other words (L4).
Check same_run_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run,
                     Scope scope = Scope::flows);
/// Row for oracles among themselves, which need no backend.
Check oracle_check(std::string_view id, Level level, Names equations, std::string_view title, Names oracles,
                   Run run, bool quick = true);

// The oracles among themselves
std::vector<Check> oracle_flow_checks();
std::vector<Check> oracle_duct_checks();
std::vector<Check> oracle_lattice_checks();
std::vector<Check> oracle_pair_checks();
std::vector<Check> oracle_row_checks();

// L0
std::vector<Check> bifurcation_checks();
std::vector<Check> collision_checks();
std::vector<Check> elastic_wall_checks();
std::vector<Check> fluid_checks();
std::vector<Check> growth_checks();
std::vector<Check> inlet_checks();
std::vector<Check> kernel_function_checks();
std::vector<Check> outlet_checks();
std::vector<Check> rupture_checks();
std::vector<Check> thinning_checks();
std::vector<Check> vessel_shape_checks();
std::vector<Check> wall_law_checks();
// L1
std::vector<Check> blood_flow_mass_checks();
std::vector<Check> operator_checks();
std::vector<Check> momentum_checks();
std::vector<Check> neighborhood_checks();
std::vector<Check> wall_cloud_checks();
std::vector<Check> pressure_solve_checks();
// L2
std::vector<Check> box_flow_checks();
std::vector<Check> containment_checks();
std::vector<Check> duct_checks();
std::vector<Check> duct_flow_checks();
std::vector<Check> hydrostatics_checks();
std::vector<Check> open_end_checks();
std::vector<Check> wall_history_checks();
// L3
std::vector<Check> laminar_flow_checks();
std::vector<Check> pipe_checks();
std::vector<Check> taylor_green_checks();
// L4
std::vector<Check> metamorphic_checks();
std::vector<Check> same_run_checks();
// L5
std::vector<Check> executor_checks();

} // namespace aneurysm::checks
