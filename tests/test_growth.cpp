// SPDX-License-Identifier: Apache-2.0
// Section 3.3, (17)-(23).
#include "analytic/growth.hpp"
#include "analytic/rupture.hpp"
#include "reference/growth.hpp"
#include "tests/support.hpp"

#include <array>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

constexpr double fault = 1e-12;

/// Table 1, with a mass that matters; and a wall on which every term of (21) has about the same weight.
const reference::WallTissue table_1{1000, 0.01, 1500, 800, 20, 3.52, 10, 5};
const reference::WallTissue balanced{2, 3, 0.5, 4, 0.25, 0.5, 1.5, 0.006};

struct Step {
    reference::WallTissue wall;
    double F_B, R, dt;

    analytic::Resistance resistance() const
    {
        return {wall.m, wall.rho_F * wall.a * wall.c, wall.K_E * wall.A_E + wall.K_C * wall.A_C};
    }
    analytic::Balance balance() const { return analytic::backward_euler_from_rest(resistance(), F_B, R, dt); }
};

const std::array steps{Step{table_1, 730, 0.11, 1e-3}, Step{table_1, 1, 0.24, 10},
                       Step{balanced, 2.5, 0.3, 0.04}};

template <class Claim>
bool for_all_steps(Claim claim)
{
    return std::ranges::all_of(steps, [&](const Step& step) { return claim(step, step.balance()); });
}

} // namespace

BOOST_AUTO_TEST_CASE(eq17_balances_the_forces_of_a_step)
{
    const auto holds = [](auto net_wall_force) {
        return for_all_steps([&](const Step& s, const analytic::Balance& x) {
            // two subtractions; the resistances carry the errors of the linear solve
            const double allowed = x.net.error + x.tissue.error + x.fibres.error + rounding(2) * 3 * s.F_B;
            return within(net_wall_force(s.F_B, x.tissue.value, x.fibres.value), x.net.value, allowed);
        });
    };
    BOOST_TEST(holds(reference::net_wall_force));
    BOOST_TEST(!holds(
        [](double B, double F, double P) { return reference::net_wall_force(B, F * (1 + fault), P); }));
    BOOST_TEST(!holds(
        [](double B, double F, double P) { return reference::net_wall_force(B, F, P * (1 + fault)); }));
    BOOST_TEST(!holds([](double B, double F, double P) { return reference::net_wall_force(B, F, -P); }));
}

BOOST_AUTO_TEST_CASE(eq18_is_the_momentum_given_to_a_fluid_column)
{
    const auto holds = [](auto tissue_force) {
        return for_all_steps([&](const Step& s, const analytic::Balance& x) {
            const auto& w = s.wall;
            const double expected = analytic::column_momentum_rate(w.rho_F, w.a, w.c, x.speed.value, s.dt);
            const double of_step = x.tissue.error + x.speed.error * s.resistance().impedance;
            const double force = tissue_force(w, x.speed.value);
            // 3 roundings and the oracle's 5; 2 of the impedance in the linear solve
            return within(force, expected, rounding(8) * expected) &&
                   within(force, x.tissue.value, of_step + rounding(5) * expected);
        });
    };
    BOOST_TEST(holds(reference::tissue_force));
    BOOST_TEST(!holds(off_by(fault, reference::tissue_force)));
}

BOOST_AUTO_TEST_CASE(eq19_is_the_slope_of_the_fibres_energy)
{
    const auto holds = [](auto fibre_force) {
        return for_all_steps([&](const Step& s, const analytic::Balance& x) {
            const auto& w = s.wall;
            const double expected = analytic::fibre_energy_slope(w.K_E, w.A_E, w.K_C, w.A_C, x.strain.value);
            const double of_step = x.fibres.error + x.strain.error * s.resistance().stiffness;
            const double force = fibre_force(w, x.strain.value);
            // 3 roundings in each term and sum, 16 u of the oracle; all terms are positive
            return within(force, expected, rounding(3 + 16) * expected) &&
                   within(force, x.fibres.value, of_step + rounding(6) * expected);
        });
    };
    BOOST_TEST(holds(reference::fibre_force));
    BOOST_TEST(!holds(off_by(fault, reference::fibre_force)));
    BOOST_TEST(!holds([](reference::WallTissue w, double epsilon) { // collagen dropped
        w.K_C = 0;
        return reference::fibre_force(w, epsilon);
    }));
}

BOOST_AUTO_TEST_CASE(eq20_is_the_strain_of_the_circumference)
{
    const auto holds = [](auto strain) {
        return for_all_steps([&](const Step& s, const analytic::Balance& x) {
            const double epsilon = strain(x.dR.value, s.R);
            // one rounding
            return within(epsilon, analytic::circumference_strain(x.dR.value, s.R), rounding(1)) &&
                   within(epsilon, x.strain.value, x.strain.error + x.dR.error / s.R + rounding(1) * epsilon);
        });
    };
    BOOST_TEST(holds(reference::strain));
    BOOST_TEST(!holds(off_by(fault, reference::strain)));
}

