// SPDX-License-Identifier: Apache-2.0
#include "analytic/lattice/lattice_duct_steps.hpp"

#include <gsl/gsl_eigen.h>

#include <complex>

namespace aneurysm::analytic
{
namespace
{

using Eigen::VectorXd;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// What a mode that loses `loss` of itself in each step gets from n steps of the force 1.
struct Response {
    double amplitude = 0;
    double largest = 0;   ///< bound of the amplitude's magnitude over all steps
    double roundings = 0; ///< how many times u the largest may be off
};
Response respond(const Drive& drive, double dt, int n, double loss)
{
    const double t = n * dt;
    // 1 - q^n, by logarithms where it cancels
    const double lost = loss < 0.5 ? -std::expm1(n * std::log1p(-loss)) : 1 - std::pow(1 - loss, n);
    Response r;
    r.roundings = 32 + 4 * (drive.omega * t + std::abs(n * loss * (1 - lost)));
    if (drive.steady()) {
        r.amplitude = std::abs(loss) < u / n ? t : lost * dt / loss;
        r.largest = std::min(t, 2 * dt / std::abs(loss));
        return r;
    }
    const std::complex<double> i(0, 1);
    const double turn = drive.omega * dt;
    const auto z_1 = 2.0 * i * std::sin(turn / 2) * std::exp(i * turn / 2.0); // z - 1
    const auto z_n = std::exp(i * turn * static_cast<double>(n));
    const auto factor = dt * (1.0 + z_1) / (z_1 + loss);
    r.amplitude = (factor * (z_n - (1 - lost))).imag();
    r.largest = 2 * std::abs(factor);
    return r;
}

double force(const Drive& drive, double t)
{
    return drive.steady() ? drive.g : drive.g * std::sin(drive.omega * t);
}

} // namespace

DuctModes::DuctModes(const DuctOperator& A)
    : rates_(A.matrix().rows()), modes_(A.matrix()), largest_diagonal_(-A.matrix().diagonal().minCoeff()),
      time_scale_(A.time_scale())
{
    gsl_return_errors();
    const auto n = static_cast<std::size_t>(rates_.size());
    const Owned<gsl_eigen_symmv_workspace, gsl_eigen_symmv_free> work(gsl_eigen_symmv_alloc(n));
    Eigen::MatrixXd copy = -A.matrix();
    gsl_matrix_view matrix = gsl_matrix_view_array(copy.data(), n, n);
    gsl_matrix_view vectors = gsl_matrix_view_array(modes_.data(), n, n);
    gsl_vector_view values = gsl_vector_view_array(rates_.data(), n);
    gsl_check(gsl_eigen_symmv(&matrix.matrix, &values.vector, &vectors.matrix, work.get()), "eigenvectors");
    gsl_check(gsl_eigen_symmv_sort(&values.vector, &vectors.matrix, GSL_EIGEN_SORT_VAL_DESC), "sorting");
    modes_.transposeInPlace(); // GSL's rows are Eigen's columns
    parts_ = modes_.transpose() * VectorXd::Ones(rates_.size());

    const LongMatrix V = modes_.cast<long double>();
    const LongMatrix off = A.matrix().cast<long double>() * V + V * rates_.cast<long double>().asDiagonal();
    residuals_ = off.cwiseAbs().colwise().maxCoeff().transpose().cast<double>();
    const LongVector rest = (V * parts_.cast<long double>()).array() - 1;
    parts_error_ = static_cast<double>(rest.cwiseAbs().maxCoeff());
}

Profile DuctModes::after(const Drive& drive, double dt, int n) const
{
    if (dt * largest_diagonal_ > 1) {
        throw std::invalid_argument("DuctModes: the step is too long for a bound of its error");
    }
    VectorXd c(parts_.size());
    double amplitudes_error = 0;
    double disturbance = std::abs(drive.g) * parts_error_;
    for (Eigen::Index j = 0; j < c.size(); ++j) {
        const Response response = respond(drive, dt, n, dt * rates_(j));
        c(j) = drive.g * parts_(j) * response.amplitude;
        const double largest = std::abs(drive.g * parts_(j)) * response.largest;
        amplitudes_error += (response.roundings + static_cast<double>(c.size())) * u * largest *
                            modes_.col(j).cwiseAbs().maxCoeff();
        disturbance += largest * residuals_(j);
    }
    return {modes_ * c, amplitudes_error + std::min(n * dt, time_scale_) * disturbance};
}

Profile step_by_step(const DuctOperator& A, const Drive& drive, double dt, int n)
{
    const LongMatrix matrix = static_cast<long double>(dt) * A.matrix().cast<long double>();
    LongVector velocity = LongVector::Zero(matrix.rows());
    long double largest = 0;
    for (int step = 1; step <= n; ++step) {
        const long double phase = static_cast<long double>(drive.omega) * step * static_cast<long double>(dt);
        const long double g = drive.steady() ? drive.g : drive.g * std::sin(phase);
        const LongVector change = matrix * velocity;
        velocity = (velocity + change).array() + dt * g;
        largest = std::max(largest, velocity.cwiseAbs().maxCoeff());
    }
    constexpr double long_u = static_cast<double>(std::numeric_limits<long double>::epsilon()) / 2;
    const auto rows = static_cast<double>(matrix.rows());
    return {velocity.cast<double>(), (2 * (rows + 8) * n * long_u + 2 * u) * static_cast<double>(largest)};
}

double step_uncertainty(const DuctOperator& A, const Drive& drive, double dt, int n, double roundoff,
                        double displacement)
{
    const Couplings uncertainty = A.uncertainty(roundoff, displacement);
    VectorXd velocity = VectorXd::Zero(A.matrix().rows());
    double sum = 0;
    double largest = 0;
    for (int step = 1; step <= n; ++step) {
        const double t = step * dt;
        const VectorXd friction = A.matrix() * velocity;
        double off = dt * uncertainty.largest_sum(velocity);
        velocity += dt * (friction.array() + force(drive, t)).matrix();
        off += roundoff *
               (dt * (8 * friction.cwiseAbs().maxCoeff() + (8 + 4 * drive.omega * t) * std::abs(drive.g)) +
                velocity.cwiseAbs().maxCoeff());
        sum += off;
        largest = std::max(largest, off);
    }
    return std::min(sum, largest * A.time_scale() / dt);
}

} // namespace aneurysm::analytic
