// SPDX-License-Identifier: Apache-2.0
// A whole run of data/scenarios/quick.json: warm-up, growth, rupture, bleeding. Given the wall's load in each frame,
// everything that happens to the wall, (13), (17)-(23) and (28), follows exactly.
#include "analytic/boundary.hpp"
#include "analytic/growth.hpp"
#include "analytic/rupture.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

std::string frame(const FrameRecord& r)
{
    return "frame " + std::to_string(r.frame);
}

/// A finished run, frame by frame.
struct History {
    Scenario scenario;
    SimulationState start;
    std::vector<FrameRecord> frames;

    double R_0() const { return start.aneurysm.radius; }
    double h_0() const { return start.aneurysm.thickness; }
    std::int64_t warm_up() const { return scenario.growth.warm_up_frames; }
    double largest_radius() const
    {
        return scenario.aneurysm.base_width_radii / 2 * scenario.vessel.radius_m;
    }
};

History run(const Probe& probe, const Scenario& scenario, std::int64_t frames)
{
    const auto flow = probe.simulate(scenario);
    History history{scenario, flow->state(), {}};
    for (std::int64_t n = 0; n < frames; ++n) {
        history.frames.push_back(flow->advance());
    }
    return history;
}

analytic::Resistance resistance(const Scenario& s)
{
    const auto& g = s.growth;
    return {.m = g.wall_mass_kg,
            .impedance = g.tissue_density_kg_m3 * g.tissue_area_m2 * g.wave_speed_m_s,
            .stiffness =
                g.elastin_stiffness_n_m * g.elastin_area_m2 + g.collagen_stiffness_n_m * g.collagen_area_m2};
}

void check_phases(Probe& probe, const History& run)
{
    Quantity& phase = probe.quantity(
        "frames in the right phase", Source::exact,
        "a claim: warm-up, growing, fully developed and ruptured follow from the number of the "
        "frame, R and the load against P_c");
    Quantity& at_rest = probe.quantity("wall in the warm-up", Source::exact,
                                       "bits: R, h and u keep their first values until the warm-up ends");
    Quantity& start =
        probe.quantity("R and h of frame 0 [m]", Source::rounding,
                       "gamma_1, for either text: a ratio of the scenario times the artery's radius");
    const double r_0 = run.scenario.vessel.radius_m;
    const double R_0 = run.scenario.aneurysm.initial_radius_radii * r_0;
    const double h_0 = run.scenario.rupture.thickness_ratio * r_0;
    start.within(run.R_0(), R_0, rounding(2) * R_0, "R");
    start.within(run.h_0(), h_0, rounding(2) * h_0, "h");
    bool ruptured = false;
    double R = run.R_0();
    for (const FrameRecord& r : run.frames) {
        if (r.frame <= run.warm_up()) {
            phase.holds(r.phase == Phase::warm_up, frame(r));
            at_rest.holds(r.radius == run.R_0() && r.thickness == run.h_0() && r.displacement == 0, frame(r));
            continue;
        }
        const bool developed = R >= run.largest_radius();
        ruptured = ruptured || r.wall_load / run.scenario.rupture.conversion_area_m2 > r.critical_pressure;
        const Phase expected = ruptured    ? Phase::ruptured
                               : developed ? Phase::fully_developed
                                           : Phase::growing;
        phase.holds(r.phase == expected, frame(r));
        R = r.radius;
    }
    probe.quantity("the run ruptures", Source::exact, "a claim: else half of the phases were not looked at")
        .holds(ruptured);
}

/// (28) from the recorded loads, while the wall lives: a sum over all of them.
void check_displacement(Probe& probe, const History& run)
{
    Quantity& displacement = probe.quantity(
        "displacement u of (28) [m]", Source::rounding,
        "gamma_(20 + 4n) of the sum of |terms| of the oracle, dt^2/m F_j sin(k theta)/sin theta, n frames");
    const Scenario& s = run.scenario;
    const double dt = s.time.frame_s;
    const double omega = std::sqrt(s.elastic_wall.stiffness_n_m / s.elastic_wall.mass_kg);
    const double theta = 2 * std::asin(omega * dt / 2);
    std::vector<double> F;
    for (const FrameRecord& r : run.frames) {
        if (r.frame <= run.warm_up()) {
            continue;
        }
        F.push_back(r.wall_load);
        const auto n = static_cast<double>(F.size());
        double u = 0;
        double terms = 0;
        for (std::size_t j = 0; j < F.size(); ++j) {
            const double k = n - static_cast<double>(j);
            const double term = dt * dt / s.elastic_wall.mass_kg * F[j] / std::sin(theta);
            u += term * std::sin(k * theta);
            terms += std::abs(term);
        }
        displacement.within(r.displacement, u, rounding(20 + 4 * n) * terms, frame(r));
        if (r.phase == Phase::ruptured) {
            break;
        }
    }
}

