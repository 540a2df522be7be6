// SPDX-License-Identifier: Apache-2.0
// Blood driven along the channel and the tube of data/scenarios/verify_channel.json and verify_tube.json, at
// any resolution, whatever backend computes it, beside what the oracles say of it.
#pragma once

#include "analytic/laminar_flow.hpp"
#include "analytic/lattice/lattice_duct.hpp"
#include "verification/checks/checks.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace aneurysm::checks
{

/// A flow from rest between walls 0.25 m apart, nu = 0.01 m^2/s.
struct Laminar {
    analytic::Section section = analytic::Section::channel;
    int across = 16;       ///< cells between the walls
    double ratio = 1;      ///< h/dx
    analytic::Drive drive; ///< along x in the channel, y in the tube
    double dt = 0;         ///< [s]

    static constexpr double width = 0.25; ///< [m]
    static constexpr double nu = 0.01;    ///< [m^2/s]
    double dx() const { return width / across; }
    analytic::Duct exact() const { return {section, width / 2, nu}; }
    analytic::LatticeDuct lattice() const;
    Scenario scenario() const;
    std::string name() const;
};

/// g sin(omega t) with this Womersley number.
analytic::Drive pulse(double g, double womersley);

/// Steps in [0, t], a multiple of `parts`, of at most dt = 0.1 dx^2/nu each: less than the scenario's limit.
int steps_to(double t, double dx, int parts);

/// The subject's flow. Nothing moves it across, so that each particle stays in its column.
class LaminarFlow
{
public:
    /// Counts the particles in each column of the oracle's lattice: `placed` [particles].
    LaminarFlow(const Probe& probe, const Laminar& flow, Quantity& placed);
    LaminarFlow(const Probe& probe, const Laminar& flow, const Scenario& scenario, Quantity& placed);

    void advance(int steps);
    int steps() const { return steps_; }

    /// Calls visit(column, velocity along the duct [m/s]) for each particle.
    void for_each(const std::function<void(std::size_t, double)>& visit) const;
    /// Mean velocity of each column [m/s].
    Eigen::VectorXd profile() const;

private:
    Laminar flow_;
    std::unique_ptr<Simulation> backend_;
    std::vector<std::size_t> column_; ///< by particle
    int steps_ = 0;
};

} // namespace aneurysm::checks
