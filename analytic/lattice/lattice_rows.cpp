// SPDX-License-Identifier: Apache-2.0
#include "analytic/lattice/lattice_rows.hpp"

#include "analytic/kernel_function.hpp"

#include <gsl/gsl_poly.h>

#include <numbers>
#include <vector>

namespace aneurysm::analytic
{
namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

double viscosity_kernel(const Lattice& l, double r)
{
    const double H = 2 * l.h;
    return r > 0 ? viscosity_kernel_laplacian(H, r) : 45 / (pi * std::pow(H, 5));
}

/// Sum over row n, slid by s, of f(x, y, z) within the support; `terms` counts them.
template <class F>
double row_sum(const Lattice& l, int n, double s, F f, int* terms = nullptr)
{
    const int reach = static_cast<int>(std::ceil(2 * l.h / l.dx)) + 1;
    const double y = n * l.dx;
    double sum = 0;
    for (int i = -reach; i <= reach; ++i) {
        for (int k = -reach; k <= reach; ++k) {
            const double r = std::hypot(i * l.dx + s, y, k * l.dx);
            if (r <= 2 * l.h) {
                sum += f(r, y);
                if (terms != nullptr) {
                    ++*terms;
                }
            }
        }
    }
    return sum;
}

int rows_within_reach(const Lattice& l)
{
    return static_cast<int>(std::floor(2 * l.h / l.dx));
}

double volume(const Lattice& l)
{
    return 1 / kernel_sum(l).value;
}

/// C of row_pressure().
MatrixXd row_matrix(const RowColumn& column)
{
    const Lattice& l = column.lattice;
    MatrixXd C = MatrixXd::Zero(column.rows, column.rows);
    for (int n = 1; n <= std::min(rows_within_reach(l), column.rows - 1); ++n) {
        const double gamma =
            row_sum(l, n, 0, [&](double r, double y) { return -y / r * kernel_slope(l.kernel, l.h, r); });
        C.diagonal(n).setConstant(gamma);
        C.diagonal(-n).setConstant(-gamma);
    }
    C.diagonal() = -C.rowwise().sum();
    return C;
}

/// Largest row sum of magnitudes.
double norm(const MatrixXd& M)
{
    return M.size() > 0 ? M.cwiseAbs().rowwise().sum().maxCoeff() : 0;
}

} // namespace

Estimate viscosity_ratio(const Lattice& l)
{
    double sum = 0;
    double terms = 0;
    for (int n = -rows_within_reach(l); n <= rows_within_reach(l); ++n) {
        int here = 0;
        sum += row_sum(
            l, n, 0, [&](double r, double) { return r * r * viscosity_kernel(l, r); }, &here);
        terms += here;
    }
    const Estimate density = kernel_sum(l);
    const double ratio = sum / (6 * density.value);
    // 16 u of the largest term: r^2 lap W is at most H^2 times lap W at 0
    const double largest = 4 * l.h * l.h * viscosity_kernel(l, 0) / (6 * density.value);
    return {ratio, ratio * (density.error / density.value + (terms + 40) * u) + 16 * terms * u * largest};
}

double wall_layer_ratio(const Lattice& l)
{
    // (z^n + z^-n - 2) z/(z - 1)^2 = sum_{|k| < n} (n - |k|) z^k
    const int m = rows_within_reach(l);
    std::vector<double> coefficients(static_cast<std::size_t>(2 * m - 1), 0);
    for (int n = 1; n <= m; ++n) {
        const double S = row_sum(l, n, 0, [&](double r, double) { return viscosity_kernel(l, r); });
        for (int k = 1 - n; k < n; ++k) {
            coefficients.at(static_cast<std::size_t>(m + k) - 1) += (n - std::abs(k)) * S;
        }
    }
    while (coefficients.size() > 1 && coefficients.back() < 64 * u * coefficients[coefficients.size() / 2]) {
        coefficients = {coefficients.begin() + 1, coefficients.end() - 1}; // a row at the support's end
    }
    if (coefficients.size() == 1) {
        return 0;
    }
    gsl_return_errors();
    const std::size_t n = coefficients.size();
    const Owned<gsl_poly_complex_workspace, gsl_poly_complex_workspace_free> work(
        gsl_poly_complex_workspace_alloc(n));
    std::vector<double> z(2 * (n - 1));
    gsl_check(gsl_poly_complex_solve(coefficients.data(), n, work.get(), z.data()), "roots of a polynomial");
    double largest = 0;
    for (std::size_t root = 0; root + 1 < n; ++root) {
        const double size = std::hypot(z[2 * root], z[2 * root + 1]);
        largest = size < 1 ? std::max(largest, size) : largest;
    }
    return largest;
}

RowPressure row_pressure(const RowColumn& column, double v, double dt)
{
    const double m = column.rho_0 * volume(column.lattice);
    const double per_pressure = dt * m / (column.rho_0 * column.rho_0);
    const MatrixXd C = row_matrix(column);
    const Eigen::CompleteOrthogonalDecomposition<MatrixXd> solver(C);
    const MatrixXd inverse = solver.pseudoInverse();
    const VectorXd start = VectorXd::Constant(column.rows, v);

    RowPressure result;
    result.pressure = inverse * start / per_pressure;
    result.velocity = start - per_pressure * C * result.pressure;
    result.rate = m * C.transpose() * result.velocity;
    result.null_modes = static_cast<int>(column.rows - solver.rank());
    result.pressure_per_residual = norm(inverse * inverse.transpose()) * column.rho_0 / (per_pressure * m);
    result.velocity_per_residual = norm(inverse.transpose()) * column.rho_0 / m;
    // the rounding of the residual: at most 2 rows + 64 operations on each term
    const double size = std::abs(v) + per_pressure * norm(C) * result.pressure.cwiseAbs().maxCoeff();
    const double off =
        (result.rate.cwiseAbs().maxCoeff() + (2 * column.rows + 64) * u * m * norm(C.transpose()) * size) /
        column.rho_0;
    result.pressure_error = result.pressure_per_residual * off;
    result.velocity_error = result.velocity_per_residual * off + 8 * u * std::abs(v);
    return result;
}

} // namespace aneurysm::analytic
