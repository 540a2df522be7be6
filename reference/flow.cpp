// SPDX-License-Identifier: Apache-2.0
#include "reference/flow.hpp"

#include "common/error.hpp"
#include "common/scenario/limits.hpp"
#include "common/vessel/body_force.hpp"
#include "reference/boundary.hpp"
#include "reference/containment.hpp"
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
        return Role::free;
    case Kind::inlet:
        return Role::mirror;
    case Kind::outlet_1:
    case Kind::outlet_2:
        return Role::outlet;
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

Flow::Flow(const Scenario& scenario, const Vessel& vessel, double dx, std::array<std::vector<Vec3>, 3> slabs)
    : scenario_(&scenario), vessel_(&vessel), dx_(dx),
      dt_(scenario.time.frame_s / static_cast<double>(scenario.time.substeps)),
      kernel_(scenario.kernel.function, scenario.kernel.smoothing_length_spacings * dx),
      mass_(scenario.fluid.density_kg_m3 / lattice_kernel_sum(kernel_, dx)),
      controller_(scenario.controller, vessel, dx, std::move(slabs)),
      solver_{.rho_0 = scenario.fluid.density_kg_m3,
              .relaxation = scenario.pressure.relaxation,
              .density_correction = scenario.pressure.density_correction,
              .tolerance = scenario.pressure.tolerance_per_s,
              .max_tolerance = scenario.pressure.max_tolerance_per_s,
              .max_iterations = scenario.pressure.max_iterations},
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
    const Vec3 g = body_force_factor(*scenario_, t) * scenario_->fluid.gravity_m_s2;
    apply_forces(step, state, g);
    solve_pressure(step, state, record, hooks.solved_pressure);
    move(step, state);
    show(FlowStage::moved, &step);
    record_flow(step, p, record);
    record_impact(*scenario_, *vessel_, dx_, step, p, wall, g, record);
    controller_.push_as_piston(p, record.inlet_velocity);
    for (const std::size_t k : {1U, 2U}) {
        if (state.outlet_velocity[k - 1] < 0) {
            controller_.hold_back(p, k);
        }
    }
    show(FlowStage::held, &step);
    handle_collisions(*vessel_, dx_, state, wall, record);
    show(FlowStage::collided, &step);
    controller_.exchange(p, state.ledger);
    show(FlowStage::exchanged, &step);
    density_.assign(step.rho.begin(), step.rho.begin() + static_cast<std::ptrdiff_t>(p.size()));
}

double Flow::inlet_velocity_at(double t) const
{
    const auto& inlet = scenario_->inlet;
    return inlet_velocity(inlet.waveform, inlet.peak_velocity_m_s, inlet.cycle_s, t, inlet.table_time_s,
                          inlet.table_velocity_m_s);
}

void Flow::drive_openings(SimulationState& state, double t, FrameRecord& record) const
{
    Particles& p = state.particles;
    const double rho_0 = scenario_->fluid.density_kg_m3;
    record.inlet_velocity = inlet_velocity_at(t);
    if (record.inlet_velocity >= 0 && inlet_velocity_at(t - dt_) < 0) {
        controller_.reset(p, 0, state.ledger);
    }
    controller_.drive_inlet(p, record.inlet_velocity);
    for (const std::size_t k : {1U, 2U}) {
        double& v = state.outlet_velocity[k - 1];
        const double previous = v;
        v = controller_.outlet_velocity(
            p, k, previous, outlet_pressure(scenario_->outlet.pressure_pa, rho_0, previous), rho_0, dt_);
        if (v < 0 && previous >= 0) {
            controller_.reset(p, k, state.ledger);
        }
        controller_.drive_outlet(p, k, v, previous);
    }
    record.outlet_velocity = 0.5 * (state.outlet_velocity[0] + state.outlet_velocity[1]);
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
    FlowStep step{std::move(b), std::move(neighbors), {}, {}, {}, {}, {}, p.velocity};
    step.rho.assign(step.bodies.size(), scenario_->fluid.density_kg_m3);
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (step.bodies.free(i)) {
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

/// Viscosity (7), gravity and, in model dfsph, the outlets' pressure (26): all but the blood's own pressure.
/// In model eos the outlets' ghosts take part in (6) with their pressure.
void Flow::apply_forces(FlowStep& step, const SimulationState& state, const Vec3& g) const
{
    Bodies& b = step.bodies;
    const Particles& p = state.particles;
    const double rho_0 = scenario_->fluid.density_kg_m3;
    step.F_viscosity.assign(p.size(), {});
    step.F_outlet.assign(p.size(), {});
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!b.free(i)) {
            continue;
        }
        step.F_viscosity[i] =
            viscosity_force(b, step.neighbors.of(i), step.rho, scenario_->fluid.viscosity_pa_s, i);
        for (const Neighbor& n : step.neighbors.of(i)) {
            if (scenario_->pressure.model == PressureModel::dfsph && b.role[n.j] == Role::outlet) {
                const double v = state.outlet_velocity[p.kind[n.j] == Kind::outlet_1 ? 0 : 1];
                step.F_outlet[i] += outlet_pressure_force(
                    b.mass[n.j], rho_0, outlet_pressure(scenario_->outlet.pressure_pa, rho_0, v), n.grad_W);
            }
        }
        const Vec3 force = momentum_force(step.rho[i], g, step.F_viscosity[i], step.F_outlet[i]);
        step.velocity[i] = b.velocity[i] + dt_ * acceleration(step.rho[i], force);
    }
    std::ranges::copy(step.velocity, b.velocity.begin());
}

