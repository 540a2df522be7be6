// SPDX-License-Identifier: Apache-2.0
#include "reference/impact.hpp"

#include "reference/blood_flow.hpp"
#include "reference/rupture.hpp"

namespace aneurysm::reference
{
namespace
{

/// S of (16): blood beyond the sac's wall, or within the impact
/// band before it, that has not been put back yet.
std::vector<std::int64_t> impacting(const Scenario& scenario, const Vessel& vessel, double dx,
                                    const Particles& p, const Wall& wall)
{
    const double band = scenario.rupture.impact_band_spacings * dx;
    std::vector<std::int64_t> S;
    for (std::size_t i = 0; vessel.has_sac() && i < p.size(); ++i) {
        const Vec3& x = p.position[i];
        if (p.kind[i] == Kind::fluid && vessel.sac(x, wall.radius).value < vessel.tubes(x).value &&
            vessel.wall(x, wall.radius).value > -band) {
            S.push_back(static_cast<std::int64_t>(i));
        }
    }
    return S;
}

} // namespace

void record_impact(const Scenario& scenario, const Vessel& vessel, double dx, const FlowStep& step,
                   const Particles& p, const Wall& wall, const Vec3& g, FrameRecord& record)
{
    const std::vector<std::int64_t> S = impacting(scenario, vessel, dx, p, wall);
    record.impact_count = static_cast<std::int64_t>(S.size());
    std::vector<double> p_eos(S.empty() ? 0 : step.bodies.size());
    for (std::size_t j = 0; j < p_eos.size(); ++j) {
        p_eos[j] =
            equation_of_state(scenario.pressure.stiffness_m2_s2, step.rho[j], scenario.fluid.density_kg_m3);
    }
    std::vector<Vec3> force(p.size());
    std::vector<Vec3> force_eos(p.size());
    for (const std::int64_t member : S) {
        const auto i = static_cast<std::size_t>(member);
        const Vec3 F_eos = pressure_force(step.bodies, step.neighbors.of(i), step.rho, p_eos, i);
        force[i] = momentum_force(step.rho[i], g, step.F_viscosity[i], step.F_pressure[i]);
        force_eos[i] = momentum_force(step.rho[i], g, step.F_viscosity[i], F_eos);
    }
    const Impact impact = impact_force(S, p.mass, step.rho, force);
    if (record.impact_particle < 0 || impact.force > record.impact_force) {
        record.impact_force = impact.force;
        record.impact_particle = impact.particle;
        record.impact_force_eos = impact_force(S, p.mass, step.rho, force_eos).force;
    }
}

} // namespace aneurysm::reference
