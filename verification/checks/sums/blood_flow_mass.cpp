// SPDX-License-Identifier: Apache-2.0
// Section 3.1, conservation of mass (2): what a frame without forces says of the velocity that it was given, and
// what the first iteration of a pressure solve makes of it, particle by particle.
#include "analytic/incompressible.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/formulas/kernel_rounding.hpp"
#include "verification/checks/sums/plates.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks
{
namespace
{

/// Neither pressure nor friction: the velocity of a frame's end is that of its start.
Scenario coasting(Scenario s)
{
    s.fluid.viscosity_pa_s = 0;
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 0;
    return s;
}

/// A frame's rates against both oracles of (2).
class BothOracles
{
public:
    explicit BothOracles(Probe& probe)
        : roundoff_(probe.roundoff()),
          pairs_(probe.quantity("mean and largest |Drho/Dt|/rho_0 over all pairs [1/s]", Source::rounding,
                                "the bound of the sum (2), (n + 32 + 8 L/h) u of the sum of |terms|, for "
                                "oracle and subject, and the mean's additions gamma_N")),
          slope_(probe.quantity("mean and largest |d/dt of (5)|/rho_0 [1/s]", Source::rounding,
                                "the same, and for the complex step 64 u more of the sum of |terms|"))
    {
    }

    /// `cloud` of the frame's start.
    void compare(const FrameRecord& record, const analytic::Cloud& cloud, double rho_0,
                 const std::string& where)
    {
        recorded_rates(cloud, rho_0, roundoff_).compare(pairs_, record, where);
        recorded_rates(cloud, rho_0, roundoff_, analytic::pair_density_slope).compare(slope_, record, where);
    }

private:
    double roundoff_;
    Quantity& pairs_;
    Quantity& slope_;
};

void cloud(Probe& probe)
{
    BothOracles oracles(probe);
    for (const KernelName kernel : both_kernels) {
        for (const double ratio : {1.0, 1.3}) {
            Box box(probe, coasting(box_scenario(kernel, ratio)));
            box.disturb(0.25, 0.5, 2450);
            const auto flow = probe.simulate(box.scenario(), box.state());
            const FrameRecord record = flow->advance();
            oracles.compare(record, box.cloud(box.state(), flow->density()), box.medium().density,
                            kernel_text(kernel) + "h/dx " + std::to_string(ratio).substr(0, 3) + ", ");
        }
    }
}

void walls(Probe& probe)
{
    BothOracles oracles(probe);
    const Scenario s = coasting(plates());
    const SimulationState before = disturbed(probe, s);
    const auto flow = probe.simulate(s, before);
    const FrameRecord record = flow->advance();
    oracles.compare(record, cloud_of(s, before, flow->density()), s.fluid.density_kg_m3,
                    "between the plates, ");
}

/// A drop moves as a solid: v_i - v_j is across r_i - r_j, so that every term is 0. Where it expands, none is.
void drop(Probe& probe)
{
    constexpr int edge = 4;              // spacings
    const Vec3 turn{1, -2, 0.5};         // [1/s]
    const Vec3 way{0.25, 0.125, -0.375}; // [m/s]
    Quantity& solid =
        probe.quantity("largest |Drho/Dt|/rho_0 of a drop that turns and travels [1/s]", Source::rounding,
                       "the bound of the sum (2) over all pairs, for oracle and subject");
    BothOracles expanding(probe);
    for (const KernelName kernel : both_kernels) {
        Box box(probe, coasting(box_scenario(kernel)));
        box.disturb(0.25, 0, 2451);
        box.keep_drop(edge);
        Particles& p = box.state().particles;
        const auto record_of = [&](const auto& velocity) {
            for (std::size_t i = 0; i < p.size(); ++i) {
                p.velocity[i] = p.kind[i] == Kind::fluid ? velocity(p.position[i] - box.middle()) : Vec3{};
            }
            return probe.simulate(box.scenario(), box.state())->advance();
        };
        const double rho_0 = box.medium().density;
        const std::vector<double> unused(p.size(), rho_0);
        const FrameRecord turning = record_of([&](const Vec3& x) { return way + cross(turn, x); });
        const analytic::Cloud turned = box.cloud(box.state(), unused);
        double allowed = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            allowed = std::max(allowed, both(pair_density_rate(turned, i).error, probe.roundoff()) / rho_0);
        }
        solid.within(turning.divergence_max, 0, allowed, kernel_text(kernel));
        const FrameRecord record = record_of([](const Vec3& x) { return 2.0 * x; });
        expanding.compare(record, box.cloud(box.state(), unused), rho_0, kernel_text(kernel));
    }
}

/// From no pressure one iteration leaves omega rho_0^2 alpha/dt Drho_i/Dt, where that is positive; v and -v show
/// every particle's rate with its sign.
void waves(Probe& probe)
{
    constexpr double neighbors = 26; // with a slope, h/dx = 1
    const double u = probe.roundoff();
    Quantity& rate = probe.quantity(
        "Drho/Dt of each particle, from its pressure after one iteration of (3) [kg/(m^3 s)]",
        Source::rounding,
        "the error of the symbol m v.G(k), (n + 40 + 16) u of the sum of |terms|, for oracle and subject; gamma_8 of "
        "that sum for the wave's rounding; gamma_2(N + 40) of the rate through alpha, N = 26 neighbors");
    for (const KernelName kernel : both_kernels) {
        Scenario s = box_scenario(kernel);
        s.fluid.viscosity_pa_s = 0;
        s.pressure.density_correction = 0;
        s.pressure.tolerance_per_s = 1e-300;
        s.pressure.max_iterations = 1;
        Box box(probe, s);
        std::ranges::fill(box.state().particles.pressure, 0.0);
        const double answer = s.pressure.relaxation * std::pow(box.medium().density, 2) *
                              analytic::dfsph_factor(box.medium()).value / s.time.frame_s;
        const double slopes =
            std::sqrt(neighbors * analytic::gradient_square_sum(box.medium().lattice).value);
        const std::vector<Mode> modes = box.modes();
        for (std::size_t m = 0; m < modes.size(); m += kernel == KernelName::cubic_spline ? 1 : 4) {
            const Mode& n = modes[m];
            for (const double sign : {1.0, -1.0}) {
                const analytic::Wave wave{box.wave_vector(n), sign * Eigen::Vector3d(0.5, -0.75, 0.625)};
                box.set_velocity(box.wave(n), to_vec3(wave.v_1));
                const auto flow = probe.simulate(s, box.state());
                flow->advance();
                const auto crest = analytic::density_rate(box.medium(), wave, 1);
                const double allowed = both(crest.error, u) +
                                       probe.gamma(8) * box.medium().mass * 2 * wave.v_1.norm() * slopes +
                                       probe.gamma(2 * (neighbors + 40)) * std::abs(crest.value);
                const std::vector<double> sines = box.wave(n, -0.25);
                for (std::size_t i = 0; i < sines.size(); ++i) {
                    rate.within(flow->solved_pressure()[i] / answer, std::max(0.0, crest.value * sines[i]),
                                allowed,
                                kernel_text(kernel) + "wave " + std::to_string(n[0]) + " " +
                                    std::to_string(n[1]) + " " + std::to_string(n[2]));
                }
            }
        }
    }
}

} // namespace

std::vector<Check> blood_flow_mass_checks()
{
    return {
        sum_check("eq02_waves", {"2", "3"},
                  "every wave of velocity changes each particle's density by its symbol",
                  {"symbol by direct lattice sum", "symbol by Poisson's formula (oracle checks)"}, waves),
        sum_check("eq02_cloud", {"2", "5"}, "in a disturbed cloud (2) is the time derivative of (5)",
                  {"(5) by the complex step", "brute force over all pairs"}, cloud),
        sum_check("eq02_walls", {"2", "27"},
                  "between plates (2) is the time derivative of (5) with the ghosts as mirror images",
                  {"(5) by the complex step", "brute force over all pairs"}, walls),
        sum_check("eq02_drop", {"2"}, "a drop that turns keeps its density, one that expands loses it",
                  {"0", "(5) by the complex step", "brute force over all pairs"}, drop),
    };
}

} // namespace aneurysm::checks
