// SPDX-License-Identifier: Apache-2.0
// Section 3.1, (3): both solves particle by particle, in disturbed clouds, where all pairs are summed up, and of two
// particles alone, whose pressures are an iteration of one number.
#include "analytic/incompressible.hpp"
#include "analytic/kernel_function.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/formulas/kernel_rounding.hpp"
#include "verification/checks/sums/incompressible.hpp"
#include "verification/checks/sums/one_iteration.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks
{
namespace
{

/// Drifts of a cloud [kg/m^3], so that no two neighbors have the same.
std::vector<double> drifts(std::size_t n)
{
    std::vector<double> all;
    for (std::size_t i = 0; i < n; ++i) {
        all.push_back((static_cast<double>(i * i % 1021) - 510) / 64);
    }
    return all;
}

/// The density's part of the residual of the pressure: the mean of the drifts, and what is missing beside voids, over dt.
analytic::Estimate density_part_of(const analytic::Cloud& cloud, const std::vector<double>& drift,
                                   double rho_0, double dt, std::size_t i)
{
    const auto mean = analytic::pair_mean(cloud, drift, i);
    const auto rho = analytic::pair_density(cloud, i);
    const bool is_void = cloud.density[i] < guards::void_density * rho_0;
    return {(mean.value + (is_void ? rho.value - rho_0 : 0)) / dt,
            (mean.error + (is_void ? rho.error + rounding(4) * rho_0 : 0)) / dt};
}

/// What the density adds when nothing moves and no iteration is made.
void density_part(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& residual = probe.quantity(
        "mean and largest residual before the first iteration [1/s]", Source::rounding,
        "the bounds of the sums of Shepard's mean and of (5) over pairs and, where that counts, "
        "gamma_4 of rho_0, over dt, for oracle and subject, and gamma_8 of the residual");
    for (const bool in_drop : {false, true}) {
        const Scenario s = without_iterations(with_tension(box_scenario(), 0x1p20), 0.5);
        const double rho_0 = s.fluid.density_kg_m3;
        const double dt = s.time.frame_s;
        Box box(probe, s);
        box.disturb(0.2, 0, 2442);
        if (in_drop) {
            box.keep_drop(4);
        }
        Particles& p = box.state().particles;
        p.drift = drifts(p.size());
        const auto flow = probe.simulate(s, box.state());
        const FrameRecord record = flow->advance();
        const auto cloud = box.cloud(box.state(), flow->density());
        const auto n = static_cast<double>(std::ranges::count(p.kind, Kind::fluid));
        double mean = 0;
        double largest = 0;
        double error = 0;
        for (std::size_t i = 0; i < box.size(); ++i) {
            if (p.kind[i] == Kind::fluid) {
                const auto part = density_part_of(cloud, p.drift, rho_0, dt, i);
                mean += std::abs(part.value) / rho_0 / n;
                largest = std::max(largest, std::abs(part.value) / rho_0);
                error = std::max(error, both(part.error, u) / rho_0);
            }
        }
        const double allowed = error + probe.gamma(8) * largest;
        const std::string where = in_drop ? ", in a drop" : ", in the box";
        residual.within(record.residual_mean, mean, allowed + rounding(n) * mean, "mean" + where);
        residual.within(record.residual_max, largest, allowed, "largest" + where);
    }
}

/// What the solve promises: pressures above their bound whose velocity obeys (3), and no force where it isn't needed.
void solves_a_cloud(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& mean = probe.quantity(
        "mean residual by all pairs [1/s]", Source::solver,
        "the tolerance of the solve, + the bounds of Shepard's mean and of the sums (5), (2) by all pairs");
    Quantity& sign = probe.quantity("pressures below their bound", Source::exact,
                                    "none: no blood has an absolute pressure below 0");
    Quantity& pulls =
        probe.quantity("pressures below 0", Source::exact,
                       "a claim: some where the bound lets them, else one bound would be as good as "
                       "the other");
    Quantity& velocity = probe.quantity("velocity by the solved pressures [m/s]", Source::rounding,
                                        "dt times the bound of the sum of the pressure's acceleration over "
                                        "all pairs, for oracle and subject, + gamma_4 |v|");
    for (const double tension : {0.0, 0x1p12}) {
        Scenario s = with_tension(without_iterations(box_scenario(), 0.5), tension);
        s.pressure.tolerance_per_s = 0.01;
        s.pressure.max_tolerance_per_s = 1;
        s.fluid.viscosity_pa_s = 0;
        const double dt = s.time.frame_s;
        const double rho_0 = s.fluid.density_kg_m3;
        Box box(probe, s);
        box.disturb(0.2, 0.25, 2443);
        const std::vector<double> drift = drifts(box.size());
        box.state().particles.drift = drift;
        const auto flow = probe.simulate(s, box.state());
        flow->advance();
        auto cloud = box.cloud(box.state(), flow->density());
        cloud.pressure = flow->solved_pressure();
        auto after = cloud;
        bool any = false;
        for (std::size_t i = 0; i < box.size(); ++i) {
            const auto a = analytic::pair_pressure_acceleration(cloud, rho_0, i);
            const Vec3& v_0 = box.state().particles.velocity[i];
            const Vec3& v = flow->state().particles.velocity[i];
            velocity.within(v, v_0 + dt * to_vec3(a.value),
                            dt * both(a.error, u) + probe.gamma(4) * (length(v_0) + length(v)),
                            "particle " + std::to_string(i));
            after.velocity[i] = to_eigen(v);
            sign.holds(cloud.pressure[i] >= -tension);
            any = any || cloud.pressure[i] < 0;
        }
        pulls.holds(any == (tension > 0));
        double residual = 0;
        double error = 0;
        for (std::size_t i = 0; i < box.size(); ++i) {
            const auto part = density_part_of(cloud, drift, rho_0, dt, i);
            const auto rate = analytic::pair_density_rate(after, i);
            const double r = part.value + rate.value;
            const bool acts = cloud.pressure[i] > -tension || r > 0;
            residual += acts ? std::abs(r) / rho_0 / static_cast<double>(box.size()) : 0;
            error = std::max(error, both(part.error + rate.error, u) / rho_0);
        }
        mean.within(residual, 0, s.pressure.tolerance_per_s + error);
    }
}

/// What the correction promises: kappa whose ways take the density's error away, which move places and no velocity.
void corrects_a_cloud(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& mean =
        probe.quantity("mean residual of the correction by all pairs [1/s]", Source::solver,
                       "the tolerance of the solve, + the bounds of the sum (5) ahead and of (2) by all "
                       "pairs, and gamma_8 of rho_0 beta/dt");
    Quantity& sign = probe.quantity("kappa below 0 beside a void, or outside of the wall", Source::exact,
                                    "none: nothing pulls there");
    Quantity& pulls = probe.quantity("kappa below 0 elsewhere", Source::exact,
                                     "a claim: some is, else the pull would not be seen");
    Quantity& velocity = probe.quantity("velocity after the correction [m/s]", Source::exact,
                                        "bits: as it was, since nothing else acts");
    Quantity& position = probe.quantity(
        "position after the correction [m]", Source::rounding,
        "dt^2 times the bound of the sum of kappa's acceleration over all pairs and that of the "
        "shifts, for oracle and subject, and gamma_5 L for a place in the box");
    Quantity& drift =
        probe.quantity("drift, without what the shifts add [kg/m^3]", Source::rounding, of_drift);
    Quantity& shifted =
        probe.quantity("particles that are shifted", Source::exact,
                       "a claim: some are, and those beside voids aren't, else neither is seen");
    Scenario s = without_iterations(box_scenario(), 0.75);
    s.pressure.shifting = 0.125;
    s.pressure.correction_tolerance_per_s = 0.01;
    s.pressure.correction_max_tolerance_per_s = 1;
    s.pressure.correction_max_iterations = 1000;
    s.fluid.viscosity_pa_s = 0;
    const double dt = s.time.frame_s;
    const double rho_0 = s.fluid.density_kg_m3;
    const double beta = s.pressure.density_correction;
    Box box(probe, s);
    box.disturb(0.2, 0.25, 2446);
    box.keep_drop(6);
    Particles& p = box.state().particles;
    for (std::size_t i = 0; i < p.size(); i += 9) {
        p.kind[i] = p.kind[i] == Kind::fluid ? Kind::escaped : p.kind[i];
    }
    const auto lowest = [&](const analytic::Cloud& cloud, std::size_t i) {
        return p.kind[i] == Kind::escaped ? 0 : lowest_kappa(cloud.density[i], rho_0);
    };
    const auto flow = probe.simulate(s, box.state());
    flow->advance();
    const auto cloud = box.cloud(box.state(), flow->density());
    auto corrected = cloud;
    corrected.pressure = flow->solved_kappa();
    const Shifts shifts = shifts_of(s, cloud, p.kind);
    const std::vector<Eigen::Vector3d> straight = ways_of(cloud, dt);
    auto moved = corrected;
    bool any = false;
    for (std::size_t i = 0; i < box.size(); ++i) {
        if (p.kind[i] == Kind::reserve) {
            continue;
        }
        const std::string where = "particle " + std::to_string(i);
        const auto a = analytic::pair_pressure_acceleration(corrected, rho_0, i);
        moved.velocity[i] = dt * a.value;
        velocity.within(flow->state().particles.velocity[i], p.velocity[i], 0, where);
        const Vec3 way = flow->state().particles.position[i] - p.position[i];
        position.within(way, dt * p.velocity[i] + to_vec3(shifts.way[i]) + dt * dt * to_vec3(a.value),
                        both(shifts.error + dt * dt * a.error, u) + probe.gamma(5) * box.edge(), where);
        compare_drift(probe, drift, flow->state().particles.drift[i], cloud, straight, dt, i);
        const bool may_pull = lowest(cloud, i) < 0;
        sign.holds(may_pull || corrected.pressure[i] >= 0, where);
        any = any || (may_pull && corrected.pressure[i] < 0);
    }
    pulls.holds(any);
    const auto is_shifted = [](const Eigen::Vector3d& way) { return way.norm() > 0; };
    const auto n_shifted = std::ranges::count_if(shifts.way, is_shifted);
    shifted.holds(n_shifted > 0 && n_shifted < std::ranges::count(p.kind, Kind::fluid));
    const std::vector<Eigen::Vector3d> way = shifts.and_ways(straight);
    const auto n =
        static_cast<double>(box.size()) - static_cast<double>(std::ranges::count(p.kind, Kind::reserve));
    double residual = 0;
    double error = 0;
    for (std::size_t i = 0; i < box.size(); ++i) {
        if (p.kind[i] != Kind::reserve) {
            const auto ahead = analytic::pair_density_ahead(cloud, way, i, shifts.error);
            const auto rate = analytic::pair_density_rate(moved, i);
            const double r = beta * (ahead.value - rho_0) / dt + rate.value;
            const bool acts = corrected.pressure[i] > lowest(cloud, i) || r > 0;
            residual += acts ? std::abs(r) / rho_0 / n : 0;
            error = std::max(error, both(beta * ahead.error / dt + rate.error, u) / rho_0);
        }
    }
    mean.within(residual, 0, s.pressure.correction_tolerance_per_s + error + probe.gamma(8) * beta / dt);
}

/// Solves go on from the potentials that they are given; blood without a pressure starts from its neighbors' mean.
void start_of_the_solve(Probe& probe)
{
    Quantity& known =
        probe.quantity("potentials that the solves start from [Pa]", Source::exact,
                       "bits: as they were given, where no iteration is made and their bounds let them");
    Quantity& mean = probe.quantity("pressures of blood that had none [Pa]", Source::rounding,
                                    "gamma_n of a mean of n pressures >= 0; 0 where no neighbor has one");
    Scenario s = without_iterations(box_scenario(), 0.5);
    s.fluid.viscosity_pa_s = 0;
    Box box(probe, s);
    box.disturb(0.2, 0, 2447);
    std::vector<double>& given = box.state().particles.pressure;
    std::vector<double>& kappa = box.state().particles.kappa;
    for (std::size_t i = 0; i < given.size(); ++i) {
        given[i] = i % 3 == 0 || i < 128 ? unset_pressure : static_cast<double>(1 + i * i % 1021);
        kappa[i] = static_cast<double>(i * i % 1019) - 510;
    }
    const auto flow = probe.simulate(s, box.state());
    flow->advance();
    const auto cloud = box.cloud(box.state(), flow->density());
    const auto is_given = [&](std::size_t i) { return given[i] != unset_pressure; };
    for (std::size_t i = 0; i < box.size(); ++i) {
        const std::string where = "particle " + std::to_string(i);
        known.within(flow->solved_kappa()[i],
                     std::max(kappa[i], lowest_kappa(cloud.density[i], s.fluid.density_kg_m3)), 0,
                     where + ", kappa");
        if (is_given(i)) {
            known.within(flow->solved_pressure()[i], given[i], 0, where);
            continue;
        }
        double sum = 0;
        double n = 0;
        for (const std::size_t j : analytic::pair_neighbors(cloud, i)) {
            sum += is_given(j) ? given[j] : 0;
            n += is_given(j) ? 1 : 0;
        }
        const double expected = n > 0 ? sum / n : 0;
        mean.within(flow->solved_pressure()[i], expected, probe.gamma(n + 2) * expected, where);
    }
}

/// From no pressure, one iteration: each particle's residual by its own DFSPH factor.
void first_iteration(Probe& probe)
{
    Quantity& pressure =
        probe.quantity("pressure after one iteration from 0 [Pa]", Source::rounding, of_one_iteration);
    Quantity& acting = probe.quantity("particles that are pressed", Source::exact,
                                      "a claim: some are and some aren't, else half of the rule isn't seen");
    for (const bool in_drop : {false, true}) {
        Scenario s = without_iterations(solve_scenario(KernelName::cubic_spline), 0.5);
        s.pressure.tolerance_per_s = 1e-300;
        s.pressure.max_iterations = 1;
        Box box(probe, s);
        box.disturb(0.25, 0.25, 2448);
        if (in_drop) {
            box.keep_drop(4);
        }
        Particles& p = box.state().particles;
        p.drift = drifts(p.size());
        const auto flow = probe.simulate(s, box.state());
        flow->advance();
        const auto cloud = box.cloud(box.state(), flow->density());
        const OneIteration iteration(probe, s, cloud);
        std::size_t pressed = 0;
        for (std::size_t i = 0; i < box.size(); ++i) {
            if (p.kind[i] == Kind::fluid) {
                const auto part = density_part_of(cloud, p.drift, s.fluid.density_kg_m3, s.time.frame_s, i);
                const auto expected = iteration.potential(i, part, 0);
                pressure.within(flow->solved_pressure()[i], expected.value, expected.error,
                                "particle " + std::to_string(i) + (in_drop ? ", in a drop" : ""));
                pressed += expected.value > 0 ? 1 : 0;
            }
        }
        acting.holds(pressed > 0 &&
                     pressed < static_cast<std::size_t>(std::ranges::count(p.kind, Kind::fluid)));
    }
}

/// Two particles a spacing apart, and nobody else.
struct TwoParticles {
    Box box;
    std::vector<std::size_t> who;

    TwoParticles(const Probe& probe, const Scenario& s, double pressure) : box(probe, s)
    {
        box.keep_drop(2);
        Particles& p = box.state().particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec3 x = p.position[i] - box.middle();
            const bool kept = p.kind[i] == Kind::fluid && x.y < 0 && x.z < 0;
            p.kind[i] = kept ? Kind::fluid : Kind::reserve;
            p.pressure[i] = kept ? pressure : 0;
            if (kept) {
                who.push_back(i);
            }
        }
    }

    /// They come nearer by `speed` [m/s].
    void approach(double speed)
    {
        Particles& p = box.state().particles;
        for (const std::size_t i : who) {
            p.velocity[i].x = p.position[i].x < box.middle().x ? speed / 2 : -speed / 2;
        }
    }
};

/// Pressures that the step alone takes below their bound in the first iteration, and those that the momentum takes
/// there in the fourth.
void two_bodies(Probe& probe)
{
    Quantity& pressure = probe.quantity(
        "pressure of two particles [Pa]", Source::rounding,
        "the rounding of two changes of at most 2 p, times what later iterations make of it; + the oracle's "
        "own error (docs/bounds.md, B5)");
    Quantity& floor =
        probe.quantity("pressures that end at their bound", Source::exact,
                       "a claim: each kernel's once for each bound, else the check would not see it");
    for (const double lowest : {0.0, -0x1p9}) {
        for (const KernelName kernel : both_kernels) {
            Scenario s = with_tension(solve_scenario(kernel), -lowest);
            s.pressure.relaxation = kernel == KernelName::cubic_spline ? 0.25 : 0.508; // g = 0.5 and -0.016
            s.pressure.tolerance_per_s = 1e-300;
            const double start = 1000 + lowest; // [Pa]
            int at_bound = 0;
            for (int n = 1; n <= 6; ++n) {
                s.pressure.max_iterations = n;
                TwoParticles two(probe, s, start);
                const analytic::Medium& medium = two.box.medium();
                const double h = medium.lattice.h;
                const double slope = -medium.mass * analytic::kernel_slope(kernel, h, h);
                // they end where 2^-11 m/s would bring them from 0, but for the bound
                const double per_pressure = 4 * s.time.frame_s * slope / std::pow(medium.density, 2);
                const double approach =
                    std::ldexp(std::round((0x1p-11 + per_pressure * lowest) * 0x1p30), -30);
                two.approach(approach);
                const auto oracle = analytic::accelerated_two_bodies(
                    {kernel, h, h, medium.mass, medium.density, start, slope * approach, lowest},
                    s.pressure.relaxation, s.time.frame_s, n);
                const double once = probe.gamma(2 * 40 + 16) * 4 * std::max(oracle.reach, std::abs(start));
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
                                    at({{"bound", lowest}, {"iteration", double(n)}}));
                }
                at_bound += expected.value == lowest ? 1 : 0;
            }
            floor.equal(at_bound, 1, at({{"bound", lowest}}));
        }
    }
}

} // namespace

