// SPDX-License-Identifier: Apache-2.0
#include "reference/controller.hpp"

#include "common/vessel/sampling.hpp"
#include "reference/boundary.hpp"

#include <algorithm>
#include <array>

namespace aneurysm::reference
{
namespace
{
constexpr std::array<Kind, 3> buffer_kind{Kind::inlet, Kind::outlet_1, Kind::outlet_2};

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

Vec3 Controller::inlet_velocity_of(const Vec3& x, double v_inlet) const
{
    const Opening& inlet = vessel_->openings()[0];
    const Vec3 d = x - inlet.center;
    const Vec3 across = d - dot(d, inlet.outward) * inlet.outward;
    return -v_inlet * inlet_profile(scenario_->inlet.profile, dot(across, across), inlet.radius) *
           inlet.outward;
}

void Controller::drive_inlet(Particles& particles, double v_inlet) const
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.kind[i] == Kind::inlet) {
            particles.velocity[i] = inlet_velocity_of(particles.position[i], v_inlet);
        }
    }
}

double Controller::buffer_velocity(const Particles& particles, std::size_t k) const
{
    double velocity = 0;
    double count = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.kind[i] == buffer_kind[k]) {
            velocity += dot(particles.velocity[i], vessel_->openings()[k].outward);
            ++count;
        }
    }
    return count > 0 ? velocity / count : 0;
}

void Controller::exchange(Particles& particles, double v_inlet, Ledger& ledger) const
{
    for (std::size_t k = 0; k < buffer_kind.size(); ++k) {
        leave(particles, k, ledger);
    }
    enter_artery(particles, ledger);
    leave_artery(particles, ledger);
    for (std::size_t k = 0; k < buffer_kind.size(); ++k) {
        fill(particles, k, v_inlet, ledger);
    }
}

void Controller::leave(Particles& particles, std::size_t k, Ledger& ledger) const
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.kind[i] == buffer_kind[k] &&
            vessel_->openings()[k].beyond(particles.position[i]) > opening_layers * dx_) {
            particles.kind[i] = Kind::reserve;
            ++ledger.recycled;
        }
    }
}

void Controller::enter_artery(Particles& particles, Ledger& ledger) const
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        for (std::size_t k = 0; k < buffer_kind.size(); ++k) {
            if (particles.kind[i] == buffer_kind[k] &&
                vessel_->openings()[k].beyond(particles.position[i]) <= 0) {
                particles.kind[i] = Kind::fluid;
                if (k == 0) {
                    particles.pressure[i] = unset_pressure;
                }
                ++(k == 0 ? ledger.inlet_in : ledger.outlet_in);
            }
        }
    }
}

void Controller::leave_artery(Particles& particles, Ledger& ledger) const
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        const std::size_t k = vessel_->nearest_tube(particles.position[i]);
        if (particles.kind[i] == Kind::fluid && vessel_->openings()[k].beyond(particles.position[i]) > 0) {
            particles.kind[i] = buffer_kind[k];
            ++(k == 0 ? ledger.inlet_out : ledger.outlet_out);
        }
    }
}

void Controller::fill(Particles& particles, std::size_t k, double v_inlet, Ledger& ledger) const
{
    const Opening& end = vessel_->openings()[k];
    const double v = k == 0 ? -v_inlet : buffer_velocity(particles, k);
    if (v > 0) {
        return;
    }
    std::vector<Vec3> places;
    for (const Vec3& x : patterns_[k]) {
        if (end.beyond(x) > (opening_layers - 1) * dx_ && is_free(particles, k, x)) {
            places.push_back(x);
        }
    }
    Reserve reserve(particles);
    for (const Vec3& x : places) {
        const std::size_t i = reserve.take();
        if (i == particles.size()) {
            ++ledger.missed;
            continue;
        }
        particles.kind[i] = buffer_kind[k];
        particles.position[i] = x;
        particles.velocity[i] = k == 0 ? inlet_velocity_of(x, v_inlet) : v * end.outward;
        particles.pressure[i] = particles.kappa[i] = particles.drift[i] = 0;
    }
}

bool Controller::is_free(const Particles& particles, std::size_t k, const Vec3& x) const
{
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.kind[i] == buffer_kind[k] &&
            length(difference(particles.position[i], x, vessel_->period())) <
                scenario_->controller.refill_distance_spacings * dx_) {
            return false;
        }
    }
    return true;
}

} // namespace aneurysm::reference
