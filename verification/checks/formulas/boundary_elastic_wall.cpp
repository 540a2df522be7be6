// SPDX-License-Identifier: Apache-2.0
// Section 3.5: the elastic wall (28), its steps and the motion that they follow.
#include "analytic/boundary.hpp"
#include "analytic/relations.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace aneurysm::checks
{
namespace
{

using analytic::Estimate;
using analytic::Oscillator;
using std::numbers::pi;

constexpr Oscillator wall{0.7, 1100, 2e-3, -0.05};

/// n steps under F + G sin(O t) from the wall's state at 0.
ElasticWall advance(const backends::Equations& equations, const Oscillator& from, double F, double G,
                    double O, double dt, int n)
{
    ElasticWall state{from.u_0, from.v_0};
    for (int k = 0; k < n; ++k) {
        state = equations.advance_elastic_wall(state, F + G * std::sin(O * k * dt), from.k, from.m, dt);
    }
    return state;
}

/// Rounding of n steps for w dt < 0.2 (docs/bounds.md, B17).
double step_rounding(double size, double dt, int n)
{
    return 1.01 * n * size * (rounding(2) + rounding(5) * wall.frequency() * dt);
}
constexpr const char* of_steps = "1.01 n A (gamma_2 + gamma_5 w dt) for the rounding of n steps on the "
                                 "amplitude A (docs/bounds.md, B17)";

/// Largest displacement and, over w, velocity: the rest position under F, the swing around it, and the motion
/// driven by G well below the resonance.
double largest(double F, double G)
{
    const double rest = F / wall.k;
    return rest + std::hypot(wall.u_0 - rest, wall.v_0 / wall.frequency()) + 2 * G / wall.k;
}

void eq28_step(Probe& probe)
{
    Quantity& force = probe.quantity(
        "F - k u - m d^2u/dt^2 of three displacements, 50 digits, over |F| + k |u| [1]", Source::rounding,
        "gamma_4 (|F| + k |u|) for the four operations of v'; m/dt^2 times u of each new displacement and of "
        "each product dt v, and gamma_2 of dt v'; in the first step, the place before it is u - dt v");
    Quantity& motion = probe.quantity("u' - u - dt v', 50 digits, over |u'| + dt |v'| [1]", Source::rounding,
                                      "u each of the sum and the product");
    Arguments a(28);
    for (int n = 0; n < 200; ++n) {
        const double m = a.between(0.2, 3);
        const double k = a.between(50, 3000);
        const double dt = a.between(0.3, 1.7) / std::sqrt(k / m); // so that all terms are of the same size
        const double u_0 = a.between(-0.03, 0.03);
        const ElasticWall start{u_0, a.between(-1, 1) * 0.03 / dt};
        const double F_0 = a.between(-1, 1) * 0.03 * k;
        const double F_1 = a.between(-1, 1) * 0.03 * k;
        const ElasticWall one = probe.equations().advance_elastic_wall(start, F_0, k, m, dt);
        const ElasticWall two = probe.equations().advance_elastic_wall(one, F_1, k, m, dt);
        const std::string where = at({{"m", m}, {"k", k}, {"dt", dt}, {"set", double(n)}});

        const double forces = std::abs(F_1) + std::abs(k * one.u);
        const double moved = rounding(1) * (std::abs(two.u) + std::abs(one.u) + dt * std::abs(one.v)) +
                             rounding(2) * dt * std::abs(two.v);
        force.within(analytic::oscillator_residual(m, k, F_1, dt, start.u, one.u, two.u) / forces, 0,
                     rounding(4) + m / (dt * dt) * moved / forces, where);
        const double begins = std::abs(F_0) + std::abs(k * start.u);
        const double changed = rounding(2) * dt * (std::abs(start.v) + std::abs(one.v)) +
                               rounding(1) * (2 * std::abs(start.u) + std::abs(one.u));
        force.within(analytic::oscillator_residual(m, k, F_0, dt, start.u - dt * start.v, start.u, one.u) /
                         begins,
                     0, rounding(4) + m / (dt * dt) * changed / begins, where + ", first step");
        for (const auto& [before, after] : {std::pair{start, one}, std::pair{one, two}}) {
            const double size = std::abs(after.u) + dt * std::abs(after.v);
            motion.within(analytic::displacement_residual(dt, before.u, after.u, after.v) / size, 0,
                          rounding(1), where);
        }
    }
}

void eq28_oscillation(Probe& probe)
{
    Quantity& constant =
        probe.quantity("u after n steps under a constant force over its amplitude [1]", Source::rounding,
                       std::string("the oracle's angle, n theta u, and ten operations; ") + of_steps);
    Quantity& driven =
        probe.quantity("u after n steps under a driving force over its amplitude [1]", Source::rounding,
                       std::string("the oracle's angle, n theta u, and ten operations; ") + of_steps);
    Quantity& invariant = probe.quantity(
        "what the steps conserve over its start [1]", Source::rounding,
        std::string("4 times the error of u over A, for it is quadratic in u and v; ") + of_steps);
    const double dt = 1e-3;
    const double F = 1.3;
    const double G = 0.9;
    for (const int n : {1, 10, 1000, 20'000}) {
        const std::string where = at({{"n", double(n)}});
        const double A = largest(F, 0);
        const Estimate exact = analytic::displacement_after_steps(wall, F, 0, 1, dt, n);
        const ElasticWall end = advance(probe.equations(), wall, F, 0, 1, dt, n);
        constant.within(end.u / A, exact.value / A, (exact.error + step_rounding(A, dt, n)) / A, where);

        const double O = 2 * pi / 0.8;
        const double B = largest(F, G);
        const Estimate swung = analytic::displacement_after_steps(wall, F, G, O, dt, n);
        const ElasticWall driven_end = advance(probe.equations(), wall, F, G, O, dt, n);
        driven.within(driven_end.u / B, swung.value / B, (swung.error + step_rounding(B, dt, n)) / B, where);

        const double before = analytic::step_invariant(wall, F, dt, wall.u_0, wall.v_0);
        const double amplitude = std::sqrt(2 * before) / wall.frequency();
        invariant.within(analytic::step_invariant(wall, F, dt, end.u, end.v) / before, 1,
                         4 * step_rounding(A, dt, n) / amplitude, where);
    }
}

void eq28_order(Probe& probe)
{
    Quantity& rest =
        probe.quantity("u under a force from rest less the motion, over w dt/2 A [1]", Source::truncation,
                       std::string("two-sided: at wt = pi/2 the step leads by w dt/2 A; 2 A pi/48 (w dt)^2 "
                                   "for its phase, the next term, and the rest of the series; ") +
                           of_steps);
    Quantity& driven = probe.quantity(
        "u of a driven wall less the motion, over dt v swing [1]", Source::truncation,
        std::string("two-sided: the first step moves by dt^2 a, not half of it, as if v_0 were larger by dt "
                    "a/2; then the frequency is high by w (w dt)^2/24, which counts wt times on the swing "
                    "and (1 + wt)^2 times on the driven part at resonance, doubled for the amplitudes; ") +
            of_steps);
    const double w = wall.frequency();
    for (const int n : {100, 200, 400}) {
        const double dt = pi / 2 / (w * n);
        const double F = 1.3;
        const double A = F / wall.k;
        const Oscillator from_rest{wall.m, wall.k, 0, 0};
        const double error = advance(probe.equations(), from_rest, F, 0, 1, dt, n).u -
                             analytic::displacement(from_rest, F, n * dt);
        const double lead = A * w * dt / 2;
        const double next = 2 * A * pi / 48 * (w * dt) * (w * dt);
        rest.within(error / lead, 1, (next + step_rounding(2 * A, dt, n)) / lead, at({{"n", double(n)}}));
    }
    const double G = 0.9;
    for (const double O : {w, w / 5}) { // at the resonance the amplitude grows by G/(2 m w) a second
        for (const int per_period : {8000, 16'000, 32'000}) {
            const double dt = 2 * pi / w / per_period;
            const int n = 5 * per_period + per_period / 8;
            const double error = advance(probe.equations(), wall, 0, G, O, dt, n).u -
                                 analytic::displacement_driven(wall, G, O, n * dt);
            const double wt = w * n * dt;
            const double lead = -dt / 2 * w * wall.u_0 * std::sin(wt);
            const double swing = std::hypot(wall.u_0, wall.v_0 / w);
            const double next =
                std::pow(w * dt, 2) / 12 * (swing * wt + G / (2 * wall.k) * std::pow(1 + wt, 2));
            driven.within(error / lead, 1, (next + step_rounding(largest(0, G * wt), dt, n)) / std::abs(lead),
                          at({{"O/w", O / w}, {"steps a period", double(per_period)}}));
        }
    }
}

/// The wall with a column of mass M from rest, and what n steps' rounding makes of u.
struct Carried {
    std::vector<double> u; ///< after 0, 1, ... steps [m]
    double rounding = 0;   ///< of the last [m]
};

/// Displacements after 0 to n steps from u_0, v_0, when the column's last velocity was `before`.
std::vector<double> carry(const backends::Equations& equations, double M, double F, double dt,
                          ElasticWall state, double before, int n)
{
    std::vector<double> u{state.u};
    for (int k = 0; k < n; ++k) {
        const double column = M * (state.v - before) / dt;
        before = state.v;
        state = equations.advance_elastic_wall(state, F - column, wall.k, wall.m, dt);
        u.push_back(state.u);
    }
    return u;
}

Carried carried(const backends::Equations& equations, double M, double F, double dt, int n)
{
    Carried result{carry(equations, M, F, dt, {}, 0, n)};
    const double A = 2 * F / wall.k; // it swings from 0 to there
    const double V = A * wall.frequency();
    const double of_v = rounding(7) * dt / wall.m * (F + wall.k * A + M * F / wall.m) + rounding(1) * V;
    const double of_u = rounding(2) * (A + dt * V);
    for (const double x : carry(equations, M, 0, dt, {0, 1}, 0, n)) {
        result.rounding += of_v * std::abs(x);
    }
    for (const double x : carry(equations, M, 0, dt, {1, 0}, 0, n)) {
        result.rounding += of_u * std::abs(x);
    }
    return result;
}

/// The wall pushes a column of blood, whose mass it then has, too.
void eq28_column(Probe& probe)
{
    Quantity& motion = probe.quantity(
        "u of a wall with a column after n steps [m]", Source::rounding,
        "each step's rounding of u, gamma_2, and of v, gamma_7 of the forces over m and gamma_1 of v, times "
        "what a unit of each becomes in the steps that follow, summed; + the oracle's own error");
    Quantity& frequency = probe.quantity(
        "(theta/e - 1)/e^2 less its leading term, e = dt sqrt(k/(m + M)) [1]", Source::truncation,
        "two-sided: the next coefficient of the steps' angle is below 1/12; three differences of u, each off "
        "by its rounding, over e^3 (docs/bounds.md, B19)");
    const double F = 1.3;
    const double M = wall.m / 2;
    const double r = M / (wall.m + M);
    for (const double dt : {4e-3, 2e-3, 1e-3}) {
        const int n = static_cast<int>(std::lround(0.4 / dt));
        const Carried found = carried(probe.equations(), M, F, dt, n);
        const Estimate exact = analytic::wall_with_column(wall, M, F, dt, n);
        motion.within(found.u.back(), exact.value, exact.error + found.rounding, at({{"dt", dt}}));

        // x_n+1 + q x_n-1 = p x_n twice, p = 2 |z| cos theta, q = |z|^2: the column's own root has died out
        const auto x = [&](int back) { return found.u[static_cast<std::size_t>(n - back)] - F / wall.k; };
        const double determinant = x(1) * x(3) - x(2) * x(2);
        const double p = (x(0) * x(3) - x(1) * x(2)) / determinant;
        const double q = (x(0) * x(2) - x(1) * x(1)) / determinant;
        const double theta = std::acos(p / (2 * std::sqrt(q)));
        const double e = dt * std::sqrt(wall.k / (wall.m + M));
        const double leading = (1.0 / 12 + r / 2 - 5 * r * r / 4) / 2;
        const double swing = std::sqrt(std::abs(determinant)) / e;
        frequency.within((theta / e - 1) / (e * e), leading,
                         e * e / 12 + 16 * found.rounding / swing / std::pow(e, 5), at({{"dt", dt}}));
    }
}

void eq28_oracles(Probe& probe)
{
    Quantity& response = probe.quantity("closed forms of the motion against Duhamel's integral, over A [1]",
                                        Source::quadrature,
                                        "GSL's estimate and 16 u of the integral; gamma_8 (1 + wt) for the "
                                        "angle in each of its and the closed form's sines");
    Quantity& kept =
        probe.quantity("invariant of the closed form's steps over its start [1]", Source::rounding,
                       "2 v times the error of both displacements over dt, and w^2 times that of one twice u "
                       "and dt v, of the start");
    Quantity& limit = probe.quantity(
        "closed form of the steps less that of the motion, over the swing [1]", Source::truncation,
        "two-sided: the first step and (w dt)^2/12 (1 + w t) for frequency and amplitude, doubled for the "
        "rest of the series (docs/bounds.md, B18)");
    const double w = wall.frequency();
    for (const double t : {0.013, 0.71, 2.9}) {
        for (const double O : {0.0, w, w / 5}) {
            const double F = 1.3;
            const double u =
                O == 0 ? analytic::displacement(wall, F, t) : analytic::displacement_driven(wall, F, O, t);
            const double A = largest(F, F) + F / (2 * wall.k) * w * t;
            const Estimate pushed = analytic::driven_response(
                wall, [&](double s) { return O == 0 ? F : F * std::sin(O * s); }, t);
            const double free = analytic::displacement(wall, 0, t);
            response.within(u / A, (free + pushed.value) / A,
                            pushed.error / A + 2 * rounding(8) * (1 + w * t), at({{"t", t}, {"O/w", O / w}}));
        }
    }
    for (const int n : {7, 400, 9000}) {
        const double dt = 1e-3;
        const double F = 1.3;
        const Estimate before = analytic::displacement_after_steps(wall, F, 0, 1, dt, n - 1);
        const Estimate u = analytic::displacement_after_steps(wall, F, 0, 1, dt, n);
        const double v = (u.value - before.value) / dt;
        const double start = analytic::step_invariant(wall, F, dt, wall.u_0, wall.v_0);
        const double of_v = (u.error + before.error) / dt + rounding(2) * std::abs(v);
        const double size = std::abs(u.value - F / wall.k) + dt * std::abs(v);
        const double allowed =
            2 * (std::abs(v) * of_v + w * w * size * (u.error + dt * of_v)) + rounding(8) * start;
        kept.within(analytic::step_invariant(wall, F, dt, u.value, v) / start, 1, allowed / start,
                    at({{"n", double(n)}}));
    }
    for (const int n : {1000, 10'000}) {
        const double F = 1.3;
        const double t = 0.3;
        const double dt = t / n;
        const double offset = wall.u_0 - F / wall.k;
        const double swing = std::hypot(offset, wall.v_0 / w);
        const double lead = -dt / 2 * w * offset * std::sin(w * t);
        const double difference = analytic::displacement_after_steps(wall, F, 0, 1, dt, n).value -
                                  analytic::displacement(wall, F, t);
        limit.within(difference / swing, lead / swing, std::pow(w * dt, 2) / 12 * (1 + w * t),
                     at({{"n", double(n)}}));
    }
}

} // namespace

std::vector<Check> boundary_elastic_wall_checks()
{
    return {
        formula_check(
            "eq28_step", {"28"}, "two steps make the difference quotient that Newton's law demands",
            {"Newton's law for three displacements, 50 digits", "velocity as a difference, 50 digits"},
            eq28_step),
        formula_check("eq28_oscillation", {"28"},
                      "many steps give the discrete oscillation, and keep its invariant",
                      {"closed form of the discrete motion", "invariant"}, eq28_oscillation),
        formula_check("eq28_order", {"28"},
                      "the steps miss the motion by their first order, no more and no less",
                      {"closed form under a constant force", "closed form of the driven motion"}, eq28_order),
        formula_check("eq28_column", {"28"},
                      "a wall that pushes a column of blood swings with the mass of both",
                      {"roots of the steps' characteristic polynomial (GSL)",
                       "frequency sqrt(k/(m + M)) with its next term"},
                      eq28_column),
        oracle_check(
            "eq28_oracles", Level::scalar, {"28"},
            "the closed forms of the motion answer the force as they must, and that of the steps tends "
            "to them",
            {"Duhamel's integral by GSL quadrature", "limit of short steps"}, eq28_oracles),
    };
}

} // namespace aneurysm::checks
