// SPDX-License-Identifier: Apache-2.0
#include "analytic/blood_flow.hpp"

namespace aneurysm::analytic
{
namespace
{

constexpr double u = std::numeric_limits<double>::epsilon() / 2;

/// A factor with 8 roundings of its own.
Estimate scaled(double factor, const Estimate& x)
{
    const double size = std::abs(factor);
    return {factor * x.value, size * (x.error + 8 * u * std::abs(x.value))};
}
VectorEstimate scaled(double factor, const VectorEstimate& x)
{
    const double size = std::abs(factor);
    return {factor * x.value, size * (x.error + 8 * u * x.value.cwiseAbs().maxCoeff())};
}

} // namespace

Estimate density_rate(const Medium& medium, const Wave& wave, double s)
{
    const VectorEstimate G = gradient_sum(medium.lattice, wave.k);
    const double along = wave.v_1.dot(G.value);
    const double size = wave.v_1.cwiseAbs().sum();
    return scaled(-medium.mass * s, {along, size * (G.error + 4 * u * G.value.cwiseAbs().maxCoeff())});
}

Estimate density(const Medium& medium)
{
    return scaled(medium.mass, kernel_sum(medium.lattice));
}

VectorEstimate viscosity_force(const Medium& medium, double mu, const Wave& wave, double c)
{
    const Estimate L = viscosity_sum(medium.lattice, wave.k);
    const double largest = wave.v_1.cwiseAbs().maxCoeff();
    return scaled(-mu * medium.volume() * c, VectorEstimate{L.value * wave.v_1, largest * L.error});
}

Estimate shear_decay_rate(const Medium& medium, double mu, const Eigen::Vector3d& k)
{
    return scaled(mu * medium.volume() / medium.density, viscosity_sum(medium.lattice, k));
}

Estimate pressure_of_sound_speed(double kappa, double rho, double rho_0)
{
    return integrate([&](double) { return kappa; }, rho_0, rho);
}

Estimate sound_frequency_squared(const Medium& medium, double kappa, const Eigen::Vector3d& k)
{
    const VectorEstimate G = gradient_sum(medium.lattice, k);
    const double size = G.value.norm();
    return scaled(kappa * medium.volume() * medium.volume() / 2, {size * size, 2 * size * 2 * G.error});
}

} // namespace aneurysm::analytic
