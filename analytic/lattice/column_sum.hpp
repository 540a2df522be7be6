// SPDX-License-Identifier: Apache-2.0
// Columns of particles along a straight duct on the cubic lattice, and what a particle feels of one.
#pragma once

#include "analytic/lattice/lattice.hpp"

#include <functional>
#include <vector>

namespace aneurysm::analytic
{

struct Column {
    Eigen::Vector2d x; ///< in the cross-section [m]
    double mass = 0;   ///< of each particle [kg]
};

struct LatticeDuct {
    Lattice lattice;
    double rho_0 = 0;      ///< [kg/m^3]
    double mu = 0;         ///< [Pa s]
    bool layered = false;  ///< each column stands for a whole plane, x(1) = 0: a channel
    double half_width = 0; ///< a: from the middle to the wall [m]
    std::vector<Column> fluid;
    std::vector<Column> ghosts; ///< where a ghost's cell is partly inside, a particle can be at its place

    double mass() const; ///< rho_0 / sum of W over the lattice [kg]
    double r(std::size_t column) const { return fluid[column].x.norm(); } ///< from the middle [m]
    std::size_t size() const { return fluid.size(); }
};

/// Planes of particles at the middles of `rows` cells between the walls.
LatticeDuct lattice_channel(const Lattice& lattice, double rho_0, double mu, int rows);

/// Columns at ((i + 1/2) dx, (k + 1/2) dx) deeper than `inset` in a circular wall of radius a, and ghosts
/// with the mass m clamp(1/2 + d/dx, 0, 1) at the distance d < 2 h beyond it.
LatticeDuct lattice_tube(const Lattice& lattice, double rho_0, double mu, double a, double inset);

/// A function of r with the support 2 h.
struct RadialKernel {
    std::function<double(double)> f;
    double largest = 0;  ///< |f|
    double steepest = 0; ///< |df/dr|
};
RadialKernel density_kernel(const Lattice& lattice);   ///< W [1/m^3]
RadialKernel viscosity_kernel(const Lattice& lattice); ///< lap W of (7) [1/m^5]

/// A sum of the kernel over the particles of a column, and what it may be off by in another text.
struct ColumnSum {
    double value = 0;
    double of_rounding = 0; ///< per roundoff: n additions, 40 for each term, 16 of the largest value
    double of_distance = 0; ///< per displacement of each particle [1/m]
    double terms = 0;

    void add(double factor, const ColumnSum& sum)
    {
        value += factor * sum.value;
        of_rounding += factor * sum.of_rounding;
        of_distance += factor * sum.of_distance;
        terms += sum.terms;
    }
};

/// Over the column at x from a particle.
ColumnSum column_sum(const LatticeDuct& duct, const Eigen::Vector2d& x, const RadialKernel& kernel);

} // namespace aneurysm::analytic
