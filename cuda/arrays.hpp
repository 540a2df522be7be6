// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cuda/cells.hpp"
#include "cuda/constants.hpp"
#include "cuda/executor/executor.hpp"
#include "cuda/fields.hpp"
#include "cuda/setup.hpp"
#include "cuda/simulation.hpp"

#include <algorithm>
#include <vector>

namespace aneurysm::device
{

/// What the host hands over for each frame.
struct FrameInput {
    std::int64_t frame = 0;
    double time = 0; ///< [s]
};

/// Starts its record and what it counts up.
struct BeginFrame {
    Scene* scene;
    const FrameInput* input;

    ANEURYSM_HD void operator()() const
    {
        scene->record = FrameRecord{};
        scene->record.frame = input->frame;
        scene->record.time = input->time;
        scene->fault = Fault::none;
        scene->blood_blocks = 0;
        scene->wall_blocks = 0;
    }
};

/// Device memory of a model, and the ways in and out.
template <class Executor, class Real>
class Arrays
{
public:
    Arrays(Executor& executor, const Scenario& scenario, const Setup& setup, const Tuning& tuning)
        : executor_(&executor), memory_(executor), fields_{make_constants<Real>(scenario, setup)},
          n_(fields_.c.particles), steps_(static_cast<Index>(scenario.time.substeps)),
          keeps_gradients_(tuning.gradients == Tuning::Gradients::kept ||
                           (tuning.gradients == Tuning::Gradients::automatic && executor.keeps_gradients(n_)))
    {
        make_frame();
        make_particles();
        make_bodies();
        make_sorted();
        make_solve();
        make_cells(setup);
        make_patterns(setup.lattice);
        const bool given = tuning.list_blocks > 0;
        make_lists(given ? tuning.list_blocks : 5 * n_ + 64, given ? tuning.list_blocks : 2 * n_ + 64);
        place_null_body();
    }

    const Fields<Real>& fields() const { return fields_; }
    Scene* scene() { return fields_.scene; }
    const FrameInput* input() const { return input_; }

    void upload(const SimulationState& state)
    {
        const Particles& p = state.particles;
        std::vector<Row<Real>> x;
        std::vector<Row<Real>> v;
        for (std::size_t i = 0; i < p.size(); ++i) {
            x.push_back(row(fields_.c.vessel.wrapped(narrow<Real>(p.position[i])), Real(0)));
            v.push_back(row(narrow<Real>(p.velocity[i]), Real(0)));
        }
        executor_->upload(fields_.position, x.data(), x.size());
        executor_->upload(fields_.velocity, v.data(), v.size());
        upload_narrowed(fields_.pressure, p.pressure);
        upload_narrowed(fields_.kappa, p.kappa);
        upload_narrowed(fields_.drift, p.drift);
        executor_->upload(fields_.kind, p.kind.data(), p.kind.size());
        const std::vector<Real> rho(p.size(), fields_.c.rho_0);
        executor_->upload(fields_.density, rho.data(), rho.size());
        Scene scene{};
        scene.aneurysm = state.aneurysm;
        scene.ledger = state.ledger;
        scene.outlet_velocity[0] = state.outlet_velocity[0];
        scene.outlet_velocity[1] = state.outlet_velocity[1];
        executor_->upload(fields_.scene, &scene, 1);
    }

    void upload_input(const FrameInput& input, const std::vector<StepInput>& steps)
    {
        executor_->upload(input_, &input, 1);
        executor_->upload(step_inputs_, steps.data(), steps.size());
    }

    /// All that a checkpoint holds but frame, spacing and mass.
    void download(SimulationState& state) const
    {
        Particles& p = state.particles;
        const auto x = fetched(fields_.position, n_);
        const auto v = fetched(fields_.velocity, n_);
        const auto place = [](const Row<Real>& r) { return wide(r.vector()); };
        p.position.resize(x.size());
        p.velocity.resize(x.size());
        std::ranges::transform(x, p.position.begin(), place);
        std::ranges::transform(v, p.velocity.begin(), place);
        p.pressure = widened(fetched(fields_.pressure, n_));
        p.kappa = widened(fetched(fields_.kappa, n_));
        p.drift = widened(fetched(fields_.drift, n_));
        p.kind = fetched(fields_.kind, n_);
        const Scene scene = fetched_scene();
        state.aneurysm = scene.aneurysm;
        state.ledger = scene.ledger;
        state.outlet_velocity = {scene.outlet_velocity[0], scene.outlet_velocity[1]};
    }
    Scene fetched_scene() const { return fetched(fields_.scene, 1).front(); }
    std::vector<double> density() const { return widened(fetched(fields_.density, n_)); }
    std::vector<double> solved_pressure() const
    {
        return widened(fetched(fields_.solved_pressure, n_ * steps_));
    }
    std::vector<double> solved_kappa() const { return widened(fetched(fields_.solved_kappa, n_ * steps_)); }

