// SPDX-License-Identifier: Apache-2.0
// What is misprinted, missing or inconsistent in the paper, and how it is read here.
#include "common/equations.hpp"
#include "common/wall.hpp"
#include "reference/blood_flow.hpp"
#include "reference/growth.hpp"
#include "reference/rupture.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/reproduction/variants.hpp"
#include "verification/suite/words.hpp"

#include <array>

namespace aneurysm::reproduction
{
namespace
{

/// F_b (16) of one particle of mass m on which a force per volume acts [N].
double impact_of(double m, double rho, const Vec3& force)
{
    constexpr std::array<std::int64_t, 1> S{0};
    return reference::impact_force(S, m, std::array{rho}, std::array{force}).force;
}

/// (16): no load at rest, and no limit as the particles get smaller.
void add_impact(ResultTable& table, const Scenario& s)
{
    const double rho = s.fluid.density_kg_m3;
    const Vec3 g = s.fluid.gravity_m_s2;
    const Vec3 at_rest = reference::momentum_force(rho, g, {}, -rho * g); // F^pressure = -grad p = -rho g
    table.add("(16)", "F_b of blood at rest, grad p = rho g, at any pressure", impact_of(1, rho, at_rest),
              "N");
    const Vec3 force{rho, 0, 0}; // the same acceleration at any size
    const double half = impact_of(1.0 / 8, rho, force) / impact_of(1, rho, force);
    table.add("(16)", "F_b of particles of half the spacing, m / 8, at the same acceleration", half,
              "of F_b");
    table.add("(16)", "the same divided by a particle's face, spacing^2", half * 4, "of F_b / spacing^2");
}

/// (10) and (13) with numbers of an aneurysm of the brain.
void add_strength(ResultTable& table, const Scenario& s)
{
    const double sigma = s.rupture.poisson_ratio;
    const double phi = s.rupture.porosity;
    constexpr double R = 1.6e-3;
    constexpr double h = 5e-5;
    constexpr double Y = 1e6;
    constexpr double artery = 120 * 133.322; // 120 mmHg
    const double P_c = reference::critical_pressure(h, R, Y, sigma, phi);
    table.add("(10)", "dR/R with which (10) takes all of phi = " + number(phi),
              -phi / reference::porosity_differential(sigma, 1, 1), "1");
    table.add("(13)", "P_c with h = 50 um, R = 1.6 mm, Y = 1 MPa and Table 1", P_c, "Pa");
    table.add("(13)", "the same against a blood pressure of 120 mmHg", P_c / artery, "1");
    table.add("(13)", "Y with which P_c would be 120 mmHg there", Y * artery / P_c, "Pa");
    table.add("(13)", "Y that meets Table 4 here, calibrated", s.rupture.yield_limit_pa, "Pa");
}

/// What (21) and (28) make of the same wall under the same force.
void add_wall(ResultTable& table, const Scenario& s)
{
    constexpr double F_b = 400; // [N]
    const double R = s.aneurysm.base_width_radii / 2 * s.vessel.radius_m;
    const WallTissue tissue = wall_tissue(s);
    const double dR = reference::radius_increment(tissue, F_b, R, s.time.frame_s);
    const std::string at = " at R = " + number(R) + " m";
    table.add("(21)", "stiffness of the wall, (K_E A_E + K_C A_C) / R" + at,
              reference::fiber_force(tissue, reference::strain(1, R)), "N/m");
    table.add("(28)", "stiffness of the same wall, k", s.elastic_wall.stiffness_n_m, "N/m");
    table.add("(21)", "growth in 1 s under F_b = 400 N" + at, dR / s.time.frame_s, "m");
    table.add("(28)", "displacement at rest under F_b = 400 N, F_b / k", F_b / s.elastic_wall.stiffness_n_m,
              "m");
}

/// Poisson's ratio above 1/2, as Table 4 has it. The bulk modulus is E / (3 (1 - 2 nu)). A sheet that is
/// stretched alike in two directions has dh/h = -2 nu / (1 - nu) dR/R: (9) with sigma = 2 nu / (1 - nu).
void add_poisson(ResultTable& table)
{
    constexpr double sigma = 0.6;
    table.add("(9)", "bulk modulus over Young's, were sigma = 0.6 Poisson's ratio", 1 / (3 * (1 - 2 * sigma)),
              "1");
    table.add("(9)", "Poisson's ratio of a sheet that thins by (9) with sigma = 0.6", sigma / (2 + sigma),
              "1");
    table.add("(10)", "dV/V over dR/R with sigma = 2, Poisson's ratio 1/2",
              -reference::porosity_differential(2, 1, 1), "1");
}

ResultTable arithmetic()
{
    const Scenario scenario = calibrated_scenario();
    ResultTable table{"The arithmetic, with the functions of the reference",
                      {"where", "what", "value", "unit"}};
    add_impact(table, scenario);
    add_strength(table, scenario);
    add_poisson(table);
    add_wall(table, scenario);
    return table;
}

} // namespace

Section errata(Reproduction& reproduction)
{
    ResultTable by_equation{
        "Equations", {"equation", "title", "in runs", "read", "what is printed, and what is done here"}};
    for (const Equation& e : equations) {
        if (!e.deviation.empty()) {
            by_equation.add("(" + std::string(e.id) + ")", std::string(e.title),
                            std::string(suite::name_of(e.use)), std::string(suite::name_of(e.status)),
                            std::string(e.deviation));
        }
    }
    ResultTable others{"Tables, figures and text", {"where", "what", "read as"}};
    for (const auto& row : reproduction.paper.at("errata")) { // what the table of equations has no place for
        others.add(row.at("where").get<std::string>(), row.at("what").get<std::string>(),
                   row.at("read_as").get<std::string>());
    }
    Section section{"errata", "Errata of the paper, and how they are read"};
    section.tables = {by_equation, others, arithmetic()};
    return section;
}

} // namespace aneurysm::reproduction
