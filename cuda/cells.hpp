// SPDX-License-Identifier: Apache-2.0
// What the cells of the grid hold and know before a run, worked out on the host.
#pragma once

#include "cuda/constants.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace aneurysm::device
{

/// The wall's ghosts, which never move, by cell.
template <class Real>
struct WallsByCell {
    std::vector<Row<Real>> ghosts; ///< w: mass where the sac doesn't reach, else -1
    std::vector<Index> start;      ///< [cells + 1] first ghost of each cell
};
template <class Real>
WallsByCell<Real> sort_walls(const Grid<Real>& grid, const GhostLattice& lattice)
{
    std::vector<Row<Real>> walls;
    const WallGhosts& fixed = lattice.fixed();
    for (std::size_t i = 0; i < fixed.size(); ++i) {
        walls.push_back(row(narrow<Real>(fixed.position[i]), static_cast<Real>(fixed.mass[i])));
    }
    for (const Vec3& x : lattice.near_sac()) {
        walls.push_back(row(narrow<Real>(x), Real(-1)));
    }
    const auto cell = [&grid](const Row<Real>& w) { return grid.cell(w.vector()); };
    std::vector<std::size_t> order(walls.size()); // stable_sort of rows would ignore their alignment
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t w) { return cell(walls[w]); });
    WallsByCell<Real> result{{}, std::vector<Index>(static_cast<std::size_t>(grid.cells()) + 1, 0)};
    for (const std::size_t w : order) {
        result.ghosts.push_back(walls[w]);
        ++result.start[static_cast<std::size_t>(cell(walls[w])) + 1];
    }
    std::partial_sum(result.start.begin(), result.start.end(), result.start.begin());
    return result;
}

/// Finds the properties of all cells, see CellProperty.
template <class Real>
class CellProperties
{
public:
    CellProperties(const Constants<Real>& constants, const Setup& setup)
        : constants_(&constants), properties_(static_cast<std::size_t>(constants.grid.cells()), 0)
    {
        if (setup.vessel.form() == DomainForm::artery) {
            mark_ghosts(setup);
        } else { // small domains, with walls all around or behind seams
            std::ranges::fill(properties_, near_wall);
        }
        mark_deep_cells(setup.vessel);
    }

    const std::vector<Index>& values() const { return properties_; }

private:
    void mark_ghosts(const Setup& setup)
    {
        for (const Vec3& x : setup.ghosts.fixed().position) {
            mark_around(x, near_wall);
        }
        for (const Vec3& x : setup.ghosts.near_sac()) {
            mark_around(x, near_wall);
        }
    }
    /// All cells from which something at x may be seen.
    void mark_around(const Vec3& place, CellProperty what)
    {
        const Grid<Real>& grid = constants_->grid;
        const auto x = narrow<Real>(place);
        const auto around = [](Index c, Index reach, Index count) {
            return std::pair{std::max(c - reach, Index{0}), std::min(c + reach, count - 1)};
        };
        const auto [z_low, z_high] = around(grid.z_cell(x.z), 1, grid.z_cells);
        const auto [y_low, y_high] = around(grid.y_cell(x.y), 1, grid.y_cells);
        const auto [x_low, x_high] = around(grid.x_cell(x.x), 2, grid.x_cells);
        for (Index k = z_low; k <= z_high; ++k) {
            for (Index j = y_low; j <= y_high; ++j) {
                for (Index i = x_low; i <= x_high; ++i) {
                    properties_[static_cast<std::size_t>(grid.index(i, j, k))] |= what;
                }
            }
        }
    }

    /// The distance to the wall is at most that to the tubes, and grows by no more than the way. The cells at
    /// the grid's edge go on for ever.
    void mark_deep_cells(const Vessel& vessel)
    {
        const Grid<Real>& grid = constants_->grid;
        const Vec3 per_width = wide(grid.per_width);
        const Vec3 edge{1 / per_width.x, 1 / per_width.y, 1 / per_width.z};
        const double deep = -1.01 * (0.5 * length(edge) + static_cast<double>(constants_->impact_band));
        for (Index y = 1; y + 1 < grid.y_cells; ++y) {
            for (Index z = 1; z + 1 < grid.z_cells; ++z) {
                for (Index x = 1; x + 1 < grid.x_cells; ++x) {
                    const Vec3 center =
                        wide(grid.low) + Vec3{(x + 0.5) * edge.x, (y + 0.5) * edge.y, (z + 0.5) * edge.z};
                    if (vessel.tubes(center).value < deep) {
                        properties_[static_cast<std::size_t>(grid.index(x, y, z))] |= deep_inside;
                    }
                }
            }
        }
    }

    const Constants<Real>* constants_;
    std::vector<Index> properties_;
};

} // namespace aneurysm::device
