// SPDX-License-Identifier: Apache-2.0
#include "verification/bounds/opening.hpp"

#include "common/scenario/limits.hpp"
#include "common/vessel/sampling.hpp"
#include "reference/boundary.hpp"
#include "verification/bounds/seam.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace aneurysm::bounds
{
namespace
{
constexpr std::array<Kind, 3> ghost_kind{Kind::inlet, Kind::outlet_1, Kind::outlet_2};

bool is_ghost(Kind kind)
{
    return kind == Kind::inlet || kind == Kind::outlet_1 || kind == Kind::outlet_2;
}

/// Steepest change of (25) [m/s^2].
double steepest(const Scenario& s)
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

} // namespace

OpeningBounds::OpeningBounds(const Scenario& scenario, const WallBounds& wall, double dx,
                             const Rounding& rounding)
    : scenario_(&scenario), wall_(&wall), dx_(dx),
      dt_(scenario.time.frame_s / static_cast<double>(scenario.time.substeps)), rounding_(rounding)
{
}

Inexact OpeningBounds::inlet_velocity(double t) const
{
    const auto& inlet = scenario_->inlet;
    const double v = reference::inlet_velocity(inlet.waveform, inlet.peak_velocity_m_s, inlet.cycle_s, t,
                                               inlet.table_time_s, inlet.table_velocity_m_s);
    // Frame number times dt, sine's argument and the waveform: 8 roundings to double on each side.
    const double in_double =
        2 * 8 * 0x1p-53 * (steepest(*scenario_) * (t + dt_) + largest_inlet_speed(*scenario_));
    return {v, rounding_.units(in_double) + std::abs(v)};
}

void OpeningBounds::drive(const SimulationState& begun, const SimulationState& driven, double t,
                          ParticleErrors& errors) const
{
    const auto sign = [&](double time) {
        Inexact v = inlet_velocity(time);
        v.error -= std::abs(v.value); // the last rounding doesn't change the sign
        return is_positive(v, rounding_);
    };
    if (sign(t) != Truth::no && sign(t - dt_) != Truth::yes &&
        (sign(t) == Truth::open || sign(t - dt_) == Truth::open)) {
        errors.frame_open = true;
    }
    const Inexact v = inlet_velocity(t);
    const Particles& p = driven.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::inlet) {
            errors.velocity[i] = v.error + 2 * std::abs(v.value);
        }
        if (is_ghost(p.kind[i]) && p.position[i] != begun.particles.position[i]) {
            errors.position[i] = length(p.position[i]); // a pattern's place
            errors.velocity[i] = 0;
        }
    }
    for (const std::size_t k : {1U, 2U}) {
        drive_outlet(begun, driven, k, errors);
    }
}

/// v' = mean v + dt (mean p - p_outlet) / (rho_0 D). A particle that may or may not be counted moves each
/// mean by its distance from it over their number.
Inexact OpeningBounds::outlet_velocity(const SimulationState& begun, std::size_t k, double e_previous,
                                       const ParticleErrors& errors) const
{
    const Particles& p = begun.particles;
    const Vec3& n = wall_->vessel().openings()[k].outward;
    const double depth = scenario_->controller.probe_depth_spacings * dx_;
    const Inexact probe{-depth, 3 * depth};
    std::vector<std::size_t> open;
    double count = 0;
    double v = 0;
    double pressure = 0;
    double v_error = 0;
    double p_error = 0;
    double v_magnitude = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const InexactVec x = inexact(p.position[i], errors.position[i]);
        const Truth before =
            p.kind[i] == Kind::fluid ? is_positive(wall_->beyond(k, x) - probe, rounding_) : Truth::no;
        const Truth counts = before == Truth::no ? before : before && wall_->is_nearest(k, x);
        if (counts == Truth::open) {
            open.push_back(i);
        } else if (counts == Truth::yes) {
            ++count;
            v += dot(p.velocity[i], n);
            v_magnitude += length(p.velocity[i]);
            v_error += errors.velocity[i];
            pressure += std::max(p.pressure[i], 0.0);
            p_error += errors.pressure[i];
        }
    }
    const double previous = begun.outlet_velocity[k - 1];
    if (count == 0) {
        return {previous, open.empty() ? e_previous : rounding_.units(largest_inlet_speed(*scenario_))};
    }
    const double dynamic = previous < 0 ? 0.5 * scenario_->fluid.density_kg_m3 * previous * previous : 0;
    const double p_const = std::abs(scenario_->outlet.pressure_pa);
    const double e_outlet = 5 * dynamic + 2 * p_const +
                            (previous < 0 ? scenario_->fluid.density_kg_m3 * -previous * e_previous : 0);
    const double inertia = dt_ / (scenario_->fluid.density_kg_m3 * opening_layers * dx_);
    for (const std::size_t i : open) {
        v_error += rounding_.units(std::abs(dot(p.velocity[i], n) - v / count));
        p_error += rounding_.units(std::abs(std::max(p.pressure[i], 0.0) - pressure / count));
    }
    // Sums of `count` terms, each a dot product; 8 operations more.
    const double error = (v_error + (count + 8) * v_magnitude) / count +
                         inertia * ((p_error + (count + 8) * pressure) / count + e_outlet + 8 * p_const);
    return {v / count, error};
}

