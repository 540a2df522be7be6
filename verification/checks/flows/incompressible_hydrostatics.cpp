// SPDX-License-Identifier: Apache-2.0
// Blood between two plates under its own weight (1), on the lattice: the solve of (3) for rows.
#include "analytic/lattice/lattice_rows.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"

#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

void rows(Probe& probe)
{
    const double u = probe.roundoff();
    Quantity& pressure = probe.quantity(
        "pressure of each row [Pa]", Source::solver,
        "the residual that the solve leaves times the pressure that a unit of it allows, the oracle's bound, "
        "and gamma_80 of the largest pressure times the condition of the rows' matrix (docs/bounds.md, B7)");
    Quantity& velocity = probe.quantity("velocity of each row after the first step [m/s]", Source::solver,
                                        "the residual that the solve leaves times the velocity that a unit "
                                        "of it allows, the oracle's bound, and gamma_80 of g dt and of what "
                                        "the pressures make of it (docs/bounds.md, B7)");
    Scenario s = shipped_scenario("verify_hydrostatic");
    if (u > 1e-10) { // single precision can't reach the scenario's tolerance
        s.pressure.tolerance_per_s = 1e-3;
        s.pressure.max_tolerance_per_s = 1e-2;
    }
    const double dx = s.domain.spacing_m;
    const double dt = s.time.frame_s;
    const auto n = static_cast<int>(s.domain.cells_y);
    const double v_0 = dt * s.fluid.gravity_m_s2.y;
    const analytic::Lattice lattice{s.kernel.function, s.kernel.smoothing_length_spacings * dx, dx};
    const auto expected = analytic::row_pressure({lattice, s.fluid.density_kg_m3, n}, v_0, dt);
    const auto flow = probe.simulate(s);
    const FrameRecord r = flow->advance();
    const double largest = expected.pressure.cwiseAbs().maxCoeff();
    const double rounded =
        probe.gamma(80) * largest * dt / (s.fluid.density_kg_m3 * dx) + probe.gamma(80) * std::abs(v_0);
    const double residual = r.residual_max + rounded / dx;
    const Particles& p = flow->state().particles;
    Plot plot{"Pressure of blood between two plates", "height / H", "pressure [Pa]", false, false, {}};
    Series found{"found", {}, {}, false};
    Series predicted{"rows of the lattice", {}, {}, true};
    Series linear{"rho g (H - y)", {}, {}, true};
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto row = static_cast<Eigen::Index>((static_cast<std::int64_t>(i) / s.domain.cells_x) % n);
        const std::string where = "row " + std::to_string(row + 1);
        pressure.within(flow->solved_pressure()[i], expected.pressure(row),
                        expected.pressure_per_residual * residual + expected.pressure_error, where);
        velocity.within(p.velocity[i], {0, expected.velocity(row), 0},
                        expected.velocity_per_residual * residual + expected.velocity_error + rounded, where);
        if (i % static_cast<std::size_t>(s.domain.cells_x) == 0 &&
            found.x.size() < static_cast<std::size_t>(n)) {
            const double y = (static_cast<double>(row) + 0.5) / n;
            found.x.push_back(y);
            found.y.push_back(flow->solved_pressure()[i]);
            predicted.x.push_back(y);
            predicted.y.push_back(expected.pressure(row));
            linear.x.push_back(y);
            linear.y.push_back(-s.fluid.density_kg_m3 * s.fluid.gravity_m_s2.y * n * dx * (1 - y));
        }
    }
    plot.series = {predicted, linear, found};
    probe.plot(std::move(plot));
    probe.note("pressure changes that move nothing (null modes)", expected.null_modes,
               "with h = dx only next rows couple, so that odd and even rows don't feel each other");
}

} // namespace

std::vector<Check> incompressible_hydrostatics_checks()
{
    return {flow_check("eq03_hydrostatics", {"3", "1", "15"},
                       "blood between two plates finds the pressures that its rows need against their weight",
                       {"non-negative least squares of the rows' matrix (Lawson and Hanson)"}, rows)};
}

} // namespace aneurysm::checks