BOOST_AUTO_TEST_CASE(eq21_solves_17_to_20_as_one_backward_euler_step)
{
    const auto holds = [](auto radius_increment) {
        return for_all_steps([&](const Step& s, const analytic::Balance& x) {
            // 10 roundings, all terms positive; the oracle bounds its own error
            return within(radius_increment(s.wall, s.F_B, s.R, s.dt), x.dR, rounding(10));
        });
    };
    BOOST_TEST(holds(reference::radius_increment));
    BOOST_TEST(!holds(off_by(fault, reference::radius_increment)));
    BOOST_TEST(!holds([](reference::WallTissue w, double F_B, double R, double dt) { // one coefficient
        w.a *= 1 + fault;
        return reference::radius_increment(w, F_B, R, dt);
    }));
}

BOOST_AUTO_TEST_CASE(eq21_has_the_limits_of_a_static_and_of_a_free_wall)
{
    const auto holds = [](auto radius_increment) {
        const double F = 730;
        const double R = 0.11;
        const double K = table_1.K_E * table_1.A_E + table_1.K_C * table_1.A_C;
        const double impedance = table_1.rho_F * table_1.a * table_1.c;
        // long steps: F R/K up to the other terms over K/R; short ones: F dt^2/m, twice the true F dt^2/(2
        // m), up to impedance dt/m. Both leave terms of the second order, squares of those; 10 roundings
        const double longest = 1e7;
        const double lag = impedance / longest * R / K;
        const double shortest = 1e-12;
        const double drag = impedance * shortest / table_1.m;
        const double at_rest = F * R / K * (1 - lag);
        const double in_flight = F * shortest * shortest / table_1.m * (1 - drag);
        return within(radius_increment(table_1, F, R, longest), at_rest,
                      (2 * lag * lag + rounding(20)) * at_rest) &&
               within(radius_increment(table_1, F, R, shortest), in_flight,
                      (2 * drag * drag + rounding(20)) * in_flight);
    };
    BOOST_TEST(holds(reference::radius_increment));
    BOOST_TEST(!holds(off_by(1e-10, reference::radius_increment)));
    BOOST_TEST(
        !holds([](const reference::WallTissue& w, double F, double R, double dt) { // the true acceleration
            return reference::radius_increment(w, F / 2, R, dt);
        }));
}

BOOST_AUTO_TEST_CASE(eq21_repeated_follows_the_lambert_flow)
{
    const auto holds = [](auto radius_increment) {
        return std::ranges::all_of(std::array{100, 200, 400}, [&](int n) {
            const Step s{balanced, 40.0 / n, 0.3, 0.04};
            double R = s.R;
            for (int k = 0; k < n; ++k) {
                R += radius_increment(s.wall, s.F_B, R, s.dt);
            }
            // each step rounds R and its increment; neighbouring solutions diverge by less than R_n/R_0
            const double rounded = n * rounding(2) * R * R / s.R;
            const auto expected = analytic::radius_after_steps(s.resistance(), s.F_B, s.R, s.dt, n);
            return within(R, expected.value, expected.error + rounded);
        });
    };
    BOOST_TEST(holds(reference::radius_increment));
    BOOST_TEST(!holds(off_by(1e-5, reference::radius_increment))); // the oracle's truncation is of that order
}

