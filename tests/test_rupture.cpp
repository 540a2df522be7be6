// SPDX-License-Identifier: Apache-2.0
// Section 3.2, (8)-(14) and (16). (15) stands with the sums of (6) and (7) in test_blood_flow.cpp.
#include "analytic/rupture.hpp"
#include "reference/rupture.hpp"
#include "tests/support.hpp"

#include <array>
#include <vector>

using namespace aneurysm;
using namespace aneurysm::test;
using analytic::Wall;

namespace
{

constexpr double fault = 1e-12;
constexpr double dR = 1e-4;

/// Every pair of sigma and phi of Table 4, from rest and from a start pressure of 0.4 times the largest.
std::vector<Wall> walls()
{
    std::vector<Wall> all;
    for (const double sigma : {0.2, 0.3, 0.4, 0.5, 0.6}) {
        for (const double phi : {3e-3, 4e-3, 5e-3, 6e-3}) {
            Wall wall{41.25, sigma, phi, 0.11, 0.0075, 0};
            all.push_back(wall);
            wall.P_0 = 0.4 * analytic::largest_pressure(wall);
            all.push_back(wall);
        }
    }
    return all;
}

template <class Claim>
bool for_all_walls(Claim claim)
{
    const std::vector<Wall> all = walls();
    return std::ranges::all_of(all, claim);
}

/// The terms of the denominator of (12) that cancel at the critical pressure, over their difference.
double cancellation(const Wall& wall, double P, double R, double h)
{
    const double softening = wall.modulus() / R;
    const double thinning = P * (1 + wall.sigma) / (2 * h);
    return (softening + thinning) / std::abs(softening - thinning);
}

} // namespace

BOOST_AUTO_TEST_CASE(eq08_balances_the_pressure_on_a_half_sphere)
{
    const auto holds = [](auto wall_stress) {
        // 4 roundings; the quadrature bounds its own error
        return within(wall_stress(1234.5, 0.11, 0.0075), analytic::cut_sphere_stress(1234.5, 0.11, 0.0075),
                      rounding(4));
    };
    BOOST_TEST(holds(reference::wall_stress));
    BOOST_TEST(!holds(off_by(fault, reference::wall_stress)));
}

BOOST_AUTO_TEST_CASE(eq09_is_the_differential_of_the_power_law)
{
    const auto holds = [](auto thickness_differential) {
        return for_all_walls([&](const Wall& wall) {
            const double R = 1.7 * wall.R_0;
            const double expected = analytic::thickness_slope(wall, R) * dR;
            const double h = analytic::thickness(wall, R);
            // 16 u of the oracle, 8 u of h, 6 roundings
            return within(thickness_differential(wall.sigma, h, R, dR), expected,
                          rounding(30) * std::abs(expected));
        });
    };
    BOOST_TEST(holds(reference::thickness_differential));
    BOOST_TEST(!holds(off_by(fault, reference::thickness_differential)));
    BOOST_TEST(!holds(off_by(-2, reference::thickness_differential))); // the sign lost in print
}

BOOST_AUTO_TEST_CASE(eq10_is_the_differential_of_the_wall_volume)
{
    const auto holds = [](auto porosity_differential) {
        return for_all_walls([&](const Wall& wall) {
            const double R = 1.7 * wall.R_0;
            const double expected = analytic::porosity_slope(wall, R) * dR;
            // 16 u of the oracle's two terms, 2 and sigma; 5 roundings
            const double allowed = rounding(16 + 5 + 1) * (2 + wall.sigma) / R * dR;
            return within(porosity_differential(wall.sigma, R, dR), expected, allowed);
        });
    };
    BOOST_TEST(holds(reference::porosity_differential));
    BOOST_TEST(!holds(off_by(fault, reference::porosity_differential)));
    BOOST_TEST(!holds(off_by(-2, reference::porosity_differential))); // the sign lost in print
}

