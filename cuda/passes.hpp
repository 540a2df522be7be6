// SPDX-License-Identifier: Apache-2.0
// One flow step: which passes run, in which order. What each does is said in the header of its section.
#pragma once

#include "cuda/containment.hpp"
#include "cuda/executor/executor.hpp"
#include "cuda/flow.hpp"
#include "cuda/impact.hpp"

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

/// The particles that take part in the sums, and those that are not in the reserve.
template <class Real>
Extent free_of(const Fields<Real>& f)
{
    return {f.c.particles, f.start + f.c.grid.cells()};
}
template <class Real>
Extent active_of(const Fields<Real>& f)
{
    return {f.c.particles, f.start + 2 * f.c.grid.cells()};
}

template <class Executor, class Real>
class Passes
{
public:
    using F = Fields<Real>;

    Passes(Executor& executor, const Scenario& scenario)
        : executor_(&executor), scenario_(&scenario), n_(static_cast<Index>(scenario.particles.count)),
          sums_(executor, n_)
    {
    }

    void flow_step(const F& f)
    {
        drive_openings(f);
        find_neighbors(f);
        executor_->for_each_group(free_of(f), Densities<Real>{f});
        executor_->mark("density");
        apply_forces(f);
        solve_pressure(f);
        executor_->for_each(n_, MoveParticles<Real>{f});
        record(f);
        executor_->for_each(n_, ContainBlood<Real>{f});
        executor_->mark("walls");
        exchange(f);
        reduce(n_, CountEvents<Real>{f}, sums_.events);
        executor_->once(KeepLedger{f.scene, sums_.events.get()});
        executor_->mark("exchange");
    }

    /// Without room for the lists the scene's fault says so, and no particle takes part in what follows.
    void find_neighbors(const F& f)
    {
        executor_->for_each(n_, Keys<Real>{f});
        executor_->sort(n_, f.key, f.sorted_key, f.order, 2 * f.c.grid.cells() + 1);
        executor_->find_starts(n_, f.sorted_key, f.start, 2 * f.c.grid.cells() + 1);
        executor_->for_each(n_, SortBodies<Real>{f});
        executor_->mark("sort");
        f.c.is_periodic ? make_lists<true>(f) : make_lists<false>(f);
        executor_->mark("neighbors");
    }

    /// Eq. (3), see reference/incompressible.hpp.
    void solve_incompressibility(const F& f, double density_correction, std::int64_t max_iterations,
                                 bool from_zero)
    {
        executor_->once(BeginSolve{f.scene, density_correction, static_cast<Index>(max_iterations)});
        executor_->for_each(free_of(f), SortPressure<Real>{f});
        reduce(free_of(f), InverseFactor<Real>{f}, sums_.largest_inverse);
        executor_->for_each_group(free_of(f), StartSolve<Real>{f, sums_.largest_inverse.get(), from_zero});
        executor_->for_each(free_of(f), PrepareSolve<Real>{f});
        evaluate(f);
        executor_->repeat_while(&f.scene->solving, [&] {
            executor_->for_each(free_of(f), IteratePressure<Real>{f});
            evaluate(f);
        });
    }

    void exchange(const F& f)
    {
        executor_->for_each(n_, MarkExchange<Real>{f});
        executor_->scan(n_, f.flag, f.rank);
        executor_->scan(n_, f.entering, f.entry_rank);
        executor_->for_each(n_, ListReserve<Real>{f});
        executor_->for_each(n_, EnterArtery<Real>{f});
        executor_->for_each(n_, CrossOpenings<Real>{f});
    }

    /// Escaped blood may return to the reserve. \return where the numbers of particles will be
    const KindCounts* recycle_and_count(const F& f)
    {
        executor_->for_each(n_, RecycleEscaped<Real>{f});
        reduce(n_, CountKinds<Real>{f}, sums_.kinds);
        return sums_.kinds.get();
    }

private:
    template <class Value, class Map>
    void reduce(Extent extent, const Map& map, Buffer<Value, Executor>& out)
    {
        executor_->reduce(extent, map, sums_.template space<Value>(), out.get());
    }

    template <bool periodic>
    void make_lists(const F& f)
    {
        executor_->for_each_group(free_of(f), FindNeighbors<Real, false, periodic>{f});
        executor_->scan(free_of(f), f.free.blocks, f.free.begin);
        executor_->scan(free_of(f), f.ghosts.blocks, f.ghosts.begin);
        executor_->once(CheckLists<Real>{f});
        executor_->for_each_group(free_of(f), FindNeighbors<Real, true, periodic>{f});
    }

    void drive_openings(const F& f)
    {
        reduce(n_, ProbeOutlets<Real>{f}, sums_.probe);
        executor_->once(DriveOpenings<Real>{f, sums_.probe.get()});
        executor_->repeat_while(&f.scene->resetting, [&] {
            executor_->for_each(n_, EmptySlab<Real>{f});
            executor_->scan(n_, f.flag, f.rank);
            executor_->for_each(n_, FillSlab<Real>{f});
            executor_->once(FinishReset<Real>{f});
        });
        executor_->for_each(n_, DriveSlabs<Real>{f});
        executor_->mark("openings");
    }

    void apply_forces(const F& f)
    {
        executor_->for_each_group(free_of(f), Forces<Real>{f});
        executor_->for_each(free_of(f), TakeVelocity<Real>{f});
        executor_->mark("forces");
    }

    void solve_pressure(const F& f)
    {
        const auto& pressure = scenario_->pressure;
        if (pressure.model == PressureModel::eos) {
            executor_->once(BeginSolve{f.scene, 0, 0});
            executor_->for_each_group(free_of(f), AccelerateByState<Real>{f});
            executor_->for_each(free_of(f), PrepareSolve<Real>{f});
            executor_->for_each_group(free_of(f), Rates<Real, false>{f});
            reduce(free_of(f), Residuals<Real>{f}, sums_.solve);
            executor_->once(RecordDivergence{f.scene, sums_.solve.get(), scenario_->fluid.density_kg_m3});
        } else {
            solve_incompressibility(f, pressure.density_correction, pressure.max_iterations, false);
        }
        executor_->mark("pressure");
    }
    void evaluate(const F& f)
    {
        if (f.gradient != nullptr) {
            executor_->for_each_group(free_of(f), AccelerateByPressure<Real, true>{f});
            executor_->for_each_group(free_of(f), Rates<Real, true>{f});
        } else {
            executor_->for_each_group(free_of(f), AccelerateByPressure<Real, false>{f});
            executor_->for_each_group(free_of(f), Rates<Real, false>{f});
        }
        reduce(free_of(f), Residuals<Real>{f}, sums_.solve);
        executor_->once(CheckSolve{f.scene, sums_.solve.get(), scenario_->fluid.density_kg_m3,
                                   scenario_->pressure.tolerance_per_s,
                                   scenario_->pressure.max_tolerance_per_s});
    }

    void record(const F& f)
    {
        reduce(active_of(f), SumUpFlow<Real>{f}, sums_.flow);
        executor_->once(RecordFlow{f.scene, sums_.flow.get(), scenario_->pressure.blow_up_density_ratio});
        executor_->for_each_group(free_of(f), Impacts<Real>{f});
        reduce(free_of(f), HardestImpact<Real>{f}, sums_.impact);
        executor_->once(RecordImpact{f.scene, sums_.impact.get()});
        executor_->mark("record");
    }

    Executor* executor_;
    const Scenario* scenario_;
    Index n_;
    Sums<Executor> sums_;
};

} // namespace aneurysm::device
