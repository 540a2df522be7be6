// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/opening.hpp"

#include "common/guards.hpp"
#include "common/scenario/limits.hpp"
#include "common/vessel/initial_state.hpp"
#include "reference/boundary.hpp"
#include "reference/flow_path.hpp"
#include "verification/bounds/seam.hpp"

#include <algorithm>
#include <numbers>

namespace aneurysm::bounds
{
namespace
{
constexpr std::array<Kind, 3> buffer_kind{Kind::inlet, Kind::outlet_1, Kind::outlet_2};
constexpr double in_double = 0x1p-53;

/// Steepest change of the waveform of (25) [m/s^2].
double steepest_wave(const Scenario& s)
{
    const auto& inlet = s.inlet;
    if (inlet.waveform != Waveform::table) {
        return inlet.peak_velocity_m_s * 2 * std::numbers::pi / inlet.cycle_s;
    }
    double slope = 0;
    for (std::size_t k = 0; k < inlet.table_time_s.size(); ++k) {
        const std::size_t next = (k + 1) % inlet.table_time_s.size();
        const double t = next > 0 ? inlet.table_time_s[next] : inlet.cycle_s;
        slope = std::max(slope, std::abs(inlet.table_velocity_m_s[next] - inlet.table_velocity_m_s[k]) /
                                    (t - inlet.table_time_s[k]));
    }
    return slope;
}

/// Steepest change of (25) [m/s^2].
double steepest(const Scenario& s)
{
    const double ramp = s.inlet.ramp_s > 0 ? 1.5 / s.inlet.ramp_s : 0;
    return steepest_wave(s) + ramp * largest_inlet_speed(s);
}

/// Whether the controller has just placed particle i.
bool is_placed(const Particles& before, const Particles& after, std::size_t i)
{
    return after.kind[i] != Kind::reserve &&
           (before.kind[i] == Kind::reserve || before.position[i] != after.position[i]);
}

/// Whether each particle is in buffer k when its far layer is filled.
std::vector<Truth> members(const Particles& before, const Particles& after, std::size_t k,
                           const ParticleErrors& errors)
{
    std::vector<Truth> result(after.size(), Truth::no);
    for (std::size_t i = 0; i < after.size(); ++i) {
        const bool is = after.kind[i] == buffer_kind.at(k) && !is_placed(before, after, i);
        const bool may_be = is || errors.other_kind[i] == buffer_kind.at(k);
        if (may_be) {
            result[i] = errors.other_kind[i] ? Truth::open : Truth::yes;
        }
    }
    return result;
}

} // namespace

OpeningBounds::OpeningBounds(const Scenario& scenario, const WallBounds& wall, double dx,
                             const Rounding& rounding)
    : scenario_(&scenario), wall_(&wall), dx_(dx),
      dt_(scenario.time.frame_s / static_cast<double>(scenario.time.substeps)), rounding_(rounding),
      patterns_(sample_lattice(wall.vessel(), initial_radius(scenario), dx).openings)
{
}

/// How far both sides together can be from (25) before it is rounded: frame number times dt, the sine's
/// argument, the waveform and the ramp are 16 roundings to double on each.
double OpeningBounds::inlet_velocity_in_double(double t) const
{
    return 2 * 16 * in_double * (steepest(*scenario_) * (t + dt_) + largest_inlet_speed(*scenario_));
}

Inexact OpeningBounds::inlet_velocity(double t) const
{
    const auto& inlet = scenario_->inlet;
    const double v = reference::inlet_ramp(inlet.ramp_s, t) *
                     reference::inlet_velocity(inlet.waveform, inlet.peak_velocity_m_s, inlet.cycle_s, t,
                                               inlet.table_time_s, inlet.table_velocity_m_s);
    return {v, rounding_.units(inlet_velocity_in_double(t)) + std::abs(v)};
}

/// min(p_const, margin (rho_0 (inertia max(0, -dv/dt) + v^2) + mu friction max(0, -v))): a minimum moves by
/// no more than what it is of. The path's sums and these are 24 roundings to double on each side.
Inexact OpeningBounds::level(Phase phase, double t) const
{
    const double p_const = scenario_->outlet.pressure_pa;
    if (!wall_->vessel().is_open(1)) {
        return {};
    }
    if (scenario_->pressure.model == PressureModel::eos || phase == Phase::ruptured) {
        return rounded(p_const);
    }
    const reference::FlowPath path = reference::flow_path(*scenario_, wall_->vessel());
    const double rho_0 = scenario_->fluid.density_kg_m3;
    const double v = inlet_velocity(t).value;
    const double v_error = inlet_velocity_in_double(t);
    const double slowing = std::max(0.0, (inlet_velocity(t - dt_).value - v) / dt_);
    const double friction = scenario_->fluid.viscosity_pa_s * path.friction;
    const double pull = rho_0 * (path.inertia * slowing + v * v) + friction * std::max(0.0, -v);
    const double error =
        v_error * (rho_0 * (2 * path.inertia / dt_ + 2 * std::abs(v)) + friction) + 2 * 24 * in_double * pull;
    const double margin = scenario_->outlet.level_margin;
    const double value = std::min(p_const, margin * pull);
    return {value, rounding_.units(margin * error) + std::abs(value)};
}

/// The level less p_const; both sides take 0 where it is p_const itself.
Inexact OpeningBounds::lowest_pressure(Phase phase, double t) const
{
    const Inexact level = this->level(phase, t);
    const double p_const = scenario_->outlet.pressure_pa;
    return level.value < p_const ? level - rounded(p_const) : Inexact{};
}

/// (25) times the profile over the inlet's section.
Inexact OpeningBounds::inlet_speed(const InexactVec& x, const Inexact& v_inlet) const
{
    if (scenario_->inlet.profile == InletProfile::plug) {
        return v_inlet;
    }
    const Opening& inlet = wall_->vessel().openings()[0];
    const InexactVec n = rounded(inlet.outward);
    const InexactVec d = x - rounded(inlet.center);
    const InexactVec across = d - dot(d, n) * n;
    const Inexact radius = rounded(inlet.radius);
    const Inexact q = dot(across, across) / (radius * radius);
    const Inexact factor = Inexact{2, 0} * (Inexact{1, 0} - q);
    return Inexact{std::max(factor.value, 0.0), factor.error} * v_inlet;
}

void OpeningBounds::drive(const SimulationState& driven, double t, ParticleErrors& errors) const
{
    const Particles& p = driven.particles;
    const Inexact v_inlet = inlet_velocity(t);
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::inlet) {
            const Inexact v = inlet_speed(inexact(p.position[i], errors.position[i]), v_inlet);
            errors.velocity[i] = v.error + 2 * std::abs(v.value);
        }
    }
    for (const std::size_t k : {1U, 2U}) {
        std::vector<Truth> member(p.size());
        std::ranges::transform(p.kind, member.begin(),
                               [k](Kind kind) { return kind == buffer_kind.at(k) ? Truth::yes : Truth::no; });
        errors.outlet_velocity[k - 1] = buffer_velocity(p, k, member, errors).error;
    }
}