std::vector<Check> incompressible_bodies_checks()
{
    return {
        sum_check(
            "eq03_density_part", {"3"},
            "the density's part of (3) is the mean of what the ways added, and what is missing beside voids",
            {"brute force over all pairs"}, density_part),
        sum_check(
            "eq03_start", {"3"},
            "both solves start from the last step's potentials, blood without one from its neighbors' mean",
            {"the potentials given", "brute force over all pairs"}, start_of_the_solve),
        sum_check("eq03_factor", {"3"},
                  "in a disturbed cloud each particle answers its residual by its own DFSPH factor",
                  {"brute force over all pairs"}, first_iteration),
        sum_check("eq03_two_bodies", {"3"},
                  "the pressures of two particles do not pass their bound, by the step or by the momentum",
                  {"iteration of one number"}, two_bodies),
        sum_check(
            "eq03_cloud", {"3"},
            "a disturbed cloud's solution obeys (3), pulls no harder than it may and moves the blood by its "
            "pressure",
            {"brute force over all pairs"}, solves_a_cloud),
        sum_check(
            "eq03_correction_cloud", {"3", "5"},
            "shifts and the correction of a drop's density move its places, pull nowhere beside voids and leave "
            "velocities and drift alone",
            {"brute force over all pairs"}, corrects_a_cloud),
    };
}

} // namespace aneurysm::checks
