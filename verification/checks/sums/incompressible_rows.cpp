// SPDX-License-Identifier: Apache-2.0
// Section 3.1, (3): the pressures of rows of the lattice between two plates, under their own weight (1).
#include "analytic/lattice/lattice_rows.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/sums/plates.hpp"

#include <cmath>
#include <numeric>
#include <string>

namespace aneurysm::checks
{
namespace
{

void rows(Probe& probe)
{
    Quantity& pressure = probe.quantity(
        "pressure of each row over the mean of all [Pa]", Source::solver,
        "the residuals that the solve leaves times the pressure that a unit of them allows, the oracle's bound, and "
        "gamma_80 of the largest pressure times the condition of the rows' matrix (docs/bounds.md, B7)");
    Quantity& velocity =
        probe.quantity("velocity of each row after the step [m/s]", Source::solver,
                       "the residuals that the solve leaves times the velocity that a unit of them "
                       "allows, the oracle's bound, and gamma_80 of g dt and of what the pressures "
                       "make of it (docs/bounds.md, B7)");
    for (const int count : {7, 8}) {
        Scenario s = plates(count);
        s.fluid.viscosity_pa_s = 0;
        s.fluid.gravity_m_s2 = {0, -9.81, 0};
        s.pressure.tolerance_per_s =
            probe.roundoff() > 1e-10 ? 1e-3 : 1e-8; // single precision can't reach the latter
        s.pressure.max_tolerance_per_s = 10 * s.pressure.tolerance_per_s;
        const double dt = s.time.frame_s;
        const double dx = s.domain.spacing_m;
        const double rho_0 = s.fluid.density_kg_m3;
        const double v_0 = dt * s.fluid.gravity_m_s2.y;
        const analytic::Lattice lattice{s.kernel.function, dx, dx};
        const auto expected = analytic::row_pressure({lattice, rho_0, count}, v_0, dt);
        const auto flow = probe.simulate(s);
        const FrameRecord record = flow->advance();
        const std::vector<double>& found = flow->solved_pressure();
        const auto n = static_cast<double>(found.size());
        const double mean = std::accumulate(found.begin(), found.end(), 0.0) / n;
        double largest = 0;
        for (const double p : found) {
            largest = std::max(largest, std::abs(p));
        }
        const double rounded = probe.gamma(80) * (largest * dt / (rho_0 * dx) + std::abs(v_0));
        // those at the bound don't count in the record; the sum of all is 0
        const double residual = count * record.residual_max + rounded / dx;
        for (std::size_t i = 0; i < found.size(); ++i) {
            const auto row = static_cast<Eigen::Index>((static_cast<std::int64_t>(i) / s.domain.cells_x) %
                                                       s.domain.cells_y);
            const std::string where = std::to_string(count) + " rows, row " + std::to_string(row + 1);
            pressure.within(found[i] - mean, expected.pressure(row),
                            expected.pressure_per_residual * residual + expected.pressure_error, where);
            velocity.within(flow->state().particles.velocity[i], {0, expected.velocity(row), 0},
                            expected.velocity_per_residual * residual + expected.velocity_error + rounded,
                            where);
        }
    }
}

} // namespace

std::vector<Check> incompressible_rows_checks()
{
    return {
        sum_check("eq03_hydrostatics", {"3", "1"},
                  "rows between plates carry their weight, by pressures that an even number of them can have",
                  {"row matrix, least squares"}, rows)};
}

} // namespace aneurysm::checks
