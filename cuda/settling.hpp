// SPDX-License-Identifier: Apache-2.0
// How a fresh lattice finds its place between the walls, as in reference::Flow::settle.
#pragma once

#include "common/guards.hpp"
#include "cuda/arrays.hpp"
#include "cuda/passes.hpp"

#include <algorithm>

namespace aneurysm::device
{

/// The density of a particle at rest is its error to correct.
template <class Real>
struct TakeDensity {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index s) const { f.source[s] = f.body_velocity[s].w; }
};

/// Particles go the way that the correction gives them, by `farthest` at most.
template <class Real>
struct Displace {
    Fields<Real> f;
    Real farthest; ///< [m]

    ANEURYSM_HD void operator()(Index s) const
    {
        const Index id = f.order[s];
        const Vec3T<Real> way = f.c.dt * f.correction[s].vector();
        const Real l = length(way);
        const Real part = l > farthest ? farthest / l : 1;
        f.position[id] = row(f.c.vessel.wrapped(f.position[id].vector() + part * way), Real(0));
        f.event[id] = 0;
    }
};
template <class Real>
struct Rest {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const { f.velocity[id] = {0, 0, 0, 0}; }
};

template <class Executor, class Real>
class Settling
{
public:
    Settling(Executor& executor, const Scenario& scenario, Arrays<Executor, Real>& arrays,
             Passes<Executor, Real>& passes)
        : executor_(&executor), scenario_(&scenario), arrays_(&arrays), passes_(&passes),
          n_(static_cast<Index>(scenario.particles.count))
    {
    }

    /// From the lattice in device memory to the settled state, there and in `state`.
    void run(SimulationState& state)
    {
        if (!fields().c.corrects_density) {
            return;
        }
        executor_->once(BeginFrame{arrays_->scene(), arrays_->input()});
        executor_->for_each(fields().c.walls, PlaceWalls<Real>{fields()});
        for (std::int64_t round = 0; round < scenario_->settling.pushing_rounds; ++round) {
            settle_once(false);
        }
        for (std::int64_t round = 0; round < scenario_->settling.rounds; ++round) {
            settle_once(true);
            if (arrays_->fetched_scene().solve_iterations == 0) {
                break;
            }
        }
        arrays_->download(state);
        state.ledger = {};
        arrays_->upload(state);
    }

private:
    const Fields<Real>& fields() const { return arrays_->fields(); }

    void settle_once(bool pulls)
    {
        const auto& pressure = scenario_->pressure;
        const auto& settling = scenario_->settling;
        const std::int64_t iterations = std::min(pressure.correction_max_iterations, settling.max_iterations);
        const SolveLimits limits{static_cast<Index>(iterations), pressure.correction_tolerance_per_s,
                                 pressure.correction_max_tolerance_per_s};
        find_densities();
        executor_->for_each(blood_of(fields()), TakeDensity<Real>{fields()});
        passes_->solve_correction(fields(), settling.density_correction, pulls, limits, true);
        const auto farthest = static_cast<Real>(guards::settling_move) * fields().c.dx;
        executor_->for_each(blood_of(fields()), Displace<Real>{fields(), farthest});
        passes_->contain(fields());
        executor_->for_each(n_, Rest<Real>{fields()});
    }

    /// Of all particles, with lists that have room for their neighbors.
    void find_densities()
    {
        passes_->find_neighbors(fields());
        for (Scene scene = arrays_->fetched_scene(); scene.fault == Fault::lists_full;
             scene = arrays_->fetched_scene()) {
            arrays_->grow_lists(scene);
            executor_->once(BeginFrame{arrays_->scene(), arrays_->input()});
            passes_->find_neighbors(fields());
        }
        passes_->find_densities(fields());
    }

    Executor* executor_;
    const Scenario* scenario_;
    Arrays<Executor, Real>* arrays_;
    Passes<Executor, Real>* passes_;
    Index n_;
};

} // namespace aneurysm::device
