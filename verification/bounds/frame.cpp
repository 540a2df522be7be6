// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/frame.hpp"

#include "common/vessel/body_force.hpp"
#include "reference/incompressible.hpp"
#include "reference/rupture.hpp"
#include "verification/bounds/seam.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace aneurysm::bounds
{

using reference::FlowStage;
using reference::FlowStep;
using reference::Role;

namespace
{

double smoothing_length(const Scenario& scenario, double dx)
{
    return scenario.kernel.smoothing_length_spacings * dx;
}

double particle_mass(const Scenario& scenario, double dx)
{
    const reference::Kernel W(scenario.kernel.function, smoothing_length(scenario, dx));
    return scenario.fluid.density_kg_m3 / reference::lattice_kernel_sum(W, dx);
}

} // namespace

FrameBounds::FrameBounds(const Scenario& scenario, const Vessel& vessel, double dx, const Rounding& rounding)
    : scenario_(&scenario), rounding_(rounding),
      kernel_(scenario.kernel.function, smoothing_length(scenario, dx)), wall_(vessel, scenario, rounding),
      ghosts_(scenario, wall_, dx, kernel_.support(), particle_mass(scenario, dx), rounding),
      openings_(scenario, wall_, dx, rounding), collisions_(wall_, dx, scenario.collision.rebound, rounding),
      record_(scenario, wall_, dx, rounding), deform_(scenario, vessel.largest_radius(), dx)
{
}

void FrameBounds::begin(std::size_t particles)
{
    errors_.emplace(particles);
    frame_ghosts_.reset();
    breach_.reset();
    record_.begin();
    taken_pressure_.clear();
    taken_kappa_.clear();
}

void FrameBounds::see(FlowStage stage, double t, const SimulationState& state, const reference::Wall& wall,
                      const FlowStep* step)
{
    time_ = t;
    switch (stage) {
    case FlowStage::begun:
        // A kind that rounding decides in one step makes the next step's sums undecided.
        errors_->frame_open =
            errors_->frame_open || errors_->exchange_open ||
            std::ranges::any_of(errors_->other_kind, [](const auto& k) { return k.has_value(); });
        if (!frame_ghosts_) {
            frame_ghosts_ = ghosts_.at(wall);
        }
        break;
    case FlowStage::driven:
        openings_.drive(state, t, *errors_);
        driven_ = state;
        break;
    case FlowStage::moved:
        see_moved(state, wall, *step);
        record_.add_collisions(collisions_.bound(state.particles, wall, *errors_));
        break;
    case FlowStage::collided:
        last_ = state;
        break;
    case FlowStage::exchanged:
        openings_.exchange(last_.particles, state.particles, t, *errors_);
        last_ = state;
        if (wall.breach) {
            breach_ = wall.breach->center;
        }
        break;
    }
}

/// None while gravity is balanced. Frame number times dt, the sine's argument and the sine: 8 roundings to
/// double on each side.
BodyForce FrameBounds::body_force(const AneurysmState& aneurysm) const
{
    if (wall_.vessel().is_open(1) && aneurysm.phase != Phase::ruptured) {
        return {};
    }
    const Vec3& g = scenario_->fluid.gravity_m_s2;
    const double T = scenario_->fluid.gravity_cycle_s;
    if (!(T > 0)) {
        return {g, 0};
    }
    const double in_double = 2 * 8 * 0x1p-53 * length(g) * (2 * std::numbers::pi / T * time_ + 1);
    return {body_force_factor(*scenario_, time_) * g, rounding_.units(in_double)};
}

StepInput FrameBounds::step_input(const SimulationState& state, const FlowStep& step) const
{
    const std::size_t count = state.particles.size();
    const InexactGhosts& g = *frame_ghosts_;
    const AneurysmState& aneurysm = state.aneurysm;
    StepInput in{wall_.vessel().period(),
                 body_force(aneurysm),
                 openings_.level(aneurysm.phase, time_),
                 step,
                 driven_,
                 state.particles,
                 step.bodies,
                 errors_->position,
                 std::vector<double>(count, state.particles.mass),
                 *errors_};
    reference::Bodies& bodies = in.bodies;
    bodies.position.resize(count);
    bodies.position.insert(bodies.position.end(), g.ghosts.position.begin(), g.ghosts.position.end());
    bodies.mass.resize(count);
    bodies.mass.insert(bodies.mass.end(), g.ghosts.mass.begin(), g.ghosts.mass.end());
    bodies.velocity.resize(bodies.size());
    const bool slips = scenario_->domain.wall == WallCondition::slip;
    bodies.role.resize(bodies.size(), slips ? Role::slip : Role::mirror);
    in.position_error.insert(in.position_error.end(), g.position_error.begin(), g.position_error.end());
    in.mass_error.insert(in.mass_error.end(), g.mass_error.begin(), g.mass_error.end());
    return in;
}

void FrameBounds::see_moved(const SimulationState& state, const reference::Wall& wall, const FlowStep& step)
{
    const StepInput in = step_input(state, step);
    const StepBounds bounds(*scenario_, kernel_.smoothing_length(), rounding_, in);
    const ParticleErrors before = *errors_;
    take_solutions(state.particles, step, bounds);
    errors_->frame_open =
        errors_->frame_open || bounds.void_open || openings_.far_layers_open(driven_.particles, before);
    bound_particles(state, bounds);
    record_.add_step(state, step, wall, bounds, *errors_, before);
}

/// v, and x' = x + dt v + correction of all that move.
void FrameBounds::bound_particles(const SimulationState& state, const StepBounds& bounds)
{
    const reference::Period& box = wall_.vessel().period();
    const Particles& p = state.particles;
    const double dt = scenario_->time.frame_s / static_cast<double>(scenario_->time.substeps);
    const double rho_0 = scenario_->fluid.density_kg_m3;
    const Inexact lowest = openings_.lowest_pressure(state.aneurysm.phase, time_);
    for (std::size_t i = 0; i < p.size(); ++i) {
        errors_->density[i] = p.kind[i] == Kind::reserve ? rho_0 : bounds.density[i];
        if (p.kind[i] == Kind::reserve) {
            continue;
        }
        errors_->velocity[i] = bounds.velocity[i];
        errors_->drift[i] = bounds.drift[i];
        errors_->open[i] = errors_->open[i] || bounds.open[i];
        if (is_free(p.kind[i])) {
            errors_->pressure[i] = p.pressure[i] == lowest.value ? lowest.error : bounds.pressure[i];
        }
        const double way = dt * length(p.velocity[i]) + length(bounds.way(i));
        errors_->position[i] +=
            dt * errors_->velocity[i] + bounds.correction[i] + 3 * way + 2 * length(p.position[i]);
        errors_->position[i] +=
            seam_error(p.position[i], way + rounding_.absolute(errors_->position[i]), box);
    }
}

/// What the reference took from the candidate, and how its solve of the correction ended with that.
void FrameBounds::take_solutions(const Particles& moved, const FlowStep& step, const StepBounds& bounds)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    double count = 0;
    correction_ = {step.corrected.residual_mean, 0, step.corrected.residual_max, 0};
    for (std::size_t i = 0; i < moved.size(); ++i) {
        taken_pressure_.push_back(step.bodies.free(i) ? step.pressure[i] : none);
        taken_kappa_.push_back(step.bodies.blood(i) ? moved.kappa[i] : none);
        if (step.bodies.blood(i)) {
            const double units = bounds.correction_residual[i];
            correction_.largest_error = std::max(correction_.largest_error, rounding_.absolute(units));
            sum += units;
            ++count;
        }
    }
    const double mean = sum / std::max(count, 1.0) + count * correction_.mean;
    correction_.mean_error = rounding_.absolute(mean);
}

