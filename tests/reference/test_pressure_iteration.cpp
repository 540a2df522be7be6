// SPDX-License-Identifier: Apache-2.0
// Section 3.1, (3): the iteration of the pressure solve, known wave by wave on a lattice and number by number
// for two bodies.
#include "analytic/incompressible.hpp"
#include "reference/incompressible.hpp"
#include "tests/periodic.hpp"

#include <limits>

using namespace aneurysm;
using namespace aneurysm::test;
using reference::Bodies;
using reference::IncompressibleReport;
using reference::IncompressibleSettings;
using reference::Neighbors;

namespace
{

constexpr double dt = 1e-3;
constexpr double rho_0 = PeriodicLattice::rho;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr int edge = 8;

/// What a test may plant in the iteration.
struct Faults {
    double omega = 1; ///< times the scenario's
    double theta = 1; ///< times the right one
    bool restart = true;
    bool weighted = true; ///< the restart's sum is over alpha
    bool clamp_p = true;
    bool clamp_y = true;
    int more = 0; ///< iterations
};

/// The iteration once more, until the mean residual is within the tolerance, with faults. Without them it has
/// the reference's bits; its report counts no clamped pressure out.
auto planted(const Faults& faults)
{
    return [=](const Bodies& b, const Neighbors& neighbors, std::span<const double> rho, double step,
               const IncompressibleSettings& s, std::span<double> y, std::span<Vec3> a) {
        std::vector<double> residual(b.size());
        std::vector<double> p(y.begin(), y.end());
        std::vector<Vec3> v = b.velocity;
        const double factor = faults.omega * s.relaxation * s.rho_0 * s.rho_0 / step;
        double t = 1;
        for (std::int64_t n = 0;; ++n) {
            for (std::size_t i = 0; i < b.size(); ++i) {
                a[i] = reference::pressure_acceleration(b, neighbors.of(i), y, s.rho_0, i);
                v[i] = b.free(i) ? b.velocity[i] + step * a[i] : b.velocity[i];
            }
            double mean = 0;
            for (std::size_t i = 0; i < b.size(); ++i) {
                residual[i] = s.density_correction * (rho[i] - s.rho_0) / step +
                              reference::density_rate(b, neighbors.of(i), std::span<const Vec3>(v), i);
                mean += std::abs(residual[i]) / s.rho_0 / static_cast<double>(b.size());
            }
            if (n >= s.max_iterations + faults.more || mean <= s.tolerance) {
                return IncompressibleReport{n, mean, 0, 0, 0};
            }
            double test = 0;
            const std::vector<double> p_old = p;
            for (std::size_t i = 0; i < b.size(); ++i) {
                if (b.free(i)) {
                    const double alpha = reference::dfsph_factor(b, neighbors.of(i));
                    p[i] = y[i] + factor * alpha * residual[i];
                    p[i] = faults.clamp_p ? std::max(0.0, p[i]) : p[i];
                    test += (y[i] - p[i]) * (p[i] - p_old[i]) / (faults.weighted ? alpha : 1);
                }
            }
            t = faults.restart && test > 0 ? 1 : t;
            const double next = (1 + std::sqrt(1 + 4 * t * t)) / 2;
            const double theta = faults.theta * (t - 1) / next;
            t = next;
            for (std::size_t i = 0; i < b.size(); ++i) {
                y[i] = p[i] + theta * (p[i] - p_old[i]);
                y[i] = faults.clamp_y ? std::max(0.0, y[i]) : y[i];
            }
        }
    };
}

constexpr auto solve = [](const auto&... x) { return reference::solve_incompressibility(x...); };

/// A wave of the density, whose residual without correction is rho_0 size/dt cos k.r.
struct DensityWave {
    Mode mode;
    double size = 0;
};

std::vector<double> densities(const PeriodicLattice& flow, const std::vector<DensityWave>& waves)
{
    std::vector<double> rho(flow.bodies.size(), rho_0);
    for (const DensityWave& wave : waves) {
        const auto c = flow.wave(wave.mode);
        for (std::size_t i = 0; i < rho.size(); ++i) {
            rho[i] += rho_0 * wave.size * c[i];
        }
    }
    return rho;
}

analytic::Iteration expected(const PeriodicLattice& flow, const std::vector<DensityWave>& waves, double omega,
                             double beta, int n)
{
    std::vector<analytic::ResidualWave> residuals;
    for (const DensityWave& wave : waves) {
        const bool is_real = std::ranges::all_of(wave.mode, [](int m) { return 2 * m % edge == 0; });
        residuals.push_back(
            {flow.wave_vector(wave.mode), beta * rho_0 * wave.size / dt, is_real ? 1.0 : 0.5});
    }
    return analytic::accelerated_waves(flow.medium, omega, dt, residuals, n);
}

/// What rounding does to the reference's pressures [Pa].
struct Rounding {
    double once = 0; ///< in one iteration, to any body
    double mean = 0; ///< after all of them, in the quadratic mean
    double most = 0; ///< after all of them, to any body

