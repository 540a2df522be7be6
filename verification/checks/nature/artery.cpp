// SPDX-License-Identifier: Apache-2.0
// Blood in the artery of paper_tc1: at rest, under another ambient pressure, at another resolution, as fast as may be.
#include "common/scenario/limits.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

/// An artery that doesn't burst.
Scenario unbreakable(const std::string& name)
{
    Scenario s = shipped_scenario(name);
    s.rupture.yield_limit_pa = 1e9;
    return s;
}

/// What a run comes to in the frames behind the start, 101 to the last.
struct Run {
    double rms_speed = 0;      ///< [m/s]
    double impact = 0;         ///< mean F_b [N]
    double kinetic_energy = 0; ///< mean [J]
    double inflow = 0;         ///< particles
    double growth = 0;         ///< of R [m]
    double mass = 0;           ///< of a particle [kg]
};

Run run(const Probe& probe, const Scenario& s, std::int64_t frames)
{
    constexpr std::int64_t start = 100; // the ramp and what it stirs
    const auto flow = probe.simulate(s);
    for (std::int64_t n = 0; n < start; ++n) {
        flow->advance();
    }
    const SimulationState first = flow->state();
    Run r{.mass = first.particles.mass};
    const auto count = static_cast<double>(frames - start);
    double squares = 0;
    double blood = 0;
    for (std::int64_t n = start; n < frames; ++n) {
        const FrameRecord record = flow->advance();
        r.impact += record.impact_force / count;
        r.kinetic_energy += record.kinetic_energy / count;
        squares += 2 * record.kinetic_energy / r.mass;
        blood += static_cast<double>(record.fluid);
    }
    const SimulationState& last = flow->state();
    r.rms_speed = std::sqrt(squares / blood);
    r.inflow = static_cast<double>(last.ledger.inlet_in - first.ledger.inlet_in -
                                   (last.ledger.inlet_out - first.ledger.inlet_out));
    r.growth = last.aneurysm.radius - first.aneurysm.radius;
    return r;
}

/// Relative.
double change(double other, double one)
{
    return std::abs(other / one - 1);
}

/// Nothing moves where nothing drives, at any ambient pressure.
void at_rest(Probe& probe)
{
    constexpr std::int64_t frames = 200;
    const Scenario s = unbreakable("paper_tc1");
    Scenario still = s;
    still.inlet.peak_velocity_m_s = 1e-6;
    const Run flow = run(probe, s, frames);
    const Run rest = run(probe, still, frames);
    probe.accuracy(
        {"blood at rest: rms speed over v_0 of the flow", rest.rms_speed / s.inlet.peak_velocity_m_s, 1e-3});
    probe.accuracy({"blood at rest: F_b over that in flow", rest.impact / flow.impact, 0.01});
    probe.accuracy({"blood at rest: growth over that in flow", rest.growth / flow.growth, 0.01});
}

/// An incompressible fluid doesn't feel the level of its pressure.
void gauge_shift(Probe& probe)
{
    constexpr std::int64_t frames = 250;
    Scenario s = unbreakable("paper_tc1");
    const Run one = run(probe, s, frames);
    s.outlet.pressure_pa *= 2;
    const Run other = run(probe, s, frames);
    const std::string name = "p_const doubled: relative change of ";
    probe.accuracy({name + "F_b", change(other.impact, one.impact), 0.05});
    probe.accuracy({name + "the kinetic energy", change(other.kinetic_energy, one.kinetic_energy), 0.05});
    probe.accuracy({name + "the inflow", change(other.inflow, one.inflow), 0.05});
    probe.accuracy({name + "growth", change(other.growth, one.growth), 0.05});
}

