// SPDX-License-Identifier: Apache-2.0
// What is misprinted, missing or inconsistent in the paper, and how it is read here.
#include "common/equations.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/suite/words.hpp"

namespace aneurysm::reproduction
{
namespace
{

/// What the table of equations has no place for.
std::vector<std::vector<std::string>> other_errata()
{
    return {
        {"Table 1", "A_E and A_C are areas [m^2], with which K A epsilon of (19) is no force but N m",
         "the numbers are kept; they are right as lengths, see the check `units`"},
        {"Table 1", "alpha has no unit; (23) needs 1/m", "1.1 per meter"},
        {"Table 1", "tissue areas of 10 to 20 m^2 don't belong to an artery of millimeters",
         "the constants are kept in SI numbers, which makes the length unit a free value: artery radii of "
         "0.3 to 0.5 m fit them"},
        {"(16), section 3.2", "the force F_b is compared with the pressure P_c",
         "a conversion area of 1 m^2, named in the scenario"},
        {"(16)", "the force on one particle depends on the particle's size",
         "Y is calibrated for 5,520 particles; the study below Table 4 has the dependence"},
        {"(21), section 3.4",
         "R grows by a step from rest in each frame, so that the growth over a time has no "
         "limit as the time step goes to 0; the paper gives no limit of the time step",
         "0.001 s is a parameter of the model"},
        {"Table 2", "R is the artery's radius, elsewhere the aneurysm's", "named apart"},
        {"Fig. 7, Table 4",
         "the hemispherical sac is fully developed from about frame 1600 in Fig. 7, but section "
         "4.4 has sigma 0.4 rupture in frame 2299 before full development",
         "both can't hold for one set of values; full development is left to come out of the run"},
        {"Table 4", "single frames, where runs scatter by a quarter to a half with the smallest change",
         "means over seeds with their spread"},
        {"section 4.4", "no values for Y, the first and the largest R, v_0, mu, p_const, g, the wall's mass",
         "each is marked `assumed` in the scenario with its reason; Table 1's section lists them"},
    };
}

} // namespace

Section errata(Reproduction&)
{
    ResultTable by_equation{
        "Equations", {"equation", "title", "read", "what is printed, and what is done here"}, {}};
    for (const Equation& e : equations) {
        if (!e.deviation.empty()) {
            by_equation.rows.push_back({"(" + std::string(e.id) + ")", std::string(e.title),
                                        std::string(suite::name_of(e.status)), std::string(e.deviation)});
        }
    }
    ResultTable others{"Tables, figures and text", {"where", "what", "read as"}, other_errata()};
    Section section{"errata", "Errata of the paper, and how they are read"};
    section.tables = {by_equation, others};
    return section;
}

} // namespace aneurysm::reproduction
