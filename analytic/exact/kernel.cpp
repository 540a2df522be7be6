// SPDX-License-Identifier: Apache-2.0
#include "analytic/exact/kernel.hpp"

#include "analytic/exact/precise.hpp"

#include <stdexcept>

namespace aneurysm::analytic
{
namespace
{

/// The B-spline of this degree on the knots first, first + 1, ...
Precise b_spline(int degree, int first, const Precise& x)
{
    if (degree == 0) {
        return first <= x && x < first + 1 ? 1 : 0;
    }
    return ((x - first) * b_spline(degree - 1, first, x) +
            (first + degree + 1 - x) * b_spline(degree - 1, first + 1, x)) /
           degree;
}

/// 20 int_x^1 t (1 - t)^3 dt = 20 int_0^(1 - x) (1 - s) s^3 ds.
Precise wendland_integral(const Precise& x)
{
    const Precise s = 1 - x;
    return 20 * (pow(s, 4) / 4 - pow(s, 5) / 5);
}

Precise kernel_at(KernelName name, double h, const Precise& r)
{
    const Precise q = r / h;
    const Precise cube = pow(Precise(h), 3);
    if (q >= 2) {
        return 0;
    }
    return name == KernelName::cubic_spline
               ? Precise(3 * b_spline(3, -2, q) / (2 * precise_pi() * cube))
               : Precise(21 * wendland_integral(q / 2) / (16 * precise_pi() * cube));
}

/// f(r), and the larger change to either end of r (1 +- off).
template <class Function>
Exact with_change(Function f, double r, double off)
{
    const Precise value = f(r);
    const Precise below = abs(Precise(f(r * (1 - Precise(off))) - value));
    const Precise above = abs(Precise(f(r * (1 + Precise(off))) - value));
    return {static_cast<double>(value), static_cast<double>(below > above ? below : above)};
}

} // namespace

Exact exact_kernel(KernelName name, double h, double r, double off)
{
    return with_change([&](const Precise& x) { return kernel_at(name, h, x); }, r, off);
}

Exact exact_kernel_slope(KernelName name, double h, double r, double off)
{
    const auto kernel = [&](const Precise& x) { return kernel_at(name, h, x); };
    Exact slope = with_change([&](const Precise& x) { return precise_slope(kernel, x, h); }, r, off);
    slope.change += 1e-30 * static_cast<double>(kernel(0)) / h;
    return slope;
}

Eigen::Vector3d exact_kernel_gradient(KernelName name, double h, const Eigen::Vector3d& x)
{
    Eigen::Vector3d gradient;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto along = [&](const Precise& t) {
            Precise square = 0;
            for (Eigen::Index b = 0; b < 3; ++b) {
                square += b == axis ? Precise(t * t) : Precise(Precise(x(b)) * x(b));
            }
            return kernel_at(name, h, sqrt(square));
        };
        gradient(axis) = static_cast<double>(precise_slope(along, x(axis), h));
    }
    return gradient;
}

Estimate exact_viscosity_laplacian(double H, double r)
{
    if (r < H / 1000) {
        throw std::invalid_argument("exact_viscosity_laplacian: too near to 0 for a difference");
    }
    if (r >= H) {
        return {};
    }
    const auto r_times_kernel = [&](const Precise& x) { // r W of Mueller et al. 2003, with z = r/H
        const Precise z = x / H;
        return Precise(15 / (2 * precise_pi() * Precise(H) * H) *
                       (-pow(z, 4) / 2 + pow(z, 3) + Precise(1) / 2 - z));
    };
    const Precise largest = 45 / (precise_pi() * pow(Precise(H), 5));
    return {static_cast<double>(precise_curvature(r_times_kernel, r, H) / r),
            2e-25 * H / r * static_cast<double>(largest)};
}

} // namespace aneurysm::analytic
