// SPDX-License-Identifier: Apache-2.0
// Disordered blood between walls, (27), with the artery's own solve of (3): under its own weight, and in Poiseuille's and
// Womersley's flows.
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/flows/laminar.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>

namespace aneurysm::checks
{
namespace
{

using analytic::Section;

/// Disordered blood with the artery's solve, to the tolerances that are the same part of U/dx as there.
Scenario disordered(const Laminar& flow, double U)
{
    Scenario s = flow.scenario();
    const Scenario artery = shipped_scenario("base");
    s.pressure = artery.pressure;
    s.settling = artery.settling;
    s.particles.jitter_spacings = artery.particles.jitter_spacings;
    s.inlet.peak_velocity_m_s = U;
    const double dx_artery = 0.1; // of 5,520 particles [m]
    const double slower = (U / flow.dx()) / (artery.inlet.peak_velocity_m_s / dx_artery);
    for (double* tolerance :
         {&s.pressure.tolerance_per_s, &s.pressure.max_tolerance_per_s,
          &s.pressure.correction_tolerance_per_s, &s.pressure.correction_max_tolerance_per_s}) {
        *tolerance *= slower;
    }
    return s;
}

/// A layer of one spacing between two plates.
struct Layer {
    double count = 0;
    double off = 0;    ///< sum of what its particles' pressures are above the hydrostatic one [Pa]
    double fallen = 0; ///< sum of how far they have come down [m]
};

/// Blood between two plates, heavy across them.
void own_weight(Probe& probe)
{
    constexpr int frames = 200;
    constexpr double g = 9.81;
    const Laminar plates{Section::channel, 16, 1, {g, 0}, 1e-3};
    Scenario s = disordered(plates, 0.5);
    s.fluid.gravity_m_s2 = {0, -g, 0};
    const auto flow = probe.simulate(s);
    const std::vector<Vec3> start = flow->state().particles.position;
    for (int n = 0; n < frames; ++n) {
        flow->advance();
    }
    const std::vector<Vec3>& place = flow->state().particles.position;
    const std::vector<double>& pressure = flow->solved_pressure();
    const auto blood = static_cast<double>(place.size());
    const double mean = std::accumulate(pressure.begin(), pressure.end(), 0.0) / blood;
    std::vector<Layer> layers(static_cast<std::size_t>(plates.across));
    double squares = 0;
    double exact_squares = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const double exact = s.fluid.density_kg_m3 * g * (Laminar::width / 2 - place[i].y);
        const double off = pressure[i] - mean - exact;
        squares += off * off;
        exact_squares += exact * exact;
        const int row = static_cast<int>(start[i].y / plates.dx());
        Layer& layer = layers[static_cast<std::size_t>(std::clamp(row, 0, plates.across - 1))];
        ++layer.count;
        layer.off += off;
        layer.fallen += start[i].y - place[i].y;
    }
    double layer_squares = 0;
    double farthest = 0;
    for (const Layer& layer : layers) {
        layer_squares += layer.off * layer.off / layer.count;
        farthest = std::max(farthest, std::abs(layer.fallen) / layer.count);
    }
    const std::string error = "own weight: rms error over the hydrostatic pressure, ";
    probe.accuracy({error + "of layers of one spacing", std::sqrt(layer_squares / exact_squares), 0.05});
    probe.accuracy(
        {error + "of single particles", std::sqrt(squares / exact_squares), 0.05, measured(0.179)});
    probe.accuracy({"own weight: farthest that a layer falls in 0.2 s, over half a spacing",
                    farthest / (plates.dx() / 2), 1});
}

/// Rms error over the rms of the exact flow, in the last part of a run.
double flow_error(const Probe& probe, const Laminar& flow, const Scenario& s, int steps, int looked_at)
{
    const auto simulated = probe.simulate(s);
    double squares = 0;
    double exact_squares = 0;
    for (int n = 1; n <= steps; ++n) {
        simulated->advance();
        if (n <= steps - looked_at) {
            continue;
        }
        const Particles& p = simulated->state().particles;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const Vec3& x = p.position[i];
            const bool plane = flow.section == Section::channel;
            const double r = plane ? std::abs(x.y - Laminar::width / 2) : std::hypot(x.x, x.z);
            const double exact =
                analytic::velocity(flow.exact(), flow.drive, std::min(r, Laminar::width / 2), n * flow.dt)
                    .value;
            squares += std::pow((plane ? p.velocity[i].x : p.velocity[i].y) - exact, 2);
            exact_squares += exact * exact;
        }
    }
    return std::sqrt(squares / exact_squares);
}