/// The mean of `count` dot products, with 8 operations more. A particle that may or may not be counted moves
/// it by its distance from it over their number.
Inexact OpeningBounds::buffer_velocity(const Particles& p, std::size_t k, const std::vector<Truth>& member,
                                       const ParticleErrors& errors) const
{
    const Vec3& n = wall_->vessel().openings()[k].outward;
    double count = 0;
    double v = 0;
    double sizes = 0;
    double error = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (member[i] == Truth::yes) {
            ++count;
            v += dot(p.velocity[i], n);
            sizes += length(p.velocity[i]);
            error += errors.velocity[i];
        }
    }
    const double size = std::max(count, 1.0);
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (member[i] == Truth::open) {
            error += rounding_.units(std::abs(dot(p.velocity[i], n) - v / size));
        }
    }
    return {v / size, (error + (count + 8) * sizes) / size};
}

bool OpeningBounds::far_layers_open(const Particles& driven, const ParticleErrors& errors) const
{
    const double near = (opening_layers - guards::open_layers) * dx_;
    for (std::size_t i = 0; i < driven.size(); ++i) {
        const Kind kind = driven.kind[i];
        if (kind != Kind::reserve && kind != Kind::fluid && kind != Kind::escaped &&
            wall_->is_beyond_nearest(inexact(driven.position[i], errors.position[i]), rounded(near)) ==
                Truth::open) {
            return true;
        }
    }
    return false;
}

/// Blood at an open end joins its buffer or not.
void OpeningBounds::cross(const Particles& before, const Particles& after, std::size_t i,
                          ParticleErrors& errors) const
{
    const InexactVec x = inexact(before.position[i], errors.position[i]);
    if (wall_->is_beyond_nearest(x, {}) != Truth::open) {
        return;
    }
    for (std::size_t k = 0; k < buffer_kind.size(); ++k) {
        if (is_positive(wall_->beyond(k, x), rounding_) != Truth::no &&
            wall_->is_nearest(k, x) != Truth::no) {
            const bool crossed = after.kind[i] == buffer_kind.at(k);
            errors.may_become(i, crossed ? Kind::fluid : buffer_kind.at(k),
                              k == 0 ? &Ledger::inlet_out : &Ledger::outlet_out);
            return;
        }
    }
}

