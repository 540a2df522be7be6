// SPDX-License-Identifier: Apache-2.0
#include "analytic/lattice/lattice_duct.hpp"

#include <gsl/gsl_linalg.h>

namespace aneurysm::analytic
{
namespace
{

using Eigen::VectorXd;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// Largest |g + A u| over all rows.
double residual(const Eigen::MatrixXd& A, const VectorXd& velocity, double g)
{
    const LongVector r = A.cast<long double>() * velocity.cast<long double>();
    return static_cast<double>((r.array() + static_cast<long double>(g)).abs().maxCoeff());
}

VectorXd solve_by_lu(Eigen::MatrixXd A, double g)
{
    const auto n = static_cast<std::size_t>(A.rows());
    A.transposeInPlace(); // GSL's rows are Eigen's columns
    gsl_matrix_view matrix = gsl_matrix_view_array(A.data(), n, n);
    const Owned<gsl_permutation, gsl_permutation_free> order(gsl_permutation_alloc(n));
    int sign = 0;
    gsl_check(gsl_linalg_LU_decomp(&matrix.matrix, order.get(), &sign), "LU decomposition");
    VectorXd right = VectorXd::Constant(A.rows(), -g);
    VectorXd x(A.rows());
    const gsl_vector_view b = gsl_vector_view_array(right.data(), n);
    gsl_vector_view solution = gsl_vector_view_array(x.data(), n);
    gsl_check(gsl_linalg_LU_solve(&matrix.matrix, order.get(), &b.vector, &solution.vector), "LU solution");
    return x;
}

} // namespace

double Couplings::largest_sum(const VectorXd& velocity) const
{
    double largest = 0;
    for (Eigen::Index a = 0; a < velocity.size(); ++a) {
        const double sum = between.col(a).dot((velocity.array() - velocity(a)).abs().matrix());
        largest = std::max(largest, sum + 2 * wall(a) * velocity.cwiseAbs().maxCoeff());
    }
    return largest;
}

DuctOperator::DuctOperator(const LatticeDuct& duct)
{
    set_density(duct);
    set_couplings(duct);
    set_ghosts(duct);
    set_time_scale();
}

void DuctOperator::set_density(const LatticeDuct& duct)
{
    const RadialKernel W = density_kernel(duct.lattice);
    density_.resize(static_cast<Eigen::Index>(duct.size()));
    for (std::size_t a = 0; a < duct.size(); ++a) {
        ColumnSum rho;
        for (const auto* columns : {&duct.fluid, &duct.ghosts}) {
            for (const Column& b : *columns) {
                rho.add(b.mass, column_sum(duct, duct.fluid[a].x - b.x, W));
            }
        }
        density_(static_cast<Eigen::Index>(a)) = rho.value;
        density_rounding_ = std::max(density_rounding_, rho.of_rounding / rho.value);
        density_distance_ = std::max(density_distance_, rho.of_distance / rho.value);
        neighbors_ = std::max(neighbors_, rho.terms);
    }
}

void DuctOperator::set_couplings(const LatticeDuct& duct)
{
    const RadialKernel lap_W = viscosity_kernel(duct.lattice);
    const Eigen::Index n = density_.size();
    A_ = Eigen::MatrixXd::Zero(n, n);
    couplings_ = of_rounding_ = of_distance_ = {A_, VectorXd::Zero(n)};
    for (Eigen::Index a = 0; a < n; ++a) {
        const auto couple = [&](const Column& b, double rho_b, double& coupling, double& rounding,
                                double& distance) {
            const ColumnSum sum = column_sum(duct, duct.fluid[static_cast<std::size_t>(a)].x - b.x, lap_W);
            const double factor = duct.mu * b.mass / (density_(a) * rho_b);
            coupling += factor * sum.value;
            // both densities and the mass, and 8 products and quotients
            rounding += factor * (sum.of_rounding + (3 * density_rounding_ + 8) * sum.value);
            distance += factor * (sum.of_distance + 3 * density_distance_ * sum.value);
        };
        for (Eigen::Index b = 0; b < n; ++b) {
            if (b != a) {
                couple(duct.fluid[static_cast<std::size_t>(b)], density_(b), couplings_.between(a, b),
                       of_rounding_.between(a, b), of_distance_.between(a, b));
            }
        }
        for (const Column& ghost : duct.ghosts) {
            couple(ghost, duct.rho_0, couplings_.wall(a), of_rounding_.wall(a), of_distance_.wall(a));
        }
    }
    A_ = couplings_.between;
    A_.diagonal() = -couplings_.between.rowwise().sum() - couplings_.wall;
}

/// The ghosts' velocities, in the matrix; what another text may make of them is as uncertain as their couplings and the
/// sums of W in them.
void DuctOperator::set_ghosts(const LatticeDuct& duct)
{
    const RadialKernel W = density_kernel(duct.lattice);
    const RadialKernel lap_W = viscosity_kernel(duct.lattice);
    for (const Column& ghost : duct.ghosts) {
        VectorXd weights = VectorXd::Zero(density_.size());
        ColumnSum all;
        for (Eigen::Index b = 0; b < weights.size(); ++b) {
            const ColumnSum sum = column_sum(duct, duct.fluid[static_cast<std::size_t>(b)].x - ghost.x, W);
            weights(b) = sum.value;
            all.add(1, sum);
        }
        if (all.value <= 0) {
            continue;
        }
        weights /= all.value;
        for (Eigen::Index a = 0; a < weights.size(); ++a) {
            const ColumnSum sum =
                column_sum(duct, duct.fluid[static_cast<std::size_t>(a)].x - ghost.x, lap_W);
            const double coupling = duct.mu * ghost.mass / (density_(a) * duct.rho_0) * sum.value;
            A_.row(a) -= coupling * weights.transpose();
            of_rounding_.wall(a) += coupling * 2 * all.of_rounding / all.value;
            of_distance_.wall(a) += coupling * 2 * all.of_distance / all.value;
        }
    }
}

void DuctOperator::set_time_scale()
{
    const Eigen::MatrixXd inverse = A_.partialPivLu().inverse();
    const auto norm = [](const Eigen::MatrixXd& matrix) {
        return matrix.cwiseAbs().rowwise().sum().maxCoeff();
    };
    const double off = norm(A_ * inverse - Eigen::MatrixXd::Identity(A_.rows(), A_.cols()));
    if (!(off < 0.5)) {
        throw std::invalid_argument("DuctOperator: no wall holds some of the columns");
    }
    time_scale_ = norm(inverse) / (1 - off);
}

Couplings DuctOperator::uncertainty(double roundoff, double displacement) const
{
    const auto combine = [&](const auto& c, const auto& rounding, const auto& distance) {
        return roundoff * (rounding + neighbors_ * c) + displacement * distance;
    };
    return {combine(couplings_.between, of_rounding_.between, of_distance_.between),
            combine(couplings_.wall, of_rounding_.wall, of_distance_.wall)};
}

Profile steady_flow(const DuctOperator& A, double g)
{
    const VectorXd velocity = solve_by_lu(A.matrix(), g);
    return {velocity, A.time_scale() * residual(A.matrix(), velocity, g)};
}

Profile steady_flow_by_qr(const DuctOperator& A, double g)
{
    const VectorXd velocity =
        A.matrix().colPivHouseholderQr().solve(VectorXd::Constant(A.matrix().rows(), -g));
    return {velocity, A.time_scale() * residual(A.matrix(), velocity, g)};
}

} // namespace aneurysm::analytic