BOOST_AUTO_TEST_CASE(eq11_is_the_integral_of_the_porosity)
{
    const auto holds = [](auto stress_of_porosity) {
        return for_all_walls([&](const Wall& wall) {
            // 5 roundings, the logarithm's among them
            return within(stress_of_porosity(wall.Y, wall.phi), analytic::porous_stress(wall.Y, wall.phi),
                          rounding(6));
        });
    };
    BOOST_TEST(holds(reference::stress_of_porosity));
    BOOST_TEST(!holds(off_by(fault, reference::stress_of_porosity)));
    BOOST_TEST(!holds(off_by(-2, reference::stress_of_porosity))); // the sign lost in print
}

BOOST_AUTO_TEST_CASE(eq12_is_the_slope_of_the_closed_form)
{
    const auto holds = [](auto radius_per_pressure) {
        return for_all_walls([&](const Wall& wall) {
            // the stable branch, and the unstable one beyond the critical radius
            return std::ranges::all_of(std::array{1.1, 1.5, 3.0}, [&](double ratio) {
                const double R = ratio * wall.R_0;
                const double h = analytic::thickness(wall, R);
                const double P = analytic::pressure(wall, R);
                const double expected = 1 / analytic::pressure_slope(wall, R);
                // 64 u of the oracle; 32 u of P, 8 u of h and 16 roundings; all on the terms that cancel
                const double allowed =
                    rounding(64 + 32 + 8 + 16) * cancellation(wall, P, R, h) * std::abs(expected);
                return within(radius_per_pressure(P, R, h, wall.Y, wall.sigma, wall.phi), expected, allowed);
            });
        });
    };
    BOOST_TEST(holds(reference::radius_per_pressure));
    BOOST_TEST(!holds(off_by(fault, reference::radius_per_pressure)));
    BOOST_TEST(!holds([](double P, double R, double h, double Y, double sigma, double phi) { // 1 - sigma
        return reference::radius_per_pressure(P * (1 - sigma) / (1 + sigma), R, h, Y, sigma, phi);
    }));
}

BOOST_AUTO_TEST_CASE(eq12_integrates_to_the_closed_form_through_the_critical_radius)
{
    const auto holds = [](auto radius_per_pressure) {
        return for_all_walls([&](const Wall& wall) {
            const double R = 1.3 * analytic::critical_radius(wall);
            const auto slope = [&](double r, double P) {
                return 1 /
                       radius_per_pressure(P, r, analytic::thickness(wall, r), wall.Y, wall.sigma, wall.phi);
            };
            // the solver's own bound holds since dP/dR falls with P; the closed form is good to 32 u of a sum
            // that is at most (1 + sigma) ln(R/R_0) + 1 < 5 times its result
            return within(analytic::pressure(wall, R), analytic::integrate_ode(slope, wall.R_0, wall.P_0, R),
                          5 * rounding(32));
        });
    };
    BOOST_TEST(holds(reference::radius_per_pressure));
    BOOST_TEST(!holds(off_by(1e-10, reference::radius_per_pressure)));
}

BOOST_AUTO_TEST_CASE(eq12_follows_from_8_to_11)
{
    const auto holds = [](auto radius_per_pressure) {
        return for_all_walls([&](const Wall& wall) {
            const double R = 1.4 * wall.R_0;
            const double h = analytic::thickness(wall, R);
            const double P = analytic::pressure(wall, R);
            const double dP = dR / radius_per_pressure(P, R, h, wall.Y, wall.sigma, wall.phi);
            // (8) is linear in P, R and 1/h; (11) falls by 2/3 Y when phi grows by the factor e
            const double dh = reference::thickness_differential(wall.sigma, h, R, dR);
            const double by_load = reference::wall_stress(dP, R, h) + reference::wall_stress(P, dR, h) -
                                   reference::wall_stress(P, R, h) * dh / h;
            const double per_e = reference::stress_of_porosity(wall.Y, wall.phi * std::exp(1)) -
                                 reference::stress_of_porosity(wall.Y, wall.phi);
            const double by_porosity = per_e * reference::porosity_differential(wall.sigma, R, dR) / wall.phi;
            // 40 roundings on either side; the difference of logarithms has terms of |ln phi| < 6 for a
            // result of 1
            return within(by_load, by_porosity,
                          rounding(40) * (2 * 6 + cancellation(wall, P, R, h)) * by_porosity);
        });
    };
    BOOST_TEST(holds(reference::radius_per_pressure));
    BOOST_TEST(!holds(off_by(fault, reference::radius_per_pressure)));
}

