// SPDX-License-Identifier: Apache-2.0
#include "analytic/lattice/lattice.hpp"

#include "analytic/kernel_function.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <numbers>
#include <utility>
#include <vector>

namespace aneurysm::analytic
{
namespace
{

using Eigen::Vector3d;
using std::numbers::pi;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// Calls visit(x) for each lattice point within `radius` of the origin.
template <class Visit>
void for_points(double dx, double radius, Visit visit)
{
    const int reach = static_cast<int>(std::ceil(radius / dx)) + 1;
    for (int i = -reach; i <= reach; ++i) {
        for (int j = -reach; j <= reach; ++j) {
            for (int l = -reach; l <= reach; ++l) {
                const Vector3d x = dx * Vector3d(i, j, l);
                if (x.norm() <= radius) {
                    visit(x);
                }
            }
        }
    }
}

/// Adds terms and keeps what their rounding may amount to.
struct Sum {
    double value = 0;
    double magnitude = 0;
    int terms = 0;

    /// The function's value at a lattice point, times a wave.
    void add(double f, double wave = 1)
    {
        value += f * wave;
        magnitude += std::abs(f);
        ++terms;
    }
    /// `largest`: of the function that each term evaluates.
    double error(double largest) const { return u * ((terms + 128) * magnitude + 16 * terms * largest); }
};

/// Largest |dW/dr|: at q = 2/3 (cubic spline) and q = 1/2 (Wendland C2).
double steepest(const Lattice& l)
{
    return -kernel_slope(l.kernel, l.h, l.kernel == KernelName::cubic_spline ? 2 * l.h / 3 : l.h / 2);
}

/// |What| <= front (q h)^-power, from the closed form for the cubic spline, 3 (sin^3 cos/x^5 + sin^4/x^6) at
/// x = q h/2 with |sin^3 cos| <= 3 sqrt(3)/16, and from the boundary terms for Wendland's; both for q h > 20.
struct Decay {
    double front;
    int power;
};
Decay decay(KernelName name)
{
    if (name == KernelName::cubic_spline) {
        return {32 * 3 * (3 * std::sqrt(3.0) / 16 + 1.0 / 10), 5};
    }
    return {21.0 / 4 * (75 + 67.5 / 20 + 180.0 / 400), 6};
}

/// Bound of sum |q|^p |What(q)| over the reciprocal lattice beyond |m| = M: each point's unit cube lies
/// within sqrt(3)/2 of it, and so does k dx/(2 pi) of 0.
double tail(const Lattice& l, int p, double M)
{
    const auto [front, power] = decay(l.kernel);
    const double from = M - 1.5 * std::sqrt(3.0);
    const double q = 2 * pi / l.dx;
    const double widened = 4 * pi * std::pow(1 + std::sqrt(3.0) / 2 / from, 2);
    return widened * front * std::pow(q, p) / std::pow(q * l.h, power) * std::pow(from, 3 + p - power) /
           (power - 3 - p);
}

/// Calls visit(q) for q = k + 2 pi m/dx, |m_a| <= M.
template <class Visit>
void for_reciprocal_points(const Lattice& l, const Vector3d& k, int M, Visit visit)
{
    for (int i = -M; i <= M; ++i) {
        for (int j = -M; j <= M; ++j) {
            for (int n = -M; n <= M; ++n) {
                visit(Vector3d(k + 2 * pi / l.dx * Vector3d(i, j, n)));
            }
        }
    }
}

/// How often a number below `size` is a sum of three squares of integers, order and sign counted.
std::vector<double> sums_of_three_squares(int size)
{
    std::vector<double> counts(static_cast<std::size_t>(size), 0);
    counts[0] = 1;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> more = counts; // the square 0
        for (std::size_t i = 1; i * i < counts.size(); ++i) {
            const std::size_t square = i * i;
            for (std::size_t s = square; s < counts.size(); ++s) {
                more[s] += 2 * counts[s - square];
            }
        }
        counts = more;
    }
    return counts;
}

} // namespace

Estimate kernel_sum(const Lattice& l)
{
    Sum sum;
    for_points(l.dx, 2 * l.h, [&](const Vector3d& x) { sum.add(kernel(l.kernel, l.h, x.norm())); });
    return {sum.value, sum.error(kernel(l.kernel, l.h, 0))};
}

VectorEstimate gradient_sum(const Lattice& l, const Vector3d& k)
{
    std::array<Sum, 3> sums;
    for_points(l.dx, 2 * l.h, [&](const Vector3d& x) {
        if (x.norm() > 0) {
            const Vector3d gradient = kernel_slope(l.kernel, l.h, x.norm()) * x.normalized();
            for (std::size_t a = 0; a < 3; ++a) {
                sums.at(a).add(gradient(static_cast<Eigen::Index>(a)), std::sin(k.dot(x)));
            }
        }
    });
    VectorEstimate G;
    for (std::size_t a = 0; a < 3; ++a) {
        G.value(static_cast<Eigen::Index>(a)) = sums.at(a).value;
        G.error = std::max(G.error, sums.at(a).error(steepest(l)));
    }
    return G;
}

