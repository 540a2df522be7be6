// SPDX-License-Identifier: Apache-2.0
// Section 3.2: how a wall's stress, thickness, porosity and radius belong to its pressure, (8)-(13).
#include "analytic/relations.hpp"
#include "analytic/rupture.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"

#include <cmath>

namespace aneurysm::checks
{
namespace
{

using analytic::Estimate;
using analytic::Wall;
using analytic::WallState;

/// Every pair of sigma and phi of Table 4, from rest and from a start pressure of 0.4 times the largest.
template <class Look>
void for_all_walls(Look look)
{
    for (const double sigma : {0.2, 0.3, 0.4, 0.5, 0.6}) {
        for (const double phi : {3e-3, 4e-3, 5e-3, 6e-3}) {
            for (const double start : {0.0, 0.4}) {
                Wall wall{41.25, sigma, phi, 0.11, 0.0075, 0};
                wall.P_0 = start * analytic::largest_pressure(wall);
                look(wall, at({{"sigma", sigma}, {"phi", phi}, {"P_0", wall.P_0}}));
            }
        }
    }
}

/// States that no law ties together, below and above the critical pressure.
template <class Look>
void for_any_states(std::uint64_t seed, Look look)
{
    Arguments a(seed);
    for (int n = 0; n < 200; ++n) {
        WallState s{0,
                    a.between(0.05, 0.7),
                    a.between(0.001, 0.02),
                    a.between(10, 90),
                    a.between(0.05, 0.9),
                    a.between(1e-3, 0.9)};
        // where radius and thickness take as much stress as porosity gives
        const double balance = s.Y * (2 - s.sigma) / s.phi * s.h / s.R / (1 + s.sigma);
        s.P = balance * a.between(0.05, 3);
        look(s, at({{"P", s.P}, {"R", s.R}, {"h", s.h}, {"Y", s.Y}, {"sigma", s.sigma}, {"phi", s.phi}}));
    }
}

void eq08_balance(Probe& probe)
{
    Quantity& balance = probe.quantity("P pi R^2 = Sigma 2 pi R h, 50 digits [1]", Source::rounding,
                                       "gamma_2: a product and a quotient; the factor 2 is exact");
    Quantity& half_sphere =
        probe.quantity("stress against the pressure on a half sphere [Pa]", Source::quadrature,
                       "GSL's estimate and 16 u of the value; gamma_2 of the stress");
    Quantity& oracles = probe.quantity("stress of the half sphere in the balance [1]", Source::quadrature,
                                       "GSL's estimate and 16 u, over the value");
    for_any_states(8, [&](const WallState& s, const std::string& where) {
        const double Sigma = probe.equations().wall_stress(s.P, s.R, s.h);
        const Estimate expected = analytic::cut_sphere_stress(s.P, s.R, s.h);
        balance.within(analytic::laplace_imbalance(s.P, s.R, s.h, Sigma), 0, rounding(2), where);
        half_sphere.within(Sigma, expected, rounding(2), where);
        oracles.within(analytic::laplace_imbalance(s.P, s.R, s.h, expected.value), 0,
                       expected.error / expected.value, where);
    });
}

void eq09_thinning(Probe& probe)
{
    Quantity& relation = probe.quantity("dh/h = -sigma dR/R, 50 digits [1]", Source::rounding,
                                        "gamma_3: two products and a quotient");
    Quantity& power_law = probe.quantity("dh against the slope of the power law [m]", Source::rounding,
                                         "gamma_28 |dh|: 3, 16 of the slope, 8 of the thickness, 1 times dR");
    Quantity& oracles = probe.quantity("slope of the power law in the relation [1]", Source::rounding,
                                       "gamma_25: 16 of the slope, 8 of the thickness, 1 times dR");
    Arguments a(9);
    for_any_states(9, [&](const WallState& s, const std::string& where) {
        const double dR = a.between(-0.2, 0.3) * s.R;
        const double dh = probe.equations().thickness_differential(s.sigma, s.h, s.R, dR);
        relation.within(analytic::thinning_imbalance(s.sigma, s.h, s.R, dR, dh), 0, rounding(3), where);
    });
    for_all_walls([&](const Wall& wall, const std::string& where) {
        const double R = 1.7 * wall.R_0;
        const double dR = 1.3e-4;
        const double h = analytic::thickness(wall, R);
        const double expected = analytic::thickness_slope(wall, R) * dR;
        power_law.within(probe.equations().thickness_differential(wall.sigma, h, R, dR), expected,
                         rounding(28) * std::abs(expected), where);
        oracles.within(analytic::thinning_imbalance(wall.sigma, h, R, dR, expected), 0, rounding(25), where);
    });
}

void eq10_porosity(Probe& probe)
{
    Quantity& relation = probe.quantity("dphi = -dV/V by a difference of V, 50 digits [1]", Source::rounding,
                                        "gamma_3: a difference, a product and a quotient");
    Quantity& logarithm =
        probe.quantity("dphi against the slope of ln V [1]", Source::rounding,
                       "gamma_17 (2 + sigma) dR/R of the oracle, 1 times dR; gamma_3 |dphi|");
    Quantity& oracles = probe.quantity("slope of ln V in the relation [1]", Source::rounding,
                                       "gamma_17 (2 + sigma)/(2 - sigma)");
    Arguments a(10);
    for_any_states(10, [&](const WallState& s, const std::string& where) {
        const double dR = a.between(-0.2, 0.3) * s.R;
        const double dphi = probe.equations().porosity_differential(s.sigma, s.R, dR);
        relation.within(analytic::porosity_imbalance(s.sigma, s.R, dR, dphi), 0, rounding(3), where);
    });
    for_all_walls([&](const Wall& wall, const std::string& where) {
        const double R = 1.7 * wall.R_0;
        const double dR = 1.3e-4;
        const double expected = analytic::porosity_slope(wall, R) * dR;
        const double of_oracle = rounding(17) * (2 + wall.sigma) * dR / R;
        logarithm.within(probe.equations().porosity_differential(wall.sigma, R, dR), expected,
                         of_oracle + rounding(3) * std::abs(expected), where);
        oracles.within(analytic::porosity_imbalance(wall.sigma, R, dR, expected), 0,
                       of_oracle / std::abs(expected), where);
    });
}

void eq11_stress(Probe& probe)
{
    Quantity& relation = probe.quantity("phi = exp(-3 Sigma/(2 Y)), 50 digits [1]", Source::rounding,
                                        "gamma_5 |ln phi|: two products and the factor 2/3, 2 of the "
                                        "logarithm, whose last place may be off by one");
    Quantity& integral = probe.quantity("stress against 2/3 Y int dx/x [Pa]", Source::quadrature,
                                        "GSL's estimate and 16 u of the value; gamma_5 of the stress");
    Quantity& oracles = probe.quantity("2/3 Y int dx/x in the relation [1]", Source::quadrature,
                                       "GSL's estimate and 16 u, over the value, times |ln phi|");
    for_any_states(11, [&](const WallState& s, const std::string& where) {
        const double Sigma = probe.equations().stress_of_porosity(s.Y, s.phi);
        const Estimate expected = analytic::porous_stress(s.Y, s.phi);
        const double share = std::abs(std::log(s.phi));
        relation.within(analytic::porous_stress_imbalance(s.Y, s.phi, Sigma), 0, rounding(5) * share, where);
        integral.within(Sigma, expected, rounding(5), where);
        oracles.within(analytic::porous_stress_imbalance(s.Y, s.phi, expected.value), 0,
                       expected.error / expected.value * share, where);
    });
}

void eq12_slope(Probe& probe)
{
    Quantity& relation = probe.quantity("(8) to (11) together, 50 digits [1]", Source::rounding,
                                        "2 gamma_8: 3 roundings around the difference, at most 5 in each of "
                                        "its terms, which are at most twice the balance's half sum");
    Quantity& closed_form = probe.quantity("dR/dP against the slope of P(R) [m/Pa]", Source::rounding,
                                           "gamma_120 of the terms that cancel: 64 of the slope, 32 of P, 8 "
                                           "of h, 16 of dR/dP and of the reciprocal");
    Quantity& oracles = probe.quantity("slope of P(R) in (8) to (11) [1]", Source::rounding,
                                       "2 gamma_105: 64 of the slope, 32 of P, 8 of h, 1 of the reciprocal, "
                                       "on terms that are at most twice the balance's half sum");
    for_any_states(12, [&](const WallState& s, const std::string& where) {
        const double slope = probe.equations().radius_per_pressure(s.P, s.R, s.h, s.Y, s.sigma, s.phi);
        relation.within(analytic::wall_law_imbalance(s, slope, 1), 0, 2 * rounding(8), where);
    });
    for_all_walls([&](const Wall& wall, const std::string& where) {
        for (const double ratio : {1.1, 1.5, 3.0}) { // stable, and beyond the critical radius
            const double R = ratio * wall.R_0;
            const double h = analytic::thickness(wall, R);
            const double P = analytic::pressure(wall, R);
            const double expected = 1 / analytic::pressure_slope(wall, R);
            const double strength = wall.modulus() / R;
            const double load = P * (1 + wall.sigma) / (2 * h);
            const double allowed = rounding(120) * (strength + load) / std::abs(strength - load);
            const std::string there = where + ", " + at({{"R/R_0", ratio}});
            closed_form.within(probe.equations().radius_per_pressure(P, R, h, wall.Y, wall.sigma, wall.phi),
                               expected, allowed * std::abs(expected), there);
            const WallState state{P, R, h, wall.Y, wall.sigma, wall.phi};
            oracles.within(analytic::wall_law_imbalance(state, expected, 1), 0, 2 * rounding(105), there);
        }
    });
}

void eq12_integral(Probe& probe)
{
    Quantity& through = probe.quantity(
        "P from integrating dP/dR through the critical radius [Pa]", Source::solver,
        "2e-15 of the largest P for each step of GSL's solver, since neighboring solutions don't diverge; 5 "
        "gamma_32 |P| of the closed form, whose terms add up to 5 |P| at most");
    for_all_walls([&](const Wall& wall, const std::string& where) {
        const double R = 1.3 * analytic::critical_radius(wall);
        const auto slope = [&](double r, double P) {
            return 1 / probe.equations().radius_per_pressure(P, r, analytic::thickness(wall, r), wall.Y,
                                                             wall.sigma, wall.phi);
        };
        through.within(analytic::pressure(wall, R), analytic::integrate_ode(slope, wall.R_0, wall.P_0, R),
                       5 * rounding(32), where);
    });
}

void eq12_oracles(Probe& probe)
{
    const std::string of_closed_form =
        "5 gamma_32 |P| of the closed form, whose terms add up to 5 |P| at most";
    Quantity& forward =
        probe.quantity("P(R) against GSL's integral of dP/dR [Pa]", Source::solver,
                       "2e-15 of the largest P for each of the solver's steps; " + of_closed_form);
    Quantity& backward = probe.quantity(
        "P of the radius by GSL's integral of dR/dP, to 0.99 P_c [Pa]", Source::solver,
        "2e-15 of the largest R for each of the solver's steps, times the largest dP/dR; " + of_closed_form);
    Quantity& lambert =
        probe.quantity("P of the radius by Lambert's W_0 and W_-1 [Pa]", Source::rounding,
                       "GSL's bound of W and 8 u of its argument, times dP/dR; " + of_closed_form);
    for_all_walls([&](const Wall& wall, const std::string& where) {
        const double far = 1.3 * analytic::critical_radius(wall);
        forward.within(analytic::pressure(wall, far), analytic::pressure_by_integration(wall, far),
                       5 * rounding(32), where);
        const double near = 0.99 * analytic::largest_pressure(wall);
        const Estimate R = analytic::radius_by_integration(wall, near); // its error is one of P
        backward.within(analytic::pressure(wall, R.value), near, R.error + 5 * rounding(32) * near, where);
        for (const bool stable : {true, false}) {
            if (wall.P_0 == 0) {
                const double P = 0.9 * analytic::largest_pressure(wall);
                const Estimate x = analytic::radius_by_lambert(wall, P, stable);
                const double slope = std::abs(analytic::pressure_slope(wall, x.value));
                lambert.within(analytic::pressure(wall, x.value), P, slope * x.error + 5 * rounding(32) * P,
                               where);
            }
        }
    });
}

void eq13_pole(Probe& probe)
{
    Quantity& relation = probe.quantity("(8) to (11) with dP = 0, 50 digits [1]", Source::rounding,
                                        "gamma_8: 8 roundings of P_c; the factor 4 is exact");
    Quantity& sign =
        probe.quantity("sign of (12) just below and above P_c", Source::rounding,
                       "1 +- gamma_16: 8 roundings of P_c, at most 5 and 3 of the terms in (12)");
    for_any_states(13, [&](WallState s, const std::string& where) {
        s.P = probe.equations().critical_pressure(s.h, s.R, s.Y, s.sigma, s.phi);
        relation.within(analytic::wall_law_imbalance(s, 1, 0), 0, rounding(8), where);
        const auto slope_at = [&](double P) {
            return probe.equations().radius_per_pressure(P, s.R, s.h, s.Y, s.sigma, s.phi);
        };
        sign.holds(slope_at(s.P * (1 - rounding(16))) > 0, where + ", below");
        sign.holds(slope_at(s.P * (1 + rounding(16))) < 0, where + ", above");
    });
}

void eq13_largest_pressure(Probe& probe)
{
    Quantity& closed_form =
        probe.quantity("P_c against the largest P(R) [Pa]", Source::rounding,
                       "gamma_80 P_c: 16 of R_c to a power below 2, 8 of h, 32 of the largest P, 8 of P_c");
    Quantity& search = probe.quantity("P_c against a search for the largest P(R) [Pa]", Source::solver,
                                      "the last bracket's width to the second order, 64 u of P; gamma_48: 16 "
                                      "of R_c to a power below 2, 8 of h, 8 of P_c");
    Quantity& oracles =
        probe.quantity("largest P(R) against the search [Pa]", Source::solver,
                       "the bracket's width to the second order, 64 u of P; gamma_32 of the closed form");
    for_all_walls([&](const Wall& wall, const std::string& where) {
        const double R = analytic::critical_radius(wall);
        const double h = analytic::thickness(wall, R);
        const double P_c = probe.equations().critical_pressure(h, R, wall.Y, wall.sigma, wall.phi);
        const double largest = analytic::largest_pressure(wall);
        const Estimate found = analytic::largest_pressure_by_search(wall);
        closed_form.within(P_c, largest, rounding(80) * largest, where);
        search.within(P_c, found, rounding(48), where);
        oracles.within(largest, found, rounding(32), where);
    });
}

} // namespace

std::vector<Check> rupture_wall_law_checks()
{
    return {
        formula_check("eq08_balance", {"8"}, "the wall's stress holds the pressure on half a sphere",
                      {"GSL quadrature over the half sphere", "balance of forces, 50 digits"}, eq08_balance),
        formula_check("eq09_thinning", {"9"}, "the wall thins with its radius by Poisson's ratio",
                      {"power law by the complex step", "the relation, 50 digits"}, eq09_thinning),
        formula_check("eq10_porosity", {"10"}, "porosity falls as the wall's volume rises",
                      {"ln V by the complex step", "difference of V, 50 digits"}, eq10_porosity),
        formula_check("eq11_stress", {"11"},
                      "the stress of a porous wall is that of its porosity, and positive",
                      {"GSL quadrature of dx/x", "the exponential, 50 digits"}, eq11_stress),
        formula_check(
            "eq12_slope", {"12"},
            "the radius grows with pressure as (8) to (11) together demand, on both sides of the pole",
            {"closed form by the complex step", "(8) to (11), 50 digits"}, eq12_slope),
        formula_check("eq12_integral", {"12"},
                      "integrated, the slope gives the closed form through the critical radius",
                      {"GSL's solver for differential equations", "closed form"}, eq12_integral),
        oracle_check("eq12_oracles", Level::scalar, {"12"},
                     "the closed form P(R) equals two integrations and both branches of its inverse",
                     {"closed form", "GSL's solver for differential equations", "Lambert's W"}, eq12_oracles),
        formula_check("eq13_pole", {"13"}, "at the critical pressure the radius grows without pressure",
                      {"(8) to (11), 50 digits", "sign of (12)"}, eq13_pole),
        formula_check("eq13_largest_pressure", {"13"},
                      "the critical pressure is the largest that the wall's law reaches",
                      {"closed form of the maximum", "GSL search for the maximum"}, eq13_largest_pressure),
    };
}

} // namespace aneurysm::checks