    Rounding(const PeriodicLattice& flow, const analytic::Iteration& oracle, std::size_t waves, double omega,
             double beta, double start)
    {
        // An iteration rounds the two sums over N neighbors, of terms up to 2 p with p <= 1.5 start; alpha
        // times the square of the gradients' sum is at most N/m^2, so that each may be wrong by omega N
        // (N + 40) 2 u of 2 p. rho is rounded twice for each wave, and once with rho_0.
        const auto& lattice = flow.medium.lattice;
        const auto N = static_cast<double>(flow.neighbors.of(0).size());
        const auto bodies = static_cast<double>(flow.bodies.size());
        const double of_rho = pressure_of_residual(flow, omega) * beta * rho_0 / dt *
                              rounding(2 * static_cast<double>(waves) + 2);
        once = omega * N * rounding(2 * (N + 40)) * 2 * 1.5 * start + of_rho;
        // what it becomes in the box's modes, a uniform pressure (g = 1) among them; no body has more than
        // sqrt(bodies) times the quadratic mean
        double gain = analytic::error_gain(oracle.theta, 1);
        for (const Mode& mode : modes(edge)) {
            const auto g = analytic::step_factor(lattice, omega, flow.wave_vector(mode));
            gain = std::max(gain, analytic::error_gain(oracle.theta, g.value));
        }
        mean = gain * once;
        most = std::sqrt(bodies) * mean;
    }

    /// What a step changes a pressure by, over the residual.
    static double pressure_of_residual(const PeriodicLattice& flow, double omega)
    {
        return omega * rho_0 * rho_0 * analytic::dfsph_factor(flow.medium).value / dt;
    }
};

/// n iterations from a uniform pressure, large enough that none is
/// clamped: pressures, restarts and the residual.
template <class Candidate>
bool follows_its_waves(Candidate candidate, const PeriodicLattice& flow,
                       const std::vector<DensityWave>& waves, double omega, int n)
{
    const double beta = 0.7;
    const auto oracle = expected(flow, waves, omega, beta, n);
    const double start = 2 * oracle.reach;
    const auto rho = densities(flow, waves);
    std::vector<double> p(rho.size(), start);
    std::vector<Vec3> a(rho.size());
    candidate(flow.bodies, flow.neighbors, std::span<const double>(rho), dt,
              IncompressibleSettings{rho_0, omega, beta, 0, 0, n}, std::span<double>(p), std::span<Vec3>(a));

    const Rounding by(flow, oracle, waves.size(), omega, beta, start);
    double allowed = by.most;
    for (const auto& pressure : oracle.pressure.back()) {
        allowed += pressure.error;
    }
    // the restart tests are decided: their sums round too, as if the pressures' differences did by this part
    const auto alpha = analytic::dfsph_factor(flow.medium);
    const double of_test =
        (rounding(static_cast<double>(rho.size()) + 8) + 2 * alpha.error / alpha.value) * oracle.reach;
    BOOST_TEST_REQUIRE(2 * by.mean + of_test < oracle.margin);

    std::vector<double> wanted(rho.size(), start);
    for (std::size_t w = 0; w < waves.size(); ++w) {
        const auto c = flow.wave(waves[w].mode);
        for (std::size_t i = 0; i < c.size(); ++i) {
            wanted[i] += oracle.pressure.back()[w].value * c[i];
        }
    }
    double error = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        error = std::max(error, std::abs(p[i] - wanted[i]));
    }
    BOOST_TEST_MESSAGE("    error " << error << " / " << allowed << " allowed, of " << oracle.reach << ", "
                                    << oracle.restarts << " restarts");
    return error <= allowed;
}

} // namespace

