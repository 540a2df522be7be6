// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/step.hpp"

#include "reference/boundary.hpp"
#include "verification/bounds/seam.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::bounds
{

using reference::Bodies;
using reference::FlowStep;
using reference::Neighbor;
using reference::Role;

StepBounds::StepBounds(const Scenario& scenario, double h, const reference::Period& box,
                       const BodyForce& body_force, const Rounding& rounding, const FlowStep& step,
                       const Bodies& bodies, std::span<const Vec3> before, const SimulationState& driven,
                       const BodyErrors& errors)
    : density(step.velocity.size(), 0), pressure(bodies.size(), 0), velocity(step.velocity.size(), 0),
      residual(step.velocity.size(), 0), divergence(step.velocity.size(), 0), scenario_(&scenario),
      rho_0_(scenario.fluid.density_kg_m3),
      dt_(scenario.time.frame_s / static_cast<double>(scenario.time.substeps)), h_(h),
      body_force_(body_force), rounding_(rounding), kernel_(scenario.kernel.function, h), step_(&step),
      bodies_(&bodies), errors_(&errors), begin_(bodies.size() + 1, 0), start_velocity_(errors.velocity),
      viscosity_(step.velocity.size(), 0), acceleration_(step.velocity.size(), 0)
{
    find_pairs(box, rounding.absolute(2 * *std::ranges::max_element(errors.position) + 10 * 2 * h));
    bound_density();
    bound_forces(before, driven);
    bound_pressure(driven);
    bound_divergence();
}

/// Also the pairs that the candidate may find just inside the support.
void StepBounds::find_pairs(const reference::Period& box, double support_margin)
{
    const reference::Kernel wide(scenario_->kernel.function, h_ + support_margin / 2);
    const reference::Neighbors neighbors(*bodies_, wide, box);
    for (std::size_t i = 0; i < bodies_->size(); ++i) {
        begin_[i] = pairs_.size();
        for (const Neighbor& n : neighbors.of(i)) {
            const Vec3& a = bodies_->position[i];
            const Vec3& b = bodies_->position[n.j];
            // A body's distance to itself is 0 for both.
            const double error =
                n.j == i ? 0 : errors_->position[i] + errors_->position[n.j] + seam_error(a, b, box);
            pairs_.push_back({n.j, kernel_.of(length(reference::difference(a, b, box)), error)});
        }
    }
    begin_[bodies_->size()] = pairs_.size();
}

/// (5): m W, the product and the candidate's mass rounded.
void StepBounds::bound_density()
{
    for (std::size_t i = 0; i < density.size(); ++i) {
        SumBound sum;
        for (const Pair& n : pairs(i)) {
            sum.add(bodies_->mass[n.j], errors_->mass[n.j], {1, 0}, n.kernel.W);
        }
        density[i] = sum.error(terms(i) + 2);
    }
}

/// (7), (26) and (1): v* = v + dt (rho g + F) / rho.
void StepBounds::bound_forces(std::span<const Vec3> before, const SimulationState& driven)
{
    const double mu = scenario_->fluid.viscosity_pa_s;
    const double g = length(body_force_.g);
    const auto velocity_of = [&](std::size_t j) { return j < before.size() ? before[j] : Vec3{}; };
    for (std::size_t i = 0; i < viscosity_.size(); ++i) {
        if (!bodies_->free(i)) {
            continue;
        }
        SumBound sum;
        for (const Pair& n : pairs(i)) {
            if (bodies_->role[n.j] == Role::slip) {
                continue;
            }
            const double dv = length(velocity_of(n.j) - velocity_of(i));
            const double dv_error = n.j == i ? 0 : errors_->velocity[i] + errors_->velocity[n.j] + dv;
            sum.add(mu * bodies_->mass[n.j] / rho(n.j), mu * errors_->mass[n.j] / rho(n.j), n.kernel.lap_W,
                    {dv, dv_error + rho_error(n.j) * dv});
        }
        viscosity_[i] = sum.error(terms(i) + 6);
        const double force = rho(i) * g + length(step_->F_viscosity[i]) + length(step_->F_outlet[i]);
        const double force_error = density[i] * g + rho(i) * body_force_.error + viscosity_[i] +
                                   outlet_force_error(i, driven) + 4 * force;
        const double a_error = (force_error + force * (density[i] / rho(i) + 1)) / rho(i);
        start_velocity_[i] =
            errors_->velocity[i] + dt_ * (a_error + 2 * force / rho(i)) + length(bodies_->velocity[i]);
    }
}

/// (26): m / rho_0 p_outlet grad W, with p_outlet = p_const - rho_0 v^2 / 2 while v < 0.
double StepBounds::outlet_force_error(std::size_t i, const SimulationState& driven) const
{
    if (scenario_->pressure.model != PressureModel::dfsph) {
        return 0;
    }
    SumBound sum;
    for (const Pair& n : pairs(i)) {
        if (bodies_->role[n.j] != Role::outlet) {
            continue;
        }
        const std::size_t k = driven.particles.kind[n.j] == Kind::outlet_1 ? 0 : 1;
        const double v = driven.outlet_velocity.at(k);
        const double p = reference::outlet_pressure(scenario_->outlet.pressure_pa, rho_0_, v);
        const double dynamic = v < 0 ? rho_0_ * v * v / 2 : 0;
        const double p_error = std::abs(scenario_->outlet.pressure_pa) + 5 * dynamic + std::abs(p) +
                               rho_0_ * std::abs(v) * errors_->outlet_velocity.at(k);
        sum.add(bodies_->mass[n.j] / rho_0_, 0, {std::abs(p), p_error}, n.kernel.grad_W);
    }
    return sum.error(terms(i) + 6);
}

/// v' = v* + dt a.
void StepBounds::bound_pressure(const SimulationState& driven)
{
    const bool dfsph = scenario_->pressure.model == PressureModel::dfsph;
    for (std::size_t j = 0; !dfsph && j < driven.particles.size(); ++j) {
        const double kappa = scenario_->pressure.stiffness_m2_s2;
        pressure[j] = kappa * (density[j] + 3 * rho(j)) + std::abs(step_->pressure[j]);
        if (bodies_->role[j] == Role::outlet) {
            const std::size_t k = driven.particles.kind[j] == Kind::outlet_1 ? 0 : 1;
            const double v = driven.outlet_velocity.at(k);
            pressure[j] = std::abs(scenario_->outlet.pressure_pa) + 4 * rho_0_ * v * v +
                          rho_0_ * std::abs(v) * errors_->outlet_velocity.at(k);
        }
    }
    for (std::size_t i = 0; i < velocity.size(); ++i) {
        velocity[i] = start_velocity_[i];
        if (bodies_->free(i)) {
            const double a = length(step_->F_pressure[i]) / rho(i);
            const double eos =
                dfsph ? 0 : eos_error(i, step_->pressure, pressure) / rho(i) + a * (density[i] / rho(i) + 1);
            acceleration_[i] = dfsph ? dfsph_error(i) : eos;
            velocity[i] += dt_ * (acceleration_[i] + 2 * a) + length(step_->velocity[i]);
        }
    }
}

/// a = -sum m (p_i + p_j) / rho_0^2 grad W; the pressures are the candidate's own.
double StepBounds::dfsph_error(std::size_t i) const
{
    SumBound sum;
    for (const Pair& n : pairs(i)) {
        const double p_j = bodies_->free(n.j) ? step_->pressure[n.j] : 0;
        const double p = std::abs(step_->pressure[i]) + std::abs(p_j);
        sum.add(bodies_->mass[n.j] * p / (rho_0_ * rho_0_), errors_->mass[n.j] * p / (rho_0_ * rho_0_),
                {1, 0}, n.kernel.grad_W);
    }
    return sum.error(terms(i) + 8);
}

/// (6), as a force per volume.
double StepBounds::eos_error(std::size_t i, std::span<const double> p, std::span<const double> p_error) const
{
    SumBound sum;
    for (const Pair& n : pairs(i)) {
        const bool mirror = bodies_->role[n.j] == Role::mirror || bodies_->role[n.j] == Role::slip;
        const double p_j = mirror ? p[i] : p[n.j];
        const double p_sum = std::abs(p[i]) + std::abs(p_j);
        const double p_sum_error = p_error[i] + (mirror ? p_error[i] : p_error[n.j]);
        sum.add(bodies_->mass[n.j] / (2 * rho(n.j)), errors_->mass[n.j] / (2 * rho(n.j)),
                {p_sum, p_sum_error + rho_error(n.j) * p_sum}, n.kernel.grad_W);
    }
    return sum.error(terms(i) + 6);
}

/// (2) with the new velocity, and the residual of (3).
void StepBounds::bound_divergence()
{
    const auto velocity_of = [&](std::size_t j) { return j < velocity.size() ? step_->velocity[j] : Vec3{}; };
    const auto error_of = [&](std::size_t j) { return j < velocity.size() ? velocity[j] : 0; };
    const double beta = scenario_->pressure.density_correction;
    for (std::size_t i = 0; i < velocity.size(); ++i) {
        if (!bodies_->free(i)) {
            continue;
        }
        SumBound sum;
        for (const Pair& n : pairs(i)) {
            const double dv = length(velocity_of(i) - velocity_of(n.j));
            const double dv_error = n.j == i ? 0 : error_of(i) + error_of(n.j) + dv;
            sum.add(bodies_->mass[n.j], errors_->mass[n.j], {dv, dv_error}, n.kernel.grad_W);
        }
        // Over rho_0: one rounding more of what is summed, which the terms' sizes bound.
        divergence[i] = sum.error(terms(i) + 6) / rho_0_;
        const double correction = beta * std::abs(rho(i) - rho_0_) / dt_;
        residual[i] =
            divergence[i] + (beta * (density[i] + rho_0_) / dt_ + 5 * correction + sum.size()) / rho_0_;
    }
}

/// m / rho |rho g + F_viscosity + F_pressure|; F_pressure = rho a in model dfsph.
InexactForce StepBounds::force(std::size_t i) const
{
    const double m = bodies_->mass[i];
    const Vec3& g = body_force_.g;
    const auto inexact_force = [&](const Vec3& F_pressure, double pressure_error) {
        const Vec3 force = reference::momentum_force(rho(i), g, step_->F_viscosity[i], F_pressure);
        const double magnitude = rho(i) * length(g) + length(step_->F_viscosity[i]) + length(F_pressure);
        const double error = density[i] * length(g) + rho(i) * body_force_.error + viscosity_[i] +
                             pressure_error + 4 * magnitude;
        const double F = length(m / rho(i) * force);
        return Inexact{F, m / rho(i) * error + F * (density[i] / rho(i) + 7)};
    };
    std::vector<double> p(bodies_->size(), 0);
    std::vector<double> p_error(bodies_->size(), 0);
    for (const Pair& n : pairs(i)) {
        const double kappa = scenario_->pressure.stiffness_m2_s2;
        p[n.j] = reference::equation_of_state(kappa, rho(n.j), rho_0_);
        p_error[n.j] = kappa * ((n.j < density.size() ? density[n.j] : 0) + 3 * rho(n.j)) + std::abs(p[n.j]);
    }
    const double a = length(step_->F_pressure[i]) / rho(i);
    const double dfsph = rho(i) * acceleration_[i] + a * density[i] + 2 * rho(i) * a;
    const Vec3 F_eos = reference::pressure_force(step_->bodies, step_->neighbors.of(i), step_->rho, p, i);
    return {inexact_force(step_->F_pressure[i], dfsph), inexact_force(F_eos, eos_error(i, p, p_error))};
}

} // namespace aneurysm::bounds
