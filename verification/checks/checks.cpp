// SPDX-License-Identifier: Apache-2.0
#include "verification/checks/checks.hpp"
#include "common/equations.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace aneurysm::checks
{
namespace
{

/// Place of a check's first equation in the paper; behind all others if it has none.
std::ptrdiff_t place_in_paper(const Check& check)
{
    return std::ranges::find_if(equations,
                                [&](const Equation& equation) {
                                    return !check.equations.empty() && equation.id == check.equations.front();
                                }) -
           equations.begin();
}

} // namespace

Check formula_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run)
{
    return {id, Level::scalar, std::move(equations), title, std::move(oracles), Scope::equations, true, run};
}

Check sum_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run)
{
    return {id, Level::lattice, std::move(equations), title, std::move(oracles), Scope::flows, true, run};
}

Check flow_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run)
{
    return {id, Level::transient, std::move(equations), title, std::move(oracles), Scope::flows, true, run};
}

Check same_run_check(std::string_view id, Names equations, std::string_view title, Names oracles, Run run,
                     Scope scope)
{
    return {id, Level::metamorphic, std::move(equations), title, std::move(oracles), scope, true, run};
}

Check nature_check(std::string_view id, std::string_view title, Names oracles, Run run, bool quick)
{
    return {id, Level::nature, {}, title, std::move(oracles), Scope::model, quick, run};
}

Check oracle_check(std::string_view id, Level level, Names equations, std::string_view title, Names oracles,
                   Run run, bool quick)
{
    return {id, level, std::move(equations), title, std::move(oracles), Scope::once, quick, run};
}

const std::vector<Check>& all_checks()
{
    static const std::vector<Check> checks = [] {
        std::vector<Check> all;
        for (const auto& of_subject : {
                 kernel_function_checks,
                 blood_flow_checks,
                 rupture_wall_law_checks,
                 rupture_checks,
                 growth_checks,
                 growth_thinning_checks,
                 bifurcation_checks,
                 boundary_inlet_checks,
                 boundary_outlet_checks,
                 boundary_elastic_wall_checks,
                 boundary_collision_checks,
                 oracle_flows_checks,
                 oracle_ducts_checks,
                 laminar_ducts_checks,
                 oracle_rows_checks,
                 oracle_lattice_checks,
                 blood_flow_sums_checks,
                 blood_flow_momentum_checks,
                 incompressible_waves_checks,
                 incompressible_bodies_checks,
                 incompressible_rows_checks,
                 blood_flow_steps_checks,
                 boundary_duct_checks,
                 growth_history_checks,
                 controller_ledger_checks,
                 impact_checks,
                 taylor_green_checks,
                 containment_checks,
                 metamorphic_checks,
                 executors_checks,
                 neighbors_checks,
                 boundary_buffers_checks,
                 slices_checks,
                 boundary_ghosts_checks,
                 same_run_checks,
                 bifurcation_shape_checks,
                 controller_checks,
                 oracle_pairs_checks,
                 nature_artery_checks,
                 nature_ends_checks,
                 nature_vortices_checks,
                 nature_walls_checks,
                 blood_flow_mass_checks,
             }) {
            std::vector<Check> more = of_subject();
            all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
        }
        std::ranges::stable_sort(all, [](const Check& a, const Check& b) {
            return a.level != b.level ? a.level < b.level : place_in_paper(a) < place_in_paper(b);
        });
        return all;
    }();
    return checks;
}

} // namespace aneurysm::checks
