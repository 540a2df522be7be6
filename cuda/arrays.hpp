// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cuda/executor.hpp"
#include "cuda/fields.hpp"
#include "cuda/flow.hpp"
#include "cuda/setup.hpp"
#include "cuda/simulation.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace aneurysm::device
{

template <class Real>
Vec3T<Real> narrow(const Vec3& v)
{
    return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}
template <class Real>
Vec3 wide(const Row<Real>& r)
{
    return {static_cast<double>(r.x), static_cast<double>(r.y), static_cast<double>(r.z)};
}

/// The grid around all places where a body can be without harm; farther out the outermost cells go on.
template <class Real>
Grid<Real> make_grid(const Setup& setup)
{
    const double width = 2 * setup.h;
    Vec3 low = setup.lattice.fluid.front();
    Vec3 high = low;
    const auto include = [&](const std::vector<Vec3>& places) {
        for (const Vec3& x : places) {
            low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
            high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
        }
    };
    include(setup.ghosts.fixed().position);
    include(setup.ghosts.near_sac());
    include(setup.lattice.fluid);
    const auto real = [](double x) { return static_cast<Real>(x); };
    const double wide = width * (1 + 1e-5); // for rounding: a cell must not be narrower than the support
    const auto cells = [&](double extent, double of) { return static_cast<Index>(extent / of) + 2; };
    return {.low = narrow<Real>(low),
            .per_width = real(1 / wide),
            .per_x_width = real(2 / wide),
            .x_cells = cells(high.x - low.x, wide / 2),
            .y_cells = cells(high.y - low.y, wide),
            .z_cells = cells(high.z - low.z, wide)};
}

template <class Real>
Constants<Real> make_constants(const Scenario& s, const Setup& setup)
{
    const auto real = [](double x) { return static_cast<Real>(x); };
    const double r_0 = s.vessel.radius_m;
    Constants<Real> c{.kernel = Kernel<Real>(s.kernel.function, setup.h),
                      .vessel = VesselT<Real>(setup.vessel),
                      .grid = make_grid<Real>(setup),
                      .model = s.pressure.model};
    c.particles = static_cast<Index>(s.particles.count);
    c.walls = static_cast<Index>(setup.ghosts.fixed().size() + setup.ghosts.near_sac().size());
    c.dx = real(setup.lattice.spacing);
    c.dt = real(s.time.frame_s / static_cast<double>(s.time.substeps));
    c.mass = real(setup.particle_mass);
    c.rho_0 = real(s.fluid.density_kg_m3);
    c.mu = real(s.fluid.viscosity_pa_s);
    c.g = narrow<Real>(s.fluid.gravity_m_s2);
    c.kappa = real(s.pressure.stiffness_m2_s2);
    c.omega = real(s.pressure.relaxation);
    c.blow_up_ratio = real(s.pressure.blow_up_density_ratio);
    c.impact_band = real(s.rupture.impact_band_spacings * setup.lattice.spacing);
    c.open_end = real(r_0);
    c.recycle_distance = real(s.rupture.recycle_distance_radii * r_0);
    c.breach_radius = real(s.rupture.breach_radius_radii * r_0);
    c.p_outlet = s.outlet.pressure_pa;
    return c;
}

/// What the host hands over for each frame.
struct FrameInput {
    std::int64_t frame = 0;
    double time = 0; ///< [s]
};

/// Device memory of a model, and the ways in and out.
template <class Executor, class Real>
class Arrays
{
public:
    Arrays(Executor& executor, const Scenario& scenario, const Setup& setup, Tuning::Gradients gradients)
        : executor_(&executor), n_(static_cast<Index>(scenario.particles.count)),
          constants_(make_constants<Real>(scenario, setup)),
          steps_(static_cast<Index>(scenario.time.substeps)), position_(executor, n_),
          velocity_(executor, n_), pressure_(executor, n_), kind_(executor, n_), old_position_(executor, n_),
          old_velocity_(executor, n_), old_pressure_(executor, n_), old_kind_(executor, n_),
          density_(executor, n_), solved_pressure_(executor, n_ * steps_), event_(executor, n_),
          body_position_(executor, constants_.bodies() + lane_count),
          body_velocity_(executor, constants_.bodies() + lane_count),
          body_x_(executor, constants_.bodies() + lane_count),
          body_y_(executor, constants_.bodies() + lane_count),
          body_z_(executor, constants_.bodies() + lane_count),
          is_mirror_(executor, constants_.bodies() + lane_count), key_(executor, n_),
          sorted_key_(executor, n_), order_(executor, n_), start_(executor, 2 * constants_.grid.cells() + 2),
          wall_start_(executor, constants_.grid.cells() + 1),
          cell_property_(executor, constants_.grid.cells()), wall_position_(executor, constants_.walls),
          free_begin_(executor, n_ + 1), free_blocks_(executor, n_), ghost_begin_(executor, n_ + 1),
          ghost_blocks_(executor, n_), ghost_gradient_(executor, n_), force_(executor, n_),
          acceleration_(executor, n_), solved_velocity_(executor, n_ + 1), p_(executor, n_ + 1),
          p_old_(executor, n_ + 1), alpha_(executor, n_), source_(executor, n_), response_(executor, n_),
          rate_(executor, n_), impact_(executor, n_), impact_eos_(executor, n_), rank_(executor, n_ + 1),
          entry_rank_(executor, n_ + 1), scene_(executor, 1), old_scene_(executor, 1),
          inlet_(executor, 2 * steps_), input_(executor, 1)
    {
        pattern_ = upload_patterns(setup);
        keep_gradients_ = gradients == Tuning::Gradients::kept ||
                          (gradients == Tuning::Gradients::automatic && executor.keeps_gradients(n_));
        make_lists(5 * n_ + 64, 2 * n_ + 64);
        place_null_body();
        place_walls(setup);
        describe_cells(setup);
        connect();
    }

    const Fields<Real>& fields() const { return fields_; }
    Scene* scene() { return scene_.get(); }
    const FrameInput* input() const { return input_.get(); }

    void upload(const SimulationState& state)
    {
        const Particles& p = state.particles;
        std::vector<Row<Real>> x;
        std::vector<Row<Real>> v;
        std::vector<Real> pressure;
        for (std::size_t i = 0; i < p.size(); ++i) {
            x.push_back(row(narrow<Real>(p.position[i]), Real(0)));
            v.push_back(row(narrow<Real>(p.velocity[i]), Real(0)));
            pressure.push_back(static_cast<Real>(p.pressure[i]));
        }
        executor_->upload(position_.get(), x.data(), x.size());
        executor_->upload(velocity_.get(), v.data(), v.size());
        executor_->upload(pressure_.get(), pressure.data(), pressure.size());
        executor_->upload(kind_.get(), p.kind.data(), p.kind.size());
        const std::vector<Real> rho(p.size(), constants_.rho_0);
        executor_->upload(density_.get(), rho.data(), rho.size());
        Scene scene{};
        scene.aneurysm = state.aneurysm;
        scene.ledger = state.ledger;
        scene.outlet_velocity[0] = state.outlet_velocity[0];
        scene.outlet_velocity[1] = state.outlet_velocity[1];
        executor_->upload(scene_.get(), &scene, 1);
    }

    void upload_input(const FrameInput& input, const std::vector<double>& inlet_velocities)
    {
        executor_->upload(input_.get(), &input, 1);
        executor_->upload(inlet_.get(), inlet_velocities.data(), inlet_velocities.size());
    }

    /// All that a checkpoint holds but frame, spacing and mass.
    void download(SimulationState& state) const
    {
        Particles& p = state.particles;
        const auto x = fetched(position_);
        const auto v = fetched(velocity_);
        const auto pressure = fetched(pressure_);
        p.position.resize(x.size());
        p.velocity.resize(x.size());
        std::ranges::transform(x, p.position.begin(), wide<Real>);
        std::ranges::transform(v, p.velocity.begin(), wide<Real>);
        p.pressure.assign(pressure.begin(), pressure.end());
        p.kind = fetched(kind_);
        const Scene scene = fetched_scene();
        state.aneurysm = scene.aneurysm;
        state.ledger = scene.ledger;
        state.outlet_velocity = {scene.outlet_velocity[0], scene.outlet_velocity[1]};
    }
    Scene fetched_scene() const
    {
        Scene scene;
        executor_->download(&scene, scene_.get(), 1);
        return scene;
    }
    std::vector<double> density() const { return widened(fetched(density_)); }
    std::vector<double> solved_pressure() const { return widened(fetched(solved_pressure_)); }

    /// Keeps the state as it is before a frame.
    void save()
    {
        executor_->copy(old_position_.get(), position_.get(), n_);
        executor_->copy(old_velocity_.get(), velocity_.get(), n_);
        executor_->copy(old_pressure_.get(), pressure_.get(), n_);
        executor_->copy(old_kind_.get(), kind_.get(), n_);
        executor_->copy(old_scene_.get(), scene_.get(), 1);
    }
    /// Goes back to it.
    void restore()
    {
        executor_->copy(position_.get(), old_position_.get(), n_);
        executor_->copy(velocity_.get(), old_velocity_.get(), n_);
        executor_->copy(pressure_.get(), old_pressure_.get(), n_);
        executor_->copy(kind_.get(), old_kind_.get(), n_);
        executor_->copy(scene_.get(), old_scene_.get(), 1);
    }

    /// Makes room for what the lists of a frame wanted, and a quarter more.
    void grow_lists(const Scene& wanted)
    {
        make_lists(std::max(fields_.free.capacity, wanted.free_blocks + wanted.free_blocks / 4),
                   std::max(fields_.ghosts.capacity, wanted.ghost_blocks + wanted.ghost_blocks / 4));
        connect();
    }

private:
    template <class T>
    using Array = Buffer<T, Executor>;

    template <class T>
    std::vector<T> fetched(const Array<T>& array) const
    {
        std::vector<T> host(static_cast<std::size_t>(array.size()));
        executor_->download(host.data(), array.get(), host.size());
        return host;
    }
    static std::vector<double> widened(const std::vector<Real>& values)
    {
        return {values.begin(), values.end()};
    }

    Array<Row<Real>> upload_patterns(const Setup& setup)
    {
        std::vector<Row<Real>> places;
        for (std::size_t k = 0; k < 3; ++k) {
            for (const Vec3& x : setup.lattice.openings[k]) {
                places.push_back(row(narrow<Real>(x), Real(0)));
            }
            fields_pattern_[k + 1] = static_cast<Index>(places.size());
        }
        Array<Row<Real>> pattern(*executor_, static_cast<Index>(places.size()));
        executor_->upload(pattern.get(), places.data(), places.size());
        return pattern;
    }

    void make_lists(Index free_blocks, Index ghost_blocks)
    {
        free_body_ = {};
        ghost_body_ = {};
        gradient_ = {};
        free_body_ = Array<Index>(*executor_, lane_count * free_blocks);
        ghost_body_ = Array<Index>(*executor_, lane_count * ghost_blocks);
        if (keep_gradients_) {
            gradient_ = Array<Real>(*executor_, 3 * lane_count * free_blocks);
        }
    }

    void place_null_body()
    {
        const Index at = constants_.null_body();
        constexpr Real far = Constants<Real>::far_away;
        const Row<Real> place{far, far, far, 0};
        const Row<Real> values{0, 0, 0, constants_.rho_0};
        const Row<Real> zeros{0, 0, 0, 0};
        const Real zero = 0;
        const Index mirror = 1;
        executor_->upload(body_position_.get() + at, &place, 1);
        executor_->upload(body_velocity_.get() + at, &values, 1);
        executor_->upload(is_mirror_.get() + at, &mirror, 1);
        executor_->upload(solved_velocity_.get() + at, &zeros, 1);
        executor_->upload(p_.get() + at, &zero, 1);
    }

    /// The wall's ghosts never move; they are sorted into cells once.
    void place_walls(const Setup& setup)
    {
        std::vector<Row<Real>> walls;
        const WallGhosts& fixed = setup.ghosts.fixed();
        for (std::size_t i = 0; i < fixed.size(); ++i) {
            walls.push_back(row(narrow<Real>(fixed.position[i]), static_cast<Real>(fixed.mass[i])));
        }
        for (const Vec3& x : setup.ghosts.near_sac()) {
            walls.push_back(row(narrow<Real>(x), Real(-1)));
        }
        const Grid<Real>& grid = constants_.grid;
        const auto cell = [&grid](const Row<Real>& w) { return grid.cell(w.vector()); };
        std::vector<std::size_t> order(walls.size()); // stable_sort of rows would ignore their alignment
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t w) { return cell(walls[w]); });
        std::vector<Row<Real>> sorted;
        for (const std::size_t w : order) {
            sorted.push_back(walls[w]);
        }
        std::vector<Index> start(static_cast<std::size_t>(grid.cells()) + 1, 0);
        for (const Row<Real>& w : walls) {
            ++start[static_cast<std::size_t>(cell(w)) + 1];
        }
        std::partial_sum(start.begin(), start.end(), start.begin());
        executor_->upload(wall_position_.get(), sorted.data(), sorted.size());
        executor_->upload(wall_start_.get(), start.data(), start.size());
    }

    void describe_cells(const Setup& setup)
    {
        const Grid<Real>& grid = constants_.grid;
        std::vector<Index> cells(static_cast<std::size_t>(grid.cells()), 0);
        for (const Vec3& x : setup.ghosts.fixed().position) {
            mark_around(cells, narrow<Real>(x), near_wall);
        }
        for (const Vec3& x : setup.ghosts.near_sac()) {
            mark_around(cells, narrow<Real>(x), near_wall);
        }
        // A slab's ghosts can be anywhere behind their plane, as far as the slab goes.
        for (const Opening& end : setup.vessel.openings()) {
            for_each_place_behind(end, setup,
                                  [&](const Vec3& x) { mark_around(cells, narrow<Real>(x), near_opening); });
        }
        mark_deep_cells(cells, setup);
        executor_->upload(cell_property_.get(), cells.data(), cells.size());
    }
    /// The distance to the wall is at most that to the tubes, and grows by no more than the way. The cells at
    /// the grid's edge go on for ever.
    void mark_deep_cells(std::vector<Index>& cells, const Setup& setup) const
    {
        const Grid<Real>& grid = constants_.grid;
        const Vec3 edge{1 / static_cast<double>(grid.per_x_width), 1 / static_cast<double>(grid.per_width),
                        1 / static_cast<double>(grid.per_width)};
        const Vec3 low{static_cast<double>(grid.low.x), static_cast<double>(grid.low.y),
                       static_cast<double>(grid.low.z)};
        const double deep = -1.01 * (0.5 * length(edge) + static_cast<double>(constants_.impact_band));
        for (Index y = 1; y + 1 < grid.y_cells; ++y) {
            for (Index z = 1; z + 1 < grid.z_cells; ++z) {
                for (Index x = 1; x + 1 < grid.x_cells; ++x) {
                    const Vec3 center =
                        low + Vec3{(x + 0.5) * edge.x, (y + 0.5) * edge.y, (z + 0.5) * edge.z};
                    if (setup.vessel.tubes(center).value < deep) {
                        cells[static_cast<std::size_t>(grid.index(x, y, z))] |= deep_inside;
                    }
                }
            }
        }
    }
    /// Places half a cell apart, all around the slab behind an open end.
    template <class Visit>
    static void for_each_place_behind(const Opening& end, const Setup& setup, const Visit& visit)
    {
        const double step = setup.h;
        const double reach = end.radius + 4 * step;
        const int n = static_cast<int>(reach / step) + 1;
        const int depth = static_cast<int>(opening_layers * setup.lattice.spacing / step) + 4;
        const Vec3 e_1 = std::abs(end.outward.z) < 0.5 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
        const Vec3 e_2 = cross(end.outward, e_1);
        for (int i = -n; i <= n; ++i) {
            for (int j = -n; j <= n; ++j) {
                for (int k = -2; k <= depth; ++k) {
                    visit(end.center + step * (static_cast<double>(i) * e_1 + static_cast<double>(j) * e_2 +
                                               static_cast<double>(k) * end.outward));
                }
            }
        }
    }
    void mark_around(std::vector<Index>& cells, const Vec3T<Real>& x, CellProperty what) const
    {
        const Grid<Real>& grid = constants_.grid;
        const auto around = [](Index c, Index reach, Index count) {
            return std::pair{std::max(c - reach, Index{0}), std::min(c + reach, count - 1)};
        };
        const auto [z_low, z_high] = around(grid.z_cell(x.z), 1, grid.z_cells);
        const auto [y_low, y_high] = around(grid.y_cell(x.y), 1, grid.y_cells);
        const auto [x_low, x_high] = around(grid.x_cell(x.x), 2, grid.x_cells);
        for (Index k = z_low; k <= z_high; ++k) {
            for (Index j = y_low; j <= y_high; ++j) {
                for (Index i = x_low; i <= x_high; ++i) {
                    cells[static_cast<std::size_t>(grid.index(i, j, k))] |= what;
                }
            }
        }
    }

    void connect()
    {
        Fields<Real>& f = fields_;
        f.c = constants_;
        f.scene = scene_.get();
        f.inlet_velocities = inlet_.get();
        f.position = position_.get();
        f.velocity = velocity_.get();
        f.pressure = pressure_.get();
        f.kind = kind_.get();
        f.density = density_.get();
        f.solved_pressure = solved_pressure_.get();
        f.event = event_.get();
        f.body_position = body_position_.get();
        f.body_velocity = body_velocity_.get();
        f.body_x = body_x_.get();
        f.body_y = body_y_.get();
        f.body_z = body_z_.get();
        f.is_mirror = is_mirror_.get();
        f.key = key_.get();
        f.sorted_key = sorted_key_.get();
        f.order = order_.get();
        f.start = start_.get();
        f.wall_start = wall_start_.get();
        f.cell_property = cell_property_.get();
        f.wall_position = wall_position_.get();
        f.free = {free_begin_.get(), free_blocks_.get(), free_body_.get(), free_body_.size() / lane_count};
        f.ghosts = {ghost_begin_.get(), ghost_blocks_.get(), ghost_body_.get(),
                    ghost_body_.size() / lane_count};
        f.gradient = keep_gradients_ ? gradient_.get() : nullptr;
        f.ghost_gradient = ghost_gradient_.get();
        f.force = force_.get();
        f.acceleration = acceleration_.get();
        f.solved_velocity = solved_velocity_.get();
        f.p = p_.get();
        f.p_old = p_old_.get();
        f.alpha = alpha_.get();
        f.source = source_.get();
        f.response = response_.get();
        f.rate = rate_.get();
        f.impact = impact_.get();
        f.impact_eos = impact_eos_.get();
        f.pattern = pattern_.get();
        std::copy_n(fields_pattern_, 4, f.pattern_begin);
        // Between a step's sort and its lists' counts these aren't needed as what they are.
        f.flag = key_.get();
        f.entering = sorted_key_.get();
        f.reserve = free_blocks_.get();
        f.rank = rank_.get();
        f.entry_rank = entry_rank_.get();
    }

    Executor* executor_;
    Index n_;
    Constants<Real> constants_;
    Index steps_;
    bool keep_gradients_ = false;
    Index fields_pattern_[4] = {0, 0, 0, 0};
    Fields<Real> fields_{constants_};
    Array<Row<Real>> position_;
    Array<Row<Real>> velocity_;
    Array<Real> pressure_;
    Array<Kind> kind_;
    Array<Row<Real>> old_position_;
    Array<Row<Real>> old_velocity_;
    Array<Real> old_pressure_;
    Array<Kind> old_kind_;
    Array<Real> density_;
    Array<Real> solved_pressure_;
    Array<Index> event_;
    Array<Row<Real>> body_position_;
    Array<Row<Real>> body_velocity_;
    Array<Real> body_x_;
    Array<Real> body_y_;
    Array<Real> body_z_;
    Array<Index> is_mirror_;
    Array<Index> key_;
    Array<Index> sorted_key_;
    Array<Index> order_;
    Array<Index> start_;
    Array<Index> wall_start_;
    Array<Index> cell_property_;
    Array<Row<Real>> wall_position_;
    Array<Index> free_begin_;
    Array<Index> free_blocks_;
    Array<Index> ghost_begin_;
    Array<Index> ghost_blocks_;
    Array<Row<Real>> ghost_gradient_;
    Array<Row<Real>> force_;
    Array<Row<Real>> acceleration_;
    Array<Row<Real>> solved_velocity_;
    Array<Real> p_;
    Array<Real> p_old_;
    Array<Real> alpha_;
    Array<Real> source_;
    Array<Real> response_;
    Array<Real> rate_;
    Array<Real> impact_;
    Array<Real> impact_eos_;
    Array<Index> rank_;
    Array<Index> entry_rank_;
    Array<Scene> scene_;
    Array<Scene> old_scene_;
    Array<double> inlet_;
    Array<FrameInput> input_;
    Array<Row<Real>> pattern_;
    Array<Index> free_body_;
    Array<Index> ghost_body_;
    Array<Real> gradient_;
};

} // namespace aneurysm::device
