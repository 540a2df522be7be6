// SPDX-License-Identifier: Apache-2.0
// One flow step: which passes run, in which order. What each does is said in the header of its section.
#pragma once

#include "cuda/containment.hpp"
#include "cuda/executor/executor.hpp"
#include "cuda/flow.hpp"
#include "cuda/impact.hpp"
#include "cuda/shifting.hpp"
#include "cuda/slices.hpp"

namespace aneurysm::device
{

/// What the sums of a frame need beside the fields.
template <class Executor>
struct Sums {
    explicit Sums(Executor& executor, Index n)
        : scratch(executor, static_cast<Index>(sizeof(FlowSums)) * (2 * chunks(n) + 8)), buffers(executor, 1),
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
    Buffer<BufferSums, Executor> buffers;
    Buffer<SolveSums, Executor> solve;
    Buffer<LargestInverse, Executor> largest_inverse;
    Buffer<FlowSums, Executor> flow;
    Buffer<Impact, Executor> impact;
    Buffer<EventCounts, Executor> events;
    Buffer<KindCounts, Executor> kinds;
};

/// The particles that are not in the reserve.
template <class Real>
Extent blood_of(const Fields<Real>& f)
{
    return {f.c.particles, f.start + f.c.grid.cells()};
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
        find_densities(f);
        apply_forces(f);
        solve_pressure(f);
        if (f.c.corrects_density) {
            correct_density(f);
        }
        executor_->for_each(n_, MoveParticles<Real>{f});
        record(f);
        contain(f);
        exchange(f);
    }

    /// Without room for the lists the scene's fault says so, and no particle takes part in what follows.
    void find_neighbors(const F& f)
    {
        executor_->for_each(n_, Keys<Real>{f});
        executor_->sort(n_, f.key, f.sorted_key, f.order, f.c.grid.cells() + 1);
        executor_->find_starts(n_, f.sorted_key, f.start, f.c.grid.cells() + 1);
        executor_->for_each(n_, SortBodies<Real>{f});
        executor_->mark("sort");
        f.c.is_periodic ? make_lists<true>(f) : make_lists<false>(f);
        executor_->mark("neighbors");
    }

    void find_densities(const F& f)
    {
        executor_->for_each_group(blood_of(f), Densities<Real>{f});
        executor_->mark("density");
    }

    /// The correction of the density that f.source holds; `beta`: the part of its error that goes.
    void solve_correction(const F& f, double beta, bool pulls, const SolveLimits& limits, bool from_zero)
    {
        executor_->for_each(blood_of(f), PoseCorrection<Real>{f, static_cast<Real>(beta), pulls});
        solve_incompressibility<Unknown::correction>(f, limits, from_zero);
    }

    void contain(const F& f)
    {
        executor_->for_each(n_, ContainBlood<Real>{f});
        executor_->mark("walls");
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
        executor_->for_each_group(blood_of(f), FindNeighbors<Real, false, periodic>{f});
        executor_->scan(blood_of(f), f.blood.blocks, f.blood.begin);
        executor_->scan(blood_of(f), f.walls.blocks, f.walls.begin);
        executor_->once(CheckLists<Real>{f});
        executor_->for_each_group(blood_of(f), FindNeighbors<Real, true, periodic>{f});
    }

    void drive_openings(const F& f)
    {
        executor_->for_each(n_, DriveInlet<Real>{f});
        reduce(n_, SumUpBuffers<Real>{f}, sums_.buffers);
        executor_->once(DriveOpenings<Real>{f, sums_.buffers.get()});
        executor_->mark("openings");
    }

    void apply_forces(const F& f)
    {
        if (!f.c.slips) {
            executor_->for_each_group(f.c.walls, ExtrapolateVelocity<Real>{f});
        }
        executor_->for_each_group(blood_of(f), Forces<Real>{f});
        executor_->for_each(blood_of(f), TakeVelocity<Real>{f});
        executor_->mark("forces");
    }

    void solve_pressure(const F& f)
    {
        const auto& pressure = scenario_->pressure;
        executor_->for_each(blood_of(f), PosePressure<Real>{f});
        if (pressure.model == PressureModel::eos) {
            executor_->for_each_group(blood_of(f), AccelerateByState<Real>{f});
            executor_->for_each_group(blood_of(f), Rates<Unknown::pressure, false, Real>{f});
            executor_->for_each(blood_of(f), NoResponse<Real>{f});
            reduce(blood_of(f), Residuals<Real>{f}, sums_.solve);
            executor_->once(RecordDivergence{f.scene, sums_.solve.get(), scenario_->fluid.density_kg_m3});
        } else {
            const SolveLimits limits{static_cast<Index>(pressure.max_iterations), pressure.tolerance_per_s,
                                     pressure.max_tolerance_per_s};
            solve_incompressibility<Unknown::pressure>(f, limits, false);
        }
        executor_->for_each(blood_of(f), KeepPressure<Real>{f});
        executor_->mark("pressure");
    }

