// SPDX-License-Identifier: Apache-2.0
// Section 3.2: when the wall ruptures, (8)-(14).
#include "analytic/rupture.hpp"
#include "verification/checks/checks.hpp"

namespace aneurysm::verification
{
namespace
{

void eq08_balance(Probe& probe)
{
    Quantity& stress = probe.quantity("stress [Pa]", Source::rounding,
                                      "gamma_4 |Sigma|: two products and a quotient here, as many there");
    for (const double R : {0.1, 0.4, 1.7}) {
        const double expected = 1000 * R / (2 * 0.01); // a stand-in: the check proper moves here from tests/
        stress.within(probe.equations().wall_stress(1000, R, 0.01), expected, rounding(4) * expected);
    }
}

} // namespace

std::vector<Check> rupture_checks()
{
    return {
        {.id = "eq08_balance",
         .level = Level::scalar,
         .equations = {"8"},
         .title = "the wall's stress balances the pressure on half a sphere",
         .oracles = {"closed form"},
         .scope = Scope::equations,
         .run = eq08_balance},
    };
}

} // namespace aneurysm::verification