double shift_limit(const Lattice& l)
{
    constexpr int points = 12;
    std::vector<std::pair<Vector3d, Eigen::Matrix3d>> hessians;
    for_points(l.dx, 2 * l.h, [&](const Vector3d& x) {
        const double r = x.norm();
        if (r > 0) {
            const double step = 1e-5 * l.h;
            const double curvature =
                (kernel_slope(l.kernel, l.h, r + step) - kernel_slope(l.kernel, l.h, r - step)) / (2 * step);
            const Eigen::Matrix3d along = x.normalized() * x.normalized().transpose();
            const double across = kernel_slope(l.kernel, l.h, r) / r;
            hessians.emplace_back(x, curvature * along + across * (Eigen::Matrix3d::Identity() - along));
        }
    });
    double largest = 0;
    for (int i = 0; i <= points;
         ++i) { // 0 <= k_z <= k_y <= k_x <= pi / dx: the lattice's symmetry gives the rest
        for (int j = 0; j <= i; ++j) {
            for (int n = 0; n <= j; ++n) {
                const Vector3d k = pi / points / l.dx * Vector3d(i, j, n);
                Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
                for (const auto& [x, hessian] : hessians) {
                    A += (1 - std::cos(k.dot(x))) * hessian;
                }
                const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(A, Eigen::EigenvaluesOnly);
                largest = std::max(largest, solved.eigenvalues().maxCoeff());
            }
        }
    }
    return 2 * kernel_sum(l).value / (l.dx * l.dx * largest);
}

Estimate gradient_floor(const Lattice& l)
{
    Sum sum; // x dW/dx summed over the three axes is r W'
    for_points(l.dx, 2 * l.h,
               [&](const Vector3d& x) { sum.add(x.norm() * kernel_slope(l.kernel, l.h, x.norm())); });
    return {-l.cell() * sum.value / 3 - 1, l.cell() * sum.error(2 * l.h * steepest(l)) / 3 + u};
}

Estimate gradient_square_sum(const Lattice& l)
{
    Sum sum;
    for_points(l.dx, 2 * l.h,
               [&](const Vector3d& x) { sum.add(std::pow(kernel_slope(l.kernel, l.h, x.norm()), 2)); });
    return {sum.value, sum.error(2 * std::pow(steepest(l), 2))};
}

Estimate viscosity_sum(const Lattice& l, const Vector3d& k)
{
    const double H = 2 * l.h;
    Sum sum;
    for_points(l.dx, H, [&](const Vector3d& x) {
        if (x.norm() > 0) {
            sum.add(viscosity_kernel_laplacian(H, x.norm()), 1 - std::cos(k.dot(x)));
        }
    });
    return {sum.value, 2 * sum.error(viscosity_kernel_laplacian(H, l.dx))};
}

Estimate kernel_sum_by_poisson(const Lattice& l)
{
    constexpr int M = 200;
    const std::vector<double> counts = sums_of_three_squares(M * M);
    double sum = 0;
    double error = 0;
    for (std::size_t s = counts.size(); s-- > 0;) { // the small terms first
        const double k = 2 * pi / l.dx * std::sqrt(static_cast<double>(s));
        const Estimate What = kernel_transform(l.kernel, l.h, k);
        sum += counts[s] * What.value;
        error += counts[s] * What.error;
    }
    return {sum / l.cell(), (error + tail(l, 0, M)) / l.cell()};
}

VectorEstimate gradient_sum_by_poisson(const Lattice& l, const Vector3d& k)
{
    constexpr int M = 40;
    Vector3d sum = Vector3d::Zero();
    double error = 0;
    for_reciprocal_points(l, k, M, [&](const Vector3d& q) {
        const Estimate What = kernel_transform(l.kernel, l.h, q.norm());
        sum -= q * What.value;
        error += q.norm() * What.error;
    });
    return {sum / l.cell(), (error + tail(l, 1, M)) / l.cell()};
}

Estimate viscosity_sum_by_poisson(const Lattice& l, const Vector3d& k)
{
    constexpr double deviations = 7.5; // beyond them a Gaussian is below 1e-13
    const double H = 2 * l.h;
    const double eps = 0.025 * l.dx;
    const double A = 180 / (4 * pi * std::pow(H, 6));
    const int M = static_cast<int>(std::ceil(8.5 * l.dx / (2 * pi * eps))) + 1;

    double smoothed = 0;
    double magnitude = 0;
    const auto damped = [&](const Vector3d& q) {
        return viscosity_transform(H, q.norm()).value * std::exp(-eps * eps * q.squaredNorm() / 2);
    };
    for_reciprocal_points(l, Vector3d::Zero(), M, [&](const Vector3d& q) {
        smoothed += damped(q) - damped(q + k);
        magnitude += std::abs(damped(q));
    });
    double put_back = 0;
    for_points(l.dx, H + deviations * eps, [&](const Vector3d& x) {
        const double r = x.norm();
        if (r == H) {
            put_back -= A * (eps / std::sqrt(2 * pi) - eps * eps / (2 * H)) * (1 - std::cos(k.dot(x)));
        } else if (std::abs(r - H) < deviations * eps) {
            throw std::invalid_argument(
                "viscosity_sum_by_poisson: a lattice point is too near to the support's end");
        } else if (r > 0) {
            put_back += A * eps * eps / r * (1 - std::cos(k.dot(x)));
        }
    });
    // the Gaussians' tails, and the rounding of the transform's sum
    return {smoothed / l.cell() + put_back, (1e-13 + 64 * u) * magnitude / l.cell()};
}

} // namespace aneurysm::analytic
