// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace aneurysm::bounds
{
namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

/// The largest of a set whose members may be uncertain.
struct Largest {
    double low = -infinite;
    double high = -infinite;

    void add(double value, double error, Truth member)
    {
        if (member == Truth::yes) {
            low = std::max(low, value - error);
        }
        if (member != Truth::no) {
            high = std::max(high, value + error);
        }
    }
};

} // namespace

RecordBounds::RecordBounds(const Scenario& scenario, const WallBounds& wall, double dx,
                           const Rounding& rounding)
    : scenario_(&scenario), wall_(&wall), dx_(dx), rounding_(rounding)
{
}

void RecordBounds::begin()
{
    const RecordBounds fresh(*scenario_, *wall_, dx_, rounding_);
    *this = fresh;
}

void RecordBounds::add_step(const SimulationState& state, const reference::FlowStep& step,
                            const reference::Wall& wall, const StepBounds& bounds,
                            const ParticleErrors& errors, const ParticleErrors& before)
{
    bound_density(state, step, bounds, before);
    bound_motion(state, errors);
    bound_solve(step, bounds);
    bound_impact(state, wall, bounds, errors);
}

/// rho / rho_0 - 1 near the ends and elsewhere, by where the step began.
void RecordBounds::bound_density(const SimulationState& state, const reference::FlowStep& step,
                                 const StepBounds& bounds, const ParticleErrors& errors)
{
    const double rho_0 = scenario_->fluid.density_kg_m3;
    const Inexact ends{-scenario_->vessel.radius_m, scenario_->vessel.radius_m};
    Largest excess;
    Largest deficit;
    Largest at_ends;
    excess.add(-1, 0, Truth::yes);
    at_ends.add(-1, 0, Truth::yes);
    deficit.add(-scenario_->pressure.blow_up_density_ratio, 0, Truth::yes);
    double sum = 0;
    double sum_error = 0;
    double count = 0;
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        if (state.particles.kind[i] != Kind::fluid) {
            continue;
        }
        const double ratio = step.rho[i] / rho_0;
        const double units = bounds.density[i] / rho_0 + 2 * ratio + std::abs(ratio - 1);
        const double error = rounding_.absolute(units);
        const Truth near =
            wall_->is_beyond_nearest(inexact(step.bodies.position[i], errors.position[i]), ends);
        at_ends.add(ratio - 1, error, near);
        excess.add(ratio - 1, error, !near);
        deficit.add(1 - ratio, error, !near);
        sum += std::max(ratio - 1, 0.0);
        sum_error += units;
        ++count;
    }
    low_.density_error_max = excess.low;
    high_.density_error_max = excess.high;
    low_.density_error_min = -deficit.high;
    high_.density_error_min = -deficit.low;
    low_.density_error_max_ends = at_ends.low;
    high_.density_error_max_ends = at_ends.high;
    error_.density_error_mean = rounding_.absolute((sum_error + (count + 2) * sum) / std::max(count, 1.0));
}

void RecordBounds::bound_motion(const SimulationState& state, const ParticleErrors& errors)
{
    const Particles& p = state.particles;
    Largest speed;
    speed.add(low_.speed_max, 0, Truth::yes);
    double energy = 0;
    double energy_error = 0;
    double count = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::fluid) {
            const double v = length(p.velocity[i]);
            const double units = errors.velocity[i] + 3 * v;
            speed.add(v, rounding_.absolute(units), Truth::yes);
            energy += 0.5 * p.mass * v * v;
            energy_error += p.mass * v * units;
            ++count;
        }
    }
    low_.speed_max = speed.low;
    high_.speed_max = std::max(speed.high, high_.speed_max);
    error_.kinetic_energy = rounding_.absolute(energy_error + (count + 5) * energy);
}

void RecordBounds::bound_solve(const reference::FlowStep& step, const StepBounds& bounds)
{
    double count = 0;
    double divergence = 0;
    double residual = 0;
    error_.divergence_max = 0;
    error_.residual_max = 0;
    for (std::size_t i = 0; i < bounds.residual.size(); ++i) {
        if (step.bodies.free(i)) {
            divergence += bounds.divergence[i];
            residual += bounds.residual[i];
            error_.divergence_max = std::max(error_.divergence_max, rounding_.absolute(bounds.divergence[i]));
            error_.residual_max = std::max(error_.residual_max, rounding_.absolute(bounds.residual[i]));
            ++count;
        }
    }
    // The rounding of the mean itself is added when its value is known.
    error_.divergence_mean = rounding_.absolute(divergence / std::max(count, 1.0));
    error_.residual_mean = rounding_.absolute(residual / std::max(count, 1.0));
}

