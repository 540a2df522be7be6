// SPDX-License-Identifier: Apache-2.0
// Section 3.1 and 3.2: what the sums of (6) and (7) do to a particle: (1), (15) and the equation of state.
#include "tests/periodic.hpp"

using namespace aneurysm;
using namespace aneurysm::test;
using Eigen::Vector3d;

namespace
{

constexpr double fault = 1e-12;
constexpr double mu = 3.7;
const Vector3d g(0.5, -9.81, 2.5);

/// Force (1) on each body of a lattice that carries the wave,
/// by the candidate from the reference's (6) and (7).
template <class Candidate>
std::vector<Vec3> forces(const PeriodicLattice& flow, const std::vector<double>& pressure,
                         const Vec3& gravity, Candidate momentum_force)
{
    std::vector<Vec3> F;
    for (std::size_t i = 0; i < flow.bodies.size(); ++i) {
        const auto near = flow.neighbors.of(i);
        F.push_back(momentum_force(PeriodicLattice::rho, gravity,
                                   reference::viscosity_force(flow.bodies, near, flow.density, mu, i),
                                   reference::pressure_force(flow.bodies, near, flow.density, pressure, i)));
    }
    return F;
}

} // namespace

BOOST_AUTO_TEST_CASE(eq01_force_of_a_wave_is_that_of_its_symbols)
{
    PeriodicLattice flow({8, 8, 8}, KernelName::cubic_spline, 1);
    const auto holds = [&](auto momentum_force) {
        return std::ranges::all_of(modes(8), [&](const Mode& n) {
            const analytic::Wave wave{flow.wave_vector(n), {0.3, -0.7, 0.5}, 40};
            const auto c = flow.wave(n);
            const auto s = flow.sine(n);
            flow.bodies.velocity = times(c, wave.v_1);
            std::vector<double> p(c.size());
            std::ranges::transform(c, p.begin(), [&](double value) { return wave.p_1 * value; });
            const auto F = forces(flow, p, to_vec3(g), momentum_force);
            // once the oracle's bound at the crest, twice the reference's as in test_blood_flow.cpp
            const double allowed = 3 * analytic::momentum_force(flow.medium, mu, g, wave, 1, 1).error;
            for (std::size_t i = 0; i < F.size(); ++i) {
                const auto expected = analytic::momentum_force(flow.medium, mu, g, wave, c[i], s[i]);
                if (distance(F[i], to_vec3(expected.value)) > allowed) {
                    return false;
                }
            }
            return true;
        });
    };
    BOOST_TEST(holds(reference::momentum_force));
    BOOST_TEST(!holds(off_by(fault, reference::momentum_force)));
    BOOST_TEST(!holds([](double rho, const Vec3& gravity, const Vec3& viscous, const Vec3& pressing) { // sign
        return reference::momentum_force(rho, gravity, viscous, -pressing);
    }));
    BOOST_TEST(!holds([](double rho, const Vec3&, const Vec3& viscous, const Vec3& pressing) { // term dropped
        return reference::momentum_force(rho, {}, viscous, pressing);
    }));
}

BOOST_AUTO_TEST_CASE(eq15_shear_wave_decays_by_its_rate)
{
    // v += dt a at rest positions: (1 - rate dt)^n, exactly
    const auto holds = [](auto acceleration) {
        PeriodicLattice flow({8, 8, 8}, KernelName::cubic_spline, 1);
        const Mode n{1, 2, 0};
        const Vector3d across(0.2, -0.1, 0.3); // no need to be: (7) treats each component alike
        const auto rate = analytic::shear_decay_rate(flow.medium, mu, flow.wave_vector(n));
        const double dt = 0.2 / rate.value;
        const std::vector<double> no_pressure(flow.bodies.size(), 0);
        flow.bodies.velocity = times(flow.wave(n), across);
        constexpr int steps = 20;
        for (int step = 0; step < steps; ++step) {
            const auto F = forces(flow, no_pressure, {}, reference::momentum_force);
            for (std::size_t i = 0; i < F.size(); ++i) {
                flow.bodies.velocity[i] += dt * acceleration(PeriodicLattice::rho, F[i]);
            }
        }
        // a step adds the error of dt times the rate, once for the oracle and twice for the reference, and 5
        // roundings; no mode grows, so that an error stays as large as it was, while the wave becomes 0.8^n
        const double allowed = steps * (3 * dt * rate.error + rounding(5)) * 0.3;
        const auto expected = times(flow.wave(n), std::pow(1 - dt * rate.value, steps) * across);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            if (distance(flow.bodies.velocity[i], expected[i]) > allowed) {
                return false;
            }
        }
        return true;
    };
    BOOST_TEST(holds(reference::acceleration));
    BOOST_TEST(!holds(off_by(1e-10, reference::acceleration)));
    BOOST_TEST(!holds([](double, const Vec3& force) { return force; })); // not divided by the density
}

