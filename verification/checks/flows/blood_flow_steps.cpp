// SPDX-License-Identifier: Apache-2.0
// Flows in time whose discrete answer is known: shear waves, (7) and (15), and sound, by the equation of state and (6),
// in the periodic box, and a force (1) between slipping plates.
#include "analytic/incompressible.hpp"
#include "common/scenario/shipped.hpp"
#include "common/vessel/body_force.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace aneurysm::checks
{
namespace
{

/// A shear wave so weak that it moves nothing: (1 - rate dt)^n after n steps.
void shear_wave(Probe& probe)
{
    constexpr int steps = 40;
    const double u = probe.roundoff();
    Quantity& velocity =
        probe.quantity("velocity after 40 frames, relative to the wave's first [1]", Source::rounding,
                       "each step adds dt times the error of the decay rate, for oracle and subject, and "
                       "gamma_8 (docs/bounds.md, B13)");
    Scenario s = box_scenario();
    s.fluid.viscosity_pa_s = 16;
    Plot plot{"Decay of shear waves", "frame", "amplitude / first amplitude", false, true, {}};
    for (const Mode& n : {Mode{1, 0, 0}, Mode{1, 2, 0}, Mode{2, 1, 3}}) {
        s.time.substeps = n[0]; // two steps a frame for the last wave
        Box box(probe, s);
        const Eigen::Vector3d k = box.wave_vector(n);
        // small enough to move nothing, and across, so that the pressure has nothing to do
        const double weak = 0x1p-60;
        const Eigen::Vector3d across = weak * k.cross(Eigen::Vector3d(0.25, -0.5, 0.75)).normalized();
        const auto c = box.wave(n);
        box.set_velocity(c, to_vec3(across));
        const auto rate = analytic::shear_decay_rate(box.medium(), s.fluid.viscosity_pa_s, k);
        const auto substeps = static_cast<int>(s.time.substeps);
        const double dt = s.time.frame_s / substeps;
        const auto flow = probe.simulate(s, box.state());
        Series found{"wave " + std::to_string(n[0]) + " " + std::to_string(n[1]) + " " + std::to_string(n[2]),
                     {},
                     {},
                     false};
        Series predicted{"(1 - rate dt)^n", {}, {}, true};
        for (int step = 1; step <= steps; ++step) {
            flow->advance();
            found.x.push_back(step);
            found.y.push_back(length(flow->state().particles.velocity[0]) / across.norm());
            predicted.x.push_back(step);
            predicted.y.push_back(std::pow(1 - rate.value * dt, substeps * step));
        }
        plot.series.push_back(found);
        plot.series.push_back(predicted);
        const double left = std::pow(1 - rate.value * dt, substeps * steps);
        const double allowed = substeps * steps * (dt * both(rate.error, u) + probe.gamma(8));
        for (std::size_t i = 0; i < c.size(); ++i) {
            const Vec3 expected = left * c[i] / weak * to_vec3(across);
            velocity.within(flow->state().particles.velocity[i] / weak, expected, allowed, found.name);
        }
    }
    probe.plot(std::move(plot));
}

/// Acceleration of the displacement A sin(k x) at its crest, from one frame.
double sound_acceleration(const Probe& probe, const Scenario& s, const Mode& n, double A)
{
    Box box(probe, s);
    const auto sines = box.wave(n, -0.25);
    for (std::size_t i = 0; i < sines.size(); ++i) {
        box.state().particles.position[i].x += A * sines[i];
    }
    const auto crest = static_cast<std::size_t>(std::ranges::max_element(sines) - sines.begin());
    const auto flow = probe.simulate(s, box.state());
    flow->advance();
    return flow->state().particles.velocity[crest].x / s.time.frame_s;
}

void sound(Probe& probe)
{
    Quantity& frequency =
        probe.quantity("omega^2 of sound [1/s^2]", Source::truncation,
                       "runs with the amplitudes +-A and +-A/2 leave the fourth order only; gamma_202 of the "
                       "change of density k A/2, and the oracle's lattice sum (docs/bounds.md, B4)");
    Scenario s = box_scenario();
    s.kernel.smoothing_length_spacings = 1.3;
    s.fluid.viscosity_pa_s = 0;
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 250;
    s.time.frame_s = 1e-4;
    const Mode n{2, 0, 0};
    const Box box(probe, s);
    const Eigen::Vector3d k = box.wave_vector(n);
    const auto expected = analytic::sound_frequency_squared(box.medium(), s.pressure.stiffness_m2_s2, k);
    // single precision holds no smaller change of a place in the box to enough digits
    const double A = (probe.roundoff() > 1e-10 ? 0x1p-4 : 0x1p-10) * s.domain.spacing_m;
    const auto odd = [&](double amplitude) {
        return -(sound_acceleration(probe, s, n, amplitude) - sound_acceleration(probe, s, n, -amplitude)) /
               (2 * amplitude);
    };
    const double coarse = odd(A);
    const double fine = odd(A / 2);
    const double found = (4 * fine - coarse) / 3;
    const double second = (coarse - fine) / found;
    const double rounded = 2 * probe.gamma(2 * 101) / (k.x() * A / 2);
    frequency.within(found, expected.value, expected.error + std::abs(found) * (second * second + rounded));
    probe.note("(6) has half of the pressure's gradient: omega^2 / (kappa k^2) [1]",
               found / (s.pressure.stiffness_m2_s2 * k.squaredNorm()), "1/2 times the lattice's own factor");
}

/// Between plates that let it slip all blood moves alike, with the integral of the force.
void slip(Probe& probe)
{
    Quantity& velocity =
        probe.quantity("velocity over the force's integral so far, largest 1 [1]", Source::rounding,
                       "each of n steps adds dt g and rounds twice, gamma_4 n of the largest sum; (7) adds "
                       "gamma_60 of nothing but differences of that size");
    Scenario s = shipped_scenario("verify_slip_channel");
    const double weak = 0x1p-60; // moves nothing
    s.fluid.gravity_m_s2 = {weak, 0, 0};
    constexpr int steps = 200;
    const auto flow = probe.simulate(s);
    double sum = 0;
    for (int n = 1; n <= steps; ++n) {
        flow->advance();
        sum += s.time.frame_s * body_force_factor(s, n * s.time.frame_s);
    }
    for (const Vec3& v : flow->state().particles.velocity) {
        velocity.within(v / weak / sum, {1, 0, 0}, steps * (probe.gamma(4) + probe.gamma(60)));
    }
    // the sum of sines in closed form
    const double phase = 2 * std::numbers::pi * s.time.frame_s / s.fluid.gravity_cycle_s;
    const double closed = s.time.frame_s * std::sin(steps * phase / 2) * std::sin((steps + 1) * phase / 2) /
                          std::sin(phase / 2);
    Quantity& force =
        probe.quantity("sum of the force's factors [s]", Source::rounding,
                       "gamma_3n of the sum of n positive sines, and 64 u of the closed form's phases");
    force.within(sum, closed, (rounding(3 * steps) + rounding(64)) * closed);
}

} // namespace

std::vector<Check> blood_flow_steps_checks()
{
    return {
        flow_check("eq07_shear_wave", {"7", "15", "1"},
                   "a shear wave decays by the same factor in every step",
                   {"(1 - rate dt)^n with the rate's lattice symbol"}, shear_wave),
        flow_check("eqEOS_sound", {"EOS", "5", "6", "15"}, "sound has the frequency of the lattice",
                   {"lattice symbol of (6) with the equation of state"}, sound),
        flow_check("eq01_slip_channel", {"1", "7", "15"},
                   "between plates that let it slip blood follows a swinging force without friction",
                   {"sum of the force's steps", "sum of sines in closed form"}, slip),
    };
}

} // namespace aneurysm::checks
