// SPDX-License-Identifier: Apache-2.0
// Section 3.3: what resists the sac's growth, and how far it grows in a frame, (17)-(21).
#include "analytic/growth.hpp"
#include "analytic/relations.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"

#include <vector>

namespace aneurysm::checks
{
namespace
{

using analytic::Balance;
using analytic::Estimate;

/// A wall, what pushes it, and for how long.
struct Step {
    WallTissue wall;
    double F_B, R, dt;
    std::string where;

    analytic::Tissue tissue() const
    {
        return {wall.rho_F, wall.a, wall.c, wall.K_E, wall.A_E, wall.K_C, wall.A_C, wall.m};
    }
    analytic::Resistance resistance() const
    {
        return {wall.m, wall.rho_F * wall.a * wall.c, wall.K_E * wall.A_E + wall.K_C * wall.A_C};
    }
    Balance balance() const { return analytic::backward_euler_from_rest(resistance(), F_B, R, dt); }
};

/// Table 1, with a mass that matters.
constexpr WallTissue table_1{1000, 0.01, 1500, 800, 20, 3.52, 10, 5};
/// A wall on which every term of (21) has about the same weight.
constexpr WallTissue balanced{2, 3, 0.5, 4, 0.25, 0.5, 1.5, 0.006};

/// Table 1's wall, one whose resistances are alike, and walls like that at random.
std::vector<Step> steps()
{
    std::vector<Step> all{{table_1, 730, 0.11, 1e-3, "Table 1"}, {table_1, 1, 0.24, 10, "Table 1, slow"}};
    Arguments a(17);
    for (int n = 0; n < 100; ++n) {
        const auto near = [&](double x) { return x * a.between(0.6, 1.6); };
        const WallTissue& b = balanced;
        const WallTissue wall{near(b.rho_F), near(b.a),   near(b.c),   near(b.K_E),
                              near(b.A_E),   near(b.K_C), near(b.A_C), near(b.m)};
        all.push_back({wall, a.between(0.5, 5), near(0.3), near(0.04), at({{"wall", double(n)}})});
    }
    return all;
}

void eq17_newton(Probe& probe)
{
    Quantity& relation =
        probe.quantity("F_T + F_F + F_P = F_B, 50 digits [1]", Source::rounding,
                       "gamma_2: two differences, neither larger than half the sum of the terms");
    Quantity& of_step = probe.quantity("F_T against a linear solve of (17) to (20) [N]", Source::solver,
                                       "the solve's own bound of each force; gamma_2 (F_B + F_F + F_P)");
    Quantity& oracles = probe.quantity("forces of the linear solve in the relation [1]", Source::solver,
                                       "the solve's own bounds, over F_B");
    Arguments a(171);
    for (const Step& s : steps()) {
        const double F_B = a.between(1, 4);
        const double F_F = a.between(0.3, 3);
        const double F_P = a.between(0.3, 3);
        const double F_T = probe.equations().net_wall_force(F_B, F_F, F_P);
        relation.within(analytic::wall_force_imbalance(F_B, F_F, F_P, F_T), 0, rounding(2),
                        at({{"F_B", F_B}, {"F_F", F_F}, {"F_P", F_P}}));
        const Balance x = s.balance();
        const double errors = x.net.error + x.tissue.error + x.fibers.error;
        of_step.within(probe.equations().net_wall_force(s.F_B, x.tissue.value, x.fibers.value), x.net.value,
                       errors + rounding(2) * 2 * s.F_B, s.where);
        oracles.within(analytic::wall_force_imbalance(s.F_B, x.tissue.value, x.fibers.value, x.net.value), 0,
                       errors / s.F_B, s.where);
    }
}

void eq18_radiation(Probe& probe)
{
    Quantity& power = probe.quantity("F_F u_t = power of the wave, 50 digits [1]", Source::rounding,
                                     "gamma_4: 3 products, one more where u_t is 1/dt");
    Quantity& momentum = probe.quantity("F_F against the momentum given to a fluid column [N]",
                                        Source::rounding, "gamma_12 F_F: 4, 8 of the oracle");
    Quantity& of_step =
        probe.quantity("F_F against a linear solve of (17) to (20) [N]", Source::solver,
                       "the solve's own bounds of F_F and of u_t; gamma_6 F_F: 4, 2 of the impedance");
    Quantity& oracles = probe.quantity("momentum of the column in the wave's power [1]", Source::rounding,
                                       "gamma_8 of the oracle");
    for (const Step& s : steps()) {
        const WallTissue& w = s.wall;
        const Balance x = s.balance();
        const double u_t = x.speed.value;
        const double F_F = probe.equations().tissue_force(w, u_t);
        const double column = analytic::column_momentum_rate(w.rho_F, w.a, w.c, u_t, s.dt);
        power.within(analytic::radiated_power_imbalance(w.rho_F, w.a, w.c, u_t, F_F), 0, rounding(4),
                     s.where);
        momentum.within(F_F, column, rounding(12) * column, s.where);
        of_step.within(F_F, x.tissue.value,
                       x.tissue.error + x.speed.error * s.resistance().impedance + rounding(6) * column,
                       s.where);
        oracles.within(analytic::radiated_power_imbalance(w.rho_F, w.a, w.c, u_t, column), 0, rounding(8),
                       s.where);
    }
}

void eq19_fibres(Probe& probe)
{
    Quantity& work = probe.quantity("F_P epsilon/2 = energy of both fibers, 50 digits [1]", Source::rounding,
                                    "gamma_3 of positive terms: two products and a sum");
    Quantity& energy = probe.quantity("F_P against the slope of the fibers' energy [N]", Source::rounding,
                                      "gamma_19 F_P: 3, 16 of the complex step");
    Quantity& of_step =
        probe.quantity("F_P against a linear solve of (17) to (20) [N]", Source::solver,
                       "the solve's own bounds of F_P and of epsilon; gamma_6 F_P: 3, 3 of the stiffness");
    Quantity& oracles = probe.quantity("slope of the energy in the work [1]", Source::rounding,
                                       "gamma_16 of the complex step");
    for (const Step& s : steps()) {
        const WallTissue& w = s.wall;
        const Balance x = s.balance();
        const double epsilon = x.strain.value;
        const double F_P = probe.equations().fiber_force(w, epsilon);
        const double slope = analytic::fiber_energy_slope(w.K_E, w.A_E, w.K_C, w.A_C, epsilon);
        work.within(analytic::fiber_work_imbalance(s.tissue(), epsilon, F_P), 0, rounding(3), s.where);
        energy.within(F_P, slope, rounding(19) * slope, s.where);
        of_step.within(F_P, x.fibers.value,
                       x.fibers.error + x.strain.error * s.resistance().stiffness + rounding(6) * slope,
                       s.where);
        oracles.within(analytic::fiber_work_imbalance(s.tissue(), epsilon, slope), 0, rounding(16), s.where);
    }
}

void eq20_strain(Probe& probe)
{
    Quantity& relation = probe.quantity("epsilon R = dR, 50 digits [1]", Source::rounding,
                                        "gamma_1: a quotient, rounded once");
    Quantity& circumference =
        probe.quantity("epsilon against the circumference's strain [1]", Source::quadrature,
                       "GSL's estimate and 20 u of the value; gamma_1 epsilon");
    Quantity& oracles = probe.quantity("the circumference's strain in the relation [1]", Source::quadrature,
                                       "GSL's estimate and 20 u, over the value");
    Arguments a(20);
    for (int n = 0; n < 100; ++n) {
        const double R = a.between(0.03, 0.7);
        const double dR = a.between(1e-6, 0.3);
        const std::string where = at({{"R", R}, {"dR", dR}});
        const double epsilon = probe.equations().strain(dR, R);
        const Estimate expected = analytic::circumference_strain(dR, R);
        relation.within(analytic::strain_imbalance(dR, R, epsilon), 0, rounding(1), where);
        circumference.within(epsilon, expected, rounding(1), where);
        oracles.within(analytic::strain_imbalance(dR, R, expected.value), 0, expected.error / expected.value,
                       where);
    }
}

void eq21_growth(Probe& probe)
{
    Quantity& relation =
        probe.quantity("F_B = m dR/dt^2 + F_F + F_P, 50 digits [1]", Source::rounding,
                       "gamma_7 of positive terms: at most 4 roundings in one, two sums, a quotient");
    Quantity& solve = probe.quantity("dR against a linear solve of (17) to (20) [m]", Source::solver,
                                     "Higham's a posteriori bound of the solve; gamma_7 dR");
    Quantity& oracles = probe.quantity("dR of the linear solve in the balance [1]", Source::solver,
                                       "the solve's own bound, over dR; gamma_3 of its coefficients");
    for (const Step& s : steps()) {
        const double dR = probe.equations().radius_increment(s.wall, s.F_B, s.R, s.dt);
        const Estimate expected = s.balance().dR;
        relation.within(analytic::growth_imbalance(s.tissue(), s.F_B, s.R, s.dt, dR), 0, rounding(7),
                        s.where);
        solve.within(dR, expected, rounding(7), s.where);
        oracles.within(analytic::growth_imbalance(s.tissue(), s.F_B, s.R, s.dt, expected.value), 0,
                       expected.error / expected.value + rounding(3), s.where);
    }
}

void eq21_limits(Probe& probe)
{
    Quantity& rest =
        probe.quantity("dR of a long step over F_B R/K [1]", Source::truncation,
                       "1 - x, x = impedance/dt R/K; 2 x^2 for the rest of the series; gamma_20");
    Quantity& free = probe.quantity("dR of a short step over F_B dt^2/m [1]", Source::truncation,
                                    "1 - x, x = impedance dt/m: twice the free wall's F_B dt^2/(2 m), to the "
                                    "first order; 2 x^2 for the rest of the series; gamma_20");
    const double F = 730;
    const double R = 0.11;
    const double K = table_1.K_E * table_1.A_E + table_1.K_C * table_1.A_C;
    const double impedance = table_1.rho_F * table_1.a * table_1.c;
    for (const double dt : {1e7, 1e8}) {
        const double lag = impedance / dt * R / K;
        rest.within(probe.equations().radius_increment(table_1, F, R, dt) / (F * R / K), 1 - lag,
                    2 * lag * lag + rounding(20), at({{"dt", dt}}));
    }
    for (const double dt : {1e-12, 1e-13}) {
        const double drag = impedance * dt / table_1.m;
        free.within(probe.equations().radius_increment(table_1, F, R, dt) / (F * dt * dt / table_1.m),
                    1 - drag, 2 * drag * drag + rounding(20), at({{"dt", dt}}));
    }
}

void eq21_repeated(Probe& probe)
{
    Quantity& flow = probe.quantity(
        "R after n steps against the flow by Lambert's W [m]", Source::truncation,
        "the next term of backward error analysis, n gamma_2 R^2/R_0 for the rounding of n steps, and GSL's "
        "bound of W (docs/bounds.md, B14)");
    Quantity& no_limit =
        probe.quantity("growth over a fixed time in short steps over t F dt/m [1]", Source::truncation,
                       "two-sided: 1/(1 + x), x = impedance dt/m, less what the fibers take; n u R for the "
                       "rounding of n steps (docs/bounds.md, B14)");
    const auto grow = [&](double F, double dt, int n) {
        double R = 0.3;
        for (int k = 0; k < n; ++k) {
            R += probe.equations().radius_increment(balanced, F, R, dt);
        }
        return R;
    };
    for (const int n : {100, 200, 400}) {
        const Step s{balanced, 40.0 / n, 0.3, 0.04, {}};
        const double R = grow(s.F_B, s.dt, n);
        const Estimate expected = analytic::radius_after_steps(s.resistance(), s.F_B, s.R, s.dt, n);
        flow.within(R, expected.value, expected.error + n * rounding(2) * R * R / s.R,
                    at({{"n", double(n)}}));
    }
    for (const int n : {1000, 10'000}) {
        const double dt = 0.01 / n;
        const double unhindered = 0.01 * dt / balanced.m;
        const analytic::Resistance resistance = Step{balanced, 1, 0.3, dt, {}}.resistance();
        const double x = resistance.impedance * dt / balanced.m;
        const double half = resistance.stiffness * dt * dt / (balanced.m * 0.3) / 2;
        no_limit.within((grow(1, dt, n) - 0.3) / unhindered, 1 / (1 + x) - half,
                        half + n * rounding(1) * 0.3 / unhindered, at({{"n", double(n)}}));
    }
}

} // namespace

std::vector<Check> growth_checks()
{
    return {
        formula_check("eq17_newton", {"17"}, "what the blood's push leaves over accelerates the wall",
                      {"linear solve of one backward-Euler step", "the relation, 50 digits"}, eq17_newton),
        formula_check(
            "eq18_radiation", {"18"}, "the tissue fluid resists as a column that a plane wave runs into",
            {"momentum of the column", "power of the wave, 50 digits", "linear solve"}, eq18_radiation),
        formula_check("eq19_fibres", {"19"}, "elastin and collagen resist by the slope of their energy",
                      {"energy by the complex step", "work, 50 digits", "linear solve"}, eq19_fibres),
        formula_check("eq20_strain", {"20"}, "the strain is that of the sac's circumference",
                      {"GSL quadrature around the circle", "the relation, 50 digits"}, eq20_strain),
        formula_check("eq21_growth", {"21"},
                      "the growth of a frame solves (17) to (20), one backward-Euler step from rest",
                      {"linear solve of six unknowns", "balance of forces, 50 digits"}, eq21_growth),
        formula_check("eq21_limits", {"21"}, "long steps end at rest, short ones in free flight",
                      {"static wall", "free wall"}, eq21_limits),
        formula_check("eq21_repeated", {"21"},
                      "repeated steps follow their flow, and have no limit as the time step goes to 0",
                      {"Lambert's W with backward error analysis", "growth without resistance"},
                      eq21_repeated),
    };
}

} // namespace aneurysm::checks