    /// Keeps the state as it is before a frame.
    void save() { copy_state(saved_, fields_); }
    /// Goes back to it.
    void restore() { copy_state(fields_, saved_); }

    /// Makes room for what the lists of a frame wanted, and a quarter more.
    void grow_lists(const Scene& wanted)
    {
        make_lists(std::max(fields_.blood.capacity, wanted.blood_blocks + wanted.blood_blocks / 4),
                   std::max(fields_.walls.capacity, wanted.wall_blocks + wanted.wall_blocks / 4));
    }

private:
    /// The state that a frame starts from.
    struct Saved {
        Row<Real>* position = nullptr;
        Row<Real>* velocity = nullptr;
        Real* pressure = nullptr;
        Real* kappa = nullptr;
        Real* drift = nullptr;
        Kind* kind = nullptr;
        Scene* scene = nullptr;
    };

    template <class To, class From>
    void copy_state(const To& to, const From& from)
    {
        executor_->copy(to.position, from.position, n_);
        executor_->copy(to.velocity, from.velocity, n_);
        executor_->copy(to.pressure, from.pressure, n_);
        executor_->copy(to.kappa, from.kappa, n_);
        executor_->copy(to.drift, from.drift, n_);
        executor_->copy(to.kind, from.kind, n_);
        executor_->copy(to.scene, from.scene, 1);
    }

    template <class T>
    std::vector<T> fetched(const T* array, Index size) const
    {
        std::vector<T> host(static_cast<std::size_t>(size));
        executor_->download(host.data(), array, host.size());
        return host;
    }
    void upload_narrowed(Real* to, const std::vector<double>& values)
    {
        std::vector<Real> narrowed(values.size());
        std::ranges::transform(values, narrowed.begin(), [](double x) { return static_cast<Real>(x); });
        executor_->upload(to, narrowed.data(), narrowed.size());
    }
    static std::vector<double> widened(const std::vector<Real>& values)
    {
        return {values.begin(), values.end()};
    }