BOOST_AUTO_TEST_CASE(eq03_iteration_follows_each_mode)
{
    const auto holds = [](auto candidate) {
        for (const KernelName name : {KernelName::cubic_spline, KernelName::wendland_c2}) {
            const PeriodicLattice flow({edge, edge, edge}, name, 1);
            for (const Mode& mode : modes(edge)) {
                // 0.4 is below the limit of both kernels, 0.95 above it
                if (!follows_its_waves(candidate, flow, {{mode, 0.01}}, 0.4, 4) ||
                    !follows_its_waves(candidate, flow, {{mode, 0.01}}, 0.95, 4)) {
                    return false;
                }
            }
        }
        return true;
    };
    BOOST_TEST(holds(solve));
    BOOST_TEST(holds(planted({})));
    BOOST_TEST(!holds(planted({.omega = 1 + 1e-7})));
    BOOST_TEST(!holds(planted({.theta = 1 + 1e-7})));
    BOOST_TEST(!holds(planted({.theta = 0})));
    BOOST_TEST(!holds(planted({.more = 1})));
}

BOOST_AUTO_TEST_CASE(eq03_restarts_when_the_waves_together_go_back)
{
    const PeriodicLattice flow({edge, edge, edge}, KernelName::cubic_spline, 1);
    const DensityWave slow{{1, 0, 0}, 0.01};
    const DensityWave fast{{3, 3, 0}, 0.003};
    const double omega = 0.4;
    for (const int n : {8, 12}) {
        // they restart in other iterations than each alone
        const auto together = expected(flow, {slow, fast}, omega, 1, n);
        BOOST_TEST(together.restarts > 0);
        BOOST_TEST(together.theta != expected(flow, {slow}, omega, 1, n).theta);
        BOOST_TEST(together.theta != expected(flow, {fast}, omega, 1, n).theta);

        const auto holds = [&](auto candidate) {
            return follows_its_waves(candidate, flow, {slow, fast}, omega, n);
        };
        BOOST_TEST(holds(solve));
        BOOST_TEST(holds(planted({})));
        BOOST_TEST(!holds(planted({.restart = false})));
        BOOST_TEST(!holds(planted({.theta = 1 + 1e-5})));
        BOOST_TEST(!holds(planted({.omega = 1 + 1e-5})));
        BOOST_TEST(!holds(planted({.more = 1})));
    }
}

BOOST_AUTO_TEST_CASE(eq03_stops_after_the_predicted_iterations)
{
    const PeriodicLattice flow({edge, edge, edge}, KernelName::cubic_spline, 1);
    const DensityWave wave{{1, 0, 0}, 0.01};
    const double omega = 0.4;
    const auto oracle = expected(flow, {wave}, omega, 1, 30);
    const auto rho = densities(flow, {wave});
    double mean = 0; // of |cos k.r|
    for (const double c : flow.wave(wave.mode)) {
        mean += std::abs(c) / static_cast<double>(rho.size());
    }
    int stops = 0;
    const auto holds = [&](auto candidate) {
        stops = 0;
        double lowest = std::abs(oracle.residual[0][0].value);
        for (std::size_t n = 1; n < oracle.residual.size(); ++n) {
            const double left = std::abs(oracle.residual[n][0].value);
            if (left >= 0.9 * lowest) {
                continue; // the momentum carried it past 0
            }
            // half-way between what the iterations before and this one
            // leave, far from rounding on either side
            const double tolerance = mean / rho_0 * std::sqrt(left * lowest);
            lowest = left;
            std::vector<double> p(rho.size(), 2 * oracle.reach);
            std::vector<Vec3> a(rho.size());
            const IncompressibleReport report =
                candidate(flow.bodies, flow.neighbors, std::span<const double>(rho), dt,
                          IncompressibleSettings{rho_0, omega, 1, tolerance, never, 1000},
                          std::span<double>(p), std::span<Vec3>(a));
            if (report.iterations != static_cast<std::int64_t>(n)) {
                return false;
            }
            ++stops;
        }
        return true;
    };
    BOOST_TEST(holds(solve));
    BOOST_TEST_MESSAGE("    " << stops << " predictions, " << oracle.restarts << " restarts");
    BOOST_TEST(stops >= 10);
    BOOST_TEST(oracle.restarts > 0);
    BOOST_TEST(holds(planted({})));
    BOOST_TEST(!holds(planted({.omega = 1.05})));
    BOOST_TEST(!holds(planted({.theta = 0.95})));
    BOOST_TEST(!holds(planted({.restart = false})));
    BOOST_TEST(!holds([](const auto& b, const auto& neighbors, auto rho_i, double step,
                         IncompressibleSettings settings, auto p, auto a) {
        settings.tolerance *= 0.5;
        return reference::solve_incompressibility(b, neighbors, rho_i, step, settings, p, a);
    }));
}

