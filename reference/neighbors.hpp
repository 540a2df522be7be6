// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/particles.hpp"
#include "reference/kernel_function.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace aneurysm::reference
{

/// How a body takes part in the SPH sums.
enum class Role : std::uint8_t {
    free,   ///< blood that forces move
    driven, ///< blood in the inlet's buffer: moves with (25)
    mirror, ///< ghost of the wall, (27)
    slip,   ///< ghost of a wall that exerts no viscous force: else as `mirror`
    absent, ///< in the reserve
};

/// All that the sums run over: the particles, by their index, and behind them the wall's ghosts.
struct Bodies {
    std::vector<Vec3> position; ///< [m]
    std::vector<Vec3> velocity; ///< [m/s]
    std::vector<double> mass;   ///< [kg]
    /// By body.
    std::vector<Role> role;

    /// How many bodies there are.
    std::size_t size() const { return position.size(); }
    /// Blood that forces move.
    bool free(std::size_t i) const { return role[i] == Role::free; }
    /// Blood, whether forces move it or not.
    bool blood(std::size_t i) const { return role[i] == Role::free || role[i] == Role::driven; }
    /// A ghost of the wall.
    bool wall(std::size_t i) const { return role[i] == Role::mirror || role[i] == Role::slip; }
};

/// A body j within the support of a body i, i itself included, with all that the sums need of the pair.
struct Neighbor {
    /// Its number.
    std::size_t j = 0;
    double W = 0;     ///< W(|r_i - r_j|) [1/m^3]
    Vec3 grad_W;      ///< its gradient with respect to r_i [1/m^4]
    double lap_W = 0; ///< Laplacian of the viscosity kernel [1/m^5]
};

/// Box lengths of a periodic domain; 0: not periodic in that direction.
using Period = Vec3;

/// The shortest way from b to a.
Vec3 difference(const Vec3& a, const Vec3& b, const Period& period);

/// The neighbors of all blood, ascending in j.
class Neighbors
{
public:
    /// By a grid of cells as wide as the support; in a periodic direction the box must hold at least 2 cells,
    /// so that no body sees another one twice. \throws Error when it holds fewer
    Neighbors(const Bodies& bodies, const Kernel& kernel, const Period& period = {});

    /// Empty for bodies that are not blood.
    std::span<const Neighbor> of(std::size_t i) const
    {
        return {list_.data() + begin_[i], begin_[i + 1] - begin_[i]};
    }

private:
    std::vector<Neighbor> list_;
    std::vector<std::size_t> begin_;
};

} // namespace aneurysm::reference
