// SPDX-License-Identifier: Apache-2.0
#include "analytic/lattice/lattice_duct_steps.hpp"

#include <cmath>

namespace aneurysm::analytic
{
namespace
{

using Eigen::VectorXd;
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

double force(const Drive& drive, double t)
{
    return drive.steady() ? drive.g : drive.g * std::sin(drive.omega * t);
}

} // namespace

double largest_step(const DuctOperator& A)
{
    return 2 / A.matrix().cwiseAbs().rowwise().sum().maxCoeff();
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

Profile step_by_powers(const DuctOperator& A, double g, double dt, int n)
{
    const Eigen::Index rows = A.matrix().rows();
    const LongMatrix M =
        LongMatrix::Identity(rows, rows) + static_cast<long double>(dt) * A.matrix().cast<long double>();
    LongMatrix power = M;                                // M^(2^k)
    LongMatrix block = LongMatrix::Identity(rows, rows); // 1 + M + ... of 2^k terms
    LongMatrix sum = LongMatrix::Zero(rows, rows);
    LongMatrix before = LongMatrix::Identity(rows, rows); // M^(terms in sum)
    for (int left = n; left > 0; left /= 2) {
        if (left % 2 == 1) {
            sum += before * block;
            before = before * power;
        }
        block += power * block;
        power = power * power;
    }
    const LongVector velocity =
        sum * LongVector::Constant(rows, static_cast<long double>(dt) * static_cast<long double>(g));
    constexpr double long_u = static_cast<double>(std::numeric_limits<long double>::epsilon()) / 2;
    const double size = static_cast<double>(sum.cwiseAbs().rowwise().sum().maxCoeff()) * dt * std::abs(g);
    return {velocity.cast<double>(), (4 * (static_cast<double>(rows) + 8) * n * long_u + 2 * u) * size};
}

double step_uncertainty(const DuctOperator& A, const Drive& drive, double dt, int n, double roundoff,
                        double displacement)
{
    const Couplings uncertainty = A.uncertainty(roundoff, displacement);
    VectorXd velocity = VectorXd::Zero(A.matrix().rows());
    const Eigen::MatrixXd M =
        Eigen::MatrixXd::Identity(A.matrix().rows(), A.matrix().cols()) + dt * A.matrix();
    const double growth =
        std::max(1.0, M.cwiseAbs().rowwise().sum().maxCoeff()); // of a disturbance in a step
    double sum = 0;
    for (int step = 1; step <= n; ++step) {
        const double t = step * dt;
        const VectorXd friction = A.matrix() * velocity;
        double off = dt * uncertainty.largest_sum(velocity);
        velocity += dt * (friction.array() + force(drive, t)).matrix();
        off += roundoff *
               (dt * (8 * friction.cwiseAbs().maxCoeff() + (8 + 4 * drive.omega * t) * std::abs(drive.g)) +
                velocity.cwiseAbs().maxCoeff());
        sum = growth * sum + off;
    }
    return sum;
}

} // namespace aneurysm::analytic
