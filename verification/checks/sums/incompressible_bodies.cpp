// SPDX-License-Identifier: Apache-2.0
// Section 3.1, (3): the pressure solve particle by particle, in disturbed clouds, where all pairs are summed up,
// and of two particles alone, whose pressures are an iteration of one number.
#include "analytic/incompressible.hpp"
#include "analytic/kernel_function.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/sums/incompressible.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks
{
namespace
{

/// beta (rho - rho_0)/dt: what the density of a disturbed cloud adds,
/// when nothing moves and no iteration is made.
void density_part(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& residual =
        probe.quantity("mean and largest residual before the first iteration [1/s]", Source::rounding,
                       "the bound of the sum (5) over pairs times beta/dt, for oracle and subject, and "
                       "gamma_8 of the residual");
    for (const double beta : {0.25, 1.0}) {
        Scenario s = box_scenario();
        s.pressure.density_correction = beta;
        s.pressure.tolerance_per_s = never;
        s.pressure.max_tolerance_per_s = never;
        Box box(probe, s);
        box.disturb(0.2, 0, 2442);
        const auto flow = probe.simulate(s, box.state());
        const FrameRecord record = flow->advance();
        const auto cloud = box.cloud(box.state(), flow->density());
        double mean = 0;
        double largest = 0;
        double error = 0;
        for (std::size_t i = 0; i < box.size(); ++i) {
            const auto rho = analytic::pair_density(cloud, i);
            // where the pressure can act: p = 0 and compressed
            const double r = std::max(0.0, beta * (rho.value / s.fluid.density_kg_m3 - 1) / s.time.frame_s);
            mean += r / static_cast<double>(box.size());
            largest = std::max(largest, r);
            error = std::max(error, beta * both(rho.error, u) / s.fluid.density_kg_m3 / s.time.frame_s);
        }
        const double allowed = error + probe.gamma(8) * largest;
        residual.within(record.residual_mean, mean, allowed, "mean, beta " + std::to_string(beta));
        residual.within(record.residual_max, largest, allowed, "largest, beta " + std::to_string(beta));
    }
}

/// What the solve promises: pressures p >= 0 whose velocity obeys (3), and no force where it isn't needed.
void solves_a_cloud(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& mean =
        probe.quantity("mean residual by all pairs [1/s]", Source::solver,
                       "the tolerance of the solve, + the bounds of the sums (5), (2) by all pairs");
    Quantity& sign = probe.quantity("pressures below 0", Source::exact, "none: blood does not pull");
    Quantity& velocity = probe.quantity("velocity by the solved pressures [m/s]", Source::rounding,
                                        "dt times the bound of the sum of the pressure's acceleration over "
                                        "all pairs, for oracle and subject, + gamma_4 |v|");
    Scenario s = box_scenario();
    s.pressure.density_correction = 0.5;
    s.pressure.tolerance_per_s = 0.01;
    s.pressure.max_tolerance_per_s = 1;
    s.fluid.viscosity_pa_s = 0;
    const double dt = s.time.frame_s;
    const double rho_0 = s.fluid.density_kg_m3;
    Box box(probe, s);
    box.disturb(0.2, 0.25, 2443);
    std::ranges::fill(box.state().particles.pressure, 0.0);
    const auto flow = probe.simulate(s, box.state());
    flow->advance();
    auto cloud = box.cloud(box.state(), flow->density());
    cloud.pressure = flow->solved_pressure();
    auto after = cloud;
    for (std::size_t i = 0; i < box.size(); ++i) {
        const auto a = analytic::pair_pressure_acceleration(cloud, rho_0, i);
        const Vec3& v_0 = box.state().particles.velocity[i];
        const Vec3& v = flow->state().particles.velocity[i];
        velocity.within(v, v_0 + dt * to_vec3(a.value),
                        dt * both(a.error, u) + probe.gamma(4) * (length(v_0) + length(v)),
                        "particle " + std::to_string(i));
        after.velocity[i] = to_eigen(v);
        sign.holds(cloud.pressure[i] >= 0);
    }
    double residual = 0;
    double error = 0;
    for (std::size_t i = 0; i < box.size(); ++i) {
        const auto rho = analytic::pair_density(cloud, i);
        const auto rate = analytic::pair_density_rate(after, i);
        const double r = s.pressure.density_correction * (rho.value - rho_0) / dt + rate.value;
        residual +=
            cloud.pressure[i] > 0 || r > 0 ? std::abs(r) / rho_0 / static_cast<double>(box.size()) : 0;
        error = std::max(error, both(s.pressure.density_correction * rho.error / dt + rate.error, u) / rho_0);
    }
    mean.within(residual, 0, s.pressure.tolerance_per_s + error);
}

/// A solve goes on from the pressures that it is given; blood without one starts from its neighbors' mean.
void start_of_the_solve(Probe& probe)
{
    Quantity& known = probe.quantity("pressures that the solve starts from [Pa]", Source::exact,
                                     "bits: as they were given, where no iteration is made");
    Quantity& mean = probe.quantity("pressures of blood that had none [Pa]", Source::rounding,
                                    "gamma_n of a mean of n pressures >= 0; 0 where no neighbor has one");
    Scenario s = box_scenario();
    s.pressure.tolerance_per_s = never;
    s.pressure.max_tolerance_per_s = never;
    s.fluid.viscosity_pa_s = 0;
    Box box(probe, s);
    box.disturb(0.2, 0, 2447);
    std::vector<double>& given = box.state().particles.pressure;
    for (std::size_t i = 0; i < given.size(); ++i) {
        given[i] = i % 3 == 0 || i < 128 ? -1 : static_cast<double>(1 + i * i % 1021); // -1: none
    }
    const auto flow = probe.simulate(s, box.state());
    flow->advance();
    const auto cloud = box.cloud(box.state(), flow->density());
    for (std::size_t i = 0; i < box.size(); ++i) {
        const std::string where = "particle " + std::to_string(i);
        if (given[i] >= 0) {
            known.within(flow->solved_pressure()[i], given[i], 0, where);
            continue;
        }
        double sum = 0;
        double n = 0;
        for (const std::size_t j : analytic::pair_neighbors(cloud, i)) {
            sum += given[j] >= 0 ? given[j] : 0;
            n += given[j] >= 0 ? 1 : 0;
        }
        const double expected = n > 0 ? sum / n : 0;
        mean.within(flow->solved_pressure()[i], expected, probe.gamma(n + 2) * expected, where);
    }
}

/// From no pressure, one iteration: each particle's residual by its own DFSPH factor.
void first_iteration(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& pressure = probe.quantity(
        "pressure after one iteration from 0 [Pa]", Source::rounding,
        "omega rho_0^2/dt times the bounds of the residual's sums (5) and (2) times alpha, and of alpha's "
        "sums times the residual, for oracle and subject, + gamma_12 of the product and of its two terms");
    Quantity& acting = probe.quantity("particles that are pressed", Source::exact,
                                      "a claim: some are and some aren't, else half of the rule isn't seen");
    Scenario s = solve_scenario(KernelName::cubic_spline);
    s.pressure.tolerance_per_s = 1e-300;
    s.pressure.max_iterations = 1;
    const double dt = s.time.frame_s;
    const double rho_0 = s.fluid.density_kg_m3;
    const double factor = omega * rho_0 * rho_0 / dt;
    Box box(probe, s); // a start that corrects densities would settle first
    s.pressure.density_correction = 0.5;
    box.disturb(0.25, 0.25, 2448);
    std::ranges::fill(box.state().particles.pressure, 0.0);
    const auto flow = probe.simulate(s, box.state());
    flow->advance();
    const auto cloud = box.cloud(box.state(), flow->density());
    std::size_t pressed = 0;
    for (std::size_t i = 0; i < box.size(); ++i) {
        const auto rho = analytic::pair_density(cloud, i);
        const auto rate = analytic::pair_density_rate(cloud, i);
        const auto alpha = analytic::pair_dfsph_factor(cloud, i);
        const double beta = s.pressure.density_correction;
        const double of_density = beta * (rho.value - rho_0) / dt;
        const double residual = of_density + rate.value;
        const double error = beta * both(rho.error, u) / dt + both(rate.error, u) +
                             probe.gamma(12) * (std::abs(of_density) + std::abs(rate.value));
        pressure.within(flow->solved_pressure()[i], std::max(0.0, factor * alpha.value * residual),
                        factor *
                            (alpha.value * error + (both(alpha.error, u) + probe.gamma(12) * alpha.value) *
                                                       (std::abs(residual) + error)),
                        "particle " + std::to_string(i));
        pressed += residual > 0 ? 1 : 0;
    }
    acting.holds(pressed > 0 && pressed < box.size());
}

/// Two particles a spacing apart, and nobody else.
struct TwoParticles {
    Box box;
    std::vector<std::size_t> who;

    TwoParticles(const Probe& probe, const Scenario& s, double pressure, double approach) : box(probe, s)
    {
        box.keep_drop(2);
        Particles& p = box.state().particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec3 x = p.position[i] - box.middle();
            const bool kept = p.kind[i] == Kind::fluid && x.y < 0 && x.z < 0;
            p.kind[i] = kept ? Kind::fluid : Kind::reserve;
            p.pressure[i] = kept ? pressure : 0;
            if (kept) {
                p.velocity[i].x = x.x < 0 ? approach / 2 : -approach / 2;
                who.push_back(i);
            }
        }
    }
};

/// Pressures that the step alone takes below 0 in the first iteration, and those that the momentum takes there
/// in the fourth.
void two_bodies(Probe& probe)
{
    Quantity& pressure = probe.quantity(
        "pressure of two particles [Pa]", Source::rounding,
        "the rounding of two changes of at most 2 p, times what later iterations make of it; + the oracle's "
        "own error (docs/bounds.md, B5)");
    Quantity& floor = probe.quantity("pressures that end at 0", Source::exact,
                                     "a claim: each kernel's once, else the check would not see the floor");
    constexpr double start = 1000;       // [Pa]
    constexpr double approach = 0x1p-11; // speed at which they come nearer [m/s]
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
        Scenario s = solve_scenario(kernel);
        s.pressure.relaxation = kernel == KernelName::cubic_spline ? 0.25 : 0.508; // g = 0.5 and -0.016
        s.pressure.tolerance_per_s = 1e-300;
        int at_zero = 0;
        for (int n = 1; n <= 6; ++n) {
            s.pressure.max_iterations = n;
            const TwoParticles two(probe, s, start, approach);
            const analytic::Medium& medium = two.box.medium();
            const double h = medium.lattice.h;
            const double rate = -medium.mass * analytic::kernel_slope(kernel, h, h) * approach;
            const auto oracle =
                analytic::accelerated_two_bodies({kernel, h, h, medium.mass, medium.density, start, rate},
                                                 s.pressure.relaxation, s.time.frame_s, n);
            const double once = probe.gamma(2 * 40 + 16) * 4 * std::max(oracle.reach, start);
            const double error =
                analytic::error_gain(oracle.theta, -std::abs(1 - 2 * s.pressure.relaxation)) * once;
            if (2 * error >= oracle.margin) {
                break; // from here on rounding decides about a restart
            }
            const auto flow = probe.simulate(s, two.box.state());
            flow->advance();
            const analytic::Estimate expected = oracle.pressure.back()[0];
            for (const std::size_t i : two.who) {
                pressure.within(flow->solved_pressure()[i], expected.value, expected.error + error,
                                "iteration " + std::to_string(n));
            }
            at_zero += expected.value == 0 ? 1 : 0;
        }
        floor.equal(at_zero, 1);
    }
}

} // namespace

std::vector<Check> incompressible_bodies_checks()
{
    return {
        sum_check("eq03_density_part", {"3"},
                  "the density's part of (3) is beta times its error over the step",
                  {"brute force over all pairs"}, density_part),
        sum_check("eq03_start", {"3"},
                  "a solve starts from the last step's pressures, or from the neighbors' mean",
                  {"the pressures given", "brute force over all pairs"}, start_of_the_solve),
        sum_check("eq03_factor", {"3"},
                  "in a disturbed cloud each particle answers its residual by its own DFSPH factor",
                  {"brute force over all pairs"}, first_iteration),
        sum_check("eq03_two_bodies", {"3"},
                  "the pressures of two particles do not pass 0, by the step or by the momentum",
                  {"iteration of one number"}, two_bodies),
        sum_check("eq03_cloud", {"3"},
                  "a disturbed cloud's solution obeys (3), pulls nowhere and moves the blood by its pressure",
                  {"brute force over all pairs"}, solves_a_cloud),
    };
}

} // namespace aneurysm::checks