BOOST_AUTO_TEST_CASE(eq12_oracles_agree)
{
    BOOST_TEST(for_all_walls([](const Wall& wall) {
        const double R = 1.3 * analytic::critical_radius(wall);
        return within(analytic::pressure(wall, R), analytic::pressure_by_integration(wall, R),
                      5 * rounding(32));
    }));
    BOOST_TEST(for_all_walls([](const Wall& wall) {
        const double P = 0.9999 * analytic::largest_pressure(wall);
        const auto R = analytic::radius_by_integration(wall, P); // its error is one of P
        return within(analytic::pressure(wall, R.value), P, R.error + 2 * rounding(32) * P);
    }));
    for (const bool stable : {true, false}) {
        BOOST_TEST(for_all_walls([&](const Wall& wall) {
            if (wall.P_0 > 0) {
                return true;
            }
            const double P = 0.9 * analytic::largest_pressure(wall);
            const auto R = analytic::radius_by_lambert(wall, P, stable);
            const double slope = std::abs(analytic::pressure_slope(wall, R.value));
            return within(analytic::pressure(wall, R.value), P, slope * R.error + 5 * rounding(32) * P);
        }));
    }
}

BOOST_AUTO_TEST_CASE(eq13_is_the_largest_pressure)
{
    const auto holds = [](auto critical_pressure) {
        return for_all_walls([&](const Wall& wall) {
            const double R = analytic::critical_radius(wall);
            const double h = analytic::thickness(wall, R);
            const double P_c = critical_pressure(h, R, wall.Y, wall.sigma, wall.phi);
            const double P_max = analytic::largest_pressure(wall);
            // 16 u of R_c to the power 1 + sigma, 8 u of h, 32 u of the maximum, 10 roundings
            return within(P_c, P_max, rounding(16 * 2 + 8 + 32 + 10) * P_max) &&
                   within(P_c, analytic::largest_pressure_by_search(wall), rounding(16 * 2 + 8 + 10));
        });
    };
    BOOST_TEST(holds(reference::critical_pressure));
    BOOST_TEST(!holds(off_by(fault, reference::critical_pressure)));
}

BOOST_AUTO_TEST_CASE(eq13_is_the_pole_of_eq12)
{
    const auto holds = [](auto critical_pressure) {
        return for_all_walls([&](const Wall& wall) {
            const double R = 2 * wall.R_0;
            const double h = analytic::thickness(wall, R);
            const double P_c = critical_pressure(h, R, wall.Y, wall.sigma, wall.phi);
            // (13) and each term of (12)'s denominator have at most 10 roundings: 30 u decide the sign
            const auto sign_at = [&](double P) {
                return std::signbit(reference::radius_per_pressure(P, R, h, wall.Y, wall.sigma, wall.phi));
            };
            return !sign_at(P_c * (1 - rounding(30))) && sign_at(P_c * (1 + rounding(30)));
        });
    };
    BOOST_TEST(holds(reference::critical_pressure));
    BOOST_TEST(!holds(off_by(fault, reference::critical_pressure)));
}