    void make_frame()
    {
        memory_.make(fields_.scene, 1);
        memory_.make(input_, 1);
        step_inputs_ = memory_.make(fields_.inputs, steps_);
    }
    void make_particles()
    {
        Fields<Real>& f = fields_;
        memory_.make(f.position, n_);
        memory_.make(f.velocity, n_);
        memory_.make(f.pressure, n_);
        memory_.make(f.kappa, n_);
        memory_.make(f.drift, n_);
        memory_.make(f.kind, n_);
        memory_.make(f.density, n_);
        memory_.make(f.solved_pressure, n_ * steps_);
        memory_.make(f.solved_kappa, n_ * steps_);
        memory_.make(f.event, n_);
        memory_.make(saved_.position, n_);
        memory_.make(saved_.velocity, n_);
        memory_.make(saved_.pressure, n_);
        memory_.make(saved_.kappa, n_);
        memory_.make(saved_.drift, n_);
        memory_.make(saved_.kind, n_);
        memory_.make(saved_.scene, 1);
    }
    void make_bodies()
    {
        Fields<Real>& f = fields_;
        const Index bodies = f.c.bodies() + lane_count; // a search reads eight at once
        memory_.make(f.body_position, bodies);
        memory_.make(f.body_velocity, bodies);
        memory_.make(f.body_x, bodies);
        memory_.make(f.body_y, bodies);
        memory_.make(f.body_z, bodies);
    }
    void make_sorted()
    {
        Fields<Real>& f = fields_;
        memory_.make(f.key, n_);
        memory_.make(f.sorted_key, n_);
        memory_.make(f.order, n_);
        memory_.make(f.start, f.c.grid.cells() + 2);
        memory_.make(f.is_driven, n_ + 1);
        memory_.make(f.body_drift, n_ + 1);
        memory_.make(f.blood.begin, n_ + 1);
        memory_.make(f.blood.blocks, n_);
        memory_.make(f.walls.begin, n_ + 1);
        memory_.make(f.walls.blocks, n_);
        memory_.make(f.blood_gradient, n_);
        memory_.make(f.wall_gradient, n_);
        memory_.make(f.driven_gradient, n_);
        memory_.make(f.force, n_);
        memory_.make(f.acceleration, n_);
        memory_.make(f.solved_velocity, n_ + 1);
        memory_.make(f.correction, n_ + 1);
        memory_.make(f.shift, n_ + 1);
        memory_.make(f.impact, n_);
        memory_.make(f.impact_eos, n_);
        memory_.make(f.reserve_rank, n_ + 1);
        // Between a step's sort and its lists' counts these aren't needed as what they are.
        f.in_reserve = f.key;
        f.reserve = f.blood.blocks;
    }
    void make_solve()
    {
        Fields<Real>& f = fields_;
        memory_.make(f.p, n_ + 1);
        memory_.make(f.p_old, n_ + 1);
        memory_.make(f.lowest, n_);
        memory_.make(f.alpha, n_);
        memory_.make(f.source, n_);
        memory_.make(f.response, n_);
        memory_.make(f.rate, n_);
        memory_.make(f.mirrors, n_);
        memory_.make(f.is_given, n_);
        memory_.make(f.slice, n_ + 1);
        memory_.make(f.member, n_ + 1);
        memory_.make(f.slice_sums, f.c.slices.count);
        memory_.make(f.slice_row, f.c.slices.count);
        f.slice_response = f.correction; // which is needed later
    }
    void make_cells(const Setup& setup)
    {
        Fields<Real>& f = fields_;
        const WallsByCell<Real> walls = sort_walls(f.c.grid, setup.ghosts);
        memory_.make(f.wall_position, walls.ghosts);
        memory_.make(f.wall_start, walls.start);
        memory_.make(f.cell_property, CellProperties<Real>(f.c, setup).values());
    }
    void make_patterns(const Lattice& lattice)
    {
        std::vector<Row<Real>> places;
        for (std::size_t k = 0; k < 3; ++k) {
            for (const Vec3& x : lattice.openings[k]) {
                places.push_back(row(narrow<Real>(x), Real(0)));
            }
            fields_.pattern_begin[k + 1] = static_cast<Index>(places.size());
        }
        memory_.make(fields_.pattern, places);
        memory_.make(fields_.to_fill, fields_.places());
        memory_.make(fields_.fill_rank, fields_.places() + 1);
    }
    void make_lists(Index blood_blocks, Index wall_blocks)
    {
        Fields<Real>& f = fields_;
        f.blood.capacity = blood_blocks;
        f.walls.capacity = wall_blocks;
        memory_.make(f.blood.body, lane_count * blood_blocks);
        memory_.make(f.walls.body, lane_count * wall_blocks);
        if (keeps_gradients_) {
            memory_.make(f.gradient, 3 * lane_count * blood_blocks);
        }
    }

    void place_null_body()
    {
        const Fields<Real>& f = fields_;
        const Index at = f.c.null_body();
        constexpr Real far = Constants<Real>::far_away;
        const Row<Real> place{far, far, far, 0};
        const Row<Real> values{0, 0, 0, f.c.rho_0};
        const Row<Real> zeros{0, 0, 0, 0};
        const Real zero = 0;
        const Index no = 0;
        const Index in_no_slice = -1;
        executor_->upload(f.body_position + at, &place, 1);
        executor_->upload(f.body_velocity + at, &values, 1);
        executor_->upload(f.is_driven + at, &no, 1);
        executor_->upload(f.body_drift + at, &zero, 1);
        executor_->upload(f.solved_velocity + at, &zeros, 1);
        executor_->upload(f.correction + at, &zeros, 1);
        executor_->upload(f.shift + at, &zeros, 1);
        executor_->upload(f.p + at, &zero, 1);
        executor_->upload(f.slice + at, &in_no_slice, 1);
        executor_->upload(f.member + at, &zero, 1);
    }

    Executor* executor_;
    Memory<Executor> memory_;
    Fields<Real> fields_;
    Saved saved_;
    FrameInput* input_ = nullptr;
    StepInput* step_inputs_ = nullptr;
    Index n_;
    Index steps_;
    bool keeps_gradients_;
};

} // namespace aneurysm::device
