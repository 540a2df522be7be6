// SPDX-License-Identifier: Apache-2.0
#include "reference/flow.hpp"

#include "common/error.hpp"
#include "common/scenario/limits.hpp"
#include "common/vessel/body_force.hpp"
#include "reference/boundary.hpp"
#include "reference/containment.hpp"
#include "reference/flow_path.hpp"
#include "reference/impact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::reference
{
namespace
{

Role role_of(Kind kind)
{
    switch (kind) {
    case Kind::fluid:
    case Kind::escaped:
    case Kind::outlet_1:
    case Kind::outlet_2:
        return Role::free;
    case Kind::inlet:
        return Role::driven;
    case Kind::reserve:
        break;
    }
    return Role::absent;
}

std::string place(const SimulationState& state, std::size_t particle)
{
    return "frame " + std::to_string(state.frame + 1) + ", particle " + std::to_string(particle);
}

} // namespace

Flow::Flow(const Scenario& scenario, const Vessel& vessel, double dx,
           std::array<std::vector<Vec3>, 3> patterns)
    : scenario_(&scenario), vessel_(&vessel), dx_(dx),
      dt_(scenario.time.frame_s / static_cast<double>(scenario.time.substeps)),
      kernel_(scenario.kernel.function, scenario.kernel.smoothing_length_spacings * dx),
      mass_(scenario.fluid.density_kg_m3 / lattice_kernel_sum(kernel_, dx)),
      controller_(scenario, vessel, dx, std::move(patterns)),
      solver_{.relaxation = scenario.pressure.relaxation,
              .tolerance = scenario.pressure.tolerance_per_s,
              .max_tolerance = scenario.pressure.max_tolerance_per_s,
              .max_iterations = scenario.pressure.max_iterations},
      correction_{.relaxation = scenario.pressure.relaxation,
                  .tolerance = scenario.pressure.correction_tolerance_per_s,
                  .max_tolerance = scenario.pressure.correction_max_tolerance_per_s,
                  .max_iterations = scenario.pressure.correction_max_iterations},
      density_(static_cast<std::size_t>(scenario.particles.count), scenario.fluid.density_kg_m3)
{
    check_stability();
}

void Flow::check_stability() const
{
    const Scenario& s = *scenario_;
    const double limit = step_limits(s, dx_).smallest();
    if (dt_ > limit) {
        throw InputError("time.substeps",
                         std::to_string(s.time.substeps) + " makes a step of " + std::to_string(dt_) +
                             " s, above the stability limit of " + std::to_string(limit) + " s",
                         "needed: at least " +
                             std::to_string(static_cast<int>(std::ceil(s.time.frame_s / limit))));
    }
    const double omega = relaxation_limit(s.kernel.function, s.kernel.smoothing_length_spacings);
    if (s.pressure.model == PressureModel::dfsph && s.pressure.relaxation >= omega) {
        throw InputError("pressure.relaxation", std::to_string(s.pressure.relaxation) + " is not stable",
                         "allowed: below " + std::to_string(omega) +
                             ", the limit of this kernel on a full lattice");
    }
}

void Flow::step(SimulationState& state, const Wall& wall, double t, FrameRecord& record,
                const FlowHooks& hooks)
{
    const auto show = [&](FlowStage stage, const FlowStep* step) {
        if (hooks.observer != nullptr) {
            hooks.observer->see(stage, t, state, wall, step);
        }
    };
    Particles& p = state.particles;
    show(FlowStage::begun, nullptr);
    drive_openings(state, t, record);
    show(FlowStage::driven, nullptr);
    FlowStep step = make_step(state, wall);
    const Vec3 g = body_force(state, t);
    const double p_level = level(state, t);
    apply_forces(step, state, g, p_level);
    solve_pressure(step, state, p_level, record, hooks.solved.pressure);
    correct_density(step, p, record, hooks.solved.kappa);
    move(step, state);
    show(FlowStage::moved, &step);
    record_flow(step, p, record);
    record_impact(*scenario_, *vessel_, dx_, step, p, wall, g, record);
    handle_collisions(*vessel_, dx_, scenario_->collision.rebound, state, wall, record);
    show(FlowStage::collided, &step);
    controller_.exchange(p, record.inlet_velocity, state.ledger);
    show(FlowStage::exchanged, &step);
    density_.assign(step.rho.begin(), step.rho.begin() + static_cast<std::ptrdiff_t>(p.size()));
}

double Flow::inlet_velocity_at(double t) const
{
    const auto& inlet = scenario_->inlet;
    return inlet_ramp(inlet.ramp_s, t) * inlet_velocity(inlet.waveform, inlet.peak_velocity_m_s,
                                                        inlet.cycle_s, t, inlet.table_time_s,
                                                        inlet.table_velocity_m_s);
}

void Flow::drive_openings(SimulationState& state, double t, FrameRecord& record) const
{
    record.inlet_velocity = inlet_velocity_at(t);
    controller_.drive_inlet(state.particles, record.inlet_velocity);
    for (const std::size_t k : {1U, 2U}) {
        state.outlet_velocity[k - 1] = controller_.buffer_velocity(state.particles, k);
    }
    record.outlet_velocity = 0.5 * (state.outlet_velocity[0] + state.outlet_velocity[1]);
}

/// While the wall is whole, gravity and the pressure of blood at rest balance each other exactly: the pressure is
/// counted from the latter, and what moves the blood is what remains of both, nothing. In a vessel without open
/// ends the body force drives the flow.
Vec3 Flow::body_force(const SimulationState& state, double t) const
{
    const bool balanced = vessel_->is_open(1) && state.aneurysm.phase != Phase::ruptured;
    return balanced ? Vec3{} : body_force_factor(*scenario_, t) * scenario_->fluid.gravity_m_s2;
}

/// The level of the pressure: an incompressible fluid doesn't feel it, but particles under tension clump. So it is
/// as high as inertia, friction and the flow's own pressure rho v^2 can pull the pressure down between outlets and
/// inlet, times a margin; p_const at most, below which blood would tear. Once the wall has a hole, it is p_const;
/// without open ends nothing pulls.
double Flow::level(const SimulationState& state, double t) const
{
    if (!vessel_->is_open(1)) {
        return 0;
    }
    const double p_const = scenario_->outlet.pressure_pa;
    if (scenario_->pressure.model == PressureModel::eos || state.aneurysm.phase == Phase::ruptured) {
        return p_const;
    }
    const double rho_0 = scenario_->fluid.density_kg_m3;
    const double v = inlet_velocity_at(t);
    const double slowing = std::max(0.0, (inlet_velocity_at(t - dt_) - v) / dt_);
    const FlowPath path = flow_path(*scenario_, *vessel_);
    const double pull = rho_0 * (path.inertia * slowing + v * v) +
                        scenario_->fluid.viscosity_pa_s * path.friction * std::max(0.0, -v);
    return std::min(p_const, scenario_->outlet.level_margin * pull);
}

FlowStep Flow::make_step(const SimulationState& state, const Wall& wall) const
{
    const Particles& p = state.particles;
    Bodies b{p.position, p.velocity, std::vector<double>(p.size(), p.mass), {}};
    std::ranges::transform(p.kind, std::back_inserter(b.role), role_of);
    b.position.insert(b.position.end(), wall.ghosts.position.begin(), wall.ghosts.position.end());
    b.velocity.resize(b.size(), wall_velocity());
    for (const double m : wall.ghosts.mass) {
        b.mass.push_back(m);
    }
    const bool slips = scenario_->domain.wall == WallCondition::slip;
    b.role.resize(b.size(), slips ? Role::slip : Role::mirror);
    Neighbors neighbors(b, kernel_, vessel_->period());
    FlowStep step{std::move(b), std::move(neighbors), {}, {}, {}, {}, {}, p.velocity, {}, {}, {}};
    step.rho.assign(step.bodies.size(), scenario_->fluid.density_kg_m3);
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (step.bodies.blood(i)) {
            step.rho[i] = reference::density(step.bodies, step.neighbors.of(i));
            if (!(step.rho[i] < scenario_->pressure.blow_up_density_ratio * scenario_->fluid.density_kg_m3)) {
                throw SimulationError(place(state, i),
                                      "density " + std::to_string(step.rho[i]) + " kg/m^3: the run blew up",
                                      "more time.substeps, or a stiffer pressure model");
            }
        }
    }
    return step;
}

