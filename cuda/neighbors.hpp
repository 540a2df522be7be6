// SPDX-License-Identifier: Apache-2.0
// Sorting into cells, and the lists of neighbors.
#pragma once

#include "cuda/executor/hits.hpp"
#include "cuda/fields.hpp"
#include "cuda/periodic.hpp"

namespace aneurysm::device
{

/// The key that particles are sorted by: blood by cell, then the reserve.
template <class Real>
struct Keys {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        const Index cells = f.c.grid.cells();
        f.key[id] = f.kind[id] == Kind::reserve ? cells : f.c.grid.cell(f.position[id].vector());
    }
};

/// Bodies in a row of cells along x.
struct Range {
    Index begin;
    Index end;
};

/// The nine rows of cells around a place, as far along x as a particle sees; one that a seam divides is two.
template <bool periodic, class Real, class Visit>
ANEURYSM_INLINE void for_each_row(const Grid<Real>& grid, const Vec3T<Real>& r, const Index* start,
                                  const Visit& visit)
{
    const Index x = grid.x_cell(r.x);
    const Index y = grid.y_cell(r.y);
    const Index z = grid.z_cell(r.z);
    const Index left = x > 2 ? x - 2 : 0;
    const Index behind_right = x + 3 < grid.x_cells ? x + 3 : grid.x_cells;
    for (Index dy = -1; dy <= 1; ++dy) {
        const Index row_y = periodic ? through_seam(y + dy, grid.y_period) : y + dy;
        if (row_y < 0 || row_y >= grid.y_cells) {
            continue;
        }
        for (Index dz = -1; dz <= 1; ++dz) {
            const Index row_z = periodic ? through_seam(z + dz, grid.z_period) : z + dz;
            if (row_z >= 0 && row_z < grid.z_cells) {
                const Index first = grid.index(0, row_y, row_z);
                visit(Range{start[first + left], start[first + behind_right]});
                if (periodic && grid.x_period > 0) {
                    const Index from = x < 2 ? x - 2 + grid.x_period : 0;
                    const Index to = x < 2 ? grid.x_period : x + 3 - behind_right;
                    visit(Range{start[first + from], start[first + to]});
                }
            }
        }
    }
}

/// Blood and ghosts of the wall that sorted particle i sees, itself left out, in the order of bodies: counted,
/// or written into its lists.
template <class Real, bool fill, bool periodic>
struct FindNeighbors {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        const Vec3T<Real> r = f.body_position[i].vector();
        Hits<fill> hits(fill ? f.blood.body + lane_count * f.blood.begin[i] : nullptr);
        collect(i, r, f.start, 0, hits, lane);
        finish(f.blood, i, hits, lane);

        Hits<fill> walls(fill ? f.walls.body + lane_count * f.walls.begin[i] : nullptr);
        if (f.has(r, near_wall)) {
            collect(i, r, f.wall_start, f.c.first_wall(), walls, lane);
        }
        finish(f.walls, i, walls, lane);
    }

private:
    ANEURYSM_HD void collect(Index i, const Vec3T<Real>& r, const Index* start, Index first, Hits<fill>& hits,
                             Lane lane) const
    {
        using Number = Lanes<Real>;
        const Number H2(f.c.kernel.support() * f.c.kernel.support());
        const Vec3T<Number> own{Number(r.x), Number(r.y), Number(r.z)};
        const Lanes<Index> self(i);
        for_each_row<periodic>(f.c.grid, r, start, [&](Range range) {
            const Lanes<Index> end(first + range.end);
            for (Index k = first + range.begin; k < first + range.end; k += lane_count) {
                Vec3T<Number> x{own.x - load(f.body_x + k, lane), own.y - load(f.body_y + k, lane),
                                own.z - load(f.body_z + k, lane)};
                if constexpr (periodic) {
                    x = shortest(x, f.c.vessel.period());
                }
                const Lanes<Index> j = Lanes<Index>(k) + numbers(lane);
                hits.add((dot(x, x) < H2) & (j < end) & (j != self), j, lane);
            }
        });
    }
    ANEURYSM_HD void finish(const Lists& lists, Index i, Hits<fill>& hits, Lane lane) const
    {
        if constexpr (fill) {
            hits.pad(f.c.null_body(), lane);
        } else if (lane.is_first()) {
            lists.blocks[i] = (hits.count() + lane_count - 1) / lane_count;
        }
    }
};

/// The lists' lengths are known now; without room for them the step goes on without particles, and the frame
/// is run again, with room for the longest lists of its steps.
template <class Real>
struct CheckLists {
    Fields<Real> f;

    ANEURYSM_HD void operator()() const
    {
        const Index count = f.blood_count();
        Scene& s = *f.scene;
        s.blood_blocks = larger(s.blood_blocks, f.blood.begin[count]);
        s.wall_blocks = larger(s.wall_blocks, f.walls.begin[count]);
        if (s.blood_blocks > f.blood.capacity || s.wall_blocks > f.walls.capacity) {
            s.fault = Fault::lists_full;
            f.start[f.c.grid.cells()] = 0;
        }
    }
};

} // namespace aneurysm::device
