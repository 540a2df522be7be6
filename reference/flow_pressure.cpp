// SPDX-License-Identifier: Apache-2.0
// Eq. (3) in a flow step: the pressure that keeps the velocity free of divergence, and the correction that keeps the
// density.
#include "common/guards.hpp"
#include "reference/boundary.hpp"
#include "reference/flow.hpp"
#include "reference/shifting.hpp"

#include <algorithm>
#include <limits>

namespace aneurysm::reference
{
namespace
{

/// Bodies of a correction: all blood takes part, and is at rest.
Bodies at_rest(Bodies b)
{
    for (std::size_t i = 0; i < b.size(); ++i) {
        b.role[i] = b.blood(i) ? Role::free : b.role[i];
        b.velocity[i] = {};
    }
    return b;
}

} // namespace

/// The blood's own pressure, by (3) or by the equation of state with (6); it changes the velocity.
void Flow::solve_pressure(FlowStep& step, SimulationState& state, double p_level, FrameRecord& record,
                          std::span<const double> solved)
{
    Particles& p = state.particles;
    const Bodies& b = step.bodies;
    step.pressure.assign(b.size(), 0);
    std::vector<Vec3> a(b.size());
    const bool dfsph = scenario_->pressure.model == PressureModel::dfsph;
    const IncompressibleReport report =
        dfsph ? solve_dfsph(step, p, p_level, solved, step.pressure, a) : solve_eos(step, step.pressure, a);
    step.F_pressure.assign(p.size(), {});
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (b.free(i)) {
            step.F_pressure[i] = step.rho[i] * a[i];
            step.velocity[i] = b.velocity[i] + dt_ * a[i];
            p.pressure[i] = step.pressure[i];
        }
    }
    solved_pressure_ = p.pressure;
    record.iterations += report.iterations;
    record.residual_mean = report.residual_mean;
    record.residual_max = report.residual_max;
    record.divergence_mean = report.divergence_mean;
    record.divergence_max = report.divergence_max;
}

/// From the last step's pressures; a particle that has none starts from its neighbors' mean. `solved`: not empty:
/// the solution, from which only follows what it does.
IncompressibleReport Flow::solve_dfsph(const FlowStep& step, const Particles& p, double p_level,
                                       std::span<const double> solved, std::vector<double>& pressure,
                                       std::vector<Vec3>& a) const
{
    const Bodies& b = step.bodies;
    const std::span<const double> start = solved.empty() ? std::span<const double>(p.pressure) : solved;
    for (std::size_t i = 0; i < p.size(); ++i) {
        pressure[i] = b.free(i) ? start[i] : 0;
        if (b.free(i) && start[i] == unset_pressure) {
            double sum = 0;
            double count = 0;
            for (const Neighbor& n : step.neighbors.of(i)) {
                if (b.free(n.j) && start[n.j] != unset_pressure) {
                    sum += start[n.j];
                    ++count;
                }
            }
            pressure[i] = count > 0 ? sum / count : 0;
        }
    }
    const std::vector<double> source = pressure_source(step, p);
    const std::vector<double> lowest(b.size(),
                                     p_level - scenario_->outlet.pressure_pa); // no absolute pressure below 0
    const bool in_slices = scenario_->pressure.start == PressureStart::slices && vessel_->is_open(1);
    const Slices slices = in_slices ? make_slices(*vessel_, kernel_.support()) : Slices{};
    const IncompressibleProblem problem{&b,  &step.neighbors, Given::mirrors, scenario_->fluid.density_kg_m3,
                                        dt_, source,          lowest,         slices};
    IncompressibleSettings settings = solver_;
    settings.max_iterations = solved.empty() ? settings.max_iterations : 0;
    return solve_incompressibility(problem, settings, pressure, a);
}

bool Flow::corrects_density() const
{
    return scenario_->pressure.model == PressureModel::dfsph && scenario_->pressure.density_correction > 0;
}

/// Whether blood is in the far layers of a buffer, whose neighborhoods aren't full.
bool Flow::is_far(const Particles& p, std::size_t i) const
{
    const bool in_buffer = p.kind[i] != Kind::fluid && p.kind[i] != Kind::escaped;
    const Vec3& x = p.position[i];
    return in_buffer && vessel_->openings()[vessel_->nearest_tube(x)].beyond(x) >
                            (opening_layers - guards::open_layers) * dx_;
}

/// Drho/Dt has to make up for what straight ways add to the density, c_i of the last step: in the mean over the
/// neighborhood, as the flow carries only what is wider than that; the rest is the correction's. Where there is a
/// void, but in a buffer's far layers, the density may rise to rho_0.
///
///     source_i = sum_j c_j W_ij / (dt sum_j W_ij)                                          [kg/(m^3 s)]
std::vector<double> Flow::pressure_source(const FlowStep& step, const Particles& p) const
{
    std::vector<double> source(step.bodies.size(), 0);
    if (!corrects_density()) {
        return source;
    }
    const double rho_0 = scenario_->fluid.density_kg_m3;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (!step.bodies.free(i)) {
            continue;
        }
        double drift = 0;
        double weights = 0;
        for (const Neighbor& n : step.neighbors.of(i)) {
            if (step.bodies.blood(n.j)) {
                drift += n.W * p.drift[n.j];
                weights += n.W;
            }
        }
        const double missing =
            !is_far(p, i) && step.rho[i] < guards::void_density * rho_0 ? step.rho[i] - rho_0 : 0;
        source[i] = (drift / weights + missing) / dt_;
    }
    return source;
}