BOOST_AUTO_TEST_CASE(eq13_the_wall_ruptures_just_above_and_not_just_below)
{
    const auto holds = [](auto ruptures) {
        return for_all_walls([&](const Wall& wall) {
            const double P_c = analytic::largest_pressure(wall);
            const double area = 0.37;
            // two roundings in P_c area / area: 4 u decide
            return !ruptures(P_c * area * (1 - rounding(4)), area, P_c) &&
                   ruptures(P_c * area * (1 + rounding(4)), area, P_c);
        });
    };
    BOOST_TEST(holds(reference::ruptures));
    BOOST_TEST(!holds(
        [](double F, double area, double P) { return reference::ruptures(F, area, P * (1 + fault)); }));
    BOOST_TEST(!holds(
        [](double F, double area, double P) { return reference::ruptures(F, area, P * (1 - fault)); }));
}

BOOST_AUTO_TEST_CASE(eq14_is_the_mean_force_of_a_pulse)
{
    const auto holds = [](auto impulse_force) {
        const double mean = 3.7;
        const double m = 0.011;
        const double dt = 1e-3;
        const auto speed = analytic::speed_after_pulse(mean, m, dt);
        const Vec3 direction{2.0 / 7, -3.0 / 7, 6.0 / 7};
        const Vec3 F = impulse_force(m, speed.value * direction, dt);
        // the pulse's relative error, and 5 roundings of F and of the direction
        const double allowed = mean * (speed.error / speed.value + rounding(5));
        return distance(F, mean * direction) <= allowed;
    };
    BOOST_TEST(holds(reference::impulse_force));
    BOOST_TEST(!holds(off_by(fault, reference::impulse_force)));
}

namespace
{

/// A handful of forces; the third is the hardest per density, the fourth the hardest in S once the third is
/// out.
struct Hits {
    double m = 0.0123;
    std::vector<double> density{1050, 1040, 1055, 1061, 1049};
    std::vector<Vec3> force{{1, 2, 2}, {-3, 0, 4}, {20, -30, 60}, {-10, 20, 20}, {0, 0, 0}};

    analytic::Estimate expected(const std::vector<std::int64_t>& S) const
    {
        Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(S.size()));
        for (std::size_t c = 0; c < S.size(); ++c) {
            const auto i = static_cast<std::size_t>(S[c]);
            columns.col(static_cast<Eigen::Index>(c)) =
                m / density[i] * Eigen::Vector3d(force[i].x, force[i].y, force[i].z);
        }
        const double norm = analytic::largest_norm(columns);
        return {norm, rounding(4) * norm};
    }
};

} // namespace

BOOST_AUTO_TEST_CASE(eq16_finds_the_hardest_hit_and_who_made_it)
{
    const Hits hits;
    const auto holds = [&](auto impact_force) {
        const std::vector<std::vector<std::int64_t>> sets{{0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}, {4, 3, 0}, {1}};
        const std::vector<std::int64_t> who{2, 2, 3, 1};
        for (std::size_t s = 0; s < sets.size(); ++s) {
            const reference::Impact hit = impact_force(sets[s], hits.m, hits.density, hits.force);
            // 8 roundings of a norm
            if (!within(hit.force, hits.expected(sets[s]), rounding(8)) || hit.particle != who[s]) {
                return false;
            }
        }
        return true;
    };
    using Set = std::span<const std::int64_t>;
    BOOST_TEST(holds(reference::impact_force));
    BOOST_TEST(!holds([](Set S, double m, const auto& rho, const auto& force) {
        return reference::impact_force(S, m * (1 + fault), rho, force);
    }));
    BOOST_TEST(!holds([](Set S, double m, const auto& rho, const auto& force) { // one particle overlooked
        return reference::impact_force(S.first(S.size() - 1), m, rho, force);
    }));
}

BOOST_AUTO_TEST_CASE(eq16_of_an_empty_set_is_no_impact)
{
    const Hits hits;

    const reference::Impact none = reference::impact_force({}, hits.m, hits.density, hits.force);

    BOOST_TEST(none.force == 0);
    BOOST_TEST(none.particle == -1);
}
