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

VectorEstimate momentum_force(const Medium& medium, double mu, const Eigen::Vector3d& g, const Wave& wave,
                              double c, double s)
{
    const Eigen::Vector3d weight = medium.density * g;
    const VectorEstimate viscous = viscosity_force(medium, mu, wave, c);
    const VectorEstimate pressing = pressure_force(medium, wave, s);
    const double size = weight.cwiseAbs().maxCoeff() + viscous.value.cwiseAbs().maxCoeff() +
                        pressing.value.cwiseAbs().maxCoeff();
    return {weight + viscous.value + pressing.value, viscous.error + pressing.error + 3 * u * size};
}

Estimate density_rate(const Medium& medium, const Wave& wave, double s)
{
    const VectorEstimate G = gradient_sum(medium.lattice, wave.k);
    const double along = wave.v_1.dot(G.value);
    const double size = wave.v_1.cwiseAbs().sum();
    return scaled(-medium.mass * s, {along, size * (G.error + 4 * u * G.value.cwiseAbs().maxCoeff())});
}

Estimate interpolated_wave(const Medium& medium, const Eigen::Vector3d& k, const Eigen::Vector3d& r)
{
    return scaled(medium.volume(), kernel_sum(medium.lattice, k, r));
}

Estimate density(const Medium& medium)
{
    return scaled(medium.mass, kernel_sum(medium.lattice));
}

VectorEstimate pressure_force(const Medium& medium, const Wave& wave, double s)
{
    return scaled(-medium.volume() / 2 * wave.p_1 * s, gradient_sum(medium.lattice, wave.k));
}

Estimate pressure_force_ratio(const Medium& medium)
{
    // the floor is that of a volume dx^3; the particles' volume differs from it by the lattice's density
    const Estimate b = gradient_floor(medium.lattice);
    return scaled(medium.volume() / medium.lattice.cell() / 2, {1 + b.value, b.error});
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