/// Viscosity (7), the body force and the pressure beyond the outlets (26): all but the blood's own pressure.
void Flow::apply_forces(FlowStep& step, const SimulationState& state, const Vec3& g, double p_level) const
{
    Bodies& b = step.bodies;
    const std::size_t n = state.particles.size();
    step.F_viscosity.assign(n, {});
    step.F_outlet.assign(n, {});
    const std::vector<Vec3> v = no_slip_velocity(b, step.neighbors);
    for (std::size_t i = 0; i < n; ++i) {
        if (b.free(i)) {
            step.F_viscosity[i] =
                viscosity_force(b, step.neighbors.of(i), step.rho, v, scenario_->fluid.viscosity_pa_s, i);
            step.F_outlet[i] = outlet_force(step, state, i, p_level);
            const Vec3 force = momentum_force(step.rho[i], g, step.F_viscosity[i], step.F_outlet[i]);
            step.velocity[i] = b.velocity[i] + dt_ * acceleration(step.rho[i], force);
        }
    }
    std::ranges::copy(step.velocity, b.velocity.begin());
}

Vec3 Flow::outlet_force(const FlowStep& step, const SimulationState& state, std::size_t i,
                        double p_level) const
{
    const Kind kind = state.particles.kind[i];
    if (kind != Kind::outlet_1 && kind != Kind::outlet_2) {
        return {};
    }
    const std::size_t k = kind == Kind::outlet_1 ? 1 : 2;
    const double rho_0 = scenario_->fluid.density_kg_m3;
    return outlet_pressure_force(step.bodies, step.neighbors.of(i), rho_0, p_level) +
           inflow_force(rho_0, state.outlet_velocity[k - 1], opening_layers * dx_,
                        vessel_->openings()[k].outward);
}