FrameRange FrameBounds::finish(const SimulationState& start, const SimulationState& end,
                               const FrameRecord& record)
{
    if (breach_) {
        openings_.recycle(last_.particles, end.particles, *breach_, kernel_.support(), *errors_);
    }
    FrameRange range;
    record_.finish(record, *errors_, openings_.inlet_velocity(time_), range.low, range.high);
    bound_wall(start, end, range);
    errors_->frame_open = errors_->frame_open || range.rupture_open;
    return range;
}

/// (21)-(23), (28), (13) and the criterion (bound B29): the reference's own end of a frame at both ends of
/// the load's range, since each number rises or falls with it; then the roundings of the formulas.
void FrameBounds::bound_wall(const SimulationState& start, const SimulationState& end,
                             FrameRange& range) const
{
    if (!wall_.vessel().has_sac()) {
        return;
    }
    const AneurysmState& before = start.aneurysm;
    const AneurysmState& after = end.aneurysm;
    const auto absolute = [&](double units) { return rounding_.absolute(units); };
    AneurysmState soft = before;
    AneurysmState hard = before;
    const auto load = [&](double F_b) {
        return reference::wall_load(F_b, scenario_->rupture.impact_mass_kg, start.particles.mass);
    };
    range.low.wall_load = load(range.low.impact_force) - absolute(2 * load(range.low.impact_force));
    range.high.wall_load = load(range.high.impact_force) + absolute(2 * load(range.high.impact_force));
    const double P_soft = deform_(soft, end.frame, range.low.wall_load);
    const double P_hard = deform_(hard, end.frame, range.high.wall_load);
    const auto spread = [](double a, double value, double b) {
        return std::max(std::abs(a - value), std::abs(b - value));
    };

    const bool alive = before.phase != Phase::ruptured && end.frame > scenario_->growth.warm_up_frames;
    const auto& wall = scenario_->elastic_wall;
    const double dt = alive ? scenario_->time.frame_s : 0; // afterwards nothing moves the wall
    const double v = std::abs(after.wall_velocity);
    const double dv = std::abs(after.wall_velocity - before.wall_velocity);
    const double spring = wall.stiffness_n_m * std::abs(before.displacement);
    const double R_rounding = absolute(after.radius + 14 * (after.radius - before.radius));
    const double h_rounding = absolute(2 * after.thickness + 14 * (before.thickness - after.thickness));
    const double v_rounding = absolute(v + 3 * dv + dt * spring / wall.mass_kg);
    const double u_rounding = absolute(std::abs(after.displacement) + dt * v) + dt * v_rounding;

    AneurysmState& error = range.aneurysm_error;
    error.radius = spread(soft.radius, after.radius, hard.radius) + R_rounding;
    error.thickness = spread(soft.thickness, after.thickness, hard.thickness) + h_rounding;
    error.wall_velocity = spread(soft.wall_velocity, after.wall_velocity, hard.wall_velocity) + v_rounding;
    error.displacement = spread(soft.displacement, after.displacement, hard.displacement) + u_rounding;
    const double P = range.low.critical_pressure;
    const double P_error = spread(P_soft, P, P_hard) +
                           P * (h_rounding / after.thickness + R_rounding / after.radius) + absolute(16 * P);
    const double area = scenario_->rupture.conversion_area_m2;
    const double P_margin = P_error + absolute(2 * P);
    range.rupture_open =
        alive && range.low.wall_load / area <= P + P_margin && range.high.wall_load / area >= P - P_margin;
    const auto widen = [&range](double FrameRecord::*member, double by) {
        range.low.*member -= by;
        range.high.*member += by;
    };
    widen(&FrameRecord::radius, error.radius);
    widen(&FrameRecord::thickness, error.thickness);
    widen(&FrameRecord::displacement, error.displacement);
    widen(&FrameRecord::critical_pressure, P_error);
}

} // namespace aneurysm::bounds