/// Blood of buffer k joins the artery or not. Who is placed where depends on what leaves it at its far end.
void OpeningBounds::leave_buffer(const Particles& before, const Particles& after, std::size_t i,
                                 std::size_t k, ParticleErrors& errors) const
{
    const Inexact beyond = wall_->beyond(k, inexact(before.position[i], errors.position[i]));
    const double depth = opening_layers * dx_;
    if (is_positive(beyond, rounding_) == Truth::open) {
        errors.may_become(i, after.kind[i] == Kind::fluid ? buffer_kind.at(k) : Kind::fluid,
                          k == 0 ? &Ledger::inlet_in : &Ledger::outlet_in);
    }
    if (is_positive(beyond - Inexact{depth, 2 * depth}, rounding_) == Truth::open) {
        errors.exchange_open = true;
        errors.open[i] = true;
    }
}

void OpeningBounds::exchange(const Particles& before, const Particles& after, double t,
                             ParticleErrors& errors) const
{
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before.kind[i] == Kind::fluid) {
            cross(before, after, i, errors);
        }
        for (std::size_t k = 0; k < buffer_kind.size(); ++k) {
            if (before.kind[i] == buffer_kind.at(k)) {
                leave_buffer(before, after, i, k, errors);
            }
        }
    }
    for (std::size_t k = 0; k < buffer_kind.size(); ++k) {
        fill(before, after, k, t, errors);
    }
}

/// What is placed has a place of the pattern and the velocity of its buffer.
void OpeningBounds::fill(const Particles& before, const Particles& after, std::size_t k, double t,
                         ParticleErrors& errors) const
{
    const std::vector<Truth> member = members(before, after, k, errors);
    Inexact v = k == 0 ? -inlet_velocity(t) : buffer_velocity(before, k, member, errors);
    Inexact unrounded = v;
    unrounded.error -= k == 0 ? std::abs(v.value) : 0; // the last rounding doesn't change the sign
    const bool is_zero = v.value == 0 && v.error == 0; // for both: an empty buffer
    const Truth outwards = is_zero ? Truth::no : is_positive(unrounded, rounding_);
    bool open = outwards == Truth::open;
    for (std::size_t n = 0; outwards != Truth::yes && n < patterns_.at(k).size() && !open; ++n) {
        open = is_filled(patterns_.at(k)[n], k, before, member, errors) == Truth::open;
    }
    errors.exchange_open = errors.exchange_open || open;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (after.kind[i] == buffer_kind.at(k) && is_placed(before, after, i)) {
            const InexactVec x = rounded(after.position[i]);
            const Inexact speed = k == 0 ? inlet_speed(x, v) : v;
            errors.position[i] = error_of(x);
            errors.velocity[i] = speed.error + 2 * std::abs(speed.value);
            errors.drift[i] = 0;
            errors.pressure[i] = 0;
        }
    }
}

/// Whether a place of the far layer is filled: no blood of its buffer is nearer than the refill distance.
Truth OpeningBounds::is_filled(const Vec3& place, std::size_t k, const Particles& p,
                               const std::vector<Truth>& member, const ParticleErrors& errors) const
{
    const InexactVec x = rounded(place);
    const double near = (opening_layers - 1) * dx_;
    const Inexact reach = rounded(scenario_->controller.refill_distance_spacings * dx_);
    Truth filled = is_positive(wall_->beyond(k, x) - rounded(near), rounding_);
    for (std::size_t i = 0; filled != Truth::no && i < p.size(); ++i) {
        if (member[i] != Truth::no) {
            const InexactVec d = inexact(p.position[i], errors.position[i]) - x;
            const Truth nearer = is_positive(reach - norm(shortest(d, wall_->vessel().period())), rounding_);
            filled = filled && !(member[i] && nearer);
        }
    }
    return filled;
}

void OpeningBounds::recycle(const Particles& before, const Particles& after, const Vec3& breach,
                            double support, ParticleErrors& errors) const
{
    const Particles& p = before;
    const double far = scenario_->rupture.recycle_distance_radii * scenario_->vessel.radius_m;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] != Kind::escaped) {
            continue;
        }
        const InexactVec x = inexact(p.position[i], errors.position[i]);
        const Truth at_an_end = wall_->is_beyond_nearest(x, {-support, 3 * support});
        const Truth is_far = is_positive(norm(x - rounded(breach)) - rounded(far), rounding_);
        if (at_an_end != Truth::yes && is_far != Truth::yes &&
            (at_an_end == Truth::open || is_far == Truth::open)) {
            const bool recycled = after.kind[i] == Kind::reserve;
            errors.may_become(i, recycled ? Kind::escaped : Kind::reserve, &Ledger::recycled);
        }
    }
}

} // namespace aneurysm::bounds
