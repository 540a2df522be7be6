// SPDX-License-Identifier: Apache-2.0
// How a fresh lattice finds its place between the walls, as in reference::Flow::settle.
#pragma once

#include "common/guards.hpp"
#include "cuda/arrays.hpp"
#include "cuda/passes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace aneurysm::device
{

/// Particles are displaced by what the pressure would do to them at rest.
template <class Real>
struct Displaced {
    Fields<Real> f;
    bool moves; ///< else only the densities are kept

    ANEURYSM_HD void operator()(Index s) const
    {
        const Index id = f.order[s];
        const bool free = s < f.free_count();
        f.event[id] = 0;
        f.density[id] = free ? f.body_velocity[s].w : f.c.rho_0;
        if (free && moves) {
            const Vec3T<Real> way = f.c.dt * f.c.dt * f.acceleration[s].vector();
            f.position[id] = row(f.c.vessel.wrapped(f.position[id].vector() + way), Real(0));
        }
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
        const auto& settling = scenario_->settling;
        const std::int64_t rounds = scenario_->pressure.density_correction > 0 ? settling.rounds : 0;
        // At rest a step finds nothing to correct once the mean excess is this.
        const double dt = scenario_->time.frame_s / static_cast<double>(scenario_->time.substeps);
        const double allowed =
            guards::settling_slack * scenario_->pressure.tolerance_per_s * dt / settling.density_correction;
        executor_->once(BeginFrame{arrays_->scene(), arrays_->input()});
        executor_->for_each(fields().c.walls, PlaceWalls<Real>{fields()});
        for (std::int64_t round = 0; round < rounds; ++round) {
            push_apart();
            find_densities();
            executor_->for_each(n_, Displaced<Real>{fields(), false});
            if (!take_surplus(state, allowed)) {
                break;
            }
        }
        arrays_->download(state);
        state.ledger = {};
        std::ranges::fill(state.particles.pressure, scenario_->outlet.pressure_pa);
        arrays_->upload(state);
    }

private:
    const Fields<Real>& fields() const { return arrays_->fields(); }

    void push_apart()
    {
        const auto& settling = scenario_->settling;
        const std::int64_t iterations = std::min(scenario_->pressure.max_iterations, settling.max_iterations);
        for (std::int64_t k = 0; k < settling.steps; ++k) {
            find_densities();
            passes_->solve_incompressibility(fields(), settling.density_correction, iterations, true);
            executor_->for_each(n_, Displaced<Real>{fields(), true});
            executor_->for_each(n_, ContainBlood<Real>{fields()});
            passes_->exchange(fields());
            executor_->for_each(n_, Rest<Real>{fields()});
        }
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
        executor_->for_each_group(free_of(fields()), Densities<Real>{fields()});
    }

    /// While the blood stays denser than allowed, the densest of it goes to the reserve.
    bool take_surplus(SimulationState& state, double allowed)
    {
        arrays_->download(state);
        const std::vector<double> rho = arrays_->density();
        auto& kind = state.particles.kind;
        std::vector<std::size_t> blood;
        double excess = 0;
        for (std::size_t i = 0; i < kind.size(); ++i) {
            if (kind[i] == Kind::fluid) {
                blood.push_back(i);
                excess += std::max(rho[i] / scenario_->fluid.density_kg_m3 - 1, 0.0);
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
        arrays_->upload(state);
        return true;
    }

    Executor* executor_;
    const Scenario* scenario_;
    Arrays<Executor, Real>* arrays_;
    Passes<Executor, Real>* passes_;
    Index n_;
};

} // namespace aneurysm::device