/// A flow whose exact solution is known, and its known limits.
struct Study {
    std::string name;
    Section section = Section::channel;
    analytic::Drive drive;
    double t = 0;                  ///< the end [s]
    double U = 0;                  ///< its fastest [m/s]
    std::optional<double> at_10{}; ///< with 10 particles across
    std::optional<double> at_20{};
    std::optional<double> ratio{}; ///< of both
};

/// What is asked at 10 and 20 particles across, and of the trend between: an order of 1.3; and what shifts are for.
void compare(Probe& probe, const Study& study)
{
    const bool steady = study.drive.steady();
    const auto error_of = [&](int across, bool shifts) {
        Laminar flow{study.section, across, 1, study.drive, 0};
        const int steps = steps_to(study.t, flow.dx(), 20);
        flow.dt = study.t / steps;
        Scenario s = disordered(flow, study.U);
        s.pressure.shifting = shifts ? s.pressure.shifting : 0;
        return flow_error(probe, flow, s, steps, steady ? steps / 20 : steps / 2);
    };
    const double at_10 = error_of(10, true);
    const double at_20 = error_of(20, true);
    const std::string error = " across: rms error over the exact flow";
    probe.accuracy({study.name + ", 10" + error, at_10, 0.08, measured(study.at_10)});
    probe.accuracy({study.name + ", 20" + error, at_20, 0.03, measured(study.at_20)});
    probe.accuracy({study.name + ": error at 20 over that at 10 across", at_20 / at_10, std::pow(2, -1.3),
                    measured(study.ratio)});
    if (steady) {
        probe.note(study.name + ", 10" + error + ", without shifts", error_of(10, false));
    }
}

void poiseuille_channel(Probe& probe)
{
    compare(probe, {"flow between plates", Section::channel, {0.5, 0}, 3, 0.4, {}, 0.0399, 1.01});
}

void poiseuille_tube(Probe& probe)
{
    compare(probe, {"flow in a tube", Section::pipe, {0.8, 0}, 1.2, 0.3, {}, 0.0471, 0.8});
}

/// The first cycle at about 0.4 m/s.
Study pulsating(Section section, int womersley, std::optional<double> at_10 = {},
                std::optional<double> at_20 = {}, std::optional<double> ratio = {})
{
    const double omega = pulse(1, womersley).omega;
    const std::string where = section == Section::channel ? "between plates" : "in a tube";
    return {"pulsating flow " + where + ", Womersley number " + std::to_string(womersley),
            section,
            pulse(0.2 * omega + 0.3, womersley),
            2 * std::numbers::pi / omega,
            0.4,
            at_10,
            at_20,
            ratio};
}

void womersley_channel(Probe& probe)
{
    compare(probe, pulsating(Section::channel, 2, {}, {}, 0.443));
    compare(probe, pulsating(Section::channel, 4));
    compare(probe, pulsating(Section::channel, 8));
}

void womersley_tube(Probe& probe)
{
    compare(probe, pulsating(Section::pipe, 2, {}, {}, 0.516));
    compare(probe, pulsating(Section::pipe, 4, 0.0953, 0.0418, 0.439));
    compare(probe, pulsating(Section::pipe, 8, 0.127, 0.0517, 0.412));
}

} // namespace

std::vector<Check> nature_walls_checks()
{
    return {nature_check("own_weight", "blood at rest carries its own weight", {"rho g (H - y)"}, own_weight,
                         true),
            nature_check("poiseuille_channel", "flow between plates is Poiseuille's",
                         {"Poiseuille's parabola"}, poiseuille_channel),
            nature_check("poiseuille_tube", "flow in a tube is Hagen and Poiseuille's",
                         {"Hagen and Poiseuille's parabola"}, poiseuille_tube),
            nature_check("womersley_channel", "pulsating flow between plates is Womersley's",
                         {"exact flow from rest, two ways (oracle_flow_from_rest)"}, womersley_channel),
            nature_check("womersley_tube", "pulsating flow in a tube is Womersley's",
                         {"exact flow from rest, two ways (oracle_flow_from_rest)"}, womersley_tube)};
}

} // namespace aneurysm::checks
