// SPDX-License-Identifier: Apache-2.0
#include "verification/checks/checks.hpp"

#include <iterator>

namespace aneurysm::verification
{

const std::vector<Check>& all_checks()
{
    static const std::vector<Check> checks = [] {
        std::vector<Check> all;
        for (const auto& of_subject :
             {oracle_flow_checks, oracle_duct_checks, oracle_row_checks, rupture_checks, operator_checks,
              momentum_checks, pressure_solve_checks, box_flow_checks, duct_checks, hydrostatics_checks,
              wall_history_checks, metamorphic_checks, executor_checks}) {
            std::vector<Check> more = of_subject();
            all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
        }
        return all;
    }();
    return checks;
}

} // namespace aneurysm::verification
