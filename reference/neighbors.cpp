// SPDX-License-Identifier: Apache-2.0
#include "reference/neighbors.hpp"

#include "common/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace aneurysm::reference
{
namespace
{

/// One axis of the cell grid.
struct Axis {
    double low = 0;
    double width = 0; ///< of a cell
    double period = 0;
    std::int64_t cells = 1;

    std::int64_t cell(double x) const
    {
        const auto c = static_cast<std::int64_t>(std::floor((x - low) / width));
        return period > 0 ? (c % cells + cells) % cells : c;
    }
    /// First of the neighboring cells, which end with the next one; of two cells each has one neighbor.
    std::int64_t first() const { return period > 0 && cells == 2 ? 0 : -1; }
};

double difference(double a, double b, double period)
{
    const double d = a - b;
    return period > 0 ? d - period * std::round(d / period) : d;
}

Axis make_axis(double low, double high, double period, double support)
{
    if (period <= 0) {
        return {low, support, 0, static_cast<std::int64_t>(std::floor((high - low) / support)) + 1};
    }
    const auto cells = static_cast<std::int64_t>(std::floor(period / support));
    if (cells < 2) {
        throw Error("neighbor search", "a periodic box of " + std::to_string(period) + " m",
                    "at least two supports of " + std::to_string(support) + " m");
    }
    return {low, period / static_cast<double>(cells), period, cells};
}

class Grid
{
public:
    Grid(const Bodies& bodies, double support, const Period& period)
    {
        constexpr double inf = std::numeric_limits<double>::infinity();
        Vec3 low{inf, inf, inf};
        Vec3 high = -low;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (bodies.role[i] != Role::absent) {
                const Vec3& r = bodies.position[i];
                low = {std::min(low.x, r.x), std::min(low.y, r.y), std::min(low.z, r.z)};
                high = {std::max(high.x, r.x), std::max(high.y, r.y), std::max(high.z, r.z)};
            }
        }
        if (low.x > high.x) { // no body at all
            low = high = {};
        }
        axes_ = {make_axis(low.x, high.x, period.x, support), make_axis(low.y, high.y, period.y, support),
                 make_axis(low.z, high.z, period.z, support)};
        cells_.resize(static_cast<std::size_t>(axes_[0].cells * axes_[1].cells * axes_[2].cells));
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (bodies.role[i] != Role::absent) {
                const Vec3& r = bodies.position[i];
                cells_[index(axes_[0].cell(r.x), axes_[1].cell(r.y), axes_[2].cell(r.z))].push_back(i);
            }
        }
    }

    /// Calls visit(j) for each body in the cell of r and those around it.
    template <class Visit>
    void around(const Vec3& r, const Visit& visit) const
    {
        for (std::int64_t dz = axes_[2].first(); dz <= 1; ++dz) {
            for (std::int64_t dy = axes_[1].first(); dy <= 1; ++dy) {
                for (std::int64_t dx = axes_[0].first(); dx <= 1; ++dx) {
                    const auto x = wrap(0, axes_[0].cell(r.x) + dx);
                    const auto y = wrap(1, axes_[1].cell(r.y) + dy);
                    const auto z = wrap(2, axes_[2].cell(r.z) + dz);
                    if (x >= 0 && y >= 0 && z >= 0) {
                        std::ranges::for_each(cells_[index(x, y, z)], visit);
                    }
                }
            }
        }
    }

private:
    std::size_t index(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return static_cast<std::size_t>((z * axes_[1].cells + y) * axes_[0].cells + x);
    }
    /// -1: beyond the grid.
    std::int64_t wrap(std::size_t axis, std::int64_t c) const
    {
        const std::int64_t n = axes_[axis].cells;
        if (axes_[axis].period > 0) {
            return (c + n) % n;
        }
        return c < n ? std::max<std::int64_t>(c, -1) : -1;
    }

    std::array<Axis, 3> axes_;
    std::vector<std::vector<std::size_t>> cells_;
};

} // namespace

Vec3 difference(const Vec3& a, const Vec3& b, const Period& period)
{
    return {difference(a.x, b.x, period.x), difference(a.y, b.y, period.y), difference(a.z, b.z, period.z)};
}

Neighbors::Neighbors(const Bodies& bodies, const Kernel& kernel, const Period& period)
    : begin_(bodies.size() + 1, 0)
{
    const Grid grid(bodies, kernel.support(), period);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        begin_[i] = list_.size();
        if (bodies.blood(i)) {
            grid.around(bodies.position[i], [&](std::size_t j) {
                const Vec3 x = difference(bodies.position[i], bodies.position[j], period);
                const double r = length(x);
                if (r < kernel.support()) {
                    list_.push_back(
                        {j, kernel.value(r), kernel.gradient(x), viscosity_laplacian(r, kernel.support())});
                }
            });
            std::ranges::sort(list_.begin() + static_cast<std::ptrdiff_t>(begin_[i]), list_.end(), {},
                              &Neighbor::j);
        }
    }
    begin_[bodies.size()] = list_.size();
}

} // namespace aneurysm::reference
