// SPDX-License-Identifier: Apache-2.0
#include "analytic/lattice/column_sum.hpp"

#include "analytic/kernel_function.hpp"

#include <cmath>
#include <numbers>

namespace aneurysm::analytic
{

using Eigen::Vector2d;
using std::numbers::pi;

double LatticeDuct::mass() const
{
    return rho_0 / kernel_sum(lattice).value;
}

LatticeDuct lattice_channel(const Lattice& lattice, double rho_0, double mu, int rows)
{
    LatticeDuct duct{lattice, rho_0, mu, true, rows * lattice.dx / 2, {}, {}};
    const double m = duct.mass();
    const int behind = static_cast<int>(std::ceil(2 * lattice.h / lattice.dx));
    for (int j = -behind; j < rows + behind; ++j) {
        const Column row{{(j + 0.5) * lattice.dx - duct.half_width, 0}, m};
        (j >= 0 && j < rows ? duct.fluid : duct.ghosts).push_back(row);
    }
    return duct;
}

LatticeDuct lattice_tube(const Lattice& lattice, double rho_0, double mu, double a, double inset)
{
    LatticeDuct duct{lattice, rho_0, mu, false, a, {}, {}};
    const double m = duct.mass();
    const int reach = static_cast<int>(std::ceil((a + 2 * lattice.h) / lattice.dx)) + 1;
    for (int i = -reach; i < reach; ++i) {
        for (int k = -reach; k < reach; ++k) {
            const Vector2d x = lattice.dx * Vector2d(i + 0.5, k + 0.5);
            const double d = x.norm() - a;
            const double outside = std::clamp(0.5 + d / lattice.dx, 0.0, 1.0);
            if (d < -inset) {
                duct.fluid.push_back({x, m});
            }
            if (d < 2 * lattice.h && outside > 0) {
                duct.ghosts.push_back({x, m * outside});
            }
        }
    }
    return duct;
}

RadialKernel density_kernel(const Lattice& l)
{
    const double at = l.kernel == KernelName::cubic_spline ? 2 * l.h / 3 : l.h / 2;
    return {[l](double r) { return kernel(l.kernel, l.h, r); }, kernel(l.kernel, l.h, 0),
            -kernel_slope(l.kernel, l.h, at)};
}

RadialKernel viscosity_kernel(const Lattice& l)
{
    const double H = 2 * l.h;
    const double at_0 = 45 / (pi * std::pow(H, 5));
    return {[H, at_0](double r) { return r > 0 ? viscosity_kernel_laplacian(H, r) : at_0; }, at_0, at_0 / H};
}

ColumnSum column_sum(const LatticeDuct& duct, const Vector2d& x, const RadialKernel& kernel)
{
    const double dx = duct.lattice.dx;
    const double H = 2 * duct.lattice.h;
    ColumnSum sum;
    if (x.norm() > H) {
        return sum;
    }
    const int reach = static_cast<int>(std::ceil(H / dx)) + 1;
    const int layers = duct.layered ? reach : 0;
    for (int k = -reach; k <= reach; ++k) {
        for (int j = -layers; j <= layers; ++j) {
            const double r = std::hypot(x(0), x(1) + j * dx, k * dx);
            if (r <= H) {
                sum.value += kernel.f(r);
                ++sum.terms;
            }
        }
    }
    sum.of_rounding = (sum.terms + 40) * sum.value + 16 * sum.terms * kernel.largest;
    sum.of_distance = sum.terms * kernel.steepest;
    return sum;
}

} // namespace aneurysm::analytic
