// SPDX-License-Identifier: Apache-2.0
// A short and wide duct with its two buffers, periodic across, for sums over all pairs.
#pragma once

#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"

namespace aneurysm::checks::duct
{

/// data/scenarios/verify_duct.json with `cells` along x and z and `rows` between its ends; with the buffers' rows these are
/// fewer than `cells`, less the support, so that the cloud's cube holds it.
Scenario scenario(int cells = 12, int rows = 3);

inline bool is_blood(Kind kind)
{
    return kind != Kind::reserve;
}

/// Blood up to a quarter of a spacing from its place, with velocities up to 0.5 m/s, and `along` more in the outlet's
/// buffer; the inlet's buffer has its own.
SimulationState disturbed(const Probe& probe, Scenario s, double along);

/// Poiseuille's parabola of the mean v_0 along the duct, at a place of the inlet's buffer [m/s].
Vec3 inlet_velocity_at(const Scenario& s, const Vec3& x);

/// The oracle's view: forces move all but the inlet's buffer.
analytic::Cloud cloud_of(const Scenario& s, const SimulationState& state, const std::vector<double>& density);

/// The outlet's buffer.
struct Buffer {
    double count = 0;   ///< of its particles
    double mean = 0;    ///< of their velocities, outwards [m/s]
    double fastest = 0; ///< the largest magnitude of these [m/s]
};
Buffer outlet_buffer(const Particles& p);

/// What acts at the outlet on blood i, at the level p of the pressure [N/m^3].
analytic::VectorEstimate force_at_outlet(const Scenario& s, const SimulationState& before,
                                         const analytic::Cloud& cloud, double p, std::size_t i);

/// Whether blood is in the two far layers of its buffer.
bool is_far(const Scenario& s, const Particles& p, std::size_t i);

/// What is missing of rho_0 beside a void, but in the far layers, which the pressure lets the density make up for [kg/m^3].
analytic::Estimate missing_density(const Scenario& s, const Particles& p, const analytic::Cloud& cloud,
                                   std::size_t i);

/// A step's velocities before the pressure acts on them, without viscosity, as the velocities of `cloud`.
/// \return how far the subject's may be from them [m/s]
double push_at_outlet(const Probe& probe, const Scenario& s, const SimulationState& before, double p,
                      analytic::Cloud& cloud);

} // namespace aneurysm::checks::duct