BOOST_AUTO_TEST_CASE(eq21_repeated_has_no_limit_for_short_steps)
{
    // without memory of velocity the growth over a fixed time falls with dt: from rest, n F dt^2/m = t F dt/m
    const auto growth = [](double dt, int n) {
        double R = 0.3;
        for (int k = 0; k < n; ++k) {
            R += reference::radius_increment(balanced, 1, R, dt);
        }
        return R - 0.3;
    };
    const double impedance = balanced.rho_F * balanced.a * balanced.c;
    const double stiffness = balanced.K_E * balanced.A_E + balanced.K_C * balanced.A_C;
    for (const int n : {100'000, 1'000'000}) {
        const double dt = 0.01 / n;
        const double free = 0.01 * dt / balanced.m;
        // what damping and fibres take away, at most; n roundings of R
        const double taken = impedance * dt / balanced.m + stiffness / 0.3 * dt * dt / balanced.m;
        BOOST_TEST(within(growth(dt, n), free, taken * free + n * rounding(1) * 0.3));
    }
}

BOOST_AUTO_TEST_CASE(eq22_equal_steps_give_the_gamma_product)
{
    const auto holds = [](auto thickness_growing) {
        return std::ranges::all_of(std::array{10, 40, 160, 640}, [&](int n) {
            const double R_0 = 0.11;
            const double D = R_0 / n;
            double h = 0.0075;
            for (int k = 0; k < n; ++k) {
                h = thickness_growing(h, R_0 + k * D, 0.4, D);
            }
            // a step rounds twice on h and four times on the small change, which is less than h/n
            return within(h, analytic::thickness_after_steps(0.0075, R_0, 0.4, D, n),
                          n * rounding(2) + rounding(5));
        });
    };
    BOOST_TEST(holds(reference::thickness_growing));
    BOOST_TEST(!holds([](double h, double R, double sigma, double D) {
        return reference::thickness_growing(h, R, sigma * (1 + 1e-11), D);
    }));
    BOOST_TEST(!holds([](double h, double R, double sigma, double D) { // the sign lost in print
        return reference::thickness_growing(h, R, -sigma, D);
    }));
}

BOOST_AUTO_TEST_CASE(eq22_misses_the_power_law_by_what_euler_must)
{
    const auto holds = [](auto thickness_growing) {
        return std::ranges::all_of(std::array{20, 80, 320}, [&](int n) {
            const analytic::Wall wall{1, 0.4, 1, 0.11, 0.0075, 0};
            const double D = wall.R_0 / n;
            double h = wall.h_0;
            for (int k = 0; k < n; ++k) {
                h = thickness_growing(h, wall.R_0 + k * D, wall.sigma, D);
            }
            const double error = h / analytic::thickness(wall, wall.R_0 + n * D) - 1;
            const auto expected = analytic::euler_thinning_error(wall.R_0, wall.sigma, D, n);
            // two-sided: no smaller than predicted either. 2 n u of the steps, 8 u of the power law
            return within(error, expected.value, expected.error + n * rounding(2) + rounding(10));
        });
    };
    BOOST_TEST(holds(reference::thickness_growing));
    BOOST_TEST(!holds([](double h, double R, double sigma, double D) { // a better scheme: exact steps
        return h * std::pow(1 + D / R, -sigma);
    }));
    BOOST_TEST(!holds([](double h, double R, double sigma, double D) {
        return reference::thickness_growing(h, R, sigma * (1 + 1e-6), D);
    }));
}

BOOST_AUTO_TEST_CASE(eq23_equal_steps_give_the_power)
{
    const auto holds = [](auto thickness_developed) {
        return std::ranges::all_of(std::array{1, 100, 5000}, [&](int n) {
            double h = 0.0075;
            for (int k = 0; k < n; ++k) {
                h = thickness_developed(h, 1.1, 4e-4, 1e-3);
            }
            // a step rounds the factor, near 1, and the product
            return within(h, analytic::thickness_developed_after_steps(0.0075, 1.1, 4e-4, n),
                          n * rounding(2));
        });
    };
    BOOST_TEST(holds(reference::thickness_developed));
    BOOST_TEST(!holds([](double h, double alpha, double dR, double largest) {
        return reference::thickness_developed(h, alpha * (1 + 1e-11), dR, largest);
    }));
    BOOST_TEST(!holds([](double h, double alpha, double dR, double largest) { // the sign lost in print
        return reference::thickness_developed(h, -alpha, dR, largest);
    }));
}

BOOST_AUTO_TEST_CASE(eq23_misses_the_exponential_by_what_a_product_must)
{
    const auto holds = [](auto thickness_developed) {
        return std::ranges::all_of(std::array{1000, 4000}, [&](int n) {
            const double D = 0.8 / n;
            double h = 1;
            for (int k = 0; k < n; ++k) {
                h = thickness_developed(h, 1.1, D, 1e-3);
            }
            const auto expected = analytic::exponential_thinning_error(1.1, D, n);
            // two-sided; 2 n u of the steps, 4 u of the exponential
            const double error = h / std::exp(-1.1 * n * D) - 1;
            return within(error, expected.value, expected.error + n * rounding(2) + rounding(4));
        });
    };
    BOOST_TEST(holds(reference::thickness_developed));
    BOOST_TEST(!holds([](double h, double alpha, double dR, double) { return h * std::exp(-alpha * dR); }));
}

BOOST_AUTO_TEST_CASE(eq23_caps_the_increment)
{
    const auto holds = [](auto thickness_developed) {
        const double at_cap = thickness_developed(1, 1.1, 1e-3, 1e-3);
        return thickness_developed(1, 1.1, 5, 1e-3) == at_cap &&
               thickness_developed(1, 1.1, 9e-4, 1e-3) > at_cap;
    };
    BOOST_TEST(holds(reference::thickness_developed));
    BOOST_TEST(!holds([](double h, double alpha, double dR, double) { return h * (1 - alpha * dR); }));
}