void Flow::move(const FlowStep& step, SimulationState& state) const
{
    Particles& p = state.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::reserve) {
            continue;
        }
        const Vec3 way = dt_ * step.velocity[i] + step.shift[i] + step.correction[i];
        const double distance = length(way);
        if (!(distance < kernel_.support())) { // NaN too
            throw SimulationError(place(state, i),
                                  "it moves by " + std::to_string(distance) +
                                      " m in one step, more than it can see: the run blew up",
                                  "more time.substeps, or a stiffer pressure model");
        }
        p.velocity[i] = step.velocity[i];
        p.position[i] = vessel_->wrapped(p.position[i] + way);
    }
}

void Flow::record_flow(const FlowStep& step, const Particles& p, FrameRecord& record) const
{
    double excess = 0;
    std::int64_t count = 0;
    record.kinetic_energy = 0;
    record.density_error_max = -1;
    record.density_error_max_ends = -1;
    record.density_error_min = scenario_->pressure.blow_up_density_ratio;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] != Kind::fluid) {
            continue;
        }
        const Vec3& x = step.bodies.position[i];
        const double error = step.rho[i] / scenario_->fluid.density_kg_m3 - 1;
        excess += std::max(error, 0.0);
        if (vessel_->openings()[vessel_->nearest_tube(x)].beyond(x) > -scenario_->vessel.radius_m) {
            record.density_error_max_ends = std::max(record.density_error_max_ends, error);
        } else {
            record.density_error_max = std::max(record.density_error_max, error);
            record.density_error_min = std::min(record.density_error_min, error);
        }
        const double speed = length(p.velocity[i]);
        record.kinetic_energy += 0.5 * p.mass * speed * speed;
        record.speed_max = std::max(record.speed_max, speed);
        ++count;
    }
    record.density_error_mean = excess / static_cast<double>(std::max<std::int64_t>(count, 1));
}

} // namespace aneurysm::reference