/// F_b is the force on one particle, and goes with its mass. Its acceleration, which the wall's load is made of, and so
/// growth, ought not to depend on the particle's size.
/// Finer particles have as many steps as keep v dt/dx from rising.
void impact_resolution(Probe& probe)
{
    constexpr std::int64_t frames = 300;
    const auto grown = [&](std::int64_t particles, std::int64_t steps) {
        Scenario s = unbreakable("paper_tc1");
        s.particles.count = particles;
        s.time.substeps = steps;
        s.growth.warm_up_frames = 100;
        const Run r = run(probe, s, frames);
        const std::string where = std::to_string(particles) + " particles";
        probe.note("F_b / m, " + where + " [m/s^2]", r.impact / r.mass);
        probe.note("growth of R in 200 frames, " + where + " [m]", r.growth);
        return r;
    };
    const Run coarse = grown(5520, 1);
    const Run fine = grown(15456, 2);
    const Run finest = grown(40296, 2);
    probe.accuracy({"F_b / m at 15,456 against 5,520 particles: relative change",
                    change(fine.impact / fine.mass, coarse.impact / coarse.mass), 0.15});
    probe.accuracy({"F_b / m at 40,296 against 5,520 particles: relative change",
                    change(finest.impact / finest.mass, coarse.impact / coarse.mass), 0.15, measured(0.162)});
    probe.accuracy({"growth of R at 15,456 against 5,520 particles: relative change",
                    change(fine.growth, coarse.growth), 0.15});
    probe.accuracy({"growth of R at 40,296 against 5,520 particles: relative change",
                    change(finest.growth, coarse.growth), 0.15, measured(0.162)});
    probe.accuracy({"growth of R at 15,456 against 5,520 particles, same time step: relative change",
                    change(grown(15456, 1).growth, coarse.growth), 0.15});
    probe.accuracy({"growth of R at 40,296 against 5,520 particles, same time step: relative change",
                    change(grown(40296, 1).growth, coarse.growth), 0.15, measured(0.258)});
}

/// Largest error of the density of any blood, with the fastest inlet that one step a frame allows.
double fastest_inlet_density_error(const Probe& probe, Scenario s, int frames)
{
    const double spacing = std::cbrt(probe.simulate(s)->state().particles.mass / s.fluid.density_kg_m3);
    s.inlet.peak_velocity_m_s *= 0.9999 * step_limits(s, spacing).convective / s.time.frame_s;
    const auto flow = probe.simulate(s);
    double error = 0;
    for (int n = 0; n < frames; ++n) {
        const std::vector<Kind> kind = flow->state().particles.kind;
        flow->advance();
        for (std::size_t i = 0; i < kind.size(); ++i) {
            const double relative = flow->density()[i] / s.fluid.density_kg_m3;
            error = std::max(error, kind[i] == Kind::fluid ? std::abs(relative - 1) : 0);
        }
    }
    return error;
}

/// Every inlet that a scenario may have is stable: at all angles of the paper, with all waveforms.
void fastest_inlet(Probe& probe)
{
    constexpr int cycle = 800; // frames
    const auto add = [&](const std::string& inlet, const Scenario& s, int frames, auto... known) {
        probe.accuracy({"density with the fastest inlet that a step allows, " + inlet + ": largest error",
                        fastest_inlet_density_error(probe, s, frames), 0.05, known...});
    };
    add("sine, 30 degrees", unbreakable("paper_angle_30"), cycle);
    add("sine, 40 degrees", unbreakable("paper_angle_40"), cycle);
    add("sine, 60 degrees", unbreakable("paper_angle_60"), cycle);
    add("sine, 75 degrees", unbreakable("paper_angle_75"), cycle, measured(0.166));
    Scenario s = unbreakable("paper_tc1");
    s.inlet.waveform = Waveform::rectified_sine;
    add("|sine|", s, cycle);
    s.inlet.waveform = Waveform::constant;
    add("constant", s, cycle);
    s.inlet.profile = InletProfile::parabolic;
    add("constant parabola", s, cycle);
    add("sine, 40,296 particles", unbreakable("paper_tc4"), cycle * 3 / 8); // beyond the peak
}

} // namespace

std::vector<Check> nature_artery_checks()
{
    return {nature_check("at_rest", "blood at rest stays at rest, and presses on no wall", {"rest"}, at_rest,
                         true),
            nature_check("gauge_shift", "the level of the pressure changes nothing in the flow",
                         {"the same flow at another level"}, gauge_shift, true),
            nature_check("impact_resolution", "the impact of the blood doesn't depend on the particles' size",
                         {"the same flow of smaller particles"}, impact_resolution),
            nature_check("fastest_inlet", "the fastest inlet that a step allows leaves the density as it is",
                         {"rho_0"}, fastest_inlet)};
}

} // namespace aneurysm::checks
