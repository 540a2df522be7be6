// SPDX-License-Identifier: Apache-2.0
#include "reference/controller.hpp"

#include "common/vessel/initial_state.hpp"
#include "common/vessel/sampling.hpp"
#include "reference/neighbors.hpp"

#include <algorithm>
#include <array>

namespace aneurysm::reference
{
namespace
{
constexpr std::array<Kind, 3> ghost_kind{Kind::inlet, Kind::outlet_1, Kind::outlet_2};

/// Hands out the reserve, lowest index first.
class Reserve
{
public:
    explicit Reserve(const Particles& particles) : particles_(&particles) {}

    /// An index that is in the reserve, or size() when it is empty.
    std::size_t take()
    {
        while (next_ < particles_->size() && particles_->kind[next_] != Kind::reserve) {
            ++next_;
        }
        return next_ < particles_->size() ? next_++ : particles_->size();
    }

private:
    const Particles* particles_;
    std::size_t next_ = 0;
};

} // namespace

void Controller::drive_inlet(Particles& particles, double v_inlet) const
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.kind[i] == Kind::inlet) {
            particles.velocity[i] = -v_inlet * vessel_->openings()[0].outward;
        }
    }
}

double Controller::outlet_velocity(const Particles& particles, std::size_t k, double previous,
                                   double p_outlet, double rho_0, double dt) const
{
    const Opening& end = vessel_->openings()[k];
    double velocity = 0;
    double pressure = 0;
    double count = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Vec3& x = particles.position[i];
        if (particles.kind[i] == Kind::fluid && end.beyond(x) > -settings_.probe_depth_spacings * dx_ &&
            vessel_->nearest_tube(x) == k) {
            velocity += dot(particles.velocity[i], end.outward);
            pressure += std::max(particles.pressure[i], 0.0);
            ++count;
        }
    }
    if (count == 0) {
        return previous;
    }
    return velocity / count + dt * (pressure / count - p_outlet) / (rho_0 * opening_layers * dx_);
}

void Controller::drive_outlet(Particles& particles, std::size_t k, double v, double previous) const
{
    const Vec3& outward = vessel_->openings()[k].outward;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.kind[i] == ghost_kind[k]) {
            const double own = dot(particles.velocity[i], outward) + (v - previous);
            particles.velocity[i] = (v > 0 ? std::max(own, 0.0) : v) * outward;
        }
    }
}

void Controller::reset(Particles& particles, std::size_t k, Ledger& ledger) const
{
    for (Kind& kind : particles.kind) {
        kind = kind == ghost_kind[k] ? Kind::reserve : kind;
    }
    Reserve reserve(particles);
    for (const Vec3& x : patterns_[k]) {
        const std::size_t i = reserve.take();
        if (i == particles.size()) {
            ++ledger.missed;
            continue;
        }
        particles.kind[i] = ghost_kind[k];
        particles.position[i] = x;
        particles.velocity[i] = {};
    }
}

void Controller::push_as_piston(Particles& particles, double v_inlet) const
{
    if (v_inlet < 0) {
        return;
    }
    const Opening& inlet = vessel_->openings()[0];
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double beyond = inlet.beyond(particles.position[i]);
        if (particles.kind[i] != Kind::fluid || beyond < -settings_.piston_reach_spacings * dx_) {
            continue;
        }
        const double inward = -dot(particles.velocity[i], inlet.outward);
        particles.velocity[i] -= std::max(0.0, v_inlet - inward) * inlet.outward;
        particles.position[i] -= std::max(0.0, beyond) * inlet.outward;
    }
}

void Controller::hold_back(Particles& particles, std::size_t k) const
{
    const Opening& end = vessel_->openings()[k];
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const double beyond = end.beyond(particles.position[i]);
        if (particles.kind[i] == Kind::fluid && beyond > 0 &&
            vessel_->nearest_tube(particles.position[i]) == k) {
            particles.position[i] -= beyond * end.outward;
            particles.velocity[i] -= std::max(0.0, dot(particles.velocity[i], end.outward)) * end.outward;
        }
    }
}

bool Controller::is_taken(const Particles& particles, const Vec3& x) const
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const Vec3 d = difference(particles.position[i], x, vessel_->period());
        if (particles.kind[i] == Kind::fluid && length(d) < settings_.closest_entry_spacings * dx_) {
            return true;
        }
    }
    return false;
}

void Controller::exchange(Particles& particles, Ledger& ledger) const
{
    for (std::size_t k = 0; k < ghost_kind.size(); ++k) {
        leave_slab(particles, k, ledger);
    }
    enter_artery(particles, ledger);
    cross_openings(particles, ledger);
}

void Controller::leave_slab(Particles& particles, std::size_t k, Ledger& ledger) const
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.kind[i] == ghost_kind[k] &&
            vessel_->openings()[k].beyond(particles.position[i]) > opening_layers * dx_) {
            particles.kind[i] = Kind::reserve;
            ++ledger.recycled;
        }
    }
}

void Controller::enter_artery(Particles& particles, Ledger& ledger) const
{
    struct Entry {
        std::size_t i = 0;
        std::size_t k = 0;
    };
    std::vector<Entry> entering;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        for (std::size_t k = 0; k < ghost_kind.size(); ++k) {
            if (particles.kind[i] == ghost_kind[k] &&
                vessel_->openings()[k].beyond(particles.position[i]) <= 0) {
                if (is_taken(particles, particles.position[i])) {
                    particles.position[i] += behind(k);
                } else {
                    entering.push_back({i, k});
                }
            }
        }
    }
    Reserve reserve(particles);
    for (const auto [i, k] : entering) {
        particles.kind[i] = Kind::fluid;
        particles.pressure[i] = unset_pressure;
        ++(k == 0 ? ledger.inlet_in : ledger.outlet_in);
        const std::size_t j = reserve.take();
        if (j == particles.size()) {
            ++ledger.missed;
            continue;
        }
        particles.kind[j] = ghost_kind[k];
        particles.position[j] = particles.position[i] + behind(k);
        particles.velocity[j] = particles.velocity[i];
    }
}

Vec3 Controller::behind(std::size_t k) const
{
    return opening_layers * dx_ * vessel_->openings()[k].outward;
}

void Controller::cross_openings(Particles& particles, Ledger& ledger) const
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.kind[i] != Kind::fluid) {
            continue;
        }
        const std::size_t k = vessel_->nearest_tube(particles.position[i]);
        if (vessel_->openings()[k].beyond(particles.position[i]) > 0) {
            particles.kind[i] = ghost_kind[k];
            ++(k == 0 ? ledger.inlet_out : ledger.outlet_out);
        }
    }
}

} // namespace aneurysm::reference
