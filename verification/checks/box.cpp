// SPDX-License-Identifier: Apache-2.0
#include "verification/checks/box.hpp"

#include "common/scenario/shipped.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace aneurysm::checks
{
namespace
{

analytic::Medium medium_of(const Scenario& s)
{
    const double dx = s.domain.spacing_m;
    const analytic::Lattice lattice{s.kernel.function, s.kernel.smoothing_length_spacings * dx, dx};
    const double rho = s.fluid.density_kg_m3;
    return {lattice, rho / analytic::kernel_sum(lattice).value, rho};
}

/// The scenario without what lets a fresh start settle.
Scenario unsettled(Scenario scenario)
{
    scenario.pressure.density_correction = 0;
    return scenario;
}

} // namespace

Scenario box_scenario(KernelName kernel, double ratio)
{
    Scenario scenario = shipped_scenario("verify_box");
    scenario.kernel.function = kernel;
    scenario.kernel.smoothing_length_spacings = ratio;
    scenario.pressure.shifting = 0;
    scenario.pressure.relaxation = 0.2; // below the limit of both kernels up to h/dx = 1.3
    return scenario;
}

void disturb(Particles& particles, std::initializer_list<Kind> kinds, double way, double speed,
             std::uint64_t seed)
{
    std::mt19937_64 bits(seed);
    const auto random = [&] { return std::ldexp(static_cast<double>(bits() >> 54U), -9) - 1; }; // [-1, 1)
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (std::ranges::find(kinds, particles.kind[i]) == kinds.end()) {
            continue;
        }
        for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            particles.position[i].*axis += way * random();
        }
        for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            particles.velocity[i].*axis = speed * random();
        }
    }
}

Box::Box(const Probe& probe, const Scenario& scenario)
    : scenario_(scenario), state_(probe.simulate(unsettled(scenario))->state()),
      edge_(static_cast<double>(scenario.domain.cells_x) * scenario.domain.spacing_m),
      cells_(static_cast<int>(scenario.domain.cells_x)), medium_(medium_of(scenario))
{
}

Eigen::Vector3d Box::wave_vector(const Mode& n) const
{
    return 2 * std::numbers::pi / edge_ * Eigen::Vector3d(n[0], n[1], n[2]);
}

std::vector<double> Box::wave(const Mode& n, double turns) const
{
    std::vector<double> values;
    for (int k = 0; k < cells_; ++k) {
        for (int j = 0; j < cells_; ++j) {
            for (int i = 0; i < cells_; ++i) {
                const long double phase =
                    turns + static_cast<long double>((n[0] * i + n[1] * j + n[2] * k) % cells_) / cells_;
                values.push_back(static_cast<double>(std::cos(2 * std::numbers::pi_v<long double> * phase)));
            }
        }
    }
    return values;
}

std::vector<Mode> Box::modes() const
{
    std::vector<Mode> all;
    for (int i = 1; i <= cells_ / 2; ++i) {
        for (int j = 0; j <= i; ++j) {
            for (int k = 0; k <= j; ++k) {
                all.push_back({i, j, k});
            }
        }
    }
    return all;
}

void Box::set_velocity(const std::vector<double>& wave, const Vec3& amplitude)
{
    for (std::size_t i = 0; i < wave.size(); ++i) {
        state_.particles.velocity[i] = wave[i] * amplitude;
    }
}

void Box::disturb(double jitter, double speed, std::uint64_t seed)
{
    checks::disturb(state_.particles, {Kind::fluid, Kind::reserve}, jitter * scenario_.domain.spacing_m,
                    speed, seed);
}

void Box::keep_drop(int edge)
{
    Particles& p = state_.particles;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3 d = p.position[i] - middle();
        const double reach = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        if (!(reach < edge / 2.0 * scenario_.domain.spacing_m)) {
            p.kind[i] = Kind::reserve;
            p.velocity[i] = {};
        }
    }
}

analytic::Cloud Box::cloud(const SimulationState& state, const std::vector<double>& density) const
{
    analytic::Cloud c;
    c.kernel = medium_.lattice.kernel;
    c.h = medium_.lattice.h;
    c.period = edge_;
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        c.position.push_back(to_eigen(state.particles.position[i]));
        c.velocity.push_back(to_eigen(state.particles.velocity[i]));
    }
    for (const Kind kind : state.particles.kind) {
        c.mass.push_back(kind == Kind::reserve ? 0 : medium_.mass);
    }
    c.density = density;
    c.pressure.assign(c.position.size(), 0);
    c.free.assign(c.position.size(), true);
    return c;
}

void RecordedRates::compare(Quantity& quantity, const FrameRecord& record, const std::string& where) const
{
    quantity.within(record.divergence_mean, mean, allowed, where + "mean");
    quantity.within(record.divergence_max, largest, allowed, where + "largest");
}

RecordedRates recorded_rates(const analytic::Cloud& cloud, double rho_0, double u,
                             analytic::Estimate (*rate_of)(const analytic::Cloud&, std::size_t))
{
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < cloud.mass.size(); ++i) {
        if (cloud.free[i] && cloud.mass[i] > 0) {
            free.push_back(i);
        }
    }
    const auto n = static_cast<double>(free.size());
    RecordedRates rates;
    double error = 0;
    for (const std::size_t i : free) {
        const analytic::Estimate pairs = pair_density_rate(cloud, i);
        const analytic::Estimate rate = rate_of != nullptr ? rate_of(cloud, i) : pairs;
        rates.mean += std::abs(rate.value) / rho_0 / n;
        rates.largest = std::max(rates.largest, std::abs(rate.value) / rho_0);
        const double own = rate_of != nullptr ? rate.error : 0;
        error = std::max(error, (own + both(pairs.error, u)) / rho_0);
    }
    rates.allowed = error + rounding(n) * rates.largest; // sums are double
    return rates;
}

} // namespace aneurysm::checks
