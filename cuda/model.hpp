// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/error.hpp"
#include "cuda/arrays.hpp"
#include "cuda/deform.hpp"
#include "cuda/flow.hpp"
#include "cuda/setup.hpp"
#include "cuda/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace aneurysm::device
{

/// What the sums of a frame need beside the fields.
template <class Executor>
struct Sums {
    explicit Sums(Executor& executor, Index n)
        : scratch(executor, static_cast<Index>(sizeof(FlowSums)) * (2 * chunks(n) + 8)), probe(executor, 1),
          solve(executor, 1), largest_inverse(executor, 1), flow(executor, 1), impact(executor, 1),
          events(executor, 1), kinds(executor, 1)
    {
    }
    template <class Value>
    Value* space()
    {
        static_assert(sizeof(Value) <= sizeof(FlowSums));
        return reinterpret_cast<Value*>(scratch.get()); // NOLINT: untyped memory
    }

    Buffer<char, Executor> scratch;
    Buffer<OutletProbe, Executor> probe;
    Buffer<SolveSums, Executor> solve;
    Buffer<LargestInverse, Executor> largest_inverse;
    Buffer<FlowSums, Executor> flow;
    Buffer<Impact, Executor> impact;
    Buffer<EventCounts, Executor> events;
    Buffer<KindCounts, Executor> kinds;
};

struct BeginFrame {
    Scene* scene;
    const FrameInput* input;

    ANEURYSM_HD void operator()() const
    {
        scene->record = FrameRecord{};
        scene->record.frame = input->frame;
        scene->record.time = input->time;
        scene->fault = Fault::none;
    }
};

/// The lists' lengths are known now; without room for them the step goes on without particles, and the frame
/// is run again.
template <class Real>
struct CheckLists {
    Fields<Real> f;

    ANEURYSM_HD void operator()() const
    {
        const Index free = f.free_count();
        Scene& s = *f.scene;
        s.free_blocks = f.free.begin[free];
        s.ghost_blocks = f.ghosts.begin[free];
        if (s.free_blocks > f.free.capacity || s.ghost_blocks > f.ghosts.capacity) {
            s.fault = Fault::lists_full;
            f.start[f.c.grid.cells()] = 0;
            f.start[2 * f.c.grid.cells()] = 0;
        }
    }
};

/// Model `eos` solves nothing: only the divergence is recorded.
struct RecordDivergence {
    Scene* scene;
    const SolveSums* sums;
    double rho_0;

    ANEURYSM_HD void operator()() const
    {
        scene->record.divergence_mean = sums->divergence / (rho_0 * (sums->count > 0 ? sums->count : 1));
        scene->record.divergence_max = sums->divergence_max / rho_0;
    }
};

/// The model on one executor in one precision: which passes run, in which order. What each does is said in
/// the header of its section.
template <class Executor, class Real>
class Model final : public Simulation
{
public:
    Model(Executor executor, const Scenario& scenario, const Tuning& tuning,
          const std::optional<SimulationState>& state)
        : executor_(std::move(executor)), scenario_(scenario), setup_(scenario, state),
          n_(static_cast<Index>(scenario.particles.count)),
          arrays_(executor_, scenario, setup_, tuning.gradients), sums_(executor_, n_),
          state_(state ? *state : initial_state(scenario, setup_.lattice, setup_.particle_mass))
    {
        executor_.reserve_sort(n_, 2 * arrays_.fields().c.grid.cells() + 1);
        arrays_.upload(state_);
        if (!state) {
            settle();
        }
        stale_ = true; // what was uploaded may have been rounded
    }

    std::string device() const override { return executor_.device(); }
    std::size_t bytes() const override { return executor_.bytes(); }
    std::vector<std::pair<std::string, double>> take_profile() override { return executor_.take_profile(); }
    std::pair<std::int64_t, std::int64_t> pairs() override
    {
        return {lane_count * std::int64_t{scene_.free_blocks},
                lane_count * std::int64_t{scene_.ghost_blocks}};
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

    const SimulationState& state() override
    {
        if (stale_) {
            arrays_.download(state_);
            stale_ = false;
        }
        return state_;
    }
    const std::vector<double>& density() override { return density_ = arrays_.density(); }
    const std::vector<double>& solved_pressure() override
    {
        return solved_pressure_ = arrays_.solved_pressure();
    }

private:
    using F = Fields<Real>;

    F fields(Index step) const
    {
        F f = arrays_.fields();
        f.step = step;
        return f;
    }
    static Extent free_of(const F& f) { return {f.c.particles, f.start + f.c.grid.cells()}; }
    static Extent active_of(const F& f) { return {f.c.particles, f.start + 2 * f.c.grid.cells()}; }

    template <class Value, class Map>
    void reduce(Extent extent, const Map& map, Buffer<Value, Executor>& out)
    {
        executor_.reduce(extent, map, sums_.template space<Value>(), out.get());
    }

    void upload_input()
    {
        const auto next = state_.frame + 1;
        const double dt = scenario_.time.frame_s;
        const double step = dt / static_cast<double>(scenario_.time.substeps);
        std::vector<double> inlet;
        for (std::int64_t s = 1; s <= scenario_.time.substeps; ++s) {
            const double part = static_cast<double>(s) / static_cast<double>(scenario_.time.substeps);
            const double t = (static_cast<double>(state_.frame) + part) * dt;
            inlet.push_back(inlet_velocity(scenario_, t - step));
            inlet.push_back(inlet_velocity(scenario_, t));
        }
        arrays_.upload_input({next, static_cast<double>(next) * dt}, inlet);
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
            flow_step(fields(step));
        }
        executor_.for_each(n_, RecycleEscaped<Real>{fields(0)});
        reduce(n_, CountKinds<Real>{fields(0)}, sums_.kinds);
        executor_.once(Deform(scenario_, arrays_.scene(), sums_.kinds.get(), setup_.vessel.largest_radius(),
                              setup_.lattice.spacing));
        executor_.mark("deform");
    }

    void flow_step(const F& f)
    {
        drive_openings(f);
        find_neighbors(f);
        apply_forces(f);
        solve_pressure(f);
        executor_.for_each(n_, Move<Real>{f});
        record(f);
        executor_.for_each(n_, Contain<Real>{f});
        executor_.mark("walls");
        exchange(f);
        reduce(n_, CountEvents<Real>{f}, sums_.events);
        executor_.once(KeepLedger{arrays_.scene(), sums_.events.get()});
        executor_.mark("exchange");
    }

    void drive_openings(const F& f)
    {
        reduce(n_, ProbeOutlets<Real>{f}, sums_.probe);
        executor_.once(DriveOpenings<Real>{f, sums_.probe.get()});
        executor_.repeat_while(&f.scene->resetting, [&] {
            executor_.for_each(n_, EmptySlab<Real>{f});
            executor_.scan(n_, f.flag, f.rank);
            executor_.for_each(n_, FillSlab<Real>{f});
            executor_.once(FinishReset<Real>{f});
        });
        executor_.for_each(n_, DriveSlabs<Real>{f});
        executor_.mark("openings");
    }

    void find_neighbors(const F& f)
    {
        executor_.for_each(n_, Keys<Real>{f});
        executor_.sort(n_, f.key, f.sorted_key, f.order, 2 * f.c.grid.cells() + 1);
        executor_.find_starts(n_, f.sorted_key, f.start, 2 * f.c.grid.cells() + 1);
        executor_.for_each(n_, SortBodies<Real>{f});
        executor_.mark("sort");
        executor_.for_each_group(free_of(f), Search<Real, false>{f});
        executor_.scan(free_of(f), f.free.blocks, f.free.begin);
        executor_.scan(free_of(f), f.ghosts.blocks, f.ghosts.begin);
        executor_.once(CheckLists<Real>{f});
        executor_.for_each_group(free_of(f), Search<Real, true>{f});
        executor_.mark("neighbours");
    }

    void apply_forces(const F& f)
    {
        executor_.for_each_group(free_of(f), Densities<Real>{f});
        executor_.mark("density");
        executor_.for_each_group(free_of(f), Forces<Real>{f});
        executor_.for_each(free_of(f), TakeVelocity<Real>{f});
        executor_.mark("forces");
    }

    void solve_pressure(const F& f)
    {
        if (scenario_.pressure.model == PressureModel::eos) {
            executor_.once(BeginSolve{arrays_.scene(), 0, 0});
            executor_.for_each_group(free_of(f), AccelerateByState<Real>{f});
            executor_.for_each(free_of(f), PrepareSolve<Real>{f});
            executor_.for_each_group(free_of(f), Rates<Real, false>{f});
            reduce(free_of(f), Residuals<Real>{f}, sums_.solve);
            executor_.once(
                RecordDivergence{arrays_.scene(), sums_.solve.get(), scenario_.fluid.density_kg_m3});
        } else {
            solve_incompressibility(f, scenario_.pressure.density_correction,
                                    scenario_.pressure.max_iterations, false);
        }
        executor_.mark("pressure");
    }

    /// Eq. (3), see reference/incompressible.hpp.
    void solve_incompressibility(const F& f, double density_correction, std::int64_t max_iterations,
                                 bool from_zero)
    {
        Scene* scene = arrays_.scene();
        executor_.once(BeginSolve{scene, density_correction, static_cast<Index>(max_iterations)});
        executor_.for_each(free_of(f), SortPressure<Real>{f});
        reduce(free_of(f), InverseFactor<Real>{f}, sums_.largest_inverse);
        executor_.for_each_group(free_of(f), StartSolve<Real>{f, sums_.largest_inverse.get(), from_zero});
        executor_.for_each(free_of(f), PrepareSolve<Real>{f});
        evaluate(f);
        executor_.repeat_while(&scene->solving, [&] {
            executor_.for_each(free_of(f), Iterate<Real>{f});
            evaluate(f);
        });
    }
    void evaluate(const F& f)
    {
        if (f.gradient != nullptr) {
            executor_.for_each_group(free_of(f), Accelerate<Real, true>{f});
            executor_.for_each_group(free_of(f), Rates<Real, true>{f});
        } else {
            executor_.for_each_group(free_of(f), Accelerate<Real, false>{f});
            executor_.for_each_group(free_of(f), Rates<Real, false>{f});
        }
        reduce(free_of(f), Residuals<Real>{f}, sums_.solve);
        executor_.once(Decide{arrays_.scene(), sums_.solve.get(), scenario_.fluid.density_kg_m3,
                              scenario_.pressure.tolerance_per_s, scenario_.pressure.max_tolerance_per_s});
    }

    void record(const F& f)
    {
        reduce(active_of(f), SumUpFlow<Real>{f}, sums_.flow);
        executor_.once(
            RecordFlow{arrays_.scene(), sums_.flow.get(), scenario_.pressure.blow_up_density_ratio});
        executor_.for_each_group(free_of(f), Impacts<Real>{f});
        reduce(free_of(f), HardestImpact<Real>{f}, sums_.impact);
        executor_.once(RecordImpact{arrays_.scene(), sums_.impact.get()});
        executor_.mark("record");
    }

    void exchange(const F& f)
    {
        executor_.for_each(n_, MarkExchange<Real>{f});
        executor_.scan(n_, f.flag, f.rank);
        executor_.scan(n_, f.entering, f.entry_rank);
        executor_.for_each(n_, ListReserve<Real>{f});
        executor_.for_each(n_, EnterArtery<Real>{f});
        executor_.for_each(n_, CrossOpenings<Real>{f});
    }

    /// Lets the fresh lattice find its place between the walls, as reference::Flow::settle does.
    void settle()
    {
        constexpr int rounds = 10;
        constexpr double correction = 0.25;
        // At rest a step finds nothing to correct once the mean excess is this; the factor is for rounding.
        const double dt = scenario_.time.frame_s / static_cast<double>(scenario_.time.substeps);
        const double allowed = 1.001 * scenario_.pressure.tolerance_per_s * dt / correction;
        upload_input();
        executor_.once(BeginFrame{arrays_.scene(), arrays_.input()});
        executor_.for_each(fields(0).c.walls, PlaceWalls<Real>{fields(0)});
        for (int round = 0; round < rounds; ++round) {
            push_apart(correction);
            with_lists([&] { executor_.for_each_group(free_of(fields(0)), Densities<Real>{fields(0)}); });
            executor_.for_each(n_, Displaced<Real>{fields(0), false});
            if (!take_surplus(allowed)) {
                break;
            }
        }
        arrays_.download(state_);
        state_.ledger = {};
        std::ranges::fill(state_.particles.pressure, scenario_.outlet.pressure_pa);
        arrays_.upload(state_);
    }

    void push_apart(double correction)
    {
        constexpr int steps = 40;
        // Particles too many for the space have no solution: their pressures would only rise.
        const std::int64_t iterations = std::min<std::int64_t>(scenario_.pressure.max_iterations, 25);
        for (int k = 0; k < steps; ++k) {
            with_lists([&] {
                const F f = fields(0);
                executor_.for_each_group(free_of(f), Densities<Real>{f});
                solve_incompressibility(f, correction, iterations, true);
            });
            const F f = fields(0);
            executor_.for_each(n_, Displaced<Real>{f, true});
            executor_.for_each(n_, Contain<Real>{f});
            exchange(f);
            executor_.for_each(n_, Rest<Real>{f});
        }
    }

    /// Finds the neighbours, with room for their lists, for what `use` does with them.
    template <class Use>
    void with_lists(const Use& use)
    {
        find_neighbors(fields(0));
        for (scene_ = arrays_.fetched_scene(); scene_.fault == Fault::lists_full;
             scene_ = arrays_.fetched_scene()) {
            arrays_.grow_lists(scene_);
            executor_.once(BeginFrame{arrays_.scene(), arrays_.input()});
            find_neighbors(fields(0));
        }
        use();
    }

    /// While the blood stays denser than allowed, the densest of it goes to the reserve.
    bool take_surplus(double allowed)
    {
        arrays_.download(state_);
        const std::vector<double> rho = arrays_.density();
        auto& kind = state_.particles.kind;
        std::vector<std::size_t> blood;
        double excess = 0;
        for (std::size_t i = 0; i < kind.size(); ++i) {
            if (kind[i] == Kind::fluid) {
                blood.push_back(i);
                excess += std::max(rho[i] / scenario_.fluid.density_kg_m3 - 1, 0.0);
            }
        }
        if (excess <= allowed * static_cast<double>(blood.size())) {
            return false;
        }
        const auto surplus = std::min(blood.size(), static_cast<std::size_t>(std::ceil(excess)));
        std::ranges::stable_sort(blood, std::greater<>(), [&rho](std::size_t i) { return rho[i]; });
        for (std::size_t k = 0; k < surplus; ++k) {
            kind[blood[k]] = Kind::reserve;
        }
        arrays_.upload(state_);
        return true;
    }

    /// Reports the fault, and goes back to the state before it.
    [[noreturn]] void fail()
    {
        const Scene at = scene_;
        std::vector<double> rho = arrays_.density();
        SimulationState broken;
        arrays_.download(broken);
        arrays_.restore();
        const auto i = static_cast<std::size_t>(at.fault_particle);
        const std::string frame = "frame " + std::to_string(state_.frame + 1);
        const std::string place = frame + ", particle " + std::to_string(at.fault_particle);
        const std::string advice = "more time.substeps, or a stiffer pressure model";
        const double dt = scenario_.time.frame_s / static_cast<double>(scenario_.time.substeps);
        switch (at.fault) {
        case Fault::density:
            throw SimulationError(place, "density " + std::to_string(rho[i]) + " kg/m^3: the run blew up",
                                  advice);
        case Fault::moved_too_far:
            throw SimulationError(place,
                                  "it moves by " + std::to_string(dt * length(broken.particles.velocity[i])) +
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
    Sums<Executor> sums_;
    SimulationState state_;
    Scene scene_{};
    bool stale_ = false;
    std::vector<double> density_;
    std::vector<double> solved_pressure_;
};

} // namespace aneurysm::device