/// S of (16) and its forces.
void RecordBounds::bound_impact(const SimulationState& state, const reference::Wall& wall,
                                const StepBounds& bounds, const ParticleErrors& errors)
{
    const Particles& p = state.particles;
    const double band_width = scenario_->rupture.impact_band_spacings * dx_;
    const Inexact band{-band_width, 2 * band_width};
    const Inexact R = rounded(wall.radius);
    Largest force;
    Largest force_eos;
    low_.impact_count = 0;
    high_.impact_count = 0;
    for (std::size_t i = 0; wall_->vessel().has_sac() && i < p.size(); ++i) {
        // Three spacings further in no rounding matters.
        if (p.kind[i] != Kind::fluid ||
            wall_->vessel().wall(p.position[i], wall.radius).value < -band_width - 3 * dx_) {
            continue;
        }
        const InexactVec x = inexact(p.position[i], errors.position[i]);
        const Truth touches = is_positive(wall_->wall(x, R).value - band, rounding_);
        const Truth member =
            touches == Truth::no
                ? touches
                : touches && is_positive(wall_->tubes(x).value - wall_->sac(x, R).value, rounding_);
        if (member == Truth::no) {
            continue;
        }
        low_.impact_count += member == Truth::yes ? 1 : 0;
        ++high_.impact_count;
        const InexactForce F = bounds.force(i);
        force.add(F.dfsph.value, rounding_.absolute(F.dfsph.error), member);
        force_eos.add(F.eos.value, rounding_.absolute(F.eos.error), member);
        hits_.push_back({static_cast<std::int64_t>(i), F.dfsph});
    }
    if (high_.impact_count == 0) {
        return;
    }
    // Nothing certain: F_b may be 0.
    const double low_eos = std::max(force_eos.low, 0.0);
    low_.impact_force = std::max({low_.impact_force, force.low, 0.0});
    high_.impact_force = std::max(high_.impact_force, force.high);
    low_.impact_force_eos = impact_found_ ? std::min(low_.impact_force_eos, low_eos) : low_eos;
    high_.impact_force_eos = std::max(high_.impact_force_eos, force_eos.high);
    impact_found_ = true;
}

void RecordBounds::add_collisions(const CollisionCounts& counts)
{
    low_.collisions += counts.collisions_certain;
    high_.collisions += counts.collisions_possible;
    low_.outside = counts.outside_certain;
    high_.outside = counts.outside_possible;
}

void RecordBounds::finish(const FrameRecord& record, const ParticleErrors& errors,
                          const Inexact& inlet_velocity, FrameRecord& low, FrameRecord& high) const
{
    low = record;
    high = record;
    const auto n = static_cast<double>(record.active);
    FrameRecord error = error_;
    error.time = rounding_.absolute(2 * record.time);
    error.inlet_velocity = rounding_.absolute(inlet_velocity.error);
    error.outlet_velocity = rounding_.absolute(errors.outlet_velocity[0] + errors.outlet_velocity[1] +
                                               2 * std::abs(record.outlet_velocity));
    error.divergence_mean += rounding_.absolute(n * record.divergence_mean);
    error.residual_mean += rounding_.absolute(n * record.residual_mean);
    for (const auto number :
         {&FrameRecord::time, &FrameRecord::inlet_velocity, &FrameRecord::outlet_velocity,
          &FrameRecord::density_error_mean, &FrameRecord::divergence_mean, &FrameRecord::divergence_max,
          &FrameRecord::residual_mean, &FrameRecord::residual_max, &FrameRecord::kinetic_energy}) {
        low.*number -= error.*number;
        high.*number += error.*number;
    }
    const auto take = [&](auto number) {
        low.*number = low_.*number;
        high.*number = high_.*number;
    };
    for (const auto number : {&FrameRecord::density_error_max, &FrameRecord::density_error_min,
                              &FrameRecord::density_error_max_ends, &FrameRecord::speed_max,
                              &FrameRecord::impact_force, &FrameRecord::impact_force_eos}) {
        take(number);
    }
    for (const auto count : {&FrameRecord::impact_count, &FrameRecord::collisions, &FrameRecord::outside}) {
        take(count);
    }
    const Ledger& other = errors.other_counts;
    for (const auto count : {&Ledger::inlet_in, &Ledger::inlet_out, &Ledger::outlet_in, &Ledger::outlet_out,
                             &Ledger::escaped, &Ledger::recycled}) {
        low.ledger.*count -= other.*count;
        high.ledger.*count += other.*count;
    }
    const std::int64_t blood =
        other.inlet_in + other.inlet_out + other.outlet_in + other.outlet_out + other.escaped;
    low.fluid -= blood;
    high.fluid += blood;
    low.active -= other.recycled;
    high.active += other.recycled;
}

} // namespace aneurysm::bounds
