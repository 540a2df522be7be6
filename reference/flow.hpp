// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/frame.hpp"
#include "common/geometry.hpp"
#include "common/sampling.hpp"
#include "common/scenario.hpp"
#include "reference/controller.hpp"
#include "reference/incompressible.hpp"

#include <optional>
#include <vector>

namespace aneurysm::reference
{

/// The wall as one flow step sees it.
struct Wall {
    double radius = 0; ///< of the sac, displacement included [m]
    WallGhosts ghosts;
    std::optional<Breach> breach;
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
    void step(SimulationState& state, const Wall& wall, double t, FrameRecord& record);

    /// Lets a fresh lattice find its place between the walls: overlaps are pushed apart, and while the blood
    /// stays denser than the solver's tolerance allows, the densest of it goes to the reserve: more was
    /// sampled than fits.
    void settle(SimulationState& state, const Wall& wall) const;

    /// By particle, of the last step; rho_0 for what isn't blood [kg/m^3]
    const std::vector<double>& density() const { return density_; }
    /// By particle, as the last step's solve left it, before the controller acted [Pa]
    const std::vector<double>& solved_pressure() const { return solved_pressure_; }

private:
    struct Step;
    /// (3) with the velocity set to 0 before each step.
    void push_apart(SimulationState& state, const Wall& wall) const;
    void check_stability() const;
    double inlet_velocity_at(double t) const;
    void drive_openings(SimulationState& state, double t, FrameRecord& record) const;
    Step make_step(const SimulationState& state, const Wall& wall) const;
    void apply_forces(Step& step, const SimulationState& state) const;
    void solve_pressure(Step& step, SimulationState& state, FrameRecord& record);
    IncompressibleReport solve_dfsph(const Step& step, const Particles& p, std::vector<double>& pressure,
                                     std::vector<Vec3>& a) const;
    IncompressibleReport solve_eos(const Step& step, const SimulationState& state,
                                   std::vector<double>& pressure, std::vector<Vec3>& a) const;
    void move(const Step& step, SimulationState& state) const;
    void record_flow(const Step& step, const Particles& p, FrameRecord& record) const;
    std::vector<std::int64_t> impacting(const Particles& p, const Wall& wall) const;
    void record_impact(const Step& step, const Particles& p, const Wall& wall, FrameRecord& record) const;
    void handle_collisions(SimulationState& state, const Wall& wall, FrameRecord& record) const;

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
