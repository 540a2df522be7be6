// SPDX-License-Identifier: Apache-2.0
#include "verification/checks/sums/one_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace aneurysm::checks
{

OneIteration::OneIteration(const Probe& probe, const Scenario& s, analytic::Cloud cloud, double of_start)
    : probe_(&probe), moved_(std::move(cloud)),
      per_residual_(s.pressure.relaxation * s.fluid.density_kg_m3 * s.fluid.density_kg_m3 / s.time.frame_s)
{
    const double dt = s.time.frame_s;
    std::vector<Eigen::Vector3d> after = moved_.velocity;
    for (std::size_t i = 0; i < after.size(); ++i) {
        if (moved_.free[i] && moved_.mass[i] > 0) {
            const auto a = analytic::pair_pressure_acceleration(moved_, s.fluid.density_kg_m3, i);
            after[i] += dt * a.value;
            of_velocity_ = std::max(of_velocity_,
                                    dt * both(a.error, probe.roundoff()) +
                                        probe.gamma(4) * (moved_.velocity[i].norm() + dt * a.value.norm()));
        }
    }
    moved_.velocity = after;
    of_velocity_ += of_start;
}

analytic::Estimate OneIteration::residual(std::size_t i, const analytic::Estimate& source) const
{
    const auto rate = analytic::pair_density_rate(moved_, i);
    // sum_j |m_j grad W_ij| over free bodies, by Cauchy and Schwarz over at most 64 neighbors; what is given adds the
    // sum over all less that over free bodies
    const double slopes = std::sqrt(64 / analytic::pair_dfsph_factor(moved_, i).value);
    return {source.value + rate.value,
            both(source.error + rate.error, probe_->roundoff()) + 4 * of_velocity_ * slopes +
                probe_->gamma(12) * (std::abs(source.value) + std::abs(rate.value))};
}

analytic::Estimate OneIteration::potential(std::size_t i, const analytic::Estimate& source,
                                           double lowest) const
{
    const auto alpha = analytic::pair_dfsph_factor(moved_, i);
    const auto [r, error] = residual(i, source);
    const double start = moved_.pressure[i];
    return {std::max(lowest, start + per_residual_ * alpha.value * r),
            per_residual_ * (alpha.value * error +
                             (both(alpha.error, probe_->roundoff()) + probe_->gamma(12) * alpha.value) *
                                 (std::abs(r) + error)) +
                probe_->gamma(4) * std::abs(start)};
}

} // namespace aneurysm::checks
