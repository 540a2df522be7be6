// SPDX-License-Identifier: Apache-2.0
#include "verification/comparison/ensemble.hpp"

#include "common/parallel.hpp"
#include "reference/simulation.hpp"
#include "verification/bounds/frame.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace aneurysm::comparison
{
namespace
{

/// Random numbers of one member, the same everywhere.
class Disturbance
{
public:
    explicit Disturbance(int member) : engine_(static_cast<std::uint64_t>(member)) {}

    /// Uniform in [-bound, bound).
    double number(double bound)
    {
        return bound * (std::ldexp(static_cast<double>(engine_() >> 11U), -52) - 1);
    }
    /// Within a ball of radius `bound`.
    Vec3 vector(double bound)
    {
        const double edge = bound / std::numbers::sqrt3;
        const double x = number(edge);
        const double y = number(edge);
        return {x, y, number(edge)};
    }

private:
    std::mt19937_64 engine_;
};

/// By one ulp of the candidate's precision, up or down.
void disturb_start(SimulationState& state, double unit, Disturbance& random)
{
    for (Vec3& x : state.particles.position) {
        const Vec3 sign = random.vector(1);
        const auto ulp = [unit](double a, double s) { return a + std::copysign(2 * unit * std::abs(a), s); };
        x = {ulp(x.x, sign.x), ulp(x.y, sign.y), ulp(x.z, sign.z)};
    }
}

/// Roundings of a sum's terms are independent: of n they add up as sqrt(n), where a bound takes n (Higham and Mary 2019);
/// the support of two spacings holds 33.
const double of_bound = 1 / std::sqrt(33.0);

/// About as rounding does to the candidate in a frame. A fully developed radius is a constant.
void disturb(SimulationState& state, const bounds::ParticleErrors& errors, const AneurysmState& wall,
             double largest_radius, const bounds::Rounding& rounding, Disturbance& random)
{
    const auto size = [&rounding](double units) { return of_bound * rounding.absolute(units); };
    Particles& p = state.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] != Kind::reserve) {
            p.position[i] += random.vector(size(errors.position[i]));
            p.velocity[i] += random.vector(size(errors.velocity[i]));
            p.drift[i] += random.number(size(errors.drift[i]));
        }
    }
    for (std::size_t k = 0; k < 2; ++k) {
        state.outlet_velocity.at(k) += random.number(size(errors.outlet_velocity.at(k)));
    }
    AneurysmState& a = state.aneurysm;
    if (a.radius < largest_radius) {
        a.radius = std::min(a.radius + random.number(of_bound * wall.radius), largest_radius);
    }
    a.thickness += random.number(of_bound * wall.thickness);
    a.displacement += random.number(of_bound * wall.displacement);
    a.wall_velocity += random.number(of_bound * wall.wall_velocity);
}

/// The solve of (3) stops when its residual is below the tolerance, and rounding moves the residual.
void disturb_tolerances(reference::Simulation& simulation, const Scenario& scenario,
                        const FrameRecord& record, const bounds::FrameRange& range, Disturbance& random)
{
    const auto disturbed = [&random](double tolerance, double bound) {
        return std::max(tolerance + random.number(of_bound * bound), 0.5 * tolerance);
    };
    simulation.set_tolerances(
        disturbed(scenario.pressure.tolerance_per_s, range.high.residual_mean - record.residual_mean),
        disturbed(scenario.pressure.max_tolerance_per_s, range.high.residual_max - record.residual_max));
}

/// Half the ranges of the numbers that are compared.
FreeFrame one_frame_rounding(const bounds::FrameRange& range, const bounds::ParticleErrors& errors,
                             const Particles& p, const bounds::Rounding& rounding)
{
    FreeFrame half;
    for (const auto member : {&FrameRecord::impact_force, &FrameRecord::radius, &FrameRecord::thickness,
                              &FrameRecord::critical_pressure, &FrameRecord::kinetic_energy}) {
        half.record.*member = range.high.*member - range.low.*member;
    }
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::fluid) {
            sum += p.mass * rounding.absolute(errors.velocity[i] + 2 * length(p.velocity[i]));
        }
    }
    half.momentum = {sum, sum, sum};
    return half;
}

FreeRun run_member(const Scenario& scenario, SimulationState start, Precision precision, std::int64_t frames,
                   std::int64_t window, int member, const FrameDone& done)
{
    const double unit = bounds::unit_roundoff(precision);
    const bounds::Rounding rounding(unit);
    Disturbance random(member);
    if (member > 0) {
        disturb_start(start, unit, random);
    }
    reference::Simulation simulation(scenario, std::move(start));
    bounds::FrameBounds bounds(scenario, simulation.vessel(), simulation.state().spacing, rounding);
    FreeRun run;
    for (std::int64_t n = 1; n <= frames; ++n) {
        const SimulationState before = simulation.state();
        bounds.begin(before.particles.size());
        const FrameRecord record = simulation.advance({}, bounds);
        const bounds::FrameRange range = bounds.finish(before, simulation.state(), record);
        const Particles& p = simulation.state().particles;
        run.frames.push_back({record, momentum(p)});
        if (member == 0) {
            run.rounding.push_back(one_frame_rounding(range, bounds.errors(), p, rounding));
        } else {
            SimulationState state = simulation.state();
            disturb(state, bounds.errors(), range.aneurysm_error, simulation.vessel().largest_radius(),
                    rounding, random);
            simulation.restart(std::move(state));
            disturb_tolerances(simulation, scenario, record, range, random);
        }
        if (n % window == 0) {
            run.particles.push_back(p);
        }
        if (!done(record)) {
            break;
        }
    }
    return run;
}

} // namespace

Vec3 momentum(const Particles& p)
{
    Vec3 sum;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::fluid) {
            sum += p.mass * p.velocity[i];
        }
    }
    return sum;
}

std::vector<FreeRun> run_ensemble(const Scenario& scenario, const SimulationState& start, Precision precision,
                                  std::int64_t frames, std::int64_t window, int members,
                                  const FrameDone& done)
{
    std::vector<FreeRun> runs(static_cast<std::size_t>(members) + 1);
    in_parallel(runs.size(), std::min(thread_count(0), members + 1), [&](std::size_t k) {
        runs[k] = run_member(scenario, start, precision, frames, window, static_cast<int>(k), done);
    });
    return runs;
}

} // namespace aneurysm::comparison
