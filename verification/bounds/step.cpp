// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/step.hpp"

#include "common/guards.hpp"
#include "common/vessel/sampling.hpp"
#include "reference/boundary.hpp"
#include "verification/bounds/mean.hpp"
#include "verification/bounds/seam.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace aneurysm::bounds
{

using reference::Neighbor;
using reference::Role;

StepBounds::StepBounds(const Scenario& scenario, double h, const Rounding& rounding, const StepInput& input)
    : density(input.moved.size(), 0), pressure(input.bodies.size(), 0), velocity(input.errors.velocity),
      residual(density), divergence(density), drift(input.errors.drift), correction(density),
      correction_residual(density), open(input.moved.size(), false), scenario_(&scenario),
      rho_0_(scenario.fluid.density_kg_m3),
      dt_(scenario.time.frame_s / static_cast<double>(scenario.time.substeps)), h_(h), rounding_(rounding),
      kernel_(scenario.kernel.function, h), in_(&input), count_(input.moved.size()),
      begin_(input.bodies.size() + 1, 0), start_velocity_error_(velocity), viscosity_(density),
      acceleration_(density), shift_error_(density), predicted_(density), predicted_error_(density)
{
    find_pairs();
    bound_density();
    bound_ghost_velocity();
    bound_forces();
    bound_pressure();
    bound_divergence();
    if (corrects_density()) {
        bound_shift();
        bound_prediction();
        bound_correction();
    }
}

bool StepBounds::corrects_density() const
{
    return scenario_->pressure.model == PressureModel::dfsph && scenario_->pressure.density_correction > 0;
}

/// Also the pairs that the candidate may find just inside the support.
void StepBounds::find_pairs()
{
    const reference::Bodies& b = in_->bodies;
    const std::vector<double>& e = in_->position_error;
    const double H = 2 * h_;
    const double margin = rounding_.absolute(2 * *std::ranges::max_element(e) + 10 * H);
    const reference::Kernel wide(scenario_->kernel.function, h_ + margin / 2);
    const reference::Neighbors neighbors(b, wide, in_->box);
    for (std::size_t i = 0; i < b.size(); ++i) {
        begin_[i] = pairs_.size();
        for (const Neighbor& n : neighbors.of(i)) {
            const Vec3& x_i = b.position[i];
            const Vec3& x_j = b.position[n.j];
            const double r = length(reference::difference(x_i, x_j, in_->box));
            // A body's distance to itself is 0 for both.
            const double error = n.j == i ? 0 : e[i] + e[n.j] + seam_error(x_i, x_j, in_->box);
            pairs_.push_back(
                {n.j, kernel_.of(r, error), error, is_positive({H - r, error + 4 * r + 2 * H}, rounding_)});
        }
    }
    begin_[b.size()] = pairs_.size();
}

/// (5): m W, the product and the candidate's mass rounded.
void StepBounds::bound_density()
{
    const double least = guards::void_density * rho_0_;
    for (std::size_t i = 0; i < count_; ++i) {
        if (!in_->bodies.blood(i)) {
            continue;
        }
        SumBound sum;
        for (const Pair& n : pairs(i)) {
            sum.add(in_->bodies.mass[n.j], in_->mass_error[n.j], {1, 0}, n.kernel.W);
        }
        density[i] = sum.error(terms(i) + 2);
        void_open =
            void_open || is_positive({rho(i) - least, density[i] + 2 * least}, rounding_) == Truth::open;
    }
}

/// (27): what blood before a ghost has in the mean, turned round.
void StepBounds::bound_ghost_velocity()
{
    std::vector<WeightedMean<Vec3>> means(in_->bodies.size() - count_);
    const auto visit = [&](auto use) {
        for (std::size_t i = 0; i < count_; ++i) {
            for (const Pair& n : pairs(i)) {
                if (in_->bodies.role[n.j] == Role::mirror) {
                    use(means[n.j - count_], n.kernel.W, i);
                }
            }
        }
    };
    const std::vector<Vec3>& v = in_->driven.particles.velocity;
    visit([&](WeightedMean<Vec3>& mean, const Inexact& w, std::size_t i) { mean.add(w, v[i]); });
    visit([&](WeightedMean<Vec3>& mean, const Inexact& w, std::size_t i) {
        mean.compare(w, v[i], in_->errors.velocity[i]);
    });
    for (const WeightedMean<Vec3>& mean : means) {
        ghost_velocity_.push_back(-mean.value());
        ghost_velocity_error_.push_back(mean.error(rounding_));
    }
}

Vec3 StepBounds::start_velocity(std::size_t j) const
{
    return j < count_ ? in_->driven.particles.velocity[j] : ghost_velocity_[j - count_];
}

/// (7), (26) and (1): v* = v + dt (rho g + F) / rho.
void StepBounds::bound_forces()
{
    const BodyForce& force = in_->body_force;
    const double g = length(force.g);
    for (std::size_t i = 0; i < count_; ++i) {
        if (!in_->bodies.free(i)) {
            continue;
        }
        viscosity_[i] = viscosity_error(i);
        const double F = rho(i) * g + length(in_->step.F_viscosity[i]) + length(in_->step.F_outlet[i]);
        const double F_error =
            density[i] * g + rho(i) * force.error + viscosity_[i] + outlet_force_error(i) + 4 * F;
        const double a_error = (F_error + F * (density[i] / rho(i) + 1)) / rho(i);
        start_velocity_error_[i] += dt_ * (a_error + 2 * F / rho(i)) + length(in_->step.bodies.velocity[i]);
    }
}

double StepBounds::viscosity_error(std::size_t i) const
{
    const double mu = scenario_->fluid.viscosity_pa_s;
    const auto error_of = [&](std::size_t j) {
        return j < count_ ? in_->errors.velocity[j] : ghost_velocity_error_[j - count_];
    };
    SumBound sum;
    for (const Pair& n : pairs(i)) {
        if (in_->bodies.role[n.j] == Role::slip) {
            continue;
        }
        const double dv = length(start_velocity(n.j) - start_velocity(i));
        const double dv_error = n.j == i ? 0 : error_of(i) + error_of(n.j) + dv;
        sum.add(mu * in_->bodies.mass[n.j] / rho(n.j), mu * in_->mass_error[n.j] / rho(n.j), n.kernel.lap_W,
                {dv, dv_error + rho_error(n.j) * dv});
    }
    return sum.error(terms(i) + 6);
}

/// (26): 2 p sum m / rho_0 grad W, and rho_0 v^2 / (2 D) while the buffer moves inwards.
double StepBounds::outlet_force_error(std::size_t i) const
{
    const Kind kind = in_->driven.particles.kind[i];
    if (kind != Kind::outlet_1 && kind != Kind::outlet_2) {
        return 0;
    }
    SumBound sum;
    const Inexact p{2 * std::abs(in_->level.value), 2 * in_->level.error};
    for (const Pair& n : pairs(i)) {
        sum.add(in_->bodies.mass[n.j] / rho_0_, in_->mass_error[n.j] / rho_0_, p, n.kernel.grad_W);
    }
    const std::size_t k = kind == Kind::outlet_1 ? 0 : 1;
    const double v = std::min(in_->driven.outlet_velocity.at(k), 0.0);
    const double depth = opening_layers * h_ / scenario_->kernel.smoothing_length_spacings;
    const double v_error = in_->errors.outlet_velocity.at(k);
    const double inflow = rho_0_ * v_error * (std::abs(v) + rounding_.absolute(v_error)) / depth;
    return sum.error(terms(i) + 6) + inflow + 8 * 0.5 * rho_0_ * v * v / depth;
}

/// v' = v* + dt a.
void StepBounds::bound_pressure()
{
    const bool dfsph = scenario_->pressure.model == PressureModel::dfsph;
    const std::vector<double>& p = in_->step.pressure;
    for (std::size_t j = 0; !dfsph && j < count_; ++j) {
        const double kappa = scenario_->pressure.stiffness_m2_s2;
        pressure[j] = kappa * (density[j] + 3 * rho(j)) + std::abs(p[j]);
    }
    for (std::size_t i = 0; i < count_; ++i) {
        velocity[i] = start_velocity_error_[i];
        if (in_->bodies.free(i)) {
            const double a = length(in_->step.F_pressure[i]) / rho(i);
            acceleration_[i] =
                dfsph ? dfsph_error(i) : eos_error(i, p, pressure) / rho(i) + a * (density[i] / rho(i) + 1);
            velocity[i] += dt_ * (acceleration_[i] + 2 * a) + length(in_->step.velocity[i]);
        }
    }
}

/// a = -sum m (p_i + p_j) / rho_0^2 grad W; the pressures are the candidate's own.
double StepBounds::dfsph_error(std::size_t i) const
{
    const std::vector<double>& pressures = in_->step.pressure;
    SumBound sum;
    for (const Pair& n : pairs(i)) {
        const double p_j = in_->bodies.free(n.j) ? pressures[n.j] : pressures[i];
        const double p = (std::abs(pressures[i]) + std::abs(p_j)) / (rho_0_ * rho_0_);
        sum.add(in_->bodies.mass[n.j] * p, in_->mass_error[n.j] * p, {1, 0}, n.kernel.grad_W);
    }
    return sum.error(terms(i) + 8);
}

/// (6), as a force per volume.
double StepBounds::eos_error(std::size_t i, std::span<const double> p, std::span<const double> p_error) const
{
    SumBound sum;
    for (const Pair& n : pairs(i)) {
        const std::size_t of = in_->bodies.free(n.j) ? n.j : i;
        const double p_sum = std::abs(p[i]) + std::abs(p[of]);
        const double p_sum_error = p_error[i] + p_error[of];
        sum.add(in_->bodies.mass[n.j] / (2 * rho(n.j)), in_->mass_error[n.j] / (2 * rho(n.j)),
                {p_sum, p_sum_error + rho_error(n.j) * p_sum}, n.kernel.grad_W);
    }
    return sum.error(terms(i) + 6);
}

/// (2) with the new velocity, and the residual of (3). What mirror images add may be rounded as the
/// velocities of both bodies rather than their difference.
void StepBounds::bound_divergence()
{
    for (std::size_t i = 0; i < count_; ++i) {
        if (!in_->bodies.free(i)) {
            continue;
        }
        SumBound sum;
        double mirrored = 0;
        for (const Pair& n : pairs(i)) {
            const double m = in_->bodies.mass[n.j];
            const double dv = length(end_velocity(i) - end_velocity(n.j));
            const double dv_error = n.j == i ? 0 : end_velocity_error(i) + end_velocity_error(n.j) + dv;
            const double w = weight(n.j);
            sum.add(w * m, w * in_->mass_error[n.j], {dv, dv_error}, n.kernel.grad_W);
            const double speeds = length(end_velocity(i)) + length(end_velocity(n.j));
            mirrored += (w - 1) * m * speeds * n.kernel.grad_W.value;
        }
        // Over rho_0: one rounding more of what is summed, which the terms' sizes bound.
        divergence[i] = (sum.error(terms(i) + 6) + (terms(i) + 6) * mirrored) / rho_0_;
        residual[i] = divergence[i] + (source_error(i) + sum.size()) / rho_0_;
    }
}

/// The mean drift and what is missing beside a void, over dt.
double StepBounds::source_error(std::size_t i) const
{
    if (!corrects_density()) {
        return 0;
    }
    const std::vector<double>& c = in_->driven.particles.drift;
    WeightedMean<double> mean;
    for (const Pair& n : pairs(i)) {
        if (in_->bodies.blood(n.j)) {
            mean.add(n.kernel.W, c[n.j]);
        }
    }
    for (const Pair& n : pairs(i)) {
        if (in_->bodies.blood(n.j)) {
            mean.compare(n.kernel.W, c[n.j], in_->errors.drift[n.j]);
        }
    }
    const double missing = rho(i) < guards::void_density * rho_0_ ? rho_0_ - rho(i) : 0;
    const double missing_error = missing > 0 ? density[i] + rho_0_ + missing : 0;
    return (mean.error(rounding_) + missing_error + 3 * (std::abs(mean.value()) + missing)) / dt_;
}

/// s = -beta dx^2 / rho_0 sum m grad W; the candidate's factor has five roundings, its product with the sum one.
void StepBounds::bound_shift()
{
    const double dx = h_ / scenario_->kernel.smoothing_length_spacings;
    const double factor = scenario_->pressure.shifting * dx * dx / rho_0_;
    for (std::size_t i = 0; i < count_; ++i) {
        const bool stays = in_->driven.particles.kind[i] != Kind::fluid ||
                           rho(i) < guards::void_density * rho_0_; // see void_open
        if (stays) {
            continue;
        }
        SumBound sum;
        for (const Pair& n : pairs(i)) {
            sum.add(in_->bodies.mass[n.j], in_->mass_error[n.j], {1, 0}, n.kernel.grad_W);
        }
        shift_error_[i] = factor * sum.error(terms(i) + 2) + 6 * length(in_->step.shift[i]);
    }
}

/// sum m W(r_ij + way_i - way_j). A neighbor at the edge of the support, which only one of the two may see, counts as a
/// whole where its way leads inside. `way`: of a body, with its error before its last rounding [m].
template <class Way>
StepBounds::Prediction StepBounds::predicted_density(std::size_t i, const Way& way) const
{
    const reference::Bodies& b = in_->bodies;
    Prediction prediction;
    SumBound sum;
    const auto [way_i, error_i] = way(i);
    for (const Pair& n : pairs(i)) {
        if (n.seen == Truth::no) {
            continue;
        }
        const auto [way_j, error_j] = way(n.j);
        const Vec3 x = reference::difference(b.position[i], b.position[n.j], in_->box);
        // The ways round twice, the sums twice each; a body's distance to itself stays 0.
        const double ways = length(way_i) + length(way_j);
        const double error = n.difference + error_i + error_j + 4 * ways + 3 * length(x);
        const Inexact W = kernel_.of(length(x + way_i - way_j), n.j == i ? 0 : error).W;
        prediction.rho += b.mass[n.j] * W.value;
        sum.add(b.mass[n.j], in_->mass_error[n.j], {1, 0}, W);
        prediction.jump += n.seen == Truth::open ? rounding_.units(b.mass[n.j] * W.value) : 0;
    }
    const double error = sum.error(terms(i) + 2);
    prediction.error = error + prediction.jump;
    return prediction;
}

/// rho* of the straight ways dt v, and the drift rho* - rho - dt Drho/Dt; and rho* with the shifts, which the correction
/// starts from.
void StepBounds::bound_prediction()
{
    const auto straight = [this](std::size_t j) {
        return std::pair{dt_ * end_velocity(j), dt_ * end_velocity_error(j)};
    };
    const auto shifted = [&](std::size_t j) {
        auto [way, error] = straight(j);
        const Vec3 shift = j < count_ ? in_->step.shift[j] : Vec3{};
        return std::pair{way + shift, error + length(shift) + (j < count_ ? shift_error_[j] : 0)};
    };
    const reference::Bodies& b = in_->bodies;
    for (std::size_t i = 0; i < count_; ++i) {
        if (!b.blood(i)) {
            continue;
        }
        const Prediction without = predicted_density(i, straight);
        const Prediction with = predicted_density(i, shifted);
        predicted_[i] = with.rho;
        predicted_error_[i] = with.error;
        open[i] = std::ranges::any_of(std::array{without, with},
                                      [](const Prediction& p) { return p.jump > p.error - p.jump; });
        drift[i] = b.free(i) ? without.error + density[i] + dt_ * rho_0_ * divergence[i] + 3 * rho(i) : 0;
    }
}

/// dt^2 a(kappa), the potential being the candidate's own, and the residual that it leaves.
void StepBounds::bound_correction()
{
    const double beta = scenario_->pressure.density_correction;
    const auto way = [&](std::size_t j) { return j < count_ ? in_->step.correction[j] : Vec3{}; };
    const auto way_error = [&](std::size_t j) { return j < count_ ? correction[j] : 0; };
    for (std::size_t i = 0; i < count_; ++i) {
        if (in_->bodies.blood(i)) {
            correction[i] = dt_ * dt_ * kappa_error(i) + 4 * length(way(i));
        }
    }
    for (std::size_t i = 0; i < count_; ++i) {
        if (!in_->bodies.blood(i)) {
            continue;
        }
        SumBound sum;
        for (const Pair& n : pairs(i)) {
            const double dx = length(way(i) - way(n.j));
            const double dx_error = n.j == i ? 0 : way_error(i) + way_error(n.j) + dx;
            sum.add(in_->bodies.mass[n.j], in_->mass_error[n.j], {dx, dx_error}, n.kernel.grad_W);
        }
        const double excess = std::abs(predicted_[i] - rho_0_);
        const double source = beta * (predicted_error_[i] + rho_0_ + 4 * excess);
        correction_residual[i] = (source + sum.error(terms(i) + 6) + sum.size()) / (dt_ * rho_0_);
    }
    for (std::size_t i = 0; i < count_; ++i) { // of the whole way
        correction[i] += shift_error_[i] + length(in_->step.shift[i]);
    }
}

/// As dfsph_error; only blood has a potential.
double StepBounds::kappa_error(std::size_t i) const
{
    const std::vector<double>& kappa = in_->moved.kappa;
    SumBound sum;
    for (const Pair& n : pairs(i)) {
        const double kappa_j = in_->bodies.blood(n.j) ? kappa[n.j] : 0;
        const double k = (std::abs(kappa[i]) + std::abs(kappa_j)) / (rho_0_ * rho_0_);
        sum.add(in_->bodies.mass[n.j] * k, in_->mass_error[n.j] * k, {1, 0}, n.kernel.grad_W);
    }
    return sum.error(terms(i) + 8);
}

/// m / rho |rho g + F_viscosity + F_pressure|; F_pressure = rho a in model dfsph.
InexactForce StepBounds::force(std::size_t i) const
{
    const double m = in_->bodies.mass[i];
    const Vec3& g = in_->body_force.g;
    const reference::FlowStep& step = in_->step;
    const auto inexact_force = [&](const Vec3& F_pressure, double pressure_error) {
        const Vec3 force = reference::momentum_force(rho(i), g, step.F_viscosity[i], F_pressure);
        const double magnitude = rho(i) * length(g) + length(step.F_viscosity[i]) + length(F_pressure);
        const double error = density[i] * length(g) + rho(i) * in_->body_force.error + viscosity_[i] +
                             pressure_error + 4 * magnitude;
        const double F = length(m / rho(i) * force);
        return Inexact{F, m / rho(i) * error + F * (density[i] / rho(i) + 7) + rounding_.lost_in_norm()};
    };
    std::vector<double> p(in_->bodies.size(), 0);
    std::vector<double> p_error(in_->bodies.size(), 0);
    for (const Pair& n : pairs(i)) {
        const double kappa = scenario_->pressure.stiffness_m2_s2;
        p[n.j] = reference::equation_of_state(kappa, rho(n.j), rho_0_);
        p_error[n.j] = kappa * ((n.j < count_ ? density[n.j] : 0) + 3 * rho(n.j)) + std::abs(p[n.j]);
    }
    const double a = length(step.F_pressure[i]) / rho(i);
    const double dfsph = rho(i) * acceleration_[i] + a * density[i] + 2 * rho(i) * a;
    const Vec3 F_eos = reference::pressure_force(step.bodies, step.neighbors.of(i), step.rho, p, i);
    return {inexact_force(step.F_pressure[i], dfsph), inexact_force(F_eos, eos_error(i, p, p_error))};
}

} // namespace aneurysm::bounds
