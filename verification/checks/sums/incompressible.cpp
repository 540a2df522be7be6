// SPDX-License-Identifier: Apache-2.0
// Section 3.1, (3): the pressure solve of one frame in the periodic box.
// On a full lattice the iteration acts on every wave by itself, by a known factor,
// so that its pressures and the number of its iterations are known beforehand.
#include "analytic/incompressible.hpp"
#include "analytic/kernel_function.hpp"
#include "common/error.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks
{
namespace
{

constexpr double omega = 0.4;
constexpr double never = 1e11; ///< a tolerance that stops nothing [1/s]

/// A wave of velocity v_1 sin(k.r), whose residual is m v_1.G cos(k.r).
struct Push {
    Mode mode;
    Eigen::Vector3d v_1;
};

Scenario solve_scenario(KernelName kernel)
{
    Scenario s = box_scenario(kernel);
    s.fluid.viscosity_pa_s = 0;
    s.pressure.relaxation = omega;
    s.pressure.density_correction = 0;
    s.pressure.max_tolerance_per_s = never;
    return s;
}

/// What the iteration must do to these waves.
analytic::Iteration expected(const Box& box, const std::vector<Push>& pushes, int n)
{
    std::vector<analytic::ResidualWave> waves;
    for (const Push& push : pushes) {
        const analytic::Wave wave{box.wave_vector(push.mode), push.v_1};
        // of v_1 cos(k.r) it is -m v_1.G sin(k.r), a quarter of a turn later that is +cos
        waves.push_back({wave.k, -analytic::density_rate(box.medium(), wave, 1).value, 0.5});
    }
    return analytic::accelerated_waves(box.medium(), omega, box.scenario().time.frame_s, waves, n);
}

void push(Box& box, const std::vector<Push>& pushes, double pressure)
{
    for (const Push& wave : pushes) {
        const auto s = box.wave(wave.mode, -0.25);
        for (std::size_t i = 0; i < s.size(); ++i) {
            box.state().particles.velocity[i] += s[i] * to_vec3(wave.v_1);
        }
    }
    std::ranges::fill(box.state().particles.pressure, pressure);
}

/// Bound of what rounding makes of a pressure: once in an iteration, and after all of them.
struct Rounding {
    double once = 0; ///< [Pa]
    double most = 0; ///< [Pa]
    double mean = 0; ///< in the quadratic mean [Pa]
};
Rounding rounding_of(const Probe& probe, const Box& box, const analytic::Iteration& oracle,
                     const std::vector<Push>& pushes, double start)
{
    constexpr double N = 26; // neighbors with a slope, h/dx = 1
    const double rho_0 = box.medium().density;
    const double alpha = analytic::dfsph_factor(box.medium()).value;
    const double dt = box.scenario().time.frame_s;
    const double slopes = std::sqrt(N * analytic::gradient_square_sum(box.medium().lattice).value);
    double speed = 0;
    for (const Push& wave : pushes) {
        speed += wave.v_1.norm();
    }
    Rounding by;
    const double of_velocity =
        omega * rho_0 * rho_0 * alpha / dt * box.medium().mass * 2 * speed * slopes * probe.gamma(8 + N);
    by.once = omega * N * probe.gamma(2 * (N + 40)) * 2 * 1.5 * start + of_velocity;
    double gain = analytic::error_gain(oracle.theta, 1);
    for (const Mode& mode : box.modes()) {
        const auto g = analytic::step_factor(box.medium().lattice, omega, box.wave_vector(mode));
        gain = std::max(gain, analytic::error_gain(oracle.theta, g.value));
    }
    by.mean = gain * by.once;
    by.most = std::sqrt(static_cast<double>(box.size())) * by.mean;
    return by;
}

constexpr const char* pressure_bound = "the rounding of one iteration times what later iterations make of "
                                       "it, for a single particle sqrt(particles) times that; + the oracle's "
                                       "own error (docs/bounds.md, B5)";

void compare_pressures(Probe& probe, Quantity& pressure, Quantity& decided, const Scenario& s,
                       const std::vector<Push>& pushes, const std::string& where)
{
    Box box(probe, s);
    const auto n = static_cast<int>(s.pressure.max_iterations);
    const auto oracle = expected(box, pushes, n);
    const double start = 2 * oracle.reach;
    push(box, pushes, start);
    const Rounding by = rounding_of(probe, box, oracle, pushes, start);
    const bool is_decided = 2 * by.mean < oracle.margin;
    if (!is_decided && probe.roundoff() > 1e-10) {
        return; // single precision: rounding decides here
    }
    decided.holds(is_decided, where);
    const auto flow = probe.simulate(s, box.state());
    flow->advance();
    double allowed = by.most;
    for (const auto& wave : oracle.pressure.back()) {
        allowed += wave.error;
    }
    std::vector<double> wanted(box.size(), start);
    for (std::size_t w = 0; w < pushes.size(); ++w) {
        const auto c = box.wave(pushes[w].mode);
        for (std::size_t i = 0; i < c.size(); ++i) {
            wanted[i] += oracle.pressure.back()[w].value * c[i];
        }
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        pressure.within(flow->solved_pressure()[i], wanted[i], allowed, where);
    }
}

/// Waves that are sines at no lattice point all 0.
bool swings(const Box& box, const Mode& n)
{
    return std::ranges::any_of(n, [&](int m) { return 2 * m % box.scenario().domain.cells_x != 0; });
}

void each_wave(Probe& probe)
{
    Quantity& pressure = probe.quantity("pressure after 4 iterations [Pa]", Source::rounding, pressure_bound);
    Quantity& decided =
        probe.quantity("restarts decided beyond rounding", Source::exact,
                       "a condition of the comparison: the oracle's margin is larger than the error");
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
        Scenario s = solve_scenario(kernel);
        s.pressure.max_iterations = 4;
        s.pressure.tolerance_per_s = 1e-300;
        const Box box(probe, s);
        const std::vector<Mode> modes = box.modes();
        for (std::size_t m = 0; m < modes.size(); m += kernel == KernelName::cubic_spline ? 1 : 4) {
            const Mode& n = modes[m];
            if (swings(box, n)) {
                compare_pressures(probe, pressure, decided, s, {{n, {0.25, -0.125, 0.375}}},
                                  "wave " + std::to_string(n[0]) + " " + std::to_string(n[1]) + " " +
                                      std::to_string(n[2]));
            }
        }
    }
}

void two_waves(Probe& probe)
{
    Quantity& pressure =
        probe.quantity("pressure after 8 and 12 iterations [Pa]", Source::rounding, pressure_bound);
    Quantity& decided =
        probe.quantity("restarts decided beyond rounding", Source::exact,
                       "a condition of the comparison: the oracle's margin is larger than the error");
    Quantity& restarts = probe.quantity("restarts in the oracle", Source::exact,
                                        "at least one: else the check would not see the restart's rule");
    const std::vector<Push> pushes{{{1, 0, 0}, {0.25, 0, 0}}, {{3, 3, 0}, {0.0625, 0.0625, 0}}};
    for (const int n : {8, 12}) {
        Scenario s = solve_scenario(KernelName::cubic_spline);
        s.pressure.max_iterations = n;
        s.pressure.tolerance_per_s = 1e-300;
        const Box box(probe, s);
        restarts.holds(expected(box, pushes, n).restarts > 0);
        compare_pressures(probe, pressure, decided, s, pushes, std::to_string(n) + " iterations");
    }
    if (pressure.compared() == 0) {
        probe.not_run("in single precision rounding decides when these waves restart");
    }
}

/// Tolerances half-way between what two iterations leave: the solve stops after the second.
void iteration_count(Probe& probe)
{
    Quantity& count = probe.quantity("iterations", Source::exact,
                                     "the tolerance is the geometric mean of two residuals that differ by "
                                     "more than a tenth: far from rounding");
    Quantity& residual = probe.quantity(
        "mean residual where it stops [1/s]", Source::rounding,
        "twice the rounding of the pressures after the iterations, and that of the last evaluation, over "
        "omega rho_0^2 alpha/dt (docs/bounds.md, B6)");
    const Scenario s = solve_scenario(KernelName::cubic_spline);
    const std::vector<Push> pushes{{{1, 0, 0}, {0.25, 0, 0}}};
    Box box(probe, s);
    const auto oracle = expected(box, pushes, 30);
    const double start = 2 * oracle.reach;
    push(box, pushes, start);
    double mean = 0;
    for (const double c : box.wave({1, 0, 0})) {
        mean += std::abs(c) / static_cast<double>(box.size());
    }
    const double per_residual = omega * std::pow(box.medium().density, 2) *
                                analytic::dfsph_factor(box.medium()).value / s.time.frame_s;
    const Rounding by = rounding_of(probe, box, oracle, pushes, start);
    Plot plot{"Residual of (3) over the iterations", "iteration", "mean residual [1/s]", false, true, {}};
    Series predicted{"predicted", {}, {}, true};
    Series found{"found", {}, {}, false};
    double lowest = std::abs(oracle.residual[0][0].value);
    for (std::size_t n = 1; n < oracle.residual.size(); ++n) {
        const double left = std::abs(oracle.residual[n][0].value);
        predicted.x.push_back(static_cast<double>(n));
        predicted.y.push_back(mean * left / box.medium().density);
        const double noise = (2 * by.mean + by.once) / per_residual;
        if (left < 4 * noise) {
            break; // from here on rounding decides
        }
        if (left >= 0.9 * lowest) {
            continue; // the momentum carried it past 0
        }
        Scenario stop = s;
        stop.pressure.tolerance_per_s = mean / box.medium().density * std::sqrt(left * lowest);
        lowest = left;
        const auto flow = probe.simulate(stop, box.state());
        const FrameRecord record = flow->advance();
        const std::string where = "iteration " + std::to_string(n);
        count.equal(record.iterations, static_cast<std::int64_t>(n), where);
        residual.within(record.residual_mean, mean * left / box.medium().density,
                        (noise + oracle.residual[n][0].error) / box.medium().density, where);
        found.x.push_back(static_cast<double>(n));
        found.y.push_back(record.residual_mean);
    }
    plot.series = {predicted, found};
    probe.plot(std::move(plot));
    if (count.compared() == 0) {
        probe.not_run("in single precision rounding decides where this solve stops");
    }
}

/// A relaxation above 4/3 of the inverse of the largest eigenvalue is refused, one below is not.
void relaxation_limit(Probe& probe)
{
    Quantity& refused = probe.quantity("refusals", Source::truncation,
                                       "the subject's limit is 0.05 to 0.2 % below the exact one, which the "
                                       "test leaves room for (docs/bounds.md, B8)");
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
        for (const double ratio : {1.0, 1.2, 1.3}) {
            Scenario s = box_scenario(kernel, ratio);
            const double dx = s.domain.spacing_m;
            const double limit = analytic::relaxation_limit({kernel, ratio * dx, dx}).value;
            const auto is_refused = [&](double relaxation) {
                s.pressure.relaxation = relaxation;
                try {
                    static_cast<void>(probe.simulate(s));
                } catch (const InputError&) {
                    return true;
                }
                return false;
            };
            refused.holds(is_refused(1.0001 * limit), "above, h/dx " + std::to_string(ratio));
            refused.holds(!is_refused(0.998 * limit), "below, h/dx " + std::to_string(ratio));
        }
    }
}

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

std::vector<Check> incompressible_checks()
{
    return {
        sum_check("eq03_waves", {"3"}, "the iteration changes every wave of a lattice by its own factor",
                  {"two-term recurrence with the symbol g(k)"}, each_wave),
        sum_check("eq03_restarts", {"3"}, "two waves restart the momentum together when their sum goes back",
                  {"two-term recurrence of two waves"}, two_waves),
        sum_check("eq03_iteration_count", {"3"}, "the solve stops in the iteration that was predicted",
                  {"two-term recurrence with the symbol g(k)"}, iteration_count),
        sum_check("eq03_relaxation_limit", {"3"},
                  "a relaxation beyond the stability limit is refused, one below is not",
                  {"largest eigenvalue by search over the Brillouin zone (gsl_multimin)"}, relaxation_limit),
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
