// SPDX-License-Identifier: Apache-2.0
#include "verification/checks/sums/duct.hpp"

#include "common/guards.hpp"
#include "common/scenario/shipped.hpp"
#include "common/vessel/sampling.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks::duct
{

Scenario scenario(int cells, int rows)
{
    Scenario s = shipped_scenario("verify_duct");
    s.domain.cells_x = s.domain.cells_z = cells;
    s.domain.cells_y = rows;
    s.particles.count = cells * cells * (rows + 2 * opening_layers + 1);
    s.kernel.smoothing_length_spacings = 1;
    s.time.frame_s = 0x1p-12;
    s.fluid.gravity_m_s2 = {250, -430, 610}; // balanced by the pressure of blood at rest
    s.pressure.relaxation = 0.2;
    s.inlet.waveform = Waveform::constant;
    s.inlet.profile = InletProfile::parabolic;
    s.inlet.ramp_s = 0;
    s.outlet.pressure_pa = 4000;
    s.outlet.level_margin = 2;
    return s;
}

SimulationState disturbed(const Probe& probe, Scenario s, double along)
{
    s.pressure.density_correction = 0; // else a fresh start settles
    SimulationState state = probe.simulate(s)->state();
    Particles& p = state.particles;
    disturb(p, {Kind::fluid, Kind::outlet_1}, s.domain.spacing_m / 4, 0.5, 2451);
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.velocity[i].y += p.kind[i] == Kind::outlet_1 ? along : 0;
    }
    return state;
}

Vec3 inlet_velocity_at(const Scenario& s, const Vec3& x)
{
    const double R = static_cast<double>(s.domain.cells_x) * s.domain.spacing_m / 2;
    const double r2 = std::pow(x.x - R, 2) + std::pow(x.z - R, 2);
    return {0, s.inlet.peak_velocity_m_s * std::max(0.0, 2 * (1 - r2 / (R * R))), 0};
}

analytic::Cloud cloud_of(const Scenario& s, const SimulationState& state, const std::vector<double>& density)
{
    analytic::Cloud c;
    c.kernel = s.kernel.function;
    c.h = s.kernel.smoothing_length_spacings * s.domain.spacing_m;
    c.period = static_cast<double>(s.domain.cells_x) * s.domain.spacing_m;
    const Particles& p = state.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const bool driven = p.kind[i] == Kind::inlet;
        c.position.push_back(to_eigen(p.position[i]));
        c.velocity.push_back(to_eigen(driven ? inlet_velocity_at(s, p.position[i]) : p.velocity[i]));
        c.mass.push_back(is_blood(p.kind[i]) ? p.mass : 0);
        c.free.push_back(!driven);
    }
    c.density = density;
    c.pressure.assign(p.size(), 0);
    return c;
}

Buffer outlet_buffer(const Particles& p)
{
    Buffer buffer;
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::outlet_1) {
            ++buffer.count;
            sum += p.velocity[i].y;
            buffer.fastest = std::max(buffer.fastest, std::abs(p.velocity[i].y));
        }
    }
    buffer.mean = sum / buffer.count;
    return buffer;
}

analytic::VectorEstimate force_at_outlet(const Scenario& s, const SimulationState& before,
                                         const analytic::Cloud& cloud, double p, std::size_t i)
{
    if (before.particles.kind[i] != Kind::outlet_1) {
        return {};
    }
    auto force = analytic::pair_outlet_force(cloud, s.fluid.density_kg_m3, p, i);
    const Buffer buffer = outlet_buffer(before.particles);
    const double depth = opening_layers * s.domain.spacing_m;
    const auto pressure = [&](double v) { return s.fluid.density_kg_m3 * v * v / 2; };
    force.value.y() += buffer.mean < 0 ? pressure(buffer.mean) / depth : 0;
    // The mean is off by gamma_(n+1) of the fastest, its square by twice that; six roundings more cover the factors.
    force.error += rounding(2 * buffer.count + 8) * pressure(buffer.fastest) / depth +
                   rounding(1) * std::abs(force.value.y());
    return force;
}

bool is_far(const Scenario& s, const Particles& p, std::size_t i)
{
    const double dx = s.domain.spacing_m;
    const double y = p.position[i].y;
    return (p.kind[i] == Kind::inlet && y < -dx) ||
           (p.kind[i] == Kind::outlet_1 && y > static_cast<double>(s.domain.cells_y + 1) * dx);
}

analytic::Estimate missing_density(const Scenario& s, const Particles& p, const analytic::Cloud& cloud,
                                   std::size_t i)
{
    const double rho_0 = s.fluid.density_kg_m3;
    if (is_far(s, p, i) || cloud.density[i] >= guards::void_density * rho_0) {
        return {};
    }
    return {analytic::pair_density(cloud, i).value - rho_0, rounding(64) * rho_0};
}

double push_at_outlet(const Probe& probe, const Scenario& s, const SimulationState& before, double p,
                      analytic::Cloud& cloud)
{
    const double dt = s.time.frame_s;
    double error = 0;
    for (std::size_t i = 0; i < cloud.velocity.size(); ++i) {
        if (before.particles.kind[i] == Kind::outlet_1) {
            const auto force = force_at_outlet(s, before, cloud, p, i);
            cloud.velocity[i] += dt / cloud.density[i] * force.value;
            error = std::max(error, dt / cloud.density[i] * both(force.error, probe.roundoff()) +
                                        probe.gamma(8) * cloud.velocity[i].norm());
        }
    }
    return error;
}

} // namespace aneurysm::checks::duct
