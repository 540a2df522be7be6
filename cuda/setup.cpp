// SPDX-License-Identifier: Apache-2.0
#include "cuda/setup.hpp"

#include "common/error.hpp"
#include "common/scenario/limits.hpp"
#include "cuda/bifurcation.hpp"
#include "cuda/kernel_function.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace aneurysm::device
{
namespace
{

/// Calls visit(x) for the points of the lattice of spacing dx within `support` of the origin.
template <class Visit>
void for_each_lattice_neighbor(double dx, double support, const Visit& visit)
{
    const int n = static_cast<int>(support / dx) + 1;
    for (int x = -n; x <= n; ++x) {
        for (int y = -n; y <= n; ++y) {
            for (int z = -n; z <= n; ++z) {
                visit(dx * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
            }
        }
    }
}

/// Imaginary part of sum_j grad W_j exp(i k.r_j). Of a neighbor and its mirror images only the sine of the slope's own
/// direction, times the cosines of the other two, doesn't cancel.
Vec3 lattice_symbol(const std::vector<std::pair<Vec3, Vec3>>& slopes, const Vec3& k)
{
    Vec3 symbol;
    for (const auto& [x, slope] : slopes) {
        const Vec3 sine{std::sin(k.x * x.x), std::sin(k.y * x.y), std::sin(k.z * x.z)};
        const Vec3 cosine{std::cos(k.x * x.x), std::cos(k.y * x.y), std::cos(k.z * x.z)};
        symbol += {slope.x * sine.x * cosine.y * cosine.z, slope.y * cosine.x * sine.y * cosine.z,
                   slope.z * cosine.x * cosine.y * sine.z};
    }
    return symbol;
}

/// \throws InputError when a step is longer, or the iteration of (3) stronger, than the flow stays stable for
void check_stability(const Scenario& s, double dx)
{
    const double dt = s.time.frame_s / static_cast<double>(s.time.substeps);
    const double longest = step_limits(s, dx).smallest();
    if (dt > longest) {
        throw InputError("time.substeps",
                         std::to_string(s.time.substeps) + " makes a step of " + std::to_string(dt) +
                             " s, above the stability limit of " + std::to_string(longest) + " s",
                         "needed: at least " +
                             std::to_string(static_cast<int>(std::ceil(s.time.frame_s / longest))));
    }
    const double omega = relaxation_limit(s.kernel.function, s.kernel.smoothing_length_spacings);
    if (s.pressure.model == PressureModel::dfsph && s.pressure.relaxation >= omega) {
        throw InputError("pressure.relaxation", std::to_string(s.pressure.relaxation) + " is not stable",
                         "allowed: below " + std::to_string(omega) +
                             ", the limit of this kernel on a full lattice");
    }
}

} // namespace

double lattice_kernel_sum(KernelName name, double h, double dx)
{
    const Kernel<double> W(name, h);
    double sum = 0;
    for_each_lattice_neighbor(dx, 2 * h, [&](const Vec3& x) { sum += first(W.value(length(x))); });
    return sum;
}

double relaxation_limit(KernelName name, double ratio)
{
    constexpr int points = 32;       // an axis: finds the largest eigenvalue to 0.15 %
    constexpr double margin = 1.002; // more than that
    const Kernel<double> W(name, ratio);
    std::vector<std::pair<Vec3, Vec3>> slopes; // of the first octant, times the number of mirror images
    double squares = 0;
    for_each_lattice_neighbor(1, 2 * ratio, [&](const Vec3& x) {
        const Vec3 slope = first(W.gradient_factor(length(x))) * x;
        squares += dot(slope, slope);
        if (x.x >= 0 && x.y >= 0 && x.z >= 0 && length(slope) > 0) {
            const double images = (x.x > 0 ? 2 : 1) * (x.y > 0 ? 2 : 1) * (x.z > 0 ? 2 : 1);
            slopes.emplace_back(x, images * slope);
        }
    });
    double largest = 0;
    for (int n = 0; n < (points + 1) * (points + 1) * (points + 1); ++n) {
        const Vec3 at{static_cast<double>(n / (points + 1) / (points + 1)),
                      static_cast<double>(n / (points + 1) % (points + 1)),
                      static_cast<double>(n % (points + 1))};
        if (at.x >= at.y && at.y >= at.z) {
            const Vec3 symbol = lattice_symbol(slopes, std::numbers::pi / points * at);
            largest = std::max(largest, dot(symbol, symbol));
        }
    }
    return 4.0 / 3 * squares / (margin * largest);
}

Setup::Setup(const Scenario& scenario, const std::optional<SimulationState>& state)
    : vessel(scenario, daughter_radius(scenario.vessel.radius_m)),
      lattice(sample(scenario, vessel, daughter_radius(scenario.vessel.radius_m),
                     state ? std::optional(state->spacing) : std::nullopt)),
      h(scenario.kernel.smoothing_length_spacings * lattice.spacing),
      particle_mass(scenario.fluid.density_kg_m3 /
                    lattice_kernel_sum(scenario.kernel.function, h, lattice.spacing)),
      ghosts(ghost_lattice(scenario, vessel, lattice.spacing, 2 * h, particle_mass))
{
    check_stability(scenario, lattice.spacing);
}

} // namespace aneurysm::device
