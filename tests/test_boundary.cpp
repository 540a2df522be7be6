// SPDX-License-Identifier: Apache-2.0
// Section 3.5, (25)-(28), and the collision handling of Fig. 1.
#include "analytic/boundary.hpp"
#include "analytic/kernel_function.hpp"
#include "reference/boundary.hpp"
#include "reference/kernel_function.hpp"
#include "tests/support.hpp"

#include <array>
#include <numbers>
#include <vector>

using namespace aneurysm;
using namespace aneurysm::test;

namespace
{

using std::numbers::pi;
constexpr double fault = 1e-12;
constexpr double v_0 = 0.31;
constexpr double T = 0.8;
const std::vector<double> table_time{0, 0.1, 0.25, 0.5};
const std::vector<double> table_velocity{0.05, 0.4, -0.1, 0.02};

const std::array formulas{Waveform::sine, Waveform::rectified_sine, Waveform::raised_sine,
                          Waveform::constant};

const auto inlet = [](Waveform waveform, double t) {
    return reference::inlet_velocity(waveform, v_0, T, t, table_time, table_velocity);
};

template <class Candidate>
bool equals_formulas(Candidate velocity)
{
    return std::ranges::all_of(formulas, [&](Waveform waveform) {
        bool equal = true;
        for (int k = 0; k <= 80; ++k) {
            const double t = 0.01 * k;
            // 3 roundings of the angle in either text, 3 of the value; the angle counts absolutely
            const double allowed = v_0 * (2 * rounding(3) * 2 * pi + rounding(3));
            const auto expected = analytic::waveform_velocity(waveform, v_0, T, t);
            equal = equal && std::abs(velocity(waveform, t) - expected.value) <= expected.error + allowed;
        }
        return equal;
    });
}

/// Against the transport of a cycle in units of v_0 T, which no sampling of the waveform can hide from.
template <class Candidate>
bool transports_exactly(Candidate velocity)
{
    return std::ranges::all_of(formulas, [&](Waveform waveform) {
        const auto v = [&](double t) { return velocity(waveform, t); };
        const auto transport = analytic::cycle_transport(v, {0, T / 2, T});
        // 6 roundings of the integrand, as above, which is at most v_0
        const double allowed = transport.error + v_0 * T * rounding(6) * 2 * pi;
        return within(transport.value, v_0 * T * analytic::exact_transport(waveform), allowed);
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(eq25_waveforms_equal_their_formulas)
{
    BOOST_TEST(equals_formulas(inlet));
    BOOST_TEST(!equals_formulas(off_by(fault, inlet)));
    BOOST_TEST(
        !equals_formulas([](Waveform waveform, double t) { return inlet(waveform, t * (1 + fault)); }));
}

BOOST_AUTO_TEST_CASE(eq25_waveforms_transport_what_they_must)
{
    BOOST_TEST(transports_exactly(inlet));
    BOOST_TEST(!transports_exactly(off_by(fault, inlet)));
    BOOST_TEST(!transports_exactly([](Waveform, double t) { return std::abs(inlet(Waveform::sine, t)); }));
}

BOOST_AUTO_TEST_CASE(eq25_sine_peaks_and_turns_where_it_must)
{
    const auto holds = [](auto velocity) {
        // the angle's 3 roundings move a zero by 3 u times the angle, a peak not at all
        return within(velocity(Waveform::sine, T / 4), v_0, v_0 * rounding(2)) &&
               within(velocity(Waveform::sine, 3 * T / 4), -v_0, v_0 * rounding(2)) &&
               velocity(Waveform::sine, 0) == 0 &&
               within(velocity(Waveform::sine, T / 2), 0, v_0 * rounding(3) * pi) &&
               within(velocity(Waveform::sine, T), 0, v_0 * rounding(3) * 2 * pi);
    };
    BOOST_TEST(holds(inlet));
    BOOST_TEST(!holds(off_by(fault, inlet)));
    BOOST_TEST(!holds([](Waveform waveform, double t) { return inlet(waveform, t + fault); }));
}

BOOST_AUTO_TEST_CASE(eq25_table_is_piecewise_linear_and_periodic)
{
    const auto holds = [](auto velocity) {
        bool equal = true;
        for (int k = -160; k <= 240; ++k) {
            const double t = 0.01 * k;
            const double expected = analytic::interpolated_velocity(table_time, table_velocity, T, t);
            // 8 roundings on either side of at most 0.4, and those of t in the cycle times the steepest slope
            const double allowed = 2 * rounding(8) * 0.4 + 4 * rounding(2) * 3 * T * (0.5 / 0.15);
            equal = equal && std::abs(velocity(t) - expected) <= allowed;
        }
        return equal;
    };
    const auto table = [](double t) { return inlet(Waveform::table, t); };
    BOOST_TEST(holds(table));
    BOOST_TEST(!holds(off_by(fault, table)));
    BOOST_TEST(!holds([&](double t) { return table(t + fault); }));
}

BOOST_AUTO_TEST_CASE(eq26_a_half_space_of_ghosts_pushes_as_its_lattice_sum)
{
    constexpr double h = 0.02;
    constexpr double dx = 0.02;
    constexpr double p = 5e5;
    constexpr double rho_0 = 1050;
    const auto holds = [&](auto outlet_pressure_force) {
        return std::ranges::all_of(
            std::array{KernelName::cubic_spline, KernelName::wendland_c2}, [&](auto name) {
                const reference::Kernel W(name, h);
                const double z = dx / 2;
                Vec3 force;
                for (int k = 0; k < 3; ++k) {
                    for (int j = -4; j <= 4; ++j) {
                        for (int i = -4; i <= 4; ++i) {
                            const Vec3 ghost{i * dx, j * dx, -(k + 0.5) * dx};
                            const Vec3 grad_W = W.gradient(Vec3{0, 0, z} - ghost);
                            force += outlet_pressure_force(rho_0 * dx * dx * dx, rho_0, p, grad_W);
                        }
                    }
                }
                // 20 roundings a term and 3 * 81 additions; all terms of the normal component are positive,
                // and those of the tangential ones, which cancel, are smaller
                const auto expected = analytic::outlet_force(name, h, dx, p, z);
                const double allowed = rounding(20 + 3 * 81) * expected.value;
                return within(force.z, expected.value, expected.error + allowed) &&
                       within(force.x, 0, allowed) && within(force.y, 0, allowed);
            });
    };
    BOOST_TEST(holds(reference::outlet_pressure_force));
    BOOST_TEST(!holds(off_by(fault, reference::outlet_pressure_force)));
    BOOST_TEST(!holds(off_by(-2, reference::outlet_pressure_force))); // pulls
}

BOOST_AUTO_TEST_CASE(eq26_ghosts_alone_carry_half_of_p_const)
{
    // int_0^2h F dz of the continuum is p/2; the fluid's mirrored pressure has to bring the other half
    constexpr double h = 0.02;
    constexpr double p = 5e5;
    for (const KernelName name : {KernelName::cubic_spline, KernelName::wendland_c2}) {
        const auto force = [&](double z) { return analytic::outlet_force_continuum(name, h, p, z).value; };
        const double total = analytic::integrate_polynomial(force, 0, h).value +
                             analytic::integrate_polynomial(force, h, 2 * h).value;
        // two nested rules of 28 roundings on positive terms
        BOOST_TEST(within(total, p / 2, rounding(56 * 2) * p / 2));
    }
}

BOOST_AUTO_TEST_CASE(eq27_wall_is_at_rest_as_channel_flow_at_its_walls)
{
    const auto holds = [](auto wall_velocity) {
        const Vec3 v = wall_velocity();
        const double H = 0.6;
        return v.x == analytic::channel_velocity(1e3, 3.5e-3, H, 0) &&
               v.x == analytic::channel_velocity(1e3, 3.5e-3, H, H) && v.y == 0 && v.z == 0;
    };
    BOOST_TEST(holds(reference::wall_velocity));
    BOOST_TEST(!holds([] { return Vec3{fault, 0, 0}; }));
}

namespace
{

const analytic::Oscillator wall{0.7, 1100, 2e-3, -0.05};

/// The displacement after n steps of the candidate under F + G sin(O t).
template <class Candidate>
reference::ElasticWall advance(Candidate step, double F, double G, double O, double dt, int n)
{
    reference::ElasticWall state{wall.u_0, wall.v_0};
    for (int k = 0; k < n; ++k) {
        state = step(state, F + G * std::sin(O * k * dt), wall.k, wall.m, dt);
    }
    return state;
}

/// Rounding of n steps: each rounds u and v once on their own size and four times on the change of v, w dt
/// times that of u; an error lives on as an oscillation of 1/cos(theta/2) < 1.01 times its size for w dt <
/// 0.2.
double step_rounding(double size, double dt, int n)
{
    return 1.01 * n * size * (rounding(2) + rounding(5) * wall.frequency() * dt);
}

/// Largest displacement and, over w, velocity under F: the rest position and the swing around it.
double largest(double F, double driven)
{
    const double rest = F / wall.k;
    return rest + std::hypot(wall.u_0 - rest, wall.v_0 / wall.frequency()) + 2 * driven / wall.k;
}

const auto explicit_euler = [](const reference::ElasticWall& w, double F, double k, double m, double dt) {
    return reference::ElasticWall{w.u + dt * w.v, w.v + dt * (F - k * w.u) / m};
};
const auto stiffer = [](const reference::ElasticWall& w, double F, double k, double m, double dt) {
    return reference::advance_elastic_wall(w, F, k * (1 + fault), m, dt);
};

} // namespace

BOOST_AUTO_TEST_CASE(eq28_constant_force_gives_the_discrete_oscillation)
{
    const auto holds = [](auto step) {
        return std::ranges::all_of(std::array{1, 10, 1000, 20'000}, [&](int n) {
            const double dt = 1e-3;
            const double F = 1.3;
            const auto expected = analytic::displacement_after_steps(wall, F, 0, 1, dt, n);
            return within(advance(step, F, 0, 1, dt, n).u, expected.value,
                          expected.error + step_rounding(largest(F, 0), dt, n));
        });
    };
    BOOST_TEST(holds(reference::advance_elastic_wall));
    BOOST_TEST(!holds(stiffer));
    BOOST_TEST(!holds(explicit_euler));
}

BOOST_AUTO_TEST_CASE(eq28_driven_wall_gives_the_discrete_oscillation)
{
    const auto holds = [](auto step) {
        return std::ranges::all_of(std::array{10, 1000, 10'000}, [&](int n) {
            const double dt = 1e-3;
            const double O = 2 * pi / T;
            const double G = 0.9;
            const auto expected = analytic::displacement_after_steps(wall, 1.3, G, O, dt, n);
            // O < w/4, so that the driven swing is below 2 G/k
            return within(advance(step, 1.3, G, O, dt, n).u, expected.value,
                          expected.error + step_rounding(largest(1.3, G), dt, n));
        });
    };
    BOOST_TEST(holds(reference::advance_elastic_wall));
    BOOST_TEST(!holds(stiffer));
    BOOST_TEST(!holds(explicit_euler));
}

BOOST_AUTO_TEST_CASE(eq28_conserves_its_invariant)
{
    const auto holds = [](auto step) {
        const double dt = 1e-3;
        const double before = analytic::step_invariant(wall, 1.3, dt, wall.u_0, wall.v_0);
        const int n = 20'000;
        const reference::ElasticWall end = advance(step, 1.3, 0, 1, dt, n);
        // quadratic: twice the state's error over its amplitude, for each of u and v
        const double amplitude = std::sqrt(2 * before) / wall.frequency();
        const double relative = step_rounding(largest(1.3, 0), dt, n) / amplitude;
        return within(analytic::step_invariant(wall, 1.3, dt, end.u, end.v), before, 4 * relative * before);
    };
    BOOST_TEST(holds(reference::advance_elastic_wall));
    BOOST_TEST(!holds(explicit_euler));
}

BOOST_AUTO_TEST_CASE(eq28_approaches_the_motion_at_order_one)
{
    // from rest under F, the step leads by w dt/2: error A w dt/2 sin(wt) against A cos(wt). At wt = pi/2 the
    // next term is the phase, A n (w dt)^3/24 = A pi/48 (w dt)^2
    const auto holds = [](auto step) {
        return std::ranges::all_of(std::array{100, 200, 400}, [&](int n) {
            const double w = wall.frequency();
            const double dt = pi / 2 / (w * n);
            const double F = 1.3;
            const double A = F / wall.k;
            reference::ElasticWall state;
            for (int k = 0; k < n; ++k) {
                state = step(state, F, wall.k, wall.m, dt);
            }
            const analytic::Oscillator at_rest{wall.m, wall.k, 0, 0};
            const double error = state.u - analytic::displacement(at_rest, F, n * dt);
            // two-sided; twice the next term covers the rest of the series in w dt < 0.02
            const double next = 2 * A * pi / 48 * (w * dt) * (w * dt);
            return within(error, A * w * dt / 2, next + step_rounding(2 * A, dt, n));
        });
    };
    BOOST_TEST(holds(reference::advance_elastic_wall));
    BOOST_TEST(!holds(explicit_euler));
    BOOST_TEST(!holds([](const reference::ElasticWall& s, double F, double k, double m, double dt) {
        return reference::advance_elastic_wall(s, F * (1 + 1e-3), k, m, dt);
    }));
}

BOOST_AUTO_TEST_CASE(eq28_driven_wall_approaches_the_motion_at_order_one)
{
    // at O = w, where the amplitude grows by F/(2 m w) a second, and well below
    const double w = wall.frequency();
    const double G = 0.9;
    const auto holds = [&](auto step) {
        return std::ranges::all_of(std::array{w, w / 5}, [&](double O) {
            return std::ranges::all_of(std::array{8000, 16'000, 32'000}, [&](int per_period) {
                const double dt = 2 * pi / w / per_period;
                const int n = 5 * per_period + per_period / 8;
                const double error =
                    advance(step, 0, G, O, dt, n).u - analytic::displacement_driven(wall, G, O, n * dt);
                // the first step moves by dt^2 a instead of dt^2 a/2, as if v_0 were larger by dt a/2
                const double wt = w * n * dt;
                const double lead = -dt / 2 * w * wall.u_0 * std::sin(wt);
                // then the frequency is high by w (w dt)^2/24: on the swing it counts wt times, on the driven
                // part (1 + wt)^2 times at resonance; doubled for the amplitudes, of the same order
                const double swing = std::hypot(wall.u_0, wall.v_0 / w);
                const double next =
                    std::pow(w * dt, 2) / 12 * (swing * wt + G / (2 * wall.k) * std::pow(1 + wt, 2));
                return within(error, lead, next + step_rounding(largest(0, G * wt), dt, n));
            });
        });
    };
    BOOST_TEST(holds(reference::advance_elastic_wall));
    BOOST_TEST(!holds(explicit_euler));
    BOOST_TEST(!holds([](const reference::ElasticWall& s, double F, double k, double m, double dt) {
        return reference::advance_elastic_wall(s, F * (1 + 1e-4), k, m, dt);
    }));
}

BOOST_AUTO_TEST_CASE(fig1_collision_mirrors_and_puts_back)
{
    const Vec3 n{2.0 / 7, -3.0 / 7, 6.0 / 7};
    const Vec3 outside{0.1, 0.2, 0.3};
    const double depth = 0.004;
    const auto holds = [&](auto collide) {
        const Vec3 v{0.5, -0.1, 0.7}; // outwards
        const reference::Collision hit = collide(outside, v, depth, n);
        const Eigen::Vector3d mirrored = analytic::mirrored({v.x, v.y, v.z}, {n.x, n.y, n.z});
        const Vec3 expected{mirrored.x(), mirrored.y(), mirrored.z()};
        const reference::Collision leaving = collide(outside, -v, depth, n);
        // 8 roundings on components below 1; |v| is kept up to those and the 6 of n's own length
        return distance(hit.velocity, expected) <= rounding(2 * 8) &&
               within(length(hit.velocity), length(v), rounding(8 + 6) * 2) && leaving.velocity == -v &&
               within(dot(outside - hit.position, n), depth, rounding(8));
    };
    using reference::Collision;
    BOOST_TEST(holds(reference::collide));
    BOOST_TEST(!holds([](const Vec3& r, const Vec3& v, double d, const Vec3& m) {
        Collision c = reference::collide(r, v, d, m);
        c.velocity = (1 + fault) * c.velocity;
        return c;
    }));
    BOOST_TEST(!holds([](const Vec3& r, const Vec3& v, double, const Vec3& m) { // left outside
        return reference::collide(r, v, 0, m);
    }));
    BOOST_TEST(
        !holds([](const Vec3& r, const Vec3& v, double d, const Vec3& m) { // turned round when leaving too
            return Collision{r - d * m, v - 2 * dot(v, m) * m};
        }));
}
