// SPDX-License-Identifier: Apache-2.0
// Section 3.1, (3): the factor of the pressure solve, its acceleration, and its solution for a cloud.
#include "analytic/incompressible.hpp"
#include "reference/incompressible.hpp"
#include "tests/periodic.hpp"

using namespace aneurysm;
using namespace aneurysm::test;
using reference::IncompressibleReport;
using reference::IncompressibleSettings;

namespace
{

constexpr double fault = 1e-12;
constexpr double dt = 1e-3;
constexpr double rho_0 = PeriodicLattice::rho;

/// The reference's solve, and the same with a change of its settings planted.
constexpr auto solve = [](const auto&... x) { return reference::solve_incompressibility(x...); };
template <class Change>
auto solve_with(Change change)
{
    return [=](const auto& b, const auto& neighbors, auto rho, double step, IncompressibleSettings settings,
               auto p, auto a) {
        change(settings);
        return reference::solve_incompressibility(b, neighbors, rho, step, settings, p, a);
    };
}

} // namespace

BOOST_AUTO_TEST_CASE(eq03_factor_is_that_of_the_lattice_and_of_all_pairs)
{
    const auto holds = [](auto factor) {
        for (const KernelName name : {KernelName::cubic_spline, KernelName::wendland_c2}) {
            const PeriodicLattice flow({8, 8, 8}, name, 1.3);
            const auto expected = analytic::dfsph_factor(flow.medium);
            // the oracle has no sum of gradients; the reference's is rounding, whose square doesn't count
            if (!within(factor(flow.bodies, flow.neighbors.of(0)), expected.value, 3 * expected.error)) {
                return false;
            }
            const RandomCloud random(name);
            if (!random.for_all([&](std::size_t i) {
                    return near(factor(random.bodies, random.neighbors.of(i)),
                                analytic::pair_dfsph_factor(random.cloud, i), 1);
                })) {
                return false;
            }
        }
        return true;
    };
    BOOST_TEST(holds(reference::dfsph_factor));
    BOOST_TEST(!holds(off_by(fault, reference::dfsph_factor)));
    BOOST_TEST(!holds([](reference::Bodies b, auto neighbors) { // ghosts counted as free
        std::ranges::fill(b.role, reference::Role::free);
        return reference::dfsph_factor(b, neighbors);
    }));
}