void OpeningBounds::drive_outlet(const SimulationState& begun, const SimulationState& driven, std::size_t k,
                                 ParticleErrors& errors) const
{
    const double previous = begun.outlet_velocity[k - 1];
    const double e_previous = errors.outlet_velocity[k - 1];
    const double v = driven.outlet_velocity[k - 1];
    const double e = outlet_velocity(begun, k, e_previous, errors).error;
    errors.outlet_velocity[k - 1] = e;
    const Truth outward = is_positive({v, e}, rounding_);
    if (outward == Truth::open) {
        errors.frame_open = true; // plug or not, reset or not
    }
    const Particles& p = driven.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == ghost_kind.at(k)) {
            const double own = outward == Truth::no
                                   ? 0
                                   : errors.velocity[i] + e_previous +
                                         4 * length(begun.particles.velocity[i]) + 2 * std::abs(previous);
            errors.velocity[i] = own + e + 4 * std::abs(v);
        }
    }
}

void OpeningBounds::hold(const SimulationState& moved, double t, ParticleErrors& errors) const
{
    const Inexact v = inlet_velocity(t);
    if (v.value >= 0 || is_positive(v, rounding_) == Truth::open) {
        push(moved.particles, v, errors);
    }
    for (const std::size_t k : {1U, 2U}) {
        if (moved.outlet_velocity[k - 1] < 0) {
            hold_back(moved.particles, k, errors);
        }
    }
}

/// The piston of the inlet: x - max(0, beyond) n and v - max(0, v_inlet - inward) n. The error of a maximum
/// with 0 is at most that of its argument. At the piston's reach the velocity sets in with a jump.
void OpeningBounds::push(const Particles& p, const Inexact& v_inlet, ParticleErrors& errors) const
{
    const Vec3& n = wall_->vessel().openings()[0].outward;
    const double before = scenario_->controller.piston_reach_spacings * dx_;
    const Inexact reach{-before, 3 * before};
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] != Kind::fluid) {
            continue;
        }
        const Inexact beyond = wall_->beyond(0, inexact(p.position[i], errors.position[i]));
        const Truth pushed = is_positive(beyond - reach, rounding_);
        if (pushed == Truth::no) {
            continue;
        }
        const double speed = length(p.velocity[i]) + std::abs(v_inlet.value);
        const double jump = std::max(0.0, v_inlet.value + dot(p.velocity[i], n));
        errors.velocity[i] += v_inlet.error + 6 * speed;
        if (pushed == Truth::open) {
            errors.velocity[i] += rounding_.units(jump);
            errors.open[i] = true;
        }
        if (is_positive(beyond, rounding_) != Truth::no) {
            errors.position[i] += beyond.error + 2 * std::abs(beyond.value) + length(p.position[i]);
        }
    }
}

