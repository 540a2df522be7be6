// SPDX-License-Identifier: Apache-2.0
#include "analytic/exact/pairs.hpp"

#include "analytic/exact/kernel.hpp"
#include "analytic/exact/precise.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace aneurysm::analytic
{
namespace
{

using Eigen::Vector3d;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// Sum of factors times numbers that are known to within an error.
class ExactSum
{
public:
    void add(const Precise& factor, double number, double error)
    {
        value_ += factor * number;
        error_ += std::abs(static_cast<double>(factor)) * error;
    }
    const Precise& value() const { return value_; }
    double error() const { return error_; }
    Estimate estimate() const
    {
        const auto rounded = static_cast<double>(value_);
        return {rounded, error_ + u * std::abs(rounded)};
    }

private:
    Precise value_ = 0;
    double error_ = 0;
};
using ExactVectorSum = std::array<ExactSum, 3>;

void add(ExactVectorSum& sum, const Precise& factor, const Vector3d& v, double error)
{
    for (Eigen::Index a = 0; a < 3; ++a) {
        sum.at(static_cast<std::size_t>(a)).add(factor, v(a), error);
    }
}

VectorEstimate estimate(const ExactVectorSum& sum)
{
    VectorEstimate result;
    for (Eigen::Index a = 0; a < 3; ++a) {
        const Estimate e = sum.at(static_cast<std::size_t>(a)).estimate();
        result.value(a) = e.value;
        result.error = std::max(result.error, e.error);
    }
    return result;
}

/// Calls visit(j, x) for each image of each particle within the support of i, itself at 0 among them.
template <class Visit>
void for_each_image(const Cloud& c, std::size_t i, Visit visit)
{
    const Precise support = 2 * Precise(c.h);
    for (std::size_t j = 0; j < c.position.size(); ++j) {
        for (int image = 0; image < 27; ++image) {
            const Eigen::Vector3i cell(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
            const Vector3d shift = cell.cast<double>();
            const Vector3d x = c.position[i] - c.position[j] + c.period * shift;
            Precise square = 0;
            for (const double component : x) {
                square += Precise(component) * component;
            }
            if (square < support * support) {
                visit(j, x);
            }
        }
    }
}

/// sum / weights.
Estimate mean_of(const ExactSum& sum, const ExactSum& weights)
{
    const auto W = static_cast<double>(weights.value());
    const auto mean = static_cast<double>(sum.value() / weights.value());
    return {mean, (sum.error() + std::abs(mean) * (weights.error() + u * W)) / W};
}

/// 1/(|sum|^2 + squares).
Estimate factor_of(const ExactVectorSum& sum, const ExactSum& squares)
{
    Precise denominator = squares.value();
    double error = squares.error();
    for (const ExactSum& component : sum) {
        denominator += component.value() * component.value();
        error += 2 * std::abs(static_cast<double>(component.value())) * component.error();
    }
    const auto D = static_cast<double>(denominator);
    return {static_cast<double>(1 / denominator), (error / D + 2 * u) / D};
}

} // namespace

ExactPairs exact_pairs(const Cloud& c, double mu, double rho_0, double time, std::size_t i)
{
    const double H = 2 * c.h;
    const double largest_slope = exact_kernel(c.kernel, c.h, 0, 0).value / c.h; // its order of magnitude
    const double largest_laplacian = 45 / (std::acos(-1.0) * std::pow(H, 5));
    ExactSum rate;
    ExactSum density;
    ExactSum density_ahead;
    ExactSum weights;
    ExactSum pressures;
    ExactSum free_weights;
    ExactVectorSum free_velocities;
    ExactSum squares;
    ExactVectorSum pressure_force;
    ExactVectorSum viscosity_force;
    ExactVectorSum acceleration;
    ExactVectorSum gradients;
    ExactVectorSum single_gradients;
    ExactPairs result;
    for_each_image(c, i, [&](std::size_t j, const Vector3d& x) {
        const double r = x.norm(); // rounded four times
        const Precise m = c.mass[j];
        const Exact W = exact_kernel(c.kernel, c.h, r, 4 * u);
        const double of_W = W.change + u * W.value;
        density.add(m, W.value, of_W);
        const double moved = (x + time * (c.velocity[i] - c.velocity[j])).norm();
        const Exact ahead = exact_kernel(c.kernel, c.h, moved, 4 * u);
        density_ahead.add(m, ahead.value, ahead.change + u * ahead.value);
        weights.add(1, W.value, of_W);
        pressures.add(c.pressure[j], W.value, of_W);
        if (c.free[j]) {
            free_weights.add(1, W.value, of_W);
            for (Eigen::Index a = 0; a < 3; ++a) {
                free_velocities.at(static_cast<std::size_t>(a))
                    .add(-Precise(c.velocity[j](a)), W.value, of_W);
            }
        }
        if (r == 0) {
            return; // W's slope vanishes, and so does v_i - v_i
        }
        ++result.neighbors;
        const Vector3d slope = exact_kernel_gradient(c.kernel, c.h, x);
        const double of_slope = u * slope.cwiseAbs().maxCoeff() + 1e-29 * largest_slope;
        const Precise p_i = c.pressure[i];
        const Precise p_j = c.free[j] ? c.pressure[j] : c.pressure[i];
        add(pressure_force, -m * (p_i + p_j) / (2 * Precise(c.density[j])), slope, of_slope);
        const bool mirror = c.given == Given::mirrors && !c.free[j];
        const Precise w = mirror ? 2 : 1;
        add(acceleration, -m * (p_i + (c.free[j] || mirror ? p_j : Precise(0))) / (Precise(rho_0) * rho_0),
            slope, of_slope);
        add(gradients, w * m, slope, of_slope);
        add(single_gradients, m, slope, of_slope);
        const Vector3d v = c.velocity[j] - c.velocity[i];
        for (Eigen::Index a = 0; a < 3; ++a) {
            rate.add(-w * m * (Precise(c.velocity[j](a)) - c.velocity[i](a)), slope(a), of_slope);
            if (c.free[j]) {
                squares.add(m * m * slope(a), slope(a), 2 * of_slope);
            }
        }
        const Estimate lap = exact_viscosity_laplacian(H, r);
        const double of_lap = lap.error + u * std::abs(lap.value) + 4 * u * r / H * largest_laplacian;
        add(viscosity_force, Precise(mu) * m / c.density[j] * lap.value, v, u * v.cwiseAbs().maxCoeff());
        for (ExactSum& component : viscosity_force) {
            component.add(Precise(mu) * m / c.density[j] * v.cwiseAbs().maxCoeff(), 0, of_lap);
        }
    });
    result.density_rate = rate.estimate();
    result.density = density.estimate();
    result.density_ahead = density_ahead.estimate();
    result.mean = mean_of(pressures, weights);
    for (Eigen::Index a = 0; a < 3; ++a) {
        const Estimate v = mean_of(free_velocities.at(static_cast<std::size_t>(a)), free_weights);
        result.no_slip_velocity.value(a) = v.value;
        result.no_slip_velocity.error = std::max(result.no_slip_velocity.error, v.error);
    }
    result.outlet_force = estimate(single_gradients);
    result.pressure_force = estimate(pressure_force);
    result.viscosity_force = estimate(viscosity_force);
    result.pressure_acceleration = estimate(acceleration);
    result.dfsph_factor = factor_of(gradients, squares);
    return result;
}

} // namespace aneurysm::analytic
