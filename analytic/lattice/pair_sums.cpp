// SPDX-License-Identifier: Apache-2.0
#include "analytic/lattice/pair_sums.hpp"

#include "analytic/kernel_function.hpp"

#include <complex>
#include <numbers>

namespace aneurysm::analytic
{
namespace
{

using Eigen::Vector3d;
using std::numbers::pi;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// The component nearest to 0 among all periodic images.
double nearest(double d, double period)
{
    const double once = std::fmod(d, period);
    return once > period / 2 ? once - period : once < -period / 2 ? once + period : once;
}

Vector3d difference(const Cloud& c, const Vector3d& a, const Vector3d& b)
{
    return (a - b).unaryExpr([&](double d) { return nearest(d, c.period); });
}

/// Bounds of |W|, |dW/dr| and |lap W| and of how fast each changes, for the error of a term.
double largest_kernel(const Cloud& c)
{
    return kernel(c.kernel, c.h, 0);
}
double largest_slope(const Cloud& c)
{
    return -kernel_slope(c.kernel, c.h, c.kernel == KernelName::cubic_spline ? 2 * c.h / 3 : c.h / 2);
}
double largest_laplacian(const Cloud& c)
{
    return 2 * viscosity_kernel_laplacian(2 * c.h, c.h);
}

Vector3d gradient(const Cloud& c, const Vector3d& x)
{
    const double r = x.norm();
    return r > 0 ? Vector3d(kernel_slope(c.kernel, c.h, r) / r * x) : Vector3d::Zero();
}

/// W of a complex distance, by the powers of analytic::kernel.
std::complex<double> complex_kernel(KernelName name, double h, const std::complex<double>& r)
{
    const std::complex<double> q = r / h;
    const std::complex<double> s = 2.0 - q;
    if (name == KernelName::cubic_spline) {
        const std::complex<double> inner = q.real() < 1 ? 1.0 - q : 0.0;
        return (s * s * s - 4.0 * inner * inner * inner) / (4 * pi * std::pow(h, 3));
    }
    return s * s * s * s * (5.0 / 16 - s / 8.0) * 21.0 / (16 * pi * std::pow(h, 3));
}

/// Error of a sum whose terms' factors, times the largest value of what they multiply, add up to `magnitude`.
double rounding(const Cloud& c, int terms, double magnitude)
{
    return u * (terms + 32 + 8 * c.period / c.h) * magnitude;
}

/// sum_j of term(j, x_ij), a vector, over all j within the support; factor(j) bounds what multiplies the
/// kernel, and `more` roundings are made on each term.
template <class Term, class Factor>
VectorEstimate sum_over_pairs(const Cloud& c, const Vector3d& r, double largest, Term term, Factor factor,
                              int more = 0)
{
    VectorEstimate sum;
    double magnitude = 0;
    int terms = more;
    for (std::size_t j = 0; j < c.position.size(); ++j) {
        const Vector3d x = difference(c, r, c.position[j]);
        if (x.norm() < 2 * c.h) {
            sum.value += term(j, x);
            magnitude += std::abs(factor(j)) * largest;
            ++terms;
        }
    }
    sum.error = rounding(c, terms, magnitude);
    return sum;
}

/// The same for numbers.
template <class Term, class Factor>
Estimate scalar_sum(const Cloud& c, const Vector3d& r, double largest, Term term, Factor factor, int more = 0)
{
    const VectorEstimate sum = sum_over_pairs(
        c, r, largest, [&](std::size_t j, const Vector3d& x) { return Vector3d(term(j, x), 0, 0); }, factor,
        more);
    return {sum.value.x(), sum.error};
}

bool mirrored(const Cloud& c, std::size_t j)
{
    return c.given == Given::mirrors && !c.free[j];
}
double weight(const Cloud& c, std::size_t j)
{
    return mirrored(c, j) ? 2 : 1;
}

/// factor sum_j m_j grad W_ij, with `more` roundings of the factor.
VectorEstimate volume_gradient(const Cloud& c, double factor, std::size_t i, int more)
{
    const auto term = [&](std::size_t j) { return factor * c.mass[j]; };
    return sum_over_pairs(
        c, c.position[i], largest_slope(c),
        [&](std::size_t j, const Vector3d& x) { return Vector3d(term(j) * gradient(c, x)); }, term, more);
}

/// Magnitude of w_j m_j (v_i - v_j).
auto speeds(const Cloud& c, std::size_t i)
{
    return [&c, i](std::size_t j) {
        return weight(c, j) * c.mass[j] * (c.velocity[i].norm() + c.velocity[j].norm());
    };
}

} // namespace

Estimate pair_density_rate(const Cloud& c, std::size_t i)
{
    return scalar_sum(
        c, c.position[i], largest_slope(c),
        [&](std::size_t j, const Vector3d& x) {
            return weight(c, j) * c.mass[j] * (c.velocity[i] - c.velocity[j]).dot(gradient(c, x));
        },
        speeds(c, i));
}

Estimate pair_interpolation(const Cloud& c, const Vector3d& r)
{
    Estimate sum;
    double magnitude = 0;
    for (std::size_t j = 0; j < c.position.size(); ++j) {
        const double factor = c.pressure[j] * c.mass[j] / c.density[j];
        const double W = kernel(c.kernel, c.h, (r - c.position[j]).norm());
        sum.value += factor * W;
        magnitude += W > 0 ? std::abs(factor) * largest_kernel(c) : 0;
    }
    sum.error = rounding(c, static_cast<int>(c.position.size()), magnitude);
    return sum;
}

Estimate pair_density(const Cloud& c, std::size_t i)
{
    return scalar_sum(
        c, c.position[i], largest_kernel(c),
        [&](std::size_t j, const Vector3d& x) { return c.mass[j] * kernel(c.kernel, c.h, x.norm()); },
        [&](std::size_t j) { return c.mass[j]; });
}

Estimate pair_density_ahead(const Cloud& c, const std::vector<Vector3d>& way, std::size_t i, double way_error)
{
    double slopes = 0;
    Estimate ahead = scalar_sum(
        c, c.position[i], largest_kernel(c),
        [&](std::size_t j, const Vector3d& x) {
            slopes += c.mass[j] * largest_slope(c);
            return c.mass[j] * kernel(c.kernel, c.h, (x + way[i] - way[j]).norm());
        },
        [&](std::size_t j) { return c.mass[j]; }, 8);
    ahead.error += 2 * way_error * slopes;
    return ahead;
}

VectorEstimate pair_shift(const Cloud& c, double rho_0, double dx, double beta, std::size_t i)
{
    return volume_gradient(c, -beta * dx * dx / rho_0, i, 6);
}

Estimate pair_mean(const Cloud& c, const std::vector<double>& A, std::size_t i)
{
    const auto sum = [&](const auto& value) {
        const auto at = [&](std::size_t j) { return j < A.size() && c.mass[j] > 0 ? value(j) : 0.0; };
        return scalar_sum(
            c, c.position[i], largest_kernel(c),
            [&](std::size_t j, const Vector3d& x) { return at(j) * kernel(c.kernel, c.h, x.norm()); }, at);
    };
    const Estimate values = sum([&](std::size_t j) { return A[j]; });
    const Estimate weights = sum([](std::size_t) { return 1.0; });
    const double mean = values.value / weights.value;
    return {mean, (values.error + std::abs(mean) * (weights.error + 4 * u * weights.value)) / weights.value};
}

VectorEstimate pair_no_slip_velocity(const Cloud& c, std::size_t j)
{
    struct Blood {
        Vector3d velocity;
        double W = 0;
        double error = 0; ///< of W
    };
    std::vector<Blood> seen;
    double weights = 0;
    for (std::size_t i = 0; i < c.position.size(); ++i) {
        const double r = difference(c, c.position[i], c.position[j]).norm();
        if (c.free[i] && c.mass[i] > 0 && r < 2 * c.h) {
            const double error =
                32 * u * kernel_terms(c.kernel, c.h, r) - 8 * u * c.period * kernel_slope(c.kernel, c.h, r);
            seen.push_back({c.velocity[i], kernel(c.kernel, c.h, r), error});
            weights += seen.back().W;
        }
    }
    VectorEstimate mean;
    for (const Blood& blood : seen) {
        mean.value += blood.W / weights * blood.velocity;
    }
    const auto n = static_cast<double>(seen.size());
    for (const Blood& blood : seen) {
        mean.error += (n + 8) * u * blood.W / weights * blood.velocity.norm() +
                      blood.error / weights * (blood.velocity - mean.value).norm();
    }
    return {-mean.value, mean.error};
}

Estimate pair_density_slope(const Cloud& c, std::size_t i)
{
    constexpr double t = 1e-100;
    return scalar_sum(
        c, c.position[i], largest_slope(c),
        [&](std::size_t j, const Vector3d& x) {
            const Vector3d v = weight(c, j) * (c.velocity[i] - c.velocity[j]);
            const std::complex<double> square(x.squaredNorm(), 2 * t * x.dot(v));
            return c.mass[j] * complex_kernel(c.kernel, c.h, std::sqrt(square)).imag() / t;
        },
        speeds(c, i), 64);
}

VectorEstimate pair_pressure_force(const Cloud& c, std::size_t i)
{
    const auto mean = [&](std::size_t j) {
        return (c.pressure[i] + (c.free[j] ? c.pressure[j] : c.pressure[i])) / 2;
    };
    const auto factor = [&](std::size_t j) { return c.mass[j] / c.density[j] * mean(j); };
    const auto size = [&](std::size_t j) {
        return c.mass[j] / c.density[j] * (std::abs(c.pressure[i]) + std::abs(c.pressure[j]));
    };
    return sum_over_pairs(
        c, c.position[i], largest_slope(c),
        [&](std::size_t j, const Vector3d& x) { return Vector3d(-factor(j) * gradient(c, x)); }, size);
}

VectorEstimate pair_viscosity_force(const Cloud& c, double mu, std::size_t i)
{
    return sum_over_pairs(
        c, c.position[i], largest_laplacian(c),
        [&](std::size_t j, const Vector3d& x) {
            const double lap =
                x.norm() > 0 ? viscosity_kernel_laplacian(2 * c.h, x.norm()) : 0; // times v_i - v_i
            return Vector3d(mu * c.mass[j] / c.density[j] * lap * (c.velocity[j] - c.velocity[i]));
        },
        [&](std::size_t j) {
            return mu * c.mass[j] / c.density[j] * (c.velocity[i].norm() + c.velocity[j].norm());
        });
}

VectorEstimate pair_outlet_force(const Cloud& c, double rho_0, double p, std::size_t i)
{
    return volume_gradient(c, 2 * p / rho_0, i, 0);
}

VectorEstimate pair_pressure_acceleration(const Cloud& c, double rho_0, std::size_t i)
{
    const auto both = [&](std::size_t j) {
        return c.pressure[i] + (c.free[j] ? c.pressure[j] : mirrored(c, j) ? c.pressure[i] : 0);
    };
    return sum_over_pairs(
        c, c.position[i], largest_slope(c),
        [&](std::size_t j, const Vector3d& x) {
            return Vector3d(-c.mass[j] / std::pow(rho_0, 2) * both(j) * gradient(c, x));
        },
        [&](std::size_t j) {
            return c.mass[j] / std::pow(rho_0, 2) * (std::abs(both(j)) + std::abs(c.pressure[i]));
        });
}

Estimate pair_dfsph_factor(const Cloud& c, std::size_t i)
{
    const double g = largest_slope(c);
    const auto mass = [&](std::size_t j) { return weight(c, j) * c.mass[j]; };
    const VectorEstimate sum = sum_over_pairs(
        c, c.position[i], g,
        [&](std::size_t j, const Vector3d& x) { return Vector3d(mass(j) * gradient(c, x)); }, mass);
    const Estimate squares = scalar_sum(
        c, c.position[i], 2 * g * g,
        [&](std::size_t j, const Vector3d& x) {
            return c.free[j] ? (c.mass[j] * gradient(c, x)).squaredNorm() : 0.0;
        },
        [&](std::size_t j) { return c.mass[j] * c.mass[j]; });
    const double denominator = sum.value.squaredNorm() + squares.value;
    const double error = 2 * sum.value.cwiseAbs().sum() * sum.error + squares.error;
    return {1 / denominator, (error / denominator + 8 * u) / denominator};
}

std::vector<std::size_t> pair_neighbors(const Cloud& c, std::size_t i)
{
    std::vector<std::size_t> all;
    for (std::size_t j = 0; j < c.position.size(); ++j) {
        if (j != i && difference(c, c.position[i], c.position[j]).norm() < 2 * c.h) {
            all.push_back(j);
        }
    }
    return all;
}

} // namespace aneurysm::analytic