BOOST_AUTO_TEST_CASE(eq03_diverges_above_the_relaxation_limit_and_not_below)
{
    const PeriodicLattice flow({edge, edge, edge}, KernelName::cubic_spline, 1);
    const double limit = analytic::relaxation_limit(flow.medium.lattice).value;
    double worst = 0;
    Mode mode{};
    for (const Mode& n : modes(edge)) {
        const double damped = 1 - analytic::step_factor(flow.medium.lattice, 1, flow.wave_vector(n)).value;
        if (damped > worst) {
            worst = damped;
            mode = n;
        }
    }
    const double limit_of_box = 4.0 / 3 / worst; // which has not all wave vectors
    BOOST_TEST(limit <= limit_of_box);
    // what n iterations leave of the worst mode's residual: by the reference, by the oracle and its bound
    struct Left {
        double reference;
        double oracle;
        double allowed;
    };
    const auto left = [&](double omega, int iterations) {
        const DensityWave wave{mode, 1e-3};
        const auto oracle = expected(flow, {wave}, omega, 1, iterations);
        const auto rho = densities(flow, {wave});
        const double start = 2 * oracle.reach;
        std::vector<double> p(rho.size(), start);
        std::vector<Vec3> a(rho.size());
        const auto report = reference::solve_incompressibility(flow.bodies, flow.neighbors, rho, dt,
                                                               {rho_0, omega, 1, 0, 0, iterations}, p, a);
        // a residual answers to the pressures by no more than the worst mode does, and is rounded once more
        const Rounding by(flow, oracle, 1, omega, 1, start);
        const auto bodies = static_cast<double>(rho.size());
        const double of_reference = (omega * worst * by.most + std::sqrt(bodies) * by.once) /
                                    Rounding::pressure_of_residual(flow, omega);
        const auto r = oracle.residual.back()[0];
        const double first = rho_0 * wave.size / dt;
        return Left{report.residual_max * rho_0 / first, std::abs(r.value) / first,
                    (r.error + of_reference) / first};
    };
    constexpr int n = 400;
    const Left below = left(0.99 * limit_of_box, n);
    const Left above = left(1.01 * limit_of_box, n);
    BOOST_TEST_MESSAGE("    left " << below.reference << " below, " << above.reference << " above");
    BOOST_TEST(within(below.reference, below.oracle, below.allowed));
    BOOST_TEST(within(above.reference, above.oracle, above.allowed));
    BOOST_TEST(!within(left(1.01 * limit_of_box, n + 1).reference, above.oracle, above.allowed));
    BOOST_TEST(below.reference < 1e-3);
    BOOST_TEST(left(limit, n).reference < 1e-3);
    BOOST_TEST(above.reference > 10);
}