namespace
{

/// Acceleration at the crest of the displacement A sin(k.r) a, by (5),
/// the equation of state, (6), (1) and (15).
template <class Candidate>
double sound_acceleration(const Mode& n, const Vector3d& a, double A, double kappa,
                          Candidate equation_of_state)
{
    PeriodicLattice flow({8, 8, 8}, KernelName::cubic_spline, 1.3);
    const auto s = flow.sine(n);
    for (std::size_t i = 0; i < s.size(); ++i) {
        flow.bodies.position[i] += A * s[i] * to_vec3(a);
    }
    const double L = 8 * PeriodicLattice::dx;
    const reference::Neighbors neighbors(flow.bodies, flow.kernel, {L, L, L});
    std::vector<double> rho;
    std::vector<double> p;
    for (std::size_t i = 0; i < s.size(); ++i) {
        rho.push_back(reference::density(flow.bodies, neighbors.of(i)));
        p.push_back(equation_of_state(kappa, rho[i], PeriodicLattice::rho));
    }
    const auto crest = static_cast<std::size_t>(std::ranges::max_element(s) - s.begin());
    const Vec3 F = reference::momentum_force(
        rho[crest], {}, {}, reference::pressure_force(flow.bodies, neighbors.of(crest), rho, p, crest));
    return dot(reference::acceleration(rho[crest], F), to_vec3(a));
}

} // namespace

BOOST_AUTO_TEST_CASE(eqEOS_sound_has_the_lattices_frequency)
{
    const auto holds = [](auto equation_of_state) {
        const Mode n{2, 0, 0};
        const double kappa = 250;
        const double dx = PeriodicLattice::dx;
        const PeriodicLattice flow({8, 8, 8}, KernelName::cubic_spline, 1.3);
        const auto expected = analytic::sound_frequency_squared(flow.medium, kappa, flow.wave_vector(n));
        // -a/A, the even orders of A taken away by +-A and the second by A and A/2
        const auto odd = [&](double A) {
            const Vector3d along(1, 0, 0);
            return -(sound_acceleration(n, along, A, kappa, equation_of_state) -
                     sound_acceleration(n, along, -A, kappa, equation_of_state)) /
                   (2 * A);
        };
        const double A = 1e-3 * dx;
        const double coarse = odd(A);
        const double fine = odd(A / 2);
        const double found = (4 * fine - coarse) / 3;
        // of the fourth order is left the square of the second's; rounding:
        // 81 additions and 20 operations in (5) and in (6), relative to the change of density k A/2,
        // and as often to the difference of two positions A/2
        const double second = (coarse - fine) / found;
        const double change = flow.wave_vector(n).x() * A / 2;
        const double rounded = 2 * rounding(2 * 101) / change;
        BOOST_TEST_MESSAGE("    second order " << second);
        return within(found, expected.value, expected.error + found * (second * second + rounded));
    };
    BOOST_TEST(holds(reference::equation_of_state));
    BOOST_TEST(!holds(off_by(1e-9, reference::equation_of_state)));
    BOOST_TEST(!holds(off_by(-2, reference::equation_of_state))); // sound that grows
}
