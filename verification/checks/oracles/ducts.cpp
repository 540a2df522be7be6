// SPDX-License-Identifier: Apache-2.0
// The oracles of ducts on the lattice, (5), (7), (15) and (27), against one another and against the exact flows.
#include "analytic/lattice/lattice_duct_steps.hpp"
#include "analytic/lattice/lattice_rows.hpp"
#include "analytic/lattice/pair_sums.hpp"
#include "verification/checks/checks.hpp"

#include <cmath>
#include <numbers>

namespace aneurysm::checks
{
namespace
{

using analytic::Drive;
using analytic::DuctOperator;
using analytic::Lattice;
using analytic::LatticeDuct;
using analytic::Profile;
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
        probe.quantity("u, LU by GSL - QR by Eigen [m/s]", Source::solver,
                       "what A u + g differs from 0, times the bound of the row sums of |A^-1|, for each");
    Quantity& parabola = probe.quantity("u with h = dx, LU - parabola [m/s]", Source::rounding,
                                        "the residual as above; all couplings are one number, whose relative "
                                        "uncertainty, and that of nu_eff, is u's");
    for (const LatticeDuct& duct : ducts()) {
        const DuctOperator A(duct);
        const Profile steady = analytic::steady_flow(A, g);
        agree(quantity, steady, analytic::steady_flow_by_qr(A, g), name(duct));
        if (duct.layered && duct.lattice.h == duct.lattice.dx) {
            // only next rows couple, and the wall's first row has the opposite velocity of the blood's: the
            // parabola's values at width/2 +- dx/2 add up to 0
            const double ratio = analytic::viscosity_ratio(duct.lattice).value;
            const double zero = std::hypot(width / 2, duct.lattice.dx / 2);
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
        probe.quantity("u after n steps, by powers of the matrix - step by step [m/s]", Source::rounding,
                       "n roundings of sums over all columns in long double, for each");
    for (const LatticeDuct& duct : ducts()) {
        const DuctOperator A(duct);
        for (const double part : {0.02, 0.2}) {
            const double dt = part * largest_step(A);
            for (const int n : {1, 7, 400}) {
                agree(quantity, step_by_powers(A, g, dt, n), step_by_step(A, {g, 0}, dt, n),
                      name(duct) + ", step " + std::to_string(n));
            }
        }
    }
}

/// The rows of a channel in a cube, between walls of six planes of ghosts from one side to the other.
analytic::Cloud rows_as_cloud(const LatticeDuct& duct, const DuctOperator& A, const Eigen::VectorXd& velocity)
{
    const int rows = static_cast<int>(duct.size());
    const int edge = rows + 6;
    const double dx = duct.lattice.dx;
    analytic::Cloud cloud{duct.lattice.kernel, duct.lattice.h, edge * dx, {}, {}, {}, {}, {}, {}};
    for (int j = 0; j < edge; ++j) {
        const bool free = j < rows;
        for (int n = 0; n < edge * edge; ++n) {
            const int k = n / edge;
            cloud.position.emplace_back(dx * (n % edge), j * dx, k * dx);
            cloud.velocity.emplace_back(free ? velocity(j) : 0, 0, 0);
            cloud.density.push_back(free ? A.density()(j) : rho_0);
            cloud.free.push_back(free);
        }
    }
    cloud.mass.assign(cloud.position.size(), duct.mass());
    cloud.pressure.assign(cloud.position.size(), 0);
    return cloud;
}

void pairs_of_the_duct(Probe& probe)
{
    Quantity& force =
        probe.quantity("du/dt of rows without the force, columns - all pairs [m/s^2]", Source::rounding,
                       "the pair sums' bounds for (7) and the ghosts' velocities, and the couplings' "
                       "uncertainty");
    const LatticeDuct duct = channel(1, 6);
    const DuctOperator A(duct);
    Eigen::VectorXd velocity(6);
    velocity << 0.3, -0.7, 1.1, 0.9, -0.2, 0.5;
    analytic::Cloud cloud = rows_as_cloud(duct, A, velocity);
    const int plane = 12 * 12;
    double of_ghosts = 0;
    for (std::size_t row = 6; row < 12; ++row) {
        const auto v = analytic::pair_no_slip_velocity(cloud, row * plane);
        of_ghosts = std::max(of_ghosts, v.error);
        std::fill_n(cloud.velocity.begin() + static_cast<std::ptrdiff_t>(row * plane), plane, v.value);
    }
    const Eigen::VectorXd rate = A.matrix() * velocity;
    const double couplings = A.uncertainty(rounding(1), 0).largest_sum(velocity);
    for (std::size_t a = 0; a < duct.size(); ++a) {
        const auto row = static_cast<Eigen::Index>(a);
        const auto F = analytic::pair_viscosity_force(cloud, mu, a * plane);
        const double rho = A.density()(row);
        force.within(rate(row), F.value(0) / rho,
                     F.error / rho + couplings + of_ghosts * A.matrix().cwiseAbs().maxCoeff(),
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
        probe.note("zero of the profile beyond the wall at 32 rows, h/dx " + std::to_string(ratio) + " [dx]",
                   (std::sqrt(C[0]) - width / 2) * rows[0] / width);
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
            {"gsl_linalg_LU", "Eigen QR", "closed form"}, steady_ducts),
        oracle_check("oracle_duct_steps", Level::transient, {"7", "15", "27"},
                     "steps on the lattice are the same by powers of the matrix and one by one",
                     {"powers by doubling", "long double"}, stepped_ducts),
        oracle_check("oracle_duct_pairs", Level::lattice, {"7", "27"},
                     "the matrix of a duct is the sum over all pairs", {"columns", "sums over all pairs"},
                     pairs_of_the_duct),
        oracle_check("oracle_duct_limit", Level::continuous, {"7", "15", "27"},
                     "the steady flow on the lattice tends to Poiseuille's", {"lattice", "Poiseuille"},
                     convergence),
    };
}

} // namespace aneurysm::checks
