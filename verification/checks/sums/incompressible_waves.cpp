// SPDX-License-Identifier: Apache-2.0
// Section 3.1, (3): the solves of one frame in the periodic box.
// On a full lattice the iteration acts on every wave by itself, by a known factor,
// so that its pressures and the number of its iterations are known beforehand.
#include "analytic/incompressible.hpp"
#include "common/error.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/sums/incompressible.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks
{
namespace
{

/// A wave of velocity v_1 sin(k.r), whose residual is m v_1.G cos(k.r).
struct Push {
    Mode mode;
    Eigen::Vector3d v_1;
};

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
constexpr double N = 26; // neighbors with a slope, h/dx = 1

/// After iterations with these theta, each off by `once`.
Rounding rounding_after(const Box& box, const std::vector<double>& theta, double once)
{
    double gain = analytic::error_gain(theta, 1);
    for (const Mode& mode : box.modes()) {
        const auto g = analytic::step_factor(box.medium().lattice, omega, box.wave_vector(mode));
        gain = std::max(gain, analytic::error_gain(theta, g.value));
    }
    return {once, std::sqrt(static_cast<double>(box.size())) * gain * once, gain * once};
}

Rounding rounding_of(const Probe& probe, const Box& box, const analytic::Iteration& oracle,
                     const std::vector<Push>& pushes, double start)
{
    const double rho_0 = box.medium().density;
    const double alpha = analytic::dfsph_factor(box.medium()).value;
    const double dt = box.scenario().time.frame_s;
    const double slopes = std::sqrt(N * analytic::gradient_square_sum(box.medium().lattice).value);
    double speed = 0;
    for (const Push& wave : pushes) {
        speed += wave.v_1.norm();
    }
    const double of_velocity =
        omega * rho_0 * rho_0 * alpha / dt * box.medium().mass * 2 * speed * slopes * probe.gamma(8 + N);
    return rounding_after(box, oracle.theta,
                          omega * N * probe.gamma(2 * (N + 40)) * 2 * 1.5 * start + of_velocity);
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

/// A wave of kappa on blood at rest, whose density is right: each iteration leaves g(k) of it, but for the momentum.
void correction_waves(Probe& probe)
{
    constexpr int n = 4;
    constexpr double start = 0x1p16; // [Pa]
    Quantity& kappa = probe.quantity(
        "kappa after 4 iterations [Pa]", Source::rounding,
        "the rounding of one iteration, with gamma_100 beta rho_0/dt of the density's part times omega rho_0^2 "
        "alpha/dt, times what later iterations make of it, for a single particle sqrt(particles) times that; + the "
        "oracle's own error (docs/bounds.md, B5)");
    Quantity& decided =
        probe.quantity("restarts decided beyond rounding", Source::exact,
                       "a condition of the comparison: the oracle's margin is larger than the error");
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
        Scenario s = without_iterations(solve_scenario(kernel), 1);
        s.pressure.correction_tolerance_per_s = 1e-300;
        s.pressure.correction_max_iterations = n;
        Box box(probe, s);
        const double rho_0 = box.medium().density;
        const double dt = s.time.frame_s;
        const double per_residual = omega * rho_0 * rho_0 * analytic::dfsph_factor(box.medium()).value / dt;
        const double once =
            omega * N * probe.gamma(2 * (N + 40)) * 2 * start + per_residual * probe.gamma(100) * rho_0 / dt;
        const std::vector<Mode> modes = box.modes();
        for (std::size_t m = 0; m < modes.size(); m += kernel == KernelName::cubic_spline ? 1 : 4) {
            if (!swings(box, modes[m])) {
                continue;
            }
            const auto k = box.wave_vector(modes[m]);
            const auto g = analytic::step_factor(box.medium().lattice, omega, k);
            const double residual = -(1 - g.value) * start / per_residual;
            const auto oracle = analytic::accelerated_waves(
                box.medium(), omega, dt, std::vector{analytic::ResidualWave{k, residual, 0.5}}, n);
            const Rounding by = rounding_after(box, oracle.theta, once + (g.error + 4 * rounding(1)) * start);
            const std::string where = "wave " + std::to_string(modes[m][0]) + " " +
                                      std::to_string(modes[m][1]) + " " + std::to_string(modes[m][2]);
            const bool is_decided = 2 * by.mean < oracle.margin;
            if (!is_decided && probe.roundoff() > 1e-10) {
                continue; // single precision: rounding decides here
            }
            decided.holds(is_decided, where);
            const auto c = box.wave(modes[m]);
            for (std::size_t i = 0; i < c.size(); ++i) {
                box.state().particles.kappa[i] = start * c[i];
            }
            const auto flow = probe.simulate(s, box.state());
            flow->advance();
            const analytic::Estimate change = oracle.pressure.back()[0];
            for (std::size_t i = 0; i < c.size(); ++i) {
                kappa.within(flow->solved_kappa()[i], (start + change.value) * c[i],
                             by.most + change.error + probe.gamma(2) * start, where);
            }
        }
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

/// The strongest shifts that a scenario may ask for are weaker than those that would make a lattice's disorder grow.
void shift_limit(Probe& probe)
{
    constexpr double strongest = 0.25; // of pressure.shifting
    Quantity& below = probe.quantity("strongest shift below the limit of the lattice", Source::exact,
                                     "a claim, with a hundredth to spare for the oracle's 1e-3");
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
        for (const double ratio : {0.8, 0.9, 1.0, 1.1, 1.2, 1.3, 1.5, 2.0}) {
            const double limit = analytic::shift_limit({kernel, ratio, 1});
            const std::string where =
                std::string(kernel == KernelName::cubic_spline ? "cubic spline" : "Wendland C2") + ", h/dx " +
                std::to_string(ratio);
            probe.note("strength of a shift from which on disorder grows, " + where, limit);
            below.holds(1.01 * strongest < limit, where);
        }
    }
    const auto refused = [](double strength) {
        Scenario s = shipped_scenario("paper_tc1");
        s.pressure.shifting = strength;
        try {
            static_cast<void>(parse_scenario(to_json(s), "a scenario"));
        } catch (const InputError&) {
            return true;
        }
        return false;
    };
    below.holds(!refused(strongest) && refused(1.001 * strongest), "as scenarios may have it");
}

} // namespace

std::vector<Check> incompressible_waves_checks()
{
    return {
        sum_check("eq03_waves", {"3"}, "the iteration changes every wave of a lattice by its own factor",
                  {"two-term recurrence with the symbol g(k)"}, each_wave),
        sum_check("eq03_correction_waves", {"3"},
                  "the iteration of the density's correction changes every wave by the same factor",
                  {"two-term recurrence with the symbol g(k)"}, correction_waves),
        sum_check("eq03_restarts", {"3"}, "two waves restart the momentum together when their sum goes back",
                  {"two-term recurrence of two waves"}, two_waves),
        sum_check("eq03_iteration_count", {"3"}, "the solve stops in the iteration that was predicted",
                  {"two-term recurrence with the symbol g(k)"}, iteration_count),
        sum_check("eq03_shift_limit", {"3"},
                  "no scenario may ask for shifts by which the disorder of a lattice would grow",
                  {"largest eigenvalue of the lattice's response over the Brillouin zone"}, shift_limit),
        sum_check("eq03_relaxation_limit", {"3"},
                  "a relaxation beyond the stability limit is refused, one below is not",
                  {"largest eigenvalue by search over the Brillouin zone (gsl_multimin)"}, relaxation_limit),
    };
}

} // namespace aneurysm::checks