IncompressibleReport Flow::solve_eos(const FlowStep& step, std::vector<double>& pressure,
                                     std::vector<Vec3>& a) const
{
    const Bodies& b = step.bodies;
    const double rho_0 = scenario_->fluid.density_kg_m3;
    for (std::size_t i = 0; i < b.size(); ++i) {
        pressure[i] = equation_of_state(scenario_->pressure.stiffness_m2_s2, step.rho[i], rho_0);
    }
    std::vector<Vec3> v = b.velocity;
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (b.free(i)) {
            a[i] = acceleration(step.rho[i], pressure_force(b, step.neighbors.of(i), step.rho, pressure, i));
            v[i] += dt_ * a[i];
        }
    }
    return divergence_report({&b, &step.neighbors, Given::mirrors, rho_0, dt_, {}, {}, {}}, v);
}

/// Density (5) after all have gone their ways, over the neighbors that they had before:
///
///     rho*_i = sum_j m_j W(r_ij + way_i - way_j)                                               [kg/m^3]
std::vector<double> Flow::predicted_density(const FlowStep& step, std::span<const Vec3> way) const
{
    const Bodies& b = step.bodies;
    std::vector<double> rho(b.size(), scenario_->fluid.density_kg_m3);
    for (std::size_t i = 0; i < b.size(); ++i) {
        if (b.blood(i)) {
            rho[i] = 0;
            for (const Neighbor& n : step.neighbors.of(i)) {
                const Vec3 x =
                    difference(b.position[i], b.position[n.j], vessel_->period()) + way[i] - way[n.j];
                rho[i] += b.mass[n.j] * kernel_.value(length(x));
            }
        }
    }
    return rho;
}

/// The shifts of what flows freely. Beside a void evenly spread would mean apart.
void Flow::shift_blood(FlowStep& step, const Particles& p) const
{
    const double rho_0 = scenario_->fluid.density_kg_m3;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::fluid && step.rho[i] >= guards::void_density * rho_0) {
            step.shift[i] =
                shift(step.bodies, step.neighbors.of(i), rho_0, dx_, scenario_->pressure.shifting);
        }
    }
}

/// The correction of the density, shifts included, and what the straight ways alone have added to it beyond dt Drho/Dt,
/// c_i. `solved`: not empty: its potential.
void Flow::correct_density(FlowStep& step, Particles& p, FrameRecord& record, std::span<const double> solved)
{
    const Bodies& b = step.bodies;
    step.shift.assign(p.size(), {});
    step.correction.assign(p.size(), {});
    solved_kappa_ = p.kappa;
    if (!corrects_density()) {
        return;
    }
    std::vector<Vec3> velocity = b.velocity;
    std::ranges::copy(step.velocity, velocity.begin());
    std::vector<Vec3> way(b.size());
    std::ranges::transform(velocity, way.begin(), [this](const Vec3& v) { return dt_ * v; });
    const std::vector<double> straight = predicted_density(step, way);
    const IncompressibleProblem given{
        &b, &step.neighbors, Given::mirrors, scenario_->fluid.density_kg_m3, dt_, {}, {}, {}};
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.drift[i] = b.free(i) ? straight[i] - step.rho[i] - dt_ * density_rate(given, velocity, i) : 0;
    }
    shift_blood(step, p);
    std::transform(step.shift.begin(), step.shift.end(), way.begin(), way.begin(),
                   [](const Vec3& s, const Vec3& w) { return w + s; });
    const std::vector<double> rho = predicted_density(step, way);
    std::vector<double> kappa(b.size(), 0);
    std::ranges::copy(solved.empty() ? std::span<const double>(p.kappa) : solved, kappa.begin());
    Correction whole{scenario_->pressure.density_correction, true, correction_};
    whole.settings.max_iterations = solved.empty() ? whole.settings.max_iterations : 0;
    step.corrected = solve_correction(step, p, rho, whole, kappa, step.correction);
    record.corrections += step.corrected.iterations;
    std::copy_n(kappa.begin(), p.size(), p.kappa.begin());
    solved_kappa_ = p.kappa;
}

/// (3) as rho = rho_0: ways x' - x = dt^2 a(kappa) that take the part beta of the error away from rho,
///
///     beta (rho_i - rho_0) / dt + Drho_i/Dt((x' - x) / dt) = 0
///
/// kappa >= 0 beside a void, outside of the wall and in the far layers of a buffer: nothing pulls there; and everywhere
/// for a correction that only pushes, from which walls are mirrors, so that blood keeps its distance from them.
IncompressibleReport Flow::solve_correction(const FlowStep& step, const Particles& p,
                                            std::span<const double> rho, const Correction& how,
                                            std::span<double> kappa, std::vector<Vec3>& way) const
{
    const double rho_0 = scenario_->fluid.density_kg_m3;
    const Bodies b = at_rest(step.bodies);
    std::vector<double> source(b.size(), 0);
    std::vector<double> lowest(b.size(), std::numeric_limits<double>::lowest());
    for (std::size_t i = 0; i < p.size(); ++i) {
        source[i] = how.beta * (rho[i] - rho_0) / dt_;
        const bool is_free = p.kind[i] == Kind::escaped || step.rho[i] < guards::void_density * rho_0;
        lowest[i] = !how.pulls || is_far(p, i) || is_free ? 0 : lowest[i];
    }
    const Given given = how.pulls ? Given::at_rest : Given::mirrors;
    std::vector<Vec3> a(b.size());
    const IncompressibleReport report = solve_incompressibility(
        {&b, &step.neighbors, given, rho_0, dt_, source, lowest, {}}, how.settings, kappa, a);
    std::transform(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(p.size()), way.begin(),
                   [this](const Vec3& a_i) { return dt_ * dt_ * a_i; });
    return report;
}

} // namespace aneurysm::reference