void OpeningBounds::hold_back(const Particles& p, std::size_t k, ParticleErrors& errors) const
{
    const Vec3& n = wall_->vessel().openings()[k].outward;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] != Kind::fluid) {
            continue;
        }
        const InexactVec x = inexact(p.position[i], errors.position[i]);
        const Inexact beyond = wall_->beyond(k, x);
        const Truth plane = is_positive(beyond, rounding_);
        const Truth held = plane == Truth::no ? plane : plane && wall_->is_nearest(k, x);
        if (held == Truth::no) {
            continue;
        }
        errors.position[i] += beyond.error + 2 * std::abs(beyond.value) + length(p.position[i]);
        errors.velocity[i] += errors.velocity[i] + 6 * length(p.velocity[i]);
        if (held == Truth::open) {
            errors.velocity[i] += rounding_.units(std::max(0.0, dot(p.velocity[i], n)));
            errors.position[i] += rounding_.units(std::abs(beyond.value));
            errors.open[i] = true;
        }
    }
}

/// Blood at an open end becomes a ghost or not. Blood that was held back lies on the very plane.
void OpeningBounds::cross(const Particles& before, const Particles& after, std::size_t i,
                          ParticleErrors& errors) const
{
    const InexactVec x = inexact(before.position[i], errors.position[i]);
    if (wall_->is_beyond_nearest(x, {}) != Truth::open) {
        return;
    }
    for (std::size_t k = 0; k < ghost_kind.size(); ++k) {
        if (is_positive(wall_->beyond(k, x), rounding_) != Truth::no &&
            wall_->is_nearest(k, x) != Truth::no) {
            const bool crossed = after.kind[i] == ghost_kind.at(k);
            errors.may_become(i, crossed ? Kind::fluid : ghost_kind.at(k),
                              k == 0 ? &Ledger::inlet_out : &Ledger::outlet_out);
            return;
        }
    }
}

/// Whether rounding decides if ghost i becomes blood or leaves its slab;
/// where others are placed depends on it.
bool OpeningBounds::may_enter_or_leave(const Particles& p, std::size_t i, const ParticleErrors& errors) const
{
    const auto k = static_cast<std::size_t>(std::ranges::find(ghost_kind, p.kind[i]) - ghost_kind.begin());
    const Inexact beyond = wall_->beyond(k, inexact(p.position[i], errors.position[i]));
    const double depth = opening_layers * dx_;
    const Truth enters = !is_positive(beyond, rounding_);
    return enters == Truth::open ||
           is_positive(beyond - Inexact{depth, 2 * depth}, rounding_) == Truth::open ||
           (enters == Truth::yes && is_taken_open(p, i, errors));
}

/// Whether rounding decides if blood is too near to ghost i, at the place where it enters.
bool OpeningBounds::is_taken_open(const Particles& p, std::size_t i, const ParticleErrors& errors) const
{
    const double closest = scenario_->controller.closest_entry_spacings * dx_;
    const Inexact reach{closest, 2 * closest};
    for (std::size_t j = 0; j < p.size(); ++j) {
        if (p.kind[j] == Kind::fluid) {
            const Inexact d = norm(shortest(inexact(p.position[j], errors.position[j]) -
                                                inexact(p.position[i], errors.position[i]),
                                            wall_->vessel().period()));
            if (is_positive(d - reach, rounding_) == Truth::open) {
                return true;
            }
        }
    }
    return false;
}

void OpeningBounds::exchange(const Particles& before, const Particles& after, ParticleErrors& errors) const
{
    double position = 0;
    double velocity = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before.kind[i] == Kind::fluid) {
            cross(before, after, i, errors);
        }
        if (!is_ghost(before.kind[i])) {
            continue;
        }
        if (may_enter_or_leave(before, i, errors)) {
            errors.exchange_open = true;
            errors.open[i] = true;
        }
        if (after.kind[i] == Kind::fluid) {
            position = std::max(position, errors.position[i]);
            velocity = std::max(velocity, errors.velocity[i]);
        }
    }
    // A new ghost is placed a slab's depth behind one that entered and has its velocity; which of them is
    // the reserve's business, so the largest error of all counts. It may have been another ghost that left.
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (is_ghost(after.kind[i]) && before.position[i] != after.position[i]) {
            errors.position[i] =
                std::max(position, errors.position[i]) + length(after.position[i]) + 5 * opening_layers * dx_;
            errors.velocity[i] = std::max(velocity, errors.velocity[i]);
        }
    }
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
