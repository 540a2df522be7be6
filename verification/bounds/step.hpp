// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario/scenario.hpp"
#include "reference/flow.hpp"
#include "verification/bounds/inexact.hpp"
#include "verification/bounds/kernel.hpp"

#include <array>
#include <vector>

namespace aneurysm::bounds
{

/// How far the candidate's bodies can be from the reference's before a flow step [in U]: the particles, and
/// behind them the wall's ghosts.
struct BodyErrors {
    std::vector<double> position;
    std::vector<double> velocity;
    std::vector<double> mass;
    std::array<double, 2> outlet_velocity{};
};

/// The body force g of (1) in one step. Time, argument and sine are computed in double.
struct BodyForce {
    Vec3 g;           ///< [m/s^2]
    double error = 0; ///< before its last rounding [in U]
};

/// The forces of (16) on a particle and their rounding.
struct InexactForce {
    Inexact dfsph; ///< with the pressure that drives the flow [N]
    Inexact eos;   ///< with the equation of state [N]
};

/// How far two computations of one flow step can be apart, by particle [in U] (docs/bounds.md, B24).
class StepBounds
{
public:
    /// \param box     edges of the periodic box
    /// \param before  velocity by particle, before any force [m/s]
    /// \param step    the reference's step; its bodies may be followed by ghosts of mass 0 that only the
    ///                candidate may have
    StepBounds(const Scenario& scenario, double h, const reference::Period& box, const BodyForce& body_force,
               const Rounding& rounding, const reference::FlowStep& step, const reference::Bodies& bodies,
               std::span<const Vec3> before, const SimulationState& driven, const BodyErrors& errors);

    /// (16) for one particle.
    InexactForce force(std::size_t i) const;

    std::vector<double> density;    ///< (5) [kg/m^3]
    std::vector<double> pressure;   ///< by body; 0 in model dfsph, where it is given [Pa]
    std::vector<double> velocity;   ///< at the end of the step [m/s]
    std::vector<double> residual;   ///< of (3) over rho_0 [1/s]
    std::vector<double> divergence; ///< of the new velocity [1/s]

private:
    struct Pair {
        std::size_t j = 0;
        PairBounds kernel;
    };
    void find_pairs(const reference::Period& box, double support_margin);
    void bound_density();
    void bound_forces(std::span<const Vec3> before, const SimulationState& driven);
    double outlet_force_error(std::size_t i, const SimulationState& driven) const;
    void bound_pressure(const SimulationState& driven);
    double dfsph_error(std::size_t i) const;
    double eos_error(std::size_t i, std::span<const double> p, std::span<const double> p_error) const;
    void bound_divergence();

    std::span<const Pair> pairs(std::size_t i) const
    {
        return {pairs_.data() + begin_[i], begin_[i + 1] - begin_[i]};
    }
    double terms(std::size_t i) const { return static_cast<double>(begin_[i + 1] - begin_[i]); }
    double rho(std::size_t j) const { return j < step_->rho.size() ? step_->rho[j] : rho_0_; }
    /// Relative; a ghost's density is a constant.
    double rho_error(std::size_t j) const { return j < density.size() ? density[j] / rho(j) : 1; }

    const Scenario* scenario_;
    double rho_0_;
    double dt_;
    double h_;
    BodyForce body_force_;
    Rounding rounding_;
    KernelBounds kernel_;
    const reference::FlowStep* step_;
    const reference::Bodies* bodies_;
    const BodyErrors* errors_;
    std::vector<Pair> pairs_;
    std::vector<std::size_t> begin_;
    std::vector<double> start_velocity_; ///< after all but the pressure [in U]
    std::vector<double> viscosity_;      ///< (7) [in U]
    std::vector<double> acceleration_;   ///< by pressure [in U]
};

} // namespace aneurysm::bounds
