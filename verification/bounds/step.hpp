// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/scenario/scenario.hpp"
#include "reference/flow.hpp"
#include "verification/bounds/inexact.hpp"
#include "verification/bounds/kernel.hpp"
#include "verification/bounds/particle_errors.hpp"

#include <vector>

namespace aneurysm::bounds
{

/// The body force g of (1) in one step. Time, argument and sine are computed in double.
struct BodyForce {
    Vec3 g;           ///< [m/s^2]
    double error = 0; ///< before its last rounding [in U]
};

/// What a flow step computes from, and the step of the reference.
struct StepInput {
    reference::Period box; ///< edges of the periodic box
    BodyForce body_force;
    Inexact level; ///< of the pressure [Pa]
    const reference::FlowStep& step;
    const SimulationState& driven; ///< before any force
    const Particles& moved;        ///< at the end of the step
    /// Those of the step; they may be followed by ghosts of mass 0 that only the candidate may have.
    reference::Bodies bodies;
    std::vector<double> position_error; ///< by body [in U]
    std::vector<double> mass_error;     ///< by body [in U]
    const ParticleErrors& errors;       ///< before any force
};

/// The forces of (16) on a particle and their rounding.
struct InexactForce {
    Inexact dfsph; ///< with the pressure that drives the flow [N]
    Inexact eos;   ///< with the equation of state [N]
};

/// How far two computations of one flow step can be apart, by particle [in U] (docs/bounds.md, B24 and B31).
class StepBounds
{
public:
    StepBounds(const Scenario& scenario, double h, const Rounding& rounding, const StepInput& input);

    /// (16) for one particle.
    InexactForce force(std::size_t i) const;
    /// How far its shift and the density move a particle.
    Vec3 way(std::size_t i) const { return in_->step.shift[i] + in_->step.correction[i]; }

    std::vector<double> density;             ///< (5) [kg/m^3]
    std::vector<double> pressure;            ///< by body; 0 in model dfsph, where it is given [Pa]
    std::vector<double> velocity;            ///< at the end of the step [m/s]
    std::vector<double> residual;            ///< of (3) over rho_0 [1/s]
    std::vector<double> divergence;          ///< of the new velocity [1/s]
    std::vector<double> drift;               ///< what straight ways add to the density [kg/m^3]
    std::vector<double> correction;          ///< of the place by shift and density [m]
    std::vector<double> correction_residual; ///< of (3) for it over rho_0 [1/s]
    std::vector<bool>
        open; ///< whether a pair that may not be seen moves what is predicted by more than rounding
    bool void_open = false; ///< whether rounding decides about a void beside a particle

private:
    struct Pair {
        std::size_t j = 0;
        PairBounds kernel;
        double difference = 0;   ///< error of the difference vector before it is computed [in U]
        Truth seen = Truth::yes; ///< whether it is within the support
    };
    void find_pairs();
    void bound_density();
    void bound_ghost_velocity();
    void bound_forces();
    double viscosity_error(std::size_t i) const;
    double outlet_force_error(std::size_t i) const;
    void bound_pressure();
    double dfsph_error(std::size_t i) const;
    double eos_error(std::size_t i, std::span<const double> p, std::span<const double> p_error) const;
    void bound_divergence();
    double source_error(std::size_t i) const;
    void bound_shift();
    /// rho* and its error.
    struct Prediction {
        double rho = 0;   ///< [kg/m^3]
        double error = 0; ///< [in U]
        double jump = 0;  ///< of it: by pairs that only one of the two may see
    };
    template <class Way>
    Prediction predicted_density(std::size_t i, const Way& way) const;
    void bound_prediction();
    void bound_correction();
    double kappa_error(std::size_t i) const;

    std::span<const Pair> pairs(std::size_t i) const
    {
        return {pairs_.data() + begin_[i], begin_[i + 1] - begin_[i]};
    }
    double terms(std::size_t i) const { return static_cast<double>(begin_[i + 1] - begin_[i]); }
    double rho(std::size_t j) const { return j < count_ ? in_->step.rho[j] : rho_0_; }
    /// Relative; a ghost's density is a constant.
    double rho_error(std::size_t j) const { return j < count_ ? density[j] / rho(j) : 1; }
    /// Velocity in (7), and what stands still in (2).
    Vec3 start_velocity(std::size_t j) const;
    Vec3 end_velocity(std::size_t j) const { return j < count_ ? in_->step.velocity[j] : Vec3{}; }
    double end_velocity_error(std::size_t j) const { return j < count_ ? velocity[j] : 0; }
    /// How often the gradient at a neighbor counts in (2) as a solve of (3) has it.
    double weight(std::size_t j) const
    {
        return reference::weight(in_->bodies, reference::Given::mirrors, j);
    }
    bool corrects_density() const;

    const Scenario* scenario_;
    double rho_0_;
    double dt_;
    double h_;
    Rounding rounding_;
    KernelBounds kernel_;
    const StepInput* in_;
    std::size_t count_; ///< of particles
    std::vector<Pair> pairs_;
    std::vector<std::size_t> begin_;
    std::vector<Vec3> ghost_velocity_;         ///< in (7), behind the particles
    std::vector<double> ghost_velocity_error_; ///< [in U]
    std::vector<double> start_velocity_error_; ///< after all but the pressure [in U]
    std::vector<double> viscosity_;            ///< (7) [in U]
    std::vector<double> acceleration_;         ///< by pressure [in U]
    std::vector<double> shift_error_;          ///< [in U]
    std::vector<double> predicted_;            ///< density after the step's straight ways [kg/m^3]
    std::vector<double> predicted_error_;      ///< [in U]
};

} // namespace aneurysm::bounds
