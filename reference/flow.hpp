// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/scenario/scenario.hpp"
#include "common/vessel/geometry.hpp"
#include "common/vessel/sampling.hpp"
#include "reference/controller.hpp"
#include "reference/flow_step.hpp"
#include "reference/incompressible.hpp"

#include <span>
#include <vector>

namespace aneurysm::reference
{

/// The moments of a flow step at which an observer may look into it, in this order.
enum class FlowStage {
    begun,     ///< nothing done
    driven,    ///< the inlet's buffer has its velocity
    moved,     ///< forces, pressure and the density's correction have moved all
    collided,  ///< collisions handled
    exchanged, ///< the controller has acted
};

/// An observer of a flow step; bounds of rounding follow from what it sees.
class FlowObserver
{
public:
    FlowObserver() = default;
    virtual ~FlowObserver() = default;
    FlowObserver(const FlowObserver&) = delete;
    FlowObserver(FlowObserver&&) = delete;
    FlowObserver& operator=(const FlowObserver&) = delete;
    FlowObserver& operator=(FlowObserver&&) = delete;

    /// `t`: at the end of the step [s]; `step`: null before stage `moved`
    virtual void see(FlowStage stage, double t, const SimulationState& state, const Wall& wall,
                     const FlowStep* step) = 0;
};

/// Solutions of (3) that a flow step takes instead of its own, by particle; empty: it solves.
struct Solved {
    std::span<const double> pressure; ///< [Pa]
    std::span<const double> kappa;    ///< of the density's correction [Pa]
};

/// What a flow step may be given by those who check it.
struct FlowHooks {
    /// Instead of its own solves.
    Solved solved;
    /// Sees what is computed on the way.
    FlowObserver* observer = nullptr;
};

/// Blood flow through a vessel whose wall stands still: sections 3.1, 3.4 and 3.5.
class Flow
{
public:
    /// `patterns`: the open ends' buffers as sampled.
    /// \throws InputError when a step is longer than the flow stays stable for
    Flow(const Scenario& scenario, const Vessel& vessel, double dx,
         std::array<std::vector<Vec3>, 3> patterns);

    double particle_mass() const { return mass_; } ///< rho_0 / sum of W over the lattice [kg]
    /// W of all sums.
    const Kernel& kernel() const { return kernel_; }

    /// One step to time t; fills in the flow's part of the record.
    /// \throws SimulationError with frame and particle
    void step(SimulationState& state, const Wall& wall, double t, FrameRecord& record,
              const FlowHooks& hooks = {});

    /// From now on (3) is solved to other tolerances than the scenario's [1/s].
    void set_tolerances(double mean, double largest)
    {
        solver_.tolerance = mean;
        solver_.max_tolerance = largest;
    }

    /// Lets a fresh lattice find its place between the walls by the density's correction alone: rounds that push
    /// blood apart and off the walls, then rounds that fill its holes too, until one finds nothing to correct.
    void settle(SimulationState& state, const Wall& wall) const;

    /// By particle, of the last step; rho_0 for what isn't blood [kg/m^3]
    const std::vector<double>& density() const { return density_; }
    /// By particle, as the last step's solve left it, before the controller acted [Pa]
    const std::vector<double>& solved_pressure() const { return solved_pressure_; }
    /// The same of the correction's potential [Pa]
    const std::vector<double>& solved_kappa() const { return solved_kappa_; }

private:
    void check_stability() const;
    double inlet_velocity_at(double t) const;
    void drive_openings(SimulationState& state, double t, FrameRecord& record) const;
    double level(const SimulationState& state, double t) const;
    Vec3 body_force(const SimulationState& state, double t) const;
    FlowStep make_step(const SimulationState& state, const Wall& wall) const;
    void apply_forces(FlowStep& step, const SimulationState& state, const Vec3& g, double p_level) const;
    Vec3 outlet_force(const FlowStep& step, const SimulationState& state, std::size_t i,
                      double p_level) const;
    void solve_pressure(FlowStep& step, SimulationState& state, double p_level, FrameRecord& record,
                        std::span<const double> solved);
    IncompressibleReport solve_dfsph(const FlowStep& step, const Particles& p, double p_level,
                                     std::span<const double> solved, std::vector<double>& pressure,
                                     std::vector<Vec3>& a) const;
    IncompressibleReport solve_eos(const FlowStep& step, std::vector<double>& pressure,
                                   std::vector<Vec3>& a) const;
    bool corrects_density() const;
    bool is_far(const Particles& p, std::size_t i) const;
    std::vector<double> pressure_source(const FlowStep& step, const Particles& p) const;
    std::vector<double> predicted_density(const FlowStep& step, std::span<const Vec3> way) const;
    void shift_blood(FlowStep& step, const Particles& p) const;
    void correct_density(FlowStep& step, Particles& p, FrameRecord& record, std::span<const double> solved);
    /// One correction of the density.
    struct Correction {
        double beta = 0;   ///< part of the error that it takes away
        bool pulls = true; ///< else it only pushes: holes stay
        IncompressibleSettings settings;
    };
    IncompressibleReport solve_correction(const FlowStep& step, const Particles& p,
                                          std::span<const double> rho, const Correction& how,
                                          std::span<double> kappa, std::vector<Vec3>& way) const;
    IncompressibleReport settle_once(SimulationState& state, const Wall& wall, const Correction& how) const;
    void move(const FlowStep& step, SimulationState& state) const;
    void record_flow(const FlowStep& step, const Particles& p, FrameRecord& record) const;

    const Scenario* scenario_;
    const Vessel* vessel_;
    double dx_;
    double dt_;
    Kernel kernel_;
    double mass_;
    Controller controller_;
    IncompressibleSettings solver_;
    IncompressibleSettings correction_;
    std::vector<double> density_;
    std::vector<double> solved_pressure_;
    std::vector<double> solved_kappa_;
};

} // namespace aneurysm::reference
