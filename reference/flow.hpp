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
    driven,    ///< the open ends' ghosts have their velocities
    moved,     ///< forces and pressure have moved all
    held,      ///< the inlet's piston and back-flowing outlets have held blood back
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

/// What a flow step may be given by those who check it.
struct FlowHooks {
    std::span<const double> solved_pressure; ///< by particle; not empty: taken as the solution of (3) [Pa]
    FlowObserver* observer = nullptr;
};

/// Blood flow through a vessel whose wall stands still: sections 3.1, 3.4 and 3.5.
class Flow
{
public:
    /// `slabs`: the open ends' ghosts as sampled.
    /// \throws InputError when a step is longer than the flow stays stable for
    Flow(const Scenario& scenario, const Vessel& vessel, double dx, std::array<std::vector<Vec3>, 3> slabs);

    double particle_mass() const { return mass_; } ///< rho_0 / sum of W over the lattice [kg]
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

    /// Lets a fresh lattice find its place between the walls: overlaps are pushed apart, and while the blood
    /// stays denser than the solver's tolerance allows, the densest of it goes to the reserve: more was
    /// sampled than fits.
    void settle(SimulationState& state, const Wall& wall) const;

    /// By particle, of the last step; rho_0 for what isn't blood [kg/m^3]
    const std::vector<double>& density() const { return density_; }
    /// By particle, as the last step's solve left it, before the controller acted [Pa]
    const std::vector<double>& solved_pressure() const { return solved_pressure_; }

private:
    /// (3) with the velocity set to 0 before each step.
    void push_apart(SimulationState& state, const Wall& wall) const;
    void check_stability() const;
    double inlet_velocity_at(double t) const;
    void drive_openings(SimulationState& state, double t, FrameRecord& record) const;
    FlowStep make_step(const SimulationState& state, const Wall& wall) const;
    void apply_forces(FlowStep& step, const SimulationState& state, const Vec3& g) const;
    void solve_pressure(FlowStep& step, SimulationState& state, FrameRecord& record,
                        std::span<const double> solved);
    IncompressibleReport take_pressure(const FlowStep& step, std::span<const double> solved,
                                       std::vector<double>& pressure, std::vector<Vec3>& a) const;
    IncompressibleReport solve_dfsph(const FlowStep& step, const Particles& p, std::vector<double>& pressure,
                                     std::vector<Vec3>& a) const;
    IncompressibleReport solve_eos(const FlowStep& step, const SimulationState& state,
                                   std::vector<double>& pressure, std::vector<Vec3>& a) const;
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
    std::vector<double> density_;
    std::vector<double> solved_pressure_;
};

} // namespace aneurysm::reference