/// The blood's own pressure, by (3) or by the equation of state with (6); it changes the velocity.
void Flow::solve_pressure(FlowStep& step, SimulationState& state, FrameRecord& record,
                          std::span<const double> solved)
{
    Particles& p = state.particles;
    const Bodies& b = step.bodies;
    std::vector<double>& pressure = step.pressure;
    pressure.assign(b.size(), 0);
    std::vector<Vec3> a(b.size());
    const bool dfsph = scenario_->pressure.model == PressureModel::dfsph;
    const IncompressibleReport report = !dfsph           ? solve_eos(step, state, pressure, a)
                                        : solved.empty() ? solve_dfsph(step, p, pressure, a)
                                                         : take_pressure(step, solved, pressure, a);
    step.F_pressure.assign(p.size(), {});
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (b.free(i)) {
            step.F_pressure[i] = step.rho[i] * a[i];
            step.velocity[i] = b.velocity[i] + dt_ * a[i];
            p.pressure[i] = pressure[i];
        }
    }
    solved_pressure_ = p.pressure;
    record.iterations += report.iterations;
    record.residual_mean = report.residual_mean;
    record.residual_max = report.residual_max;
    record.divergence_mean = report.divergence_mean;
    record.divergence_max = report.divergence_max;
}

/// (3) with its pressures given: no iteration, only what follows from them.
IncompressibleReport Flow::take_pressure(const FlowStep& step, std::span<const double> solved,
                                         std::vector<double>& pressure, std::vector<Vec3>& a) const
{
    for (std::size_t i = 0; i < solved.size(); ++i) {
        pressure[i] = step.bodies.free(i) ? solved[i] : 0;
    }
    IncompressibleSettings settings = solver_;
    settings.max_iterations = 0;
    return solve_incompressibility(step.bodies, step.neighbors, step.rho, dt_, settings, pressure, a);
}

/// From the last step's pressures; a particle that has none starts from its neighbors' mean.
IncompressibleReport Flow::solve_dfsph(const FlowStep& step, const Particles& p,
                                       std::vector<double>& pressure, std::vector<Vec3>& a) const
{
    for (std::size_t i = 0; i < p.size(); ++i) {
        pressure[i] = p.pressure[i];
        if (step.bodies.free(i) && p.pressure[i] < 0) {
            double sum = 0;
            double count = 0;
            for (const Neighbor& n : step.neighbors.of(i)) {
                if (step.bodies.free(n.j) && p.pressure[n.j] >= 0) {
                    sum += p.pressure[n.j];
                    ++count;
                }
            }
            pressure[i] = count > 0 ? sum / count : 0;
        }
    }
    return solve_incompressibility(step.bodies, step.neighbors, step.rho, dt_, solver_, pressure, a);
}

IncompressibleReport Flow::solve_eos(const FlowStep& step, const SimulationState& state,
                                     std::vector<double>& pressure, std::vector<Vec3>& a) const
{
    const Bodies& b = step.bodies;
    const double rho_0 = scenario_->fluid.density_kg_m3;
    for (std::size_t i = 0; i < b.size(); ++i) {
        pressure[i] = equation_of_state(scenario_->pressure.stiffness_m2_s2, step.rho[i], rho_0);
        if (b.role[i] == Role::outlet) {
            const double v = state.outlet_velocity[state.particles.kind[i] == Kind::outlet_1 ? 0 : 1];
            pressure[i] = outlet_pressure(scenario_->outlet.pressure_pa, rho_0, v);
        }
    }
    std::vector<Vec3> v = b.velocity;
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        if (b.free(i)) {
            a[i] = acceleration(step.rho[i], pressure_force(b, step.neighbors.of(i), step.rho, pressure, i));
            v[i] += dt_ * a[i];
        }
    }
    return divergence_report(b, step.neighbors, v, rho_0);
}

void Flow::move(const FlowStep& step, SimulationState& state) const
{
    Particles& p = state.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::reserve) {
            continue;
        }
        const Vec3 way = dt_ * step.velocity[i];
        if (!(length(way) < kernel_.support())) { // NaN too
            throw SimulationError(place(state, i),
                                  "it moves by " + std::to_string(length(way)) +
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
