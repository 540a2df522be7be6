// SPDX-License-Identifier: Apache-2.0
// Section 3.1, one frame in the periodic box: the sums (2), (5), (6), (7), the equation of state,
// (1) and (15), on a lattice with plane waves, where each has a known symbol,
// and in a disturbed cloud against all pairs.
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks
{
namespace
{

constexpr std::array<KernelName, 2> kernels{KernelName::cubic_spline, KernelName::wendland_c2};
constexpr std::array<double, 2> ratios{1, 1.3};

std::string label(KernelName kernel, double ratio, const std::string& more = {})
{
    return std::string(kernel == KernelName::cubic_spline ? "cubic spline" : "Wendland C2") + ", h/dx " +
           std::to_string(ratio).substr(0, 3) + more;
}
std::string label(const Mode& n)
{
    return ", wave " + std::to_string(n[0]) + " " + std::to_string(n[1]) + " " + std::to_string(n[2]);
}

/// At most sum_j |grad W_j| over a lattice point's neighbors, by Cauchy and Schwarz [1/m^4].
double slopes_of_lattice(const analytic::Medium& medium)
{
    constexpr double neighbors = 33; // h/dx = 1
    return std::sqrt(neighbors * analytic::gradient_square_sum(medium.lattice).value);
}

/// No pressure at all: the equation of state with stiffness 0.
Scenario without_pressure(Scenario scenario)
{
    scenario.pressure.model = PressureModel::eos;
    scenario.pressure.stiffness_m2_s2 = 0;
    return scenario;
}

void lattice_density(Probe& probe)
{
    Quantity& rho =
        probe.quantity("density [kg/m^3]", Source::rounding,
                       "(n + 40 + 16) u of the sum of |terms| over n neighbors, for the oracle and for the "
                       "subject (docs/bounds.md, B1)");
    for (const KernelName kernel : kernels) {
        for (const double ratio : ratios) {
            const Box box(probe, box_scenario(kernel, ratio));
            const auto flow = probe.simulate(box.scenario(), box.state());
            flow->advance();
            const auto expected = analytic::density(box.medium());
            for (const double value : flow->density()) {
                rho.within(value, expected.value, both(expected.error, probe.roundoff()),
                           label(kernel, ratio));
            }
        }
    }
}

void cloud_density(Probe& probe)
{
    Quantity& rho = probe.quantity("density [kg/m^3]", Source::rounding,
                                   "(n + 32 + 8 L/h) u m W(0) for each of n neighbors in a box of edge L, "
                                   "for the oracle and for the subject (docs/bounds.md, B2)");
    Quantity& record = probe.quantity(
        "recorded density errors: largest, smallest, mean excess [1]", Source::rounding,
        "the density's bound over rho_0, the quotient's gamma_2 and, of the mean, gamma_N of its additions");
    for (const KernelName kernel : kernels) {
        for (const double ratio : ratios) {
            Box box(probe, without_pressure(box_scenario(kernel, ratio)));
            box.disturb(0.25, 0, 2439);
            const auto flow = probe.simulate(box.scenario(), box.state());
            const FrameRecord r = flow->advance();
            const auto cloud = box.cloud(box.state(), flow->density());
            double most = -1;
            double least = 1;
            double excess = 0;
            double error = 0;
            for (std::size_t i = 0; i < box.size(); ++i) {
                const auto expected = analytic::pair_density(cloud, i);
                const double off = expected.value / box.medium().density - 1;
                most = std::max(most, off);
                least = std::min(least, off);
                excess += std::max(off, 0.0) / static_cast<double>(box.size());
                error = std::max(error, both(expected.error, probe.roundoff()) / box.medium().density);
                rho.within(flow->density()[i], expected.value, both(expected.error, probe.roundoff()),
                           label(kernel, ratio, ", particle " + std::to_string(i)));
            }
            error += rounding(static_cast<double>(box.size()) + 4) + probe.gamma(2);
            record.within(r.density_error_max, most, error, label(kernel, ratio, ", largest"));
            record.within(r.density_error_min, least, error, label(kernel, ratio, ", smallest"));
            record.within(r.density_error_mean, excess, error, label(kernel, ratio, ", mean excess"));
        }
    }
}

/// Pressure, friction and gravity of about the same size.
Scenario with_all_forces(Scenario s)
{
    s.time.frame_s = 0x1p-12;
    s.fluid.viscosity_pa_s = 64;
    s.fluid.gravity_m_s2 = {250, -430, 610}; // dt g is as large as v
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 256;
    return s;
}

void compare_motion(const Probe& probe, Quantity& motion, const FrameRecord& record, double mass,
                    const std::vector<Vec3>& velocity, const std::string& where)
{
    double twice_energy = 0;
    double speed = 0;
    for (const Vec3& v : velocity) {
        twice_energy += mass * dot(v, v);
        speed = std::max(speed, length(v));
    }
    motion.within(2 * record.kinetic_energy / twice_energy, 1,
                  2 * rounding(static_cast<double>(velocity.size())) + probe.gamma(16), where + "energy");
    motion.within(record.speed_max / speed, 1, probe.gamma(8), where + "largest speed");
}

/// Everything at once: equation of state, (6), (7), g, (15), the step, and (2) of the new velocity.
void cloud_frame(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& velocity = probe.quantity("velocity after one step [m/s]", Source::rounding,
                                        "dt/rho times the bounds of the sums (6) and (7), and gamma_8 of |v| "
                                        "+ dt |a| (docs/bounds.md, B2)");
    Quantity& position =
        probe.quantity("position after the step [m]", Source::rounding,
                       "gamma_3 L: the way is added to a place in the box and wrapped into it");
    Quantity& divergence =
        probe.quantity("mean and largest |Drho/Dt|/rho_0 of the new velocity [1/s]", Source::rounding,
                       "the bound of the sum (2) as above, the mean's additions gamma_N, and the velocity's "
                       "rounding within it");
    Quantity& motion =
        probe.quantity("recorded kinetic energy and largest speed, relative [1]", Source::rounding,
                       "gamma_16 of the mass and of a speed squared, gamma_2N of the additions in double");
    for (const KernelName kernel : kernels) {
        for (const double ratio : ratios) {
            const Scenario s = with_all_forces(box_scenario(kernel, ratio));
            const double rho_0 = s.fluid.density_kg_m3;
            const double dt = s.time.frame_s;
            Box box(probe, s);
            box.disturb(0.25, 0.5, 2440);
            const auto flow = probe.simulate(s, box.state());
            const FrameRecord record = flow->advance();
            auto cloud = box.cloud(box.state(), flow->density());
            for (std::size_t i = 0; i < box.size(); ++i) {
                cloud.pressure[i] = s.pressure.stiffness_m2_s2 * (cloud.density[i] - rho_0);
            }
            auto after = cloud;
            for (std::size_t i = 0; i < box.size(); ++i) {
                const auto pressing = analytic::pair_pressure_force(cloud, i);
                const auto viscous = analytic::pair_viscosity_force(cloud, s.fluid.viscosity_pa_s, i);
                const Vec3 a =
                    s.fluid.gravity_m_s2 + to_vec3(pressing.value + viscous.value) / cloud.density[i];
                const Vec3 v_0 = box.state().particles.velocity[i];
                const double allowed =
                    dt / cloud.density[i] * both(pressing.error + viscous.error, u) +
                    probe.gamma(8) * (length(v_0) + dt * length(a) + dt * length(s.fluid.gravity_m_s2));
                const std::string where = label(kernel, ratio, ", particle " + std::to_string(i));
                const Vec3 v = flow->state().particles.velocity[i];
                velocity.within(v, v_0 + dt * a, allowed, where);
                after.velocity[i] = to_eigen(v);
                const Vec3 way =
                    flow->state().particles.position[i] - box.state().particles.position[i] - dt * v;
                for (const double d : {way.x, way.y, way.z}) {
                    position.within(d - box.edge() * std::round(d / box.edge()), 0, 3 * u * box.edge(),
                                    where);
                }
            }
            compare_motion(probe, motion, record, box.medium().mass, flow->state().particles.velocity,
                           label(kernel, ratio, ", "));
            recorded_rates(after, rho_0, u).compare(divergence, record, label(kernel, ratio, ", "));
        }
    }
}

/// Waves of velocity: (7) and (2) by their symbols.
void velocity_waves(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& velocity = probe.quantity("velocity after one step [m/s]", Source::rounding,
                                        "dt times the error of the symbol -mu m/rho^2 L(k), (n + 40 + 88 + "
                                        "16) u of the sum of |terms|, for oracle and subject, and gamma_8 "
                                        "|v| (docs/bounds.md, B1)");
    Quantity& divergence = probe.quantity("largest |Drho/Dt|/rho_0 [1/s]", Source::rounding,
                                          "the error of the symbol m v.G(k), as above, for oracle and "
                                          "subject, + gamma_8 of its terms' sum, since the "
                                          "velocity that it acts on has been rounded");
    for (const KernelName kernel : kernels) {
        Scenario s = without_pressure(box_scenario(kernel, 1));
        s.fluid.viscosity_pa_s = 16;
        const double dt = s.time.frame_s;
        Box box(probe, s);
        const std::vector<Mode> modes = box.modes();
        for (std::size_t m = 0; m < modes.size(); m += kernel == KernelName::cubic_spline ? 1 : 4) {
            const Mode& n = modes[m];
            const analytic::Wave wave{box.wave_vector(n), {0.5, -0.75, 0.625}};
            const auto c = box.wave(n);
            const auto sines = box.wave(n, -0.25);
            box.set_velocity(c, to_vec3(wave.v_1));
            const auto flow = probe.simulate(s, box.state());
            const FrameRecord record = flow->advance();
            const double rho = analytic::density(box.medium()).value;
            const auto crest = analytic::viscosity_force(box.medium(), s.fluid.viscosity_pa_s, wave, 1);
            const double decay = dt / rho * both(crest.error, u) + probe.gamma(8) * wave.v_1.norm();
            double largest = 0;
            for (std::size_t i = 0; i < c.size(); ++i) {
                const auto F = analytic::viscosity_force(box.medium(), s.fluid.viscosity_pa_s, wave, c[i]);
                velocity.within(flow->state().particles.velocity[i],
                                to_vec3(c[i] * wave.v_1 + dt / rho * F.value), decay,
                                label(kernel, 1, label(n)));
                largest = std::max(largest, std::abs(sines[i]));
            }
            // the wave that is left has the amplitude v_1 (1 - rate dt)
            const auto rate = analytic::shear_decay_rate(box.medium(), s.fluid.viscosity_pa_s, wave.k);
            const double left = 1 - rate.value * dt;
            const auto of_wave = analytic::density_rate(box.medium(), wave, 1);
            const double terms = box.medium().mass * 2 * wave.v_1.norm() * slopes_of_lattice(box.medium());
            const double allowed =
                both(of_wave.error, u) + terms * (probe.gamma(8) + dt * both(rate.error, u));
            divergence.within(record.divergence_max, std::abs(left * of_wave.value) * largest / rho,
                              allowed / rho, label(kernel, 1, label(n)));
        }
    }
}

} // namespace

std::vector<Check> blood_flow_sums_checks()
{
    return {
        sum_check("eq05_lattice", {"5", "4"}, "the density of a lattice is its lattice sum",
                  {"direct lattice sum", "Poisson's formula (holds for the direct sum, oracle checks)"},
                  lattice_density),
        sum_check("eq05_cloud", {"5", "4"},
                  "the density of a disturbed cloud is the sum over all pairs, no neighbor missed or "
                  "counted twice",
                  {"brute force over all pairs"}, cloud_density),
        sum_check(
            "eq01_cloud_frame", {"1", "2", "6", "7", "15", "EOS"},
            "one step of a disturbed cloud: pressure by the equation of state, viscosity, gravity, motion",
            {"brute force over all pairs"}, cloud_frame),
        sum_check("eq07_waves", {"7", "2", "1", "15"},
                  "every wave of velocity decays by its symbol and has its divergence",
                  {"symbol by direct lattice sum", "symbol by Poisson's formula (oracle checks)"},
                  velocity_waves),
    };
}

} // namespace aneurysm::checks
