// SPDX-License-Identifier: Apache-2.0
#include "common/vessel/initial_state.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace aneurysm
{
namespace
{

/// Uniform in [-1, 1), the same on every machine.
double uniform(std::mt19937_64& engine)
{
    return std::ldexp(static_cast<double>(engine() >> 11U), -52) - 1;
}

/// \throws InputError when the scenario has too few particles for its cells
Lattice sample_cells(const Scenario& scenario, const Vessel& vessel)
{
    Lattice lattice = sample_lattice(vessel, 0, scenario.domain.spacing_m);
    if (lattice.size() > static_cast<std::size_t>(scenario.particles.count)) {
        throw InputError("particles.count",
                         std::to_string(scenario.particles.count) +
                             " is too few for the cells of this domain",
                         "needed: at least " + std::to_string(lattice.size()));
    }
    return lattice;
}

} // namespace

double initial_radius(const Scenario& scenario)
{
    return scenario.aneurysm.initial_radius_radii * scenario.vessel.radius_m;
}

Lattice sample(const Scenario& scenario, const Vessel& vessel, double daughter_radius,
               std::optional<double> spacing)
{
    const double R = initial_radius(scenario);
    if (scenario.domain.form != DomainForm::artery) {
        return sample_cells(scenario, vessel);
    }
    if (spacing) {
        return sample_lattice(vessel, R, *spacing);
    }
    return sample_count(vessel, R, static_cast<std::size_t>(scenario.particles.count),
                        scenario.particles.reserve_fraction, daughter_radius);
}

SimulationState initial_state(const Scenario& scenario, const Lattice& lattice, double particle_mass)
{
    const auto count = static_cast<std::size_t>(scenario.particles.count);
    SimulationState state;
    state.spacing = lattice.spacing;
    state.aneurysm.radius = initial_radius(scenario);
    state.aneurysm.thickness = scenario.rupture.thickness_ratio * scenario.vessel.radius_m;

    Particles& p = state.particles;
    p.mass = particle_mass;
    const auto add = [&p](const std::vector<Vec3>& positions, Kind kind) {
        p.position.insert(p.position.end(), positions.begin(), positions.end());
        p.kind.insert(p.kind.end(), positions.size(), kind);
    };
    add(lattice.fluid, Kind::fluid);
    add(lattice.openings[0], Kind::inlet);
    add(lattice.openings[1], Kind::outlet_1);
    add(lattice.openings[2], Kind::outlet_2);
    p.position.resize(count);
    p.kind.resize(count, Kind::reserve);
    p.velocity.resize(count);
    p.pressure.resize(count);
    p.kappa.resize(count);
    p.drift.resize(count);

    std::mt19937_64 engine(static_cast<std::uint64_t>(scenario.particles.seed));
    const double amplitude = scenario.particles.jitter_spacings * lattice.spacing;
    for (std::size_t i = 0; i < lattice.fluid.size(); ++i) {
        const double x = uniform(engine);
        const double y = uniform(engine);
        const double z = uniform(engine);
        p.position[i] += amplitude * Vec3{x, y, z};
    }
    return state;
}

GhostLattice ghost_lattice(const Scenario& scenario, const Vessel& vessel, double dx, double support,
                           double particle_mass)
{
    // The elastic displacement stays below one spacing to either side, else the run stops.
    const double R = initial_radius(scenario);
    return {vessel, std::max(R - dx, 0.5 * R), vessel.largest_radius() + dx, dx, support, particle_mass};
}

} // namespace aneurysm
