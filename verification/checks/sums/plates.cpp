// SPDX-License-Identifier: Apache-2.0
#include "verification/checks/sums/plates.hpp"

#include "common/scenario/shipped.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/vectors.hpp"

namespace aneurysm::checks
{
namespace
{

constexpr int cells = 8;

} // namespace

Scenario plates(int rows)
{
    Scenario s = shipped_scenario("verify_channel");
    s.domain.cells_x = s.domain.cells_z = cells;
    s.domain.cells_y = rows;
    s.particles.count = cells * rows * cells;
    s.particles.jitter_spacings = 0;
    s.kernel.smoothing_length_spacings = 1;
    s.time.frame_s = 0x1p-12;
    s.fluid.viscosity_pa_s = 64;
    s.fluid.gravity_m_s2 = {};
    s.fluid.gravity_cycle_s = 0;
    s.pressure.relaxation = 0.2;
    s.pressure.density_correction = 0; // else a fresh start settles
    s.pressure.shifting = 0;
    return s;
}

SimulationState disturbed(const Probe& probe, const Scenario& s)
{
    SimulationState state = probe.simulate(s)->state();
    disturb(state.particles, {Kind::fluid}, s.domain.spacing_m / 4, 0.5, 2449);
    return state;
}

analytic::Cloud cloud_of(const Scenario& s, const SimulationState& state, const std::vector<double>& density)
{
    const double dx = s.domain.spacing_m;
    analytic::Cloud c;
    c.kernel = s.kernel.function;
    c.h = dx;
    c.period = cells * dx;
    for (std::size_t i = 0; i < state.particles.size(); ++i) {
        c.position.push_back(to_eigen(state.particles.position[i]));
        c.velocity.push_back(to_eigen(state.particles.velocity[i]));
    }
    c.free.assign(c.position.size(), true);
    c.density = density;
    const auto rows = static_cast<double>(s.domain.cells_y);
    for (const double y : {-1.5, -0.5, rows + 0.5, rows + 1.5}) {
        for (int i = 0; i < cells; ++i) {
            for (int k = 0; k < cells; ++k) {
                c.position.emplace_back((i + 0.5) * dx, y * dx, (k + 0.5) * dx);
                c.velocity.emplace_back(0, 0, 0);
                c.free.push_back(false);
                c.density.push_back(s.fluid.density_kg_m3);
            }
        }
    }
    c.mass.assign(c.position.size(), state.particles.mass);
    c.pressure.assign(c.position.size(), 0);
    return c;
}

} // namespace aneurysm::checks