namespace
{

/// Whether the pressure and the acceleration that a candidate finds
/// for a cloud satisfy (3), by sums over all pairs.
template <class Candidate>
bool satisfies_both_conditions(Candidate candidate, double beta)
{
    const RandomCloud random(KernelName::cubic_spline);
    analytic::Cloud cloud = random.cloud;
    std::vector<double> rho(cloud.mass.size(), rho_0);
    random.for_all([&](std::size_t i) {
        rho[i] = reference::density(random.bodies, random.neighbors.of(i));
        return true;
    });
    std::ranges::fill(cloud.pressure, 0);
    std::vector<Vec3> a(rho.size());
    const IncompressibleSettings settings{rho_0, 0.3, beta, 1e-3, 1e-2, 20'000};
    const IncompressibleReport report =
        candidate(random.bodies, random.neighbors, std::span<const double>(rho), dt, settings,
                  std::span<double>(cloud.pressure), std::span<Vec3>(a));
    bool good = report.residual_mean <= settings.tolerance && report.residual_max <= settings.max_tolerance;

    good = good && random.for_all([&](std::size_t i) { // a belongs to p, and blood does not pull
        return cloud.pressure[i] >= 0 && near(a[i], analytic::pair_pressure_acceleration(cloud, rho_0, i), 1);
    });
    for (std::size_t i = 0; i < a.size(); ++i) {
        cloud.velocity[i] += dt * Eigen::Vector3d(a[i].x, a[i].y, a[i].z);
    }
    double mean = 0;
    double allowed = 0;
    double count = 0;
    random.for_all([&](std::size_t i) {
        const auto rate = analytic::pair_density_rate(cloud, i);
        const double residual = beta * (rho[i] - rho_0) / dt + rate.value;
        mean += cloud.pressure[i] > 0 || residual > 0 ? std::abs(residual) / rho_0 : 0;
        // twice the bound of (2), and 4 roundings of the density's part
        allowed += (2 * rate.error + rounding(4) * std::abs(rho[i] - rho_0) / dt) / rho_0;
        ++count;
        return true;
    });
    return good &&
           within(report.residual_mean, mean / count, allowed / count + rounding(count) * mean / count);
}

} // namespace

BOOST_AUTO_TEST_CASE(eq03_solution_satisfies_both_conditions)
{
    for (const double beta : {0.0, 0.5}) { // divergence-free; half of the density error taken away as well
        const auto holds = [&](auto candidate) { return satisfies_both_conditions(candidate, beta); };
        BOOST_TEST(holds(solve));
        BOOST_TEST(!holds(solve_with([](auto& s) { s.density_correction += 1e-9; })));
        BOOST_TEST(!holds(solve_with([](auto& s) { s.rho_0 *= 1 + fault; })));
        BOOST_TEST(!holds(solve_with([](auto& s) { s.max_iterations = 3; })));
        BOOST_TEST(!holds([](const auto& b, const auto& neighbors, auto rho, double step,
                             const auto& settings, auto p,
                             auto a) { // an acceleration that isn't that of the pressure
            const auto report = reference::solve_incompressibility(b, neighbors, rho, step, settings, p, a);
            a[0] += Vec3{1e-12 * length(a[0]) * 100, 0, 0};
            return report;
        }));
    }
}

BOOST_AUTO_TEST_CASE(eq03_pressure_acceleration_is_the_adjoint_of_eq02_and_keeps_momentum)
{
    const auto holds = [](auto acceleration) {
        RandomCloud random(KernelName::wendland_c2);
        std::ranges::fill(random.bodies.role, reference::Role::free);
        const reference::Neighbors neighbors(random.bodies, random.kernel,
                                             {random.cloud.period, random.cloud.period, random.cloud.period});
        const auto& b = random.bodies;
        const auto& p = random.cloud.pressure;
        reference::BoundedSum power;
        reference::BoundedVectorSum momentum;
        double size = 0;
        for (std::size_t i = 0; i < b.size(); ++i) {
            const Vec3 a = acceleration(b, neighbors.of(i), std::span<const double>(p), rho_0, i);
            const double rate =
                reference::density_rate(b, neighbors.of(i), std::span<const Vec3>(b.velocity), i);
            power += b.mass[i] * dot(b.velocity[i], a);
            power += b.mass[i] * p[i] * rate / (rho_0 * rho_0);
            momentum += b.mass[i] * a;
            const auto terms = reference::pressure_acceleration<reference::BoundedVectorSum>(
                b, neighbors.of(i), std::span<const double>(p), rho_0, i);
            size += b.mass[i] * (terms.magnitude.x + terms.magnitude.y + terms.magnitude.z);
        }
        // sum m v.a = -sum m p Drho/Dt/rho_0^2 and sum m a = 0 pair by pair: every term is in two bodies'
        // sums, with less than 120 neighbors, 24 operations and 512 bodies; |v| < 1, and (2)'s terms are no
        // more than twice (6)'s
        const double allowed = rounding(120 + 24 + 512) * size;
        return within(power.value, 0, 3 * 2 * allowed) && distance(momentum.value, {}) <= allowed;
    };
    const auto pressure_acceleration = [](const auto&... x) {
        return reference::pressure_acceleration(x...);
    };
    BOOST_TEST(holds(pressure_acceleration));
    BOOST_TEST(
        !holds(off_by(1e-8, pressure_acceleration))); // the bound is that of 512 bodies' terms together
    BOOST_TEST(!holds([&](const auto& b, auto near, const auto&... rest) { // one neighbor of each dropped
        return pressure_acceleration(b, near.subspan(1), rest...);
    }));
}
