// SPDX-License-Identifier: Apache-2.0
// The oracles of rows of the lattice, (2), (3), (5) and (7), against lattice sums and against sums over all pairs.
#include "analytic/kernel_function.hpp"
#include "analytic/lattice/lattice_rows.hpp"
#include "analytic/lattice/pair_sums.hpp"
#include "verification/checks/checks.hpp"

#include <cmath>

namespace aneurysm::checks
{
namespace
{

using analytic::Lattice;

constexpr double rho_0 = 1050; ///< [kg/m^3]

Lattice lattice(double ratio, double dx)
{
    return {KernelName::cubic_spline, ratio * dx, dx};
}

/// What a shear flow feels on the resting lattice.
void shear_viscosity(Probe& probe)
{
    Quantity& frozen =
        probe.quantity("nu_eff/nu of the resting lattice, moment - symbol [1]", Source::truncation,
                       "|L(k)/k^2 - limit| <= k^2/24 V sum x^4 lap W <= k^2 H^2 nu_eff/(4 nu), and the "
                       "rounding of both");
    for (const double ratio : {1.0, 1.3, 2.0}) {
        const Lattice l = lattice(ratio, 1);
        const double k = 1e-3;
        const auto V = 1 / analytic::kernel_sum(l).value;
        const auto L = analytic::viscosity_sum(l, {0, k, 0});
        const auto limit = analytic::viscosity_ratio(l);
        frozen.within(L.value * V / (k * k), limit.value,
                      k * k * l.h * l.h * limit.value + limit.error + 2 * L.error * V / (k * k),
                      "h/dx " + std::to_string(ratio));
    }
}

/// Rows of a cube between walls of ghosts, with pressures and velocities by row.
analytic::Cloud rows_as_cloud(const analytic::RowColumn& column, const analytic::RowPressure& solved)
{
    const Lattice& l = column.lattice;
    const int edge = column.rows + 6; // the walls are six planes of ghosts between one side and the other
    analytic::Cloud cloud{l.kernel, l.h, edge * l.dx, {}, {}, {}, {}, {}, {}};
    for (int j = 0; j < edge; ++j) {
        const bool free = j < column.rows;
        for (int n = 0; n < edge * edge; ++n) {
            const int k = n / edge;
            cloud.position.emplace_back(l.dx * Eigen::Vector3d(n % edge, j, k));
            cloud.velocity.emplace_back(0, free ? solved.velocity(j) : 0, 0);
            cloud.mass.push_back(column.rho_0 / analytic::kernel_sum(l).value);
            cloud.density.push_back(column.rho_0);
            cloud.pressure.push_back(free ? solved.pressure(j) : 0);
            cloud.free.push_back(free);
        }
    }
    return cloud;
}

void pressed_rows(Probe& probe)
{
    Quantity& velocity =
        probe.quantity("v + dt a(p) of the rows, row matrix - all pairs [m/s]", Source::rounding,
                       "bounds of the pair sums' rounding, and of the row solution");
    Quantity& rate = probe.quantity("Drho/Dt, all pairs [kg/(m^3 s)]", Source::rounding,
                                    "bound of the pair sum's rounding, and of the row solution's residual");
    Quantity& neutral = probe.quantity("a(p) of a pressure that is the same in all rows, all pairs [m/s^2]",
                                       Source::rounding, "bound of the pair sum's rounding");
    const double dt = 1e-3;
    const double falling = -9.81 * dt;
    for (const double ratio : {1.0, 1.3}) {
        for (const int rows : {7, 8}) {
            const analytic::RowColumn column{lattice(ratio, 1.0 / 64), rho_0, rows};
            const analytic::RowPressure solved = analytic::row_pressure(column, falling, dt);
            const analytic::Cloud cloud = rows_as_cloud(column, solved);
            analytic::Cloud uniform = cloud;
            uniform.pressure.assign(cloud.pressure.size(), 1000);
            const auto edge = static_cast<std::size_t>(rows) + 6;
            const std::string where = std::to_string(rows) + " rows, h/dx " + std::to_string(ratio);
            for (int j = 0; j < rows; ++j) {
                const std::size_t i = static_cast<std::size_t>(j) * edge * edge;
                const auto a = analytic::pair_pressure_acceleration(cloud, rho_0, i);
                const auto D = analytic::pair_density_rate(cloud, i);
                velocity.within(falling + dt * a.value(1), solved.velocity(j),
                                dt * a.error + solved.velocity_error, where);
                rate.within(D.value, 0,
                            D.error + solved.pressure_error / solved.pressure_per_residual * rho_0, where);
                const auto of_uniform = analytic::pair_pressure_acceleration(uniform, rho_0, i);
                neutral.within(of_uniform.value(1), 0, of_uniform.error, where);
            }
            probe.note("null modes of the pressures, " + where, solved.null_modes);
            probe.note("velocity left to the lowest row, " + where + " [g dt]", solved.velocity(0) / falling,
                       "0 where an even number of rows can be held");
        }
    }
}

} // namespace

std::vector<Check> oracle_rows_checks()
{
    return {
        oracle_check("oracle_shear_viscosity", Level::lattice, {"7"},
                     "the viscosity that a shear flow feels on the lattice is its symbol's limit",
                     {"row sums", "lattice sums"}, shear_viscosity),
        oracle_check("oracle_pressed_rows", Level::lattice, {"2", "3"}, "the pressures of rows solve (3)",
                     {"row matrix", "sums over all pairs"}, pressed_rows),
    };
}

} // namespace aneurysm::checks