namespace
{

/// n iterations for two bodies, whose pressures reach 0 on the way.
template <class Candidate>
bool follows_two_bodies(Candidate candidate, double omega, double start, double aim, int n)
{
    const KernelName name = KernelName::cubic_spline;
    const double h = 1.0 / 64;
    Bodies b;
    b.position = {{0, 0, 0}, {h, 0, 0}};
    b.velocity.resize(2);
    b.mass.assign(2, rho_0 * h * h * h);
    b.role.assign(2, reference::Role::free);
    const Neighbors neighbors(b, reference::Kernel(name, h));
    // a density that a pressure of about `aim` takes back
    const double slope = b.mass[0] * reference::Kernel(name, h).gradient({h, 0, 0}).x;
    const double density = rho_0 + aim * 4 * slope * slope * dt * dt / (rho_0 * rho_0);
    const std::vector<double> rho(2, density);

    const auto oracle = analytic::accelerated_two_bodies(
        {name, h, h, b.mass[0], rho_0, start, (density - rho_0) / dt}, omega, dt, n);
    std::vector<double> p(2, start);
    std::vector<Vec3> a(2);
    candidate(b, neighbors, std::span<const double>(rho), dt,
              IncompressibleSettings{rho_0, omega, 1, 0, 0, n}, std::span<double>(p), std::span<Vec3>(a));
    // an iteration adds two changes of at most 2 p, with 40 roundings of two slopes each
    const double once = rounding(2 * 40 + 16) * 4 * oracle.reach;
    const double gain = analytic::error_gain(oracle.theta, -std::abs(1 - 2 * omega));
    BOOST_TEST_REQUIRE(2 * gain * once < oracle.margin);
    const auto expected = oracle.pressure.back()[0];
    return within(p[0], expected.value, expected.error + gain * once) &&
           within(p[1], expected.value, expected.error + gain * once);
}

} // namespace

BOOST_AUTO_TEST_CASE(eq03_pressures_of_two_bodies_do_not_pass_zero)
{
    // the step alone takes the first below 0, the momentum the second
    const auto step = [](auto candidate) { return follows_two_bodies(candidate, 0.6, 1000, 30, 3); };
    const auto momentum = [](auto candidate) { return follows_two_bodies(candidate, 0.25, 1000, 10, 6); };
    BOOST_TEST(step(solve));
    BOOST_TEST(step(planted({})));
    BOOST_TEST(!step(planted({.clamp_p = false})));
    BOOST_TEST(!step(planted({.omega = 1 + 1e-9})));
    BOOST_TEST(momentum(solve));
    BOOST_TEST(momentum(planted({})));
    BOOST_TEST(!momentum(planted({.clamp_y = false})));
    BOOST_TEST(!momentum(planted({.theta = 1 + 1e-9})));
}

BOOST_AUTO_TEST_CASE(eq03_iteration_written_out_again_gives_the_same_bits)
{
    const RandomCloud random(KernelName::cubic_spline);
    Bodies b = random.bodies;
    for (std::size_t i = 0; i < b.size(); i += 5) {
        b.mass[i] *= 4; // factors that differ enough to tell whether a restart's sum is over them
    }
    std::vector<double> rho(b.size(), rho_0);
    for (std::size_t i = 0; i < b.size(); ++i) {
        rho[i] = b.free(i) ? reference::density(b, random.neighbors.of(i)) : rho_0;
    }
    const auto pressures = [&](auto candidate) {
        std::vector<double> p(rho.size(), 0);
        std::vector<Vec3> a(rho.size());
        candidate(b, random.neighbors, std::span<const double>(rho), dt,
                  IncompressibleSettings{rho_0, 0.3, 0.5, 0, 0, 50}, std::span<double>(p),
                  std::span<Vec3>(a));
        return p;
    };
    const auto right = pressures(solve);
    BOOST_TEST(std::ranges::count(right, 0.0) > 0);
    const auto holds = [&](const Faults& faults) { return pressures(planted(faults)) == right; };
    BOOST_TEST(holds({}));
    BOOST_TEST(!holds({.omega = 1 + 1e-15}));
    BOOST_TEST(!holds({.theta = 1 + 1e-15}));
    BOOST_TEST(!holds({.restart = false}));
    BOOST_TEST(!holds({.weighted = false}));
    BOOST_TEST(!holds({.clamp_p = false}));
    BOOST_TEST(!holds({.clamp_y = false}));
    BOOST_TEST(!holds({.more = 1}));
}
