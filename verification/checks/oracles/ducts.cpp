// SPDX-License-Identifier: Apache-2.0
// The oracles of ducts on the lattice, (5), (7), (15) and (27), against one another and against the exact flows.
#include "analytic/lattice/lattice_duct_steps.hpp"
#include "analytic/lattice/lattice_rows.hpp"
#include "analytic/lattice/pair_sums.hpp"
#include "analytic/lattice/sliding_duct.hpp"
#include "verification/checks/checks.hpp"

#include <cmath>
#include <numbers>

namespace aneurysm::checks
{
namespace
{

using analytic::Drive;
using analytic::DuctModes;
using analytic::DuctOperator;
using analytic::Lattice;
using analytic::LatticeDuct;
using analytic::Profile;
using analytic::SlidingDuct;
using std::numbers::pi;

constexpr double rho_0 = 1050; ///< [kg/m^3]
constexpr double mu = 10.5;    ///< [Pa s]
constexpr double nu = mu / rho_0;
constexpr double width = 0.25; ///< of channel and tube [m]
constexpr double g = 10;       ///< [m/s^2]
constexpr double inset = 0.08; ///< of a tube's columns, in spacings

Lattice lattice(double ratio, double dx)
{
    return {KernelName::cubic_spline, ratio * dx, dx};
}

LatticeDuct channel(double ratio, int rows)
{
    return analytic::lattice_channel(lattice(ratio, width / rows), rho_0, mu, rows);
}

LatticeDuct tube(double ratio, int across)
{
    const double dx = width / across;
    return analytic::lattice_tube(lattice(ratio, dx), rho_0, mu, width / 2, inset * dx);
}

std::string name(const LatticeDuct& duct)
{
    return std::string(duct.layered ? "channel" : "tube") + " of " + std::to_string(duct.size()) +
           " columns, h/dx " + std::to_string(duct.lattice.h / duct.lattice.dx);
}

std::vector<LatticeDuct> ducts()
{
    return {channel(1, 8), channel(1, 32), channel(1.3, 16), channel(2, 24), tube(1, 8), tube(1.3, 12)};
}

/// Component by component.
void agree(Quantity& quantity, const Profile& one, const Profile& other, const std::string& where)
{
    for (Eigen::Index a = 0; a < one.value.size(); ++a) {
        quantity.within(one.value(a), other.value(a), one.error + other.error, where);
    }
}

void symbol_of_the_duct(Probe& probe)
{
    Quantity& quantity =
        probe.quantity("du/dt of a wave in the middle, columns - lattice [1/s]", Source::rounding,
                       "uncertainty of the couplings, and of viscosity_sum, by rounding; 8 u of the wave and "
                       "of each product");
    const double u = rounding(1);
    for (const LatticeDuct& duct :
         {channel(1, 16), channel(1.3, 16), channel(2, 24), tube(1, 12), tube(1.3, 14)}) {
        const DuctOperator A(duct);
        std::size_t middle = 0;
        for (std::size_t b = 0; b < duct.size(); ++b) {
            middle = duct.r(b) < duct.r(middle) ? b : middle;
        }
        for (const double turns : {0.05, 0.2, 0.5}) {
            const Eigen::Vector2d k =
                2 * pi * turns / duct.lattice.dx * Eigen::Vector2d(1, duct.layered ? 0 : 0.5);
            Eigen::VectorXd wave(static_cast<Eigen::Index>(duct.size()));
            for (std::size_t b = 0; b < duct.size(); ++b) {
                wave(static_cast<Eigen::Index>(b)) = std::cos(k.dot(duct.fluid[b].x - duct.fluid[middle].x));
            }
            const double rate = A.matrix().row(static_cast<Eigen::Index>(middle)).dot(wave);
            const auto sum = analytic::viscosity_sum(duct.lattice, {k(0), k(1), 0});
            const double per_sum = nu / analytic::kernel_sum(duct.lattice).value;
            quantity.within(-rate, per_sum * sum.value,
                            A.uncertainty(u, 0).largest_sum(wave) + per_sum * sum.error +
                                (8 + static_cast<double>(wave.size())) * u *
                                    A.matrix().row(static_cast<Eigen::Index>(middle)).cwiseAbs().sum(),
                            name(duct));
        }
    }
}

void steady_ducts(Probe& probe)
{
    Quantity& quantity =
        probe.quantity("u, LU by GSL - LDL^T by Eigen [m/s]", Source::solver,
                       "what A u + g differs from 0, times the bound of the row sums of |A^-1| "
                       "(-A is an M-matrix), for each");
    Quantity& parabola = probe.quantity("u with h = dx, LU - parabola [m/s]", Source::rounding,
                                        "the residual as above; all couplings are one number, whose relative "
                                        "uncertainty, and that of nu_eff, is u's");
    for (const LatticeDuct& duct : ducts()) {
        const DuctOperator A(duct);
        const Profile steady = analytic::steady_flow(A, g);
        agree(quantity, steady, analytic::steady_flow_by_ldlt(A, g), name(duct));
        if (duct.layered && duct.lattice.h == duct.lattice.dx) {
            // only next rows couple, and the wall's first row is at rest: it is the parabola's zero
            const double ratio = analytic::viscosity_ratio(duct.lattice).value;
            const double zero = width / 2 + duct.lattice.dx / 2;
            const double text = A.uncertainty(rounding(1), 0).between(0, 1) / A.matrix()(0, 1);
            for (std::size_t a = 0; a < duct.size(); ++a) {
                const double r = duct.r(a);
                parabola.within(steady.value(static_cast<Eigen::Index>(a)),
                                g / (2 * nu * ratio) * (zero - r) * (zero + r), steady.error + 2 * text,
                                name(duct));
            }
        }
    }
}

void stepped_ducts(Probe& probe)
{
    Quantity& quantity =
        probe.quantity("u after n steps, modes in closed form - step by step [m/s]", Source::rounding,
                       "rounding of the amplitudes; |A v + lambda v| of the modes times their "
                       "amplitudes and |1 - sum b v| times g, times what a disturbance lasts; n "
                       "roundings in long double");
    for (const LatticeDuct& duct : ducts()) {
        const DuctOperator A(duct);
        const DuctModes modes(A);
        for (const double alpha : {0.0, 2.0, 8.0}) {
            const Drive drive{g, alpha * alpha * nu / (width * width / 4)};
            for (const double part : {0.02, 0.2}) {
                const double dt = part * modes.largest_step();
                for (const int n : {1, 7, 400}) {
                    agree(quantity, modes.after(drive, dt, n), analytic::step_by_step(A, drive, dt, n),
                          name(duct) + ", alpha " + std::to_string(alpha) + ", step " + std::to_string(n));
                }
            }
        }
    }
    Quantity& slip = probe.quantity("u after n steps with slip, modes - sum of the forces [m/s]",
                                    Source::rounding, "as above; n roundings of the sum");
    LatticeDuct free = channel(1, 8);
    free.no_slip = false;
    const DuctModes modes{DuctOperator(free)};
    const Drive drive{g, 2 * pi / 0.8};
    const double dt = 1e-3;
    double sum = 0;
    for (int n = 1; n <= 300; ++n) {
        sum += dt * g * std::sin(drive.omega * n * dt);
    }
    const Profile swung = modes.after(drive, dt, 300);
    for (Eigen::Index a = 0; a < swung.value.size(); ++a) {
        slip.within(swung.value(a), sum, swung.error + rounding(308) * sum);
    }
}

/// The rows of a channel in a cube, between walls of six planes of ghosts from one side to the other.
analytic::Cloud rows_as_cloud(const LatticeDuct& duct, const SlidingDuct& sliding)
{
    const int rows = static_cast<int>(duct.size());
    const int edge = rows + 6;
    const double dx = duct.lattice.dx;
    const Eigen::VectorXd rho = sliding.density();
    analytic::Cloud cloud{duct.lattice.kernel, duct.lattice.h, edge * dx, {}, {}, {}, {}, {}, {}};
    for (int j = 0; j < edge; ++j) {
        const bool free = j < rows;
        for (int n = 0; n < edge * edge; ++n) {
            const int k = n / edge;
            cloud.position.emplace_back(dx * (n % edge) + (free ? sliding.slid()(j) : 0), j * dx, k * dx);
            cloud.velocity.emplace_back(free ? sliding.velocity()(j) : 0, 0, 0);
            cloud.density.push_back(free ? rho(j) : rho_0);
        }
    }
    cloud.mass.assign(cloud.position.size(), duct.mass());
    cloud.pressure.assign(cloud.position.size(), 0);
    cloud.free.assign(cloud.position.size(), true);
    return cloud;
}

void slid_ducts(Probe& probe)
{
    Quantity& slow =
        probe.quantity("u of a flow that moves nothing, sliding - frozen columns [m/s / g]", Source::rounding,
                       "the sliding duct's bound for another text in double, and the frozen one's own");
    for (const LatticeDuct& duct : {channel(1, 8), channel(1.3, 12), tube(1, 8)}) {
        constexpr double weak = 0x1p-60;
        const DuctOperator A(duct);
        const Drive drive{weak, 20};
        const double dt = 0.1 * DuctModes(A).largest_step();
        SlidingDuct sliding(duct);
        for (int n = 1; n <= 40; ++n) {
            sliding.step(drive, dt);
        }
        const Profile frozen = analytic::step_by_step(A, drive, dt, 40);
        agree(slow, {sliding.velocity() / weak, sliding.error(rounding(1), width) / weak},
              {frozen.value / weak, frozen.error / weak}, name(duct));
    }
    Quantity& density = probe.quantity("rho of rows that have slid, columns - all pairs [kg/m^3]",
                                       Source::rounding, "bound of the pair sum's rounding, twice");
    Quantity& force =
        probe.quantity("change of u of rows that have slid, columns - all pairs [m/s]", Source::rounding,
                       "bound of the pair sums' rounding, twice, and of the last step's");
    const LatticeDuct duct = channel(1, 6);
    const Drive drive{g, 0};
    constexpr double dt = 2e-3;
    SlidingDuct sliding(duct);
    for (int n = 0; n < 60; ++n) {
        sliding.step(drive, dt);
    }
    const analytic::Cloud cloud = rows_as_cloud(duct, sliding);
    const Eigen::VectorXd before = sliding.velocity();
    const Eigen::VectorXd rho = sliding.density();
    sliding.step(drive, dt);
    for (std::size_t a = 0; a < duct.size(); ++a) {
        const auto row = static_cast<Eigen::Index>(a);
        const std::size_t i = a * (duct.size() + 6) * (duct.size() + 6);
        const auto rho_a = analytic::pair_density(cloud, i);
        density.within(rho(row), rho_a.value, 2 * rho_a.error, std::to_string(a));
        const auto F = analytic::pair_viscosity_force(cloud, mu, i);
        const double change = dt * (F.value(0) / rho_a.value + g);
        const double relative = rho_a.error / rho_a.value; // of each of two densities
        force.within(sliding.velocity()(row) - before(row), change,
                     dt / rho_a.value * (2 * F.error + 4 * relative * std::abs(F.value(0))) +
                         rounding(8) * (std::abs(change) + std::abs(before(row))),
                     std::to_string(a));
    }
}

/// (2 nu_eff/g) u + y^2 of the steady flow in a row next to the middle: the square of where it would be 0.
double squared_zero(const LatticeDuct& duct, double& error)
{
    const DuctOperator A(duct);
    const Profile steady = analytic::steady_flow(A, g);
    const std::size_t middle = duct.size() / 2;
    const double factor = 2 * nu / g * analytic::viscosity_ratio(duct.lattice).value;
    const double velocity = steady.value(static_cast<Eigen::Index>(middle));
    error = factor *
            (steady.error + 2 * A.uncertainty(rounding(1), 0).largest_sum(steady.value) * A.time_scale());
    return factor * velocity + duct.r(middle) * duct.r(middle);
}

void convergence(Probe& probe)
{
    Quantity& limit =
        probe.quantity("square of the zero of the steady profile, lattice -> wall [a^2]", Source::truncation,
                       "three resolutions give the limit of the rows' parabola: their errors times the "
                       "weights, and wall_layer_ratio^rows (docs/bounds.md, B21)");
    for (const double ratio : {1.0, 1.3, 2.0}) {
        const std::array<int, 3> rows{32, 64, 128};
        std::array<double, 3> C{};
        double error = 0;
        // the parabola through 1/rows = x, 2x and 4x at 0 has the weights 8/3, -2 and 1/3
        constexpr std::array<double, 3> weights{1.0 / 3, -2, 8.0 / 3};
        double at_0 = 0;
        const double layer = std::pow(analytic::wall_layer_ratio(lattice(ratio, 1)), rows[0] / 2.0);
        for (std::size_t i = 0; i < 3; ++i) {
            double of_C = 0;
            C.at(i) = squared_zero(channel(ratio, rows.at(i)), of_C);
            error += std::abs(weights.at(i)) * (of_C + layer * C.at(i));
            at_0 += weights.at(i) * C.at(i);
        }
        const double square = width * width / 4;
        limit.within(at_0 / square, 1, error / square, "h/dx " + std::to_string(ratio));
        // C - a^2 is linear in 1/rows but for a square
        const double displacement = (4 * (C[2] - square) * rows[2] - 2 * (C[1] - square) * rows[1]) / 2;
        probe.note("displacement of a resting wall, h/dx " + std::to_string(ratio) + " [dx]",
                   displacement / (width * width));
        probe.note("observed order from 64 to 128 rows, nu_eff taken out, h/dx " + std::to_string(ratio),
                   std::log2((C[1] - square) / (C[2] - square)));
        probe.note("nu_eff/nu - 1, h/dx " + std::to_string(ratio),
                   analytic::viscosity_ratio(lattice(ratio, 1)).value - 1);
    }
}

} // namespace

std::vector<Check> oracle_ducts_checks()
{
    return {
        oracle_check("oracle_duct_symbol", Level::lattice, {"7", "15"},
                     "columns of a duct have the lattice's symbol",
                     {"sums by columns", "sums over the lattice"}, symbol_of_the_duct),
        oracle_check(
            "oracle_duct_steady", Level::lattice, {"7", "15", "27"},
            "the steady flow of a duct on the lattice is the same by two decompositions, and the parabola "
            "for h = dx",
            {"gsl_linalg_LU", "Eigen LDL^T", "closed form"}, steady_ducts),
        oracle_check("oracle_duct_steps", Level::transient, {"7", "15", "27"},
                     "steps on the lattice are the same in closed form and one by one",
                     {"gsl_eigen_symmv", "long double"}, stepped_ducts),
        oracle_check("oracle_duct_slides", Level::transient, {"5", "7", "15", "27"},
                     "columns that slide have the frozen ones' flow, and the sums over all pairs",
                     {"sliding columns", "frozen columns", "sums over all pairs"}, slid_ducts),
        oracle_check("oracle_duct_limit", Level::continuous, {"7", "15", "27"},
                     "the steady flow on the lattice tends to Poiseuille's", {"lattice", "Poiseuille"},
                     convergence),
    };
}

} // namespace aneurysm::checks
