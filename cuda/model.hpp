// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/error.hpp"
#include "common/vessel/body_force.hpp"
#include "cuda/arrays.hpp"
#include "cuda/deform.hpp"
#include "cuda/passes.hpp"
#include "cuda/pressure_level.hpp"
#include "cuda/settling.hpp"
#include "cuda/setup.hpp"
#include "cuda/simulation.hpp"

#include <string>
#include <type_traits>

namespace aneurysm::device
{

/// The model on one executor in one precision.
template <class Executor, class Real>
class Model final : public Simulation
{
public:
    Model(Executor executor, const Scenario& scenario, const Tuning& tuning,
          const std::optional<SimulationState>& state)
        : executor_(std::move(executor)), scenario_(scenario), setup_(scenario, state),
          n_(static_cast<Index>(scenario.particles.count)), arrays_(executor_, scenario, setup_, tuning),
          passes_(executor_, scenario_),
          state_(state ? *state : initial_state(scenario, setup_.lattice, setup_.particle_mass))
    {
        executor_.reserve_sort(n_, arrays_.fields().c.grid.cells() + 1);
        arrays_.upload(state_);
        if (!state) {
            upload_input();
            Settling<Executor, Real>(executor_, scenario_, arrays_, passes_).run(state_);
        }
        stale_ = true; // what was uploaded may have been rounded
    }

    Engine engine() const override
    {
        return {Executor::backend, std::is_same_v<Real, float> ? Precision::float_ : Precision::double_,
                executor_.device()};
    }
    std::size_t bytes() const override { return executor_.bytes(); }
    std::vector<std::pair<std::string, double>> take_profile() override { return executor_.take_profile(); }
    std::pair<std::int64_t, std::int64_t> pairs() const override
    {
        return {lane_count * std::int64_t{scene_.blood_blocks},
                lane_count * std::int64_t{scene_.wall_blocks}};
    }

    FrameRecord advance() override
    {
        upload_input();
        run_frame();
        while (scene_.fault == Fault::lists_full) {
            arrays_.restore();
            arrays_.grow_lists(scene_);
            executor_.forget_recording();
            run_frame();
        }
        stale_ = true;
        if (scene_.fault != Fault::none) {
            fail();
        }
        state_.frame = scene_.record.frame;
        return scene_.record;
    }

    const SimulationState& state() const override
    {
        if (stale_) {
            arrays_.download(state_);
            stale_ = false;
        }
        return state_;
    }
    const std::vector<double>& density() const override { return density_ = arrays_.density(); }
    const std::vector<double>& solved_pressure() const override
    {
        return solved_pressure_ = arrays_.solved_pressure();
    }
    const std::vector<double>& solved_kappa() const override
    {
        return solved_kappa_ = arrays_.solved_kappa();
    }

private:
    using F = Fields<Real>;

    F fields(Index step) const
    {
        F f = arrays_.fields();
        f.step = step;
        return f;
    }
    void upload_input()
    {
        const auto next = state_.frame + 1;
        const double dt = scenario_.time.frame_s;
        std::vector<StepInput> steps;
        for (std::int64_t s = 1; s <= scenario_.time.substeps; ++s) {
            const double part = static_cast<double>(s) / static_cast<double>(scenario_.time.substeps);
            const double t = (static_cast<double>(state_.frame) + part) * dt;
            steps.push_back({inlet_velocity(scenario_, t), pressure_level(scenario_, setup_.vessel, t),
                             body_force_factor(scenario_, t) * scenario_.fluid.gravity_m_s2});
        }
        arrays_.upload_input({next, static_cast<double>(next) * dt}, steps);
    }

    void run_frame()
    {
        executor_.run_recorded([this] { frame(); });
        scene_ = arrays_.fetched_scene();
    }

    void frame()
    {
        arrays_.save();
        executor_.once(BeginFrame{arrays_.scene(), arrays_.input()});
        executor_.for_each(fields(0).c.walls, PlaceWalls<Real>{fields(0)});
        for (Index step = 0; step < static_cast<Index>(scenario_.time.substeps); ++step) {
            passes_.flow_step(fields(step));
        }
        const KindCounts* kinds = passes_.recycle_and_count(fields(0));
        executor_.once(Deform(scenario_, arrays_.scene(), kinds, setup_.vessel.largest_radius(),
                              setup_.lattice.spacing, setup_.particle_mass));
        executor_.mark("deform");
    }

    /// Reports the fault, and goes back to the state before it.
    [[noreturn]] void fail()
    {
        const Scene at = scene_;
        std::vector<double> rho = arrays_.density();
        arrays_.restore();
        const auto i = static_cast<std::size_t>(at.fault_particle);
        const std::string frame = "frame " + std::to_string(state_.frame + 1);
        const std::string place = frame + ", particle " + std::to_string(at.fault_particle);
        const std::string advice = "more time.substeps, or a stiffer pressure model";
        switch (at.fault) {
        case Fault::density:
            throw SimulationError(place, "density " + std::to_string(rho[i]) + " kg/m^3: the run blew up",
                                  advice);
        case Fault::moved_too_far:
            throw SimulationError(place,
                                  "it moves by " + std::to_string(at.fault_value) +
                                      " m in one step, more than it can see: the run blew up",
                                  advice);
        default:
            throw SimulationError(frame,
                                  "the elastic wall is displaced by " +
                                      std::to_string(at.aneurysm.displacement) +
                                      " m, more than a particle spacing",
                                  "a larger elastic_wall.stiffness_n_m");
        }
    }

    Executor executor_;
    Scenario scenario_;
    Setup setup_;
    Index n_;
    Arrays<Executor, Real> arrays_;
    Passes<Executor, Real> passes_;
    Scene scene_{};
    // Downloaded when asked for.
    mutable SimulationState state_;
    mutable bool stale_ = false;
    mutable std::vector<double> density_;
    mutable std::vector<double> solved_pressure_;
    mutable std::vector<double> solved_kappa_;
};

} // namespace aneurysm::device
