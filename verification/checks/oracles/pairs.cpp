// SPDX-License-Identifier: Apache-2.0
// The oracles for a cloud of particles, (2), (3), (5)-(7), (26), (27), against sums with 50 digits.
#include "analytic/exact/pairs.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/formulas/kernel_rounding.hpp"
#include "verification/checks/vectors.hpp"

#include <cmath>
#include <random>

namespace aneurysm::checks
{
namespace
{

using analytic::Cloud;
using analytic::Estimate;
using analytic::VectorEstimate;
using Eigen::Vector3d;

/// A disturbed lattice of 5^3 particles, a fifth of them ghosts. All coordinates are multiples of 2^-20 m, so
/// that their differences are exact.
Cloud cloud_of(KernelName kernel, double ratio)
{
    constexpr int cells = 5;
    constexpr double dx = 0x1p-3;
    std::mt19937_64 bits(17);
    const auto random = [&] { return std::ldexp(static_cast<double>(bits() >> 48U), -15) - 1; }; // [-1, 1)
    Cloud c;
    c.kernel = kernel;
    c.h = ratio * dx;
    c.period = cells * dx;
    for (int k = 0; k < cells * cells * cells; ++k) {
        const Eigen::Vector3i place(k % cells, k / cells % cells, k / (cells * cells));
        const Vector3d cell = place.cast<double>();
        const Vector3d jitter(random(), random(), random());
        c.position.emplace_back(dx * cell + Vector3d::Constant(dx / 2) + 0x1p-5 * jitter);
        c.velocity.emplace_back(random(), random(), random());
        c.mass.push_back(2 * (1 + random() / 4));
        c.density.push_back(1050 * (1 + random() / 16));
        c.pressure.push_back(1e4 * (1 + random()));
        c.free.push_back(k % 5 != 0);
    }
    return c;
}

void pairs(Probe& probe)
{
    const char* of_sum =
        "the sum's own bound of its rounding, and that of the terms that the exact sum rounds";
    Quantity& density =
        probe.quantity("(5) over all pairs against 50 digits [kg/m^3]", Source::rounding, of_sum);
    Quantity& rate =
        probe.quantity("(2) over all pairs against 50 digits [kg/(m^3 s)]", Source::rounding, of_sum);
    Quantity& force =
        probe.quantity("(6) over all pairs against 50 digits [N/m^3]", Source::rounding, of_sum);
    Quantity& viscosity =
        probe.quantity("(7) over all pairs against 50 digits [N/m^3]", Source::rounding, of_sum);
    Quantity& acceleration = probe.quantity("acceleration of (3) over all pairs against 50 digits [m/s^2]",
                                            Source::rounding, of_sum);
    Quantity& factor =
        probe.quantity("DFSPH factor over all pairs against 50 digits [m^8/kg^2]", Source::rounding, of_sum);
    Quantity& ahead =
        probe.quantity("(5) after all have moved against 50 digits [kg/m^3]", Source::rounding, of_sum);
    Quantity& mean = probe.quantity("Shepard's mean against 50 digits [Pa]", Source::rounding, of_sum);
    Quantity& no_slip =
        probe.quantity("no-slip velocity of a ghost against 50 digits [m/s]", Source::rounding, of_sum);
    Quantity& outlet =
        probe.quantity("(26) over all pairs against 50 digits [N/m^3]", Source::rounding, of_sum);
    Quantity& neighbors =
        probe.quantity("particles within the support", Source::exact, "integers: distances differ from 2 h");
    const auto vectors = [](Quantity& q, const VectorEstimate& value, const VectorEstimate& expected,
                            const std::string& where) {
        q.within(to_vec3(value.value), to_vec3(expected.value), value.error + expected.error, where);
    };
    const auto numbers = [](Quantity& q, const Estimate& value, const Estimate& expected,
                            const std::string& where) {
        q.within(value.value, expected.value, value.error + expected.error, where);
    };
    constexpr double mu = 3.5;
    constexpr double rho_0 = 1050;
    constexpr double time = 0x1p-7; // so that none leaves the support in it
    for (const KernelName kernel : both_kernels) {
        for (const auto& [ratio, given] :
             {std::pair{1.0, analytic::Given::mirrors}, std::pair{1.2, analytic::Given::at_rest}}) {
            Cloud c = cloud_of(kernel, ratio);
            c.given = given;
            std::vector<Vector3d> way;
            for (const Vector3d& v : c.velocity) {
                way.emplace_back(time * v);
            }
            for (std::size_t i = 1; i < c.position.size(); i += 13) {
                const analytic::ExactPairs exact = exact_pairs(c, mu, rho_0, time, i);
                const std::string where =
                    kernel_text(kernel) + at({{"h/dx", ratio}}) + ", particle " + std::to_string(i);
                numbers(density, pair_density(c, i), exact.density, where);
                numbers(ahead, pair_density_ahead(c, way, i), exact.density_ahead, where);
                numbers(mean, pair_mean(c, c.pressure, i), exact.mean, where);
                numbers(rate, pair_density_rate(c, i), exact.density_rate, where);
                vectors(force, pair_pressure_force(c, i), exact.pressure_force, where);
                vectors(viscosity, pair_viscosity_force(c, mu, i), exact.viscosity_force, where);
                vectors(no_slip, pair_no_slip_velocity(c, i), exact.no_slip_velocity, where);
                vectors(outlet, pair_outlet_force(c, rho_0, rho_0 / 2, i), exact.outlet_force, where);
                vectors(acceleration, pair_pressure_acceleration(c, rho_0, i), exact.pressure_acceleration,
                        where);
                numbers(factor, pair_dfsph_factor(c, i), exact.dfsph_factor, where);
                neighbors.equal(static_cast<std::int64_t>(pair_neighbors(c, i).size()),
                                static_cast<std::int64_t>(exact.neighbors), where);
            }
        }
    }
}

} // namespace

std::vector<Check> oracle_pairs_checks()
{
    return {oracle_check("oracle_pairs", Level::lattice, {"2", "3", "5", "6", "7", "26", "27"},
                         "the sums over all pairs of a cloud are those of 50 digits, within their own bounds",
                         {"pair sums in double", "terms from the kernels' definitions, added with 50 digits"},
                         pairs)};
}

} // namespace aneurysm::checks
