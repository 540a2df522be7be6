// SPDX-License-Identifier: Apache-2.0
// The checks by level and subject; each function is in the file of its name.
#pragma once

#include "verification/suite/check.hpp"

namespace aneurysm::checks
{

using namespace suite; // a check is written in the suite's words

/// All checks, by level and then in the order of the paper.
const std::vector<Check>& all_checks();

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
