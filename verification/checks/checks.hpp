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
/// Row for the same run in other words (L4).
Check same_run_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run,
                     Scope scope = Scope::flows);
/// Where the numbers of all known limits are from.
inline constexpr const char* gate_record = "measured in single precision when this gate was set";
/// A known limit of the model, as it was measured when its gate was set; none without a number.
inline std::optional<KnownLimit> measured(std::optional<double> value)
{
    return value ? std::optional<KnownLimit>({*value, gate_record}) : std::nullopt;
}

/// Row for the model against nature (L6).
/// \param quick  takes a few seconds at most
Check nature_check(std::string_view id, std::string_view title, Names oracles, Run run, bool quick = false);
/// Row for oracles among themselves, which need no backend.
Check oracle_check(std::string_view id, Level level, Names equations, std::string_view title, Names oracles,
                   Run run, bool quick = true);

// X_checks() is in the file X.cpp of the level's folder, oracle_X_checks() in oracles/X.cpp, nature_X_checks() in
// nature/X.cpp.

// formulas, L0
std::vector<Check> kernel_function_checks();       // (4), (6), (7)
std::vector<Check> blood_flow_checks();            // (1), (4), (15), EOS
std::vector<Check> rupture_wall_law_checks();      // (8)-(13)
std::vector<Check> rupture_checks();               // (13), (14), (16)
std::vector<Check> growth_checks();                // (17)-(21)
std::vector<Check> growth_thinning_checks();       // (22), (23)
std::vector<Check> bifurcation_checks();           // (24)
std::vector<Check> bifurcation_shape_checks();     // (24), Table 2
std::vector<Check> boundary_inlet_checks();        // (25)
std::vector<Check> boundary_outlet_checks();       // (26), (27)
std::vector<Check> boundary_elastic_wall_checks(); // (28)
std::vector<Check> boundary_collision_checks();    // Fig. 1

// sums, L1
std::vector<Check> blood_flow_sums_checks();       // (1), (4)-(7), (15), EOS
std::vector<Check> blood_flow_mass_checks();       // (2)
std::vector<Check> blood_flow_momentum_checks();   // (3), (7)
std::vector<Check> incompressible_waves_checks();  // (3)
std::vector<Check> incompressible_bodies_checks(); // (3)
std::vector<Check> incompressible_rows_checks();   // (3)
std::vector<Check> neighbors_checks();             // (5), (7)
std::vector<Check> boundary_buffers_checks();      // (25), (26)
std::vector<Check> slices_checks();                // (3)
std::vector<Check> boundary_ghosts_checks();       // (27)

// flows, L2
std::vector<Check> blood_flow_steps_checks();  // (1), (7), (15), EOS
std::vector<Check> growth_history_checks();    // (13), (17)-(23), (28)
std::vector<Check> impact_checks();            // (14)-(16)
std::vector<Check> controller_checks();        // section 3.4
std::vector<Check> controller_ledger_checks(); // section 3.4, (25)
std::vector<Check> boundary_duct_checks();     // (25), (26)
std::vector<Check> laminar_ducts_checks();     // (27)
std::vector<Check> containment_checks();       // Fig. 1
std::vector<Check> taylor_green_checks();      // (7)

// same_run, L4 and L5
std::vector<Check> metamorphic_checks();
std::vector<Check> same_run_checks();
std::vector<Check> executors_checks();

// nature, L6
std::vector<Check> nature_artery_checks();
std::vector<Check> nature_ends_checks();
std::vector<Check> nature_vortices_checks();
std::vector<Check> nature_walls_checks();

// oracles, L0 to L3
std::vector<Check> oracle_lattice_checks(); // (3)-(7)
std::vector<Check> oracle_pairs_checks();   // (2), (3), (5)-(7)
std::vector<Check> oracle_rows_checks();    // (2), (3), (5), (7)
std::vector<Check> oracle_flows_checks();   // (1), (27)
std::vector<Check> oracle_ducts_checks();   // (7), (15), (27)

} // namespace aneurysm::checks