/// While the wall lives: (21), (22), (23), (13) from the recorded impact forces.
void check_wall(Probe& probe, const History& run)
{
    const Scenario& s = run.scenario;
    const double dt = s.time.frame_s;
    Quantity& radius = probe.quantity("growth of R in a frame [m]", Source::rounding,
                                      "twice the oracle's bound, Higham's |A^-1| (|b - A x| + gamma_7 ...) "
                                      "of its linear system, + u R of the addition; "
                                      "or what is left to the largest radius");
    Quantity& thickness = probe.quantity("thickness h, relative [1]", Source::rounding,
                                         "each frame rounds five times: gamma_5n, the logarithms of the "
                                         "oracle as often, and h/R sigma times the error of "
                                         "the radii's differences, 2 u R each");
    Quantity& pressure =
        probe.quantity("critical pressure P_c, relative [1]", Source::rounding,
                       "gamma_9 of the product, and gamma_9 of the oracle's 2 E h/((1 + sigma) R)");
    const double sigma = s.rupture.poisson_ratio;
    const analytic::Wall wall{s.rupture.yield_limit_pa, sigma, s.rupture.porosity, run.R_0(), run.h_0(), 0};
    double R = run.R_0();
    double log_h = 0;
    double lost = 0; // relative error of h by the differences of radii
    std::int64_t n = 0;
    Plot plot{"The wall's history", "frame", "h/h_0, R/R_0", false, false, {}};
    Series found_h{"h/h_0", {}, {}, false};
    Series predicted_h{"h/h_0 predicted", {}, {}, true};
    Series found_R{"R/R_0", {}, {}, true};
    for (const FrameRecord& r : run.frames) {
        if (r.frame <= run.warm_up()) {
            continue;
        }
        const auto step = analytic::backward_euler_from_rest(resistance(s), r.wall_load, R, dt);
        const bool developed = R >= run.largest_radius();
        const double growth = developed ? 0 : std::min(step.dR.value, run.largest_radius() - R);
        radius.within(r.radius - R, growth, 2 * step.dR.error + 0x1p-52 * R, frame(r));
        log_h += developed ? std::log1p(-s.growth.thinning_intensity_per_m *
                                        std::min(step.dR.value, s.growth.largest_increment_m))
                           : std::log1p(-sigma * (r.radius - R) / R);
        lost += developed ? s.growth.thinning_intensity_per_m * 2 * step.dR.error : sigma * 0x1p-52;
        R = r.radius;
        ++n;
        thickness.within(r.thickness / run.h_0(), std::exp(log_h),
                         2 * rounding(5 * static_cast<double>(n) + 8) + lost, frame(r));
        const double P_c = 2 * wall.modulus() * r.thickness / ((1 + sigma) * r.radius);
        pressure.within(r.critical_pressure / P_c, 1, 2 * rounding(9), frame(r));
        found_h.x.push_back(static_cast<double>(r.frame));
        found_h.y.push_back(r.thickness / run.h_0());
        predicted_h.x.push_back(static_cast<double>(r.frame));
        predicted_h.y.push_back(std::exp(log_h));
        found_R.x.push_back(static_cast<double>(r.frame));
        found_R.y.push_back(R / run.R_0());
        if (r.phase == Phase::ruptured) {
            probe.note("frame of rupture", static_cast<double>(r.frame));
            break;
        }
    }
    plot.series = {predicted_h, found_h, found_R};
    probe.plot(std::move(plot));
}

void wall_history(Probe& probe)
{
    Scenario scenario = shipped_scenario("quick");
    scenario.rupture.yield_limit_pa = 120; // ruptures within these frames
    const History history = run(probe, scenario, 180);
    check_phases(probe, history);
    check_wall(probe, history);
    check_displacement(probe, history);
}

/// A sac that is nearly fully developed: the switch from (22) to (23), and its cap.
void developed_history(Probe& probe)
{
    Scenario scenario = shipped_scenario("quick");
    scenario.aneurysm.initial_radius_radii = 0.999 * scenario.aneurysm.base_width_radii / 2;
    scenario.growth.warm_up_frames = 20;
    scenario.growth.largest_increment_m = 4e-5;
    scenario.rupture.yield_limit_pa = 1e6; // holds
    const History history = run(probe, scenario, 120);
    check_wall(probe, history);
    check_displacement(probe, history);
    Quantity& phases = probe.quantity(
        "frames of each phase", Source::exact,
        "a claim: growing and fully developed frames are there, with increments above and below the cap");
    std::int64_t growing = 0;
    std::int64_t developed = 0;
    std::int64_t capped = 0;
    for (const FrameRecord& r : history.frames) {
        growing += r.phase == Phase::growing ? 1 : 0;
        developed += r.phase == Phase::fully_developed ? 1 : 0;
        const double dR = analytic::backward_euler_from_rest(resistance(scenario), r.wall_load, r.radius,
                                                             scenario.time.frame_s)
                              .dR.value;
        capped += r.phase == Phase::fully_developed && dR > scenario.growth.largest_increment_m ? 1 : 0;
    }
    phases.holds(growing > 0);
    phases.holds(capped > 0 && capped < developed);
}

} // namespace

std::vector<Check> growth_history_checks()
{
    return {
        flow_check(
            "eq21_history", {"13", "17", "18", "19", "20", "21", "22", "28"},
            "in a run to rupture the wall does what its impact forces say: radius, thickness, critical "
            "pressure, displacement, phases",
            {"linear system of (17)-(20) by elimination", "product of (22) by logarithms",
             "impulse response of (28)'s steps"},
            wall_history),
        flow_check("eq23_history", {"21", "22", "23", "13"},
                   "a fully developed wall keeps its radius and thins by (23), up to its cap",
                   {"linear system of (17)-(20) by elimination", "product of (23) by logarithms"},
                   developed_history),
    };
}

} // namespace aneurysm::checks