    void correct_density(const F& f)
    {
        const auto& pressure = scenario_->pressure;
        const SolveLimits limits{static_cast<Index>(pressure.correction_max_iterations),
                                 pressure.correction_tolerance_per_s,
                                 pressure.correction_max_tolerance_per_s};
        executor_->for_each(blood_of(f), ShiftBlood<Real>{f});
        executor_->for_each_group(blood_of(f), PredictDensities<Real>{f});
        solve_correction(f, pressure.density_correction, true, limits, false);
        executor_->mark("correction");
    }

    /// Eq. (3), see reference/incompressible.hpp.
    template <Unknown unknown>
    void solve_incompressibility(const F& f, const SolveLimits& limits, bool from_zero)
    {
        executor_->once(BeginSolve{f.scene});
        executor_->for_each(blood_of(f), SortPotential<unknown, Real>{f, from_zero});
        reduce(blood_of(f), InverseFactor<Real>{f}, sums_.largest_inverse);
        executor_->for_each_group(blood_of(f), StartSolve<Real>{f, sums_.largest_inverse.get()});
        executor_->for_each(blood_of(f), TakeStart<Real>{f});
        evaluate<unknown>(f, limits);
        if (unknown == Unknown::pressure && f.c.slices.count > 0) {
            executor_->once(StartInSlices{f.scene});
            executor_->repeat_while(&f.scene->slicing, [&] {
                add_slices(f);
                executor_->once(BeginSolve{f.scene});
                evaluate<unknown>(f, limits);
            });
        }
        executor_->repeat_while(&f.scene->solving, [&] {
            executor_->for_each(blood_of(f), IteratePressure<Real>{f});
            evaluate<unknown>(f, limits);
        });
    }
    void add_slices(const F& f)
    {
        executor_->for_each(blood_of(f), FindMembers<Real>{f});
        if (f.gradient != nullptr) {
            executor_->for_each_group(blood_of(f), RespondToSlices<true, Real>{f});
        } else {
            executor_->for_each_group(blood_of(f), RespondToSlices<false, Real>{f});
        }
        executor_->for_each_group(f.c.slices.count, SumUpSlices<Real>{f});
        executor_->once(SolveSlices<Real>{f});
        executor_->for_each(blood_of(f), AddSlices<Real>{f});
    }
    template <Unknown unknown>
    void evaluate(const F& f, const SolveLimits& limits)
    {
        if (f.gradient != nullptr) {
            executor_->for_each_group(blood_of(f), Accelerate<unknown, true, Real>{f});
            executor_->for_each_group(blood_of(f), Rates<unknown, true, Real>{f});
        } else {
            executor_->for_each_group(blood_of(f), Accelerate<unknown, false, Real>{f});
            executor_->for_each_group(blood_of(f), Rates<unknown, false, Real>{f});
        }
        reduce(blood_of(f), Residuals<Real>{f}, sums_.solve);
        executor_->once(
            CheckSolve<unknown>{f.scene, sums_.solve.get(), scenario_->fluid.density_kg_m3, limits});
    }

    void exchange(const F& f)
    {
        executor_->for_each(n_, CrossOpenings<Real>{f});
        reduce(n_, SumUpBuffers<Real>{f}, sums_.buffers);
        executor_->once(BeginFill<Real>{f, sums_.buffers.get()});
        executor_->for_each(f.places(), FindPlaces<Real>{f});
        executor_->scan(n_, f.in_reserve, f.reserve_rank);
        executor_->scan(f.places(), f.to_fill, f.fill_rank);
        executor_->for_each(n_, ListReserve<Real>{f});
        executor_->for_each(f.places(), FillPlaces<Real>{f});
        reduce(n_, CountEvents<Real>{f}, sums_.events);
        executor_->once(KeepLedger<Real>{f, sums_.events.get()});
        executor_->mark("exchange");
    }

    void record(const F& f)
    {
        reduce(blood_of(f), SumUpFlow<Real>{f}, sums_.flow);
        executor_->once(RecordFlow{f.scene, sums_.flow.get(), scenario_->pressure.blow_up_density_ratio});
        executor_->for_each_group(blood_of(f), Impacts<Real>{f});
        reduce(blood_of(f), HardestImpact<Real>{f}, sums_.impact);
        executor_->once(RecordImpact{f.scene, sums_.impact.get()});
        executor_->mark("record");
    }

    Executor* executor_;
    const Scenario* scenario_;
    Index n_;
    Sums<Executor> sums_;
};

} // namespace aneurysm::device
