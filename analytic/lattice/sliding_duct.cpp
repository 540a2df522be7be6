// SPDX-License-Identifier: Apache-2.0
#include "analytic/lattice/sliding_duct.hpp"

#include <cmath>

namespace aneurysm::analytic
{
namespace
{

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;
constexpr double u = std::numeric_limits<double>::epsilon() / 2;

Sparse matrix_of(Index n, const Triplets& elements)
{
    Sparse matrix(n, n);
    matrix.setFromTriplets(elements.begin(), elements.end());
    return matrix;
}

} // namespace

SlidingDuct::SlidingDuct(const LatticeDuct& duct)
    : duct_(duct), W_(density_kernel(duct.lattice)), lap_W_(viscosity_kernel(duct.lattice)),
      neighbors_(duct.size())
{
    for (std::size_t a = 0; a < duct_.size(); ++a) {
        const auto add = [&](const Column& b, Index index) {
            const Eigen::Vector2d x = b.x - duct_.fluid[a].x;
            if (x.norm() <= 2 * duct_.lattice.h) {
                neighbors_[a].push_back({index, {x, b.mass}});
            }
        };
        for (std::size_t b = 0; b < duct_.size(); ++b) {
            add(duct_.fluid[b], static_cast<Index>(b));
        }
        for (const Column& ghost : duct_.ghosts) {
            add(ghost, -1);
        }
    }
    const VectorXd rest = VectorXd::Zero(static_cast<Index>(duct.size()));
    states_.push_back({rest, rest});
}

SlidingDuct::Densities SlidingDuct::densities(const VectorXd& slid) const
{
    Densities rho;
    rho.value = VectorXd::Zero(slid.size());
    Triplets elements;
    for (Index a = 0; a < slid.size(); ++a) {
        ColumnSum all;
        for (const Neighbor& n : neighbors_[static_cast<std::size_t>(a)]) {
            const double s = (n.b < 0 ? 0 : slid(n.b)) - slid(a);
            const ColumnSum sum = column_sum(duct_, n.column.x, s, W_);
            all.add(n.column.mass, sum);
            elements.emplace_back(a, a, -n.column.mass * sum.slope);
            if (n.b >= 0) {
                elements.emplace_back(a, n.b, n.column.mass * sum.slope);
            }
        }
        rho.value(a) = all.value;
        rho.of_rounding = std::max(rho.of_rounding, all.of_rounding / all.value);
        rho.of_distance = std::max(rho.of_distance, all.of_distance / all.value);
    }
    rho.per_slide = matrix_of(slid.size(), elements);
    return rho;
}

SlidingDuct::Friction SlidingDuct::friction(const State& state) const
{
    const Index size = state.slid.size();
    const Densities rho = densities(state.slid);
    Friction F{VectorXd::Zero(size), {}, {}, VectorXd::Zero(size), VectorXd::Zero(size)};
    Triplets per_velocity;
    Triplets per_slide;
    Triplets per_density;
    for (Index a = 0; a < size; ++a) {
        double terms = 0;
        double magnitude = 0;
        for (const Neighbor& n : neighbors_[static_cast<std::size_t>(a)]) {
            const double s = (n.b < 0 ? 0 : state.slid(n.b)) - state.slid(a);
            const ColumnSum sum = column_sum(duct_, n.column.x, s, lap_W_);
            terms += sum.terms;
            if (n.b == a || (n.b < 0 && !duct_.no_slip)) {
                continue;
            }
            const double rho_b = n.b < 0 ? duct_.rho_0 : rho.value(n.b);
            const double factor = duct_.mu * n.column.mass / (rho.value(a) * rho_b);
            const double difference = (n.b < 0 ? 0 : state.velocity(n.b)) - state.velocity(a);
            const double part = factor * sum.value * difference;
            F.value(a) += part;
            per_velocity.emplace_back(a, a, -factor * sum.value);
            per_slide.emplace_back(a, a, -factor * sum.slope * difference);
            per_density.emplace_back(a, a, -part / rho.value(a));
            if (n.b >= 0) {
                per_velocity.emplace_back(a, n.b, factor * sum.value);
                per_slide.emplace_back(a, n.b, factor * sum.slope * difference);
                per_density.emplace_back(a, n.b, -part / rho_b);
            }
            magnitude += std::abs(part);
            F.of_rounding(a) += factor * std::abs(difference) * sum.of_rounding;
            F.of_distance(a) += factor * std::abs(difference) * sum.of_distance;
        }
        // two densities and the mass, 16 products and quotients, and a sum over all neighbors
        F.of_rounding(a) += magnitude * (3 * rho.of_rounding + 16 + terms);
        F.of_distance(a) += magnitude * 3 * rho.of_distance;
    }
    F.per_velocity = matrix_of(size, per_velocity);
    F.per_slide = matrix_of(size, per_slide) + Sparse(matrix_of(size, per_density) * rho.per_slide);
    return F;
}

void SlidingDuct::step(const Drive& drive, double dt)
{
    const State& from = states_.back();
    const double phase = drive.omega * static_cast<double>(states_.size()) * dt;
    const double g = drive.steady() ? drive.g : drive.g * std::sin(phase);
    const VectorXd velocity = from.velocity + dt * (friction(from).value.array() + g).matrix();
    states_.push_back({velocity, from.slid + dt * velocity, dt, drive.g, phase});
}

/// One for each column of an eighth of a tube, half of a channel: the others are their mirror images.
MatrixXd SlidingDuct::rows_of_identity() const
{
    std::vector<Index> chosen;
    for (std::size_t a = 0; a < duct_.size(); ++a) {
        const Eigen::Vector2d& x = duct_.fluid[a].x;
        if (x(0) >= 0 && x(1) >= 0 && x(1) <= x(0)) {
            chosen.push_back(static_cast<Index>(a));
        }
    }
    return MatrixXd::Identity(velocity().size(), velocity().size())(chosen, Eigen::all);
}

double SlidingDuct::error(double roundoff, double extent) const
{
    const double each = roundoff + u;          // the other text's and this one's
    MatrixXd of_velocity = rows_of_identity(); // dv_n/dv_k
    MatrixXd of_slide = MatrixXd::Zero(of_velocity.rows(), of_velocity.cols()); // dv_n/ds_k
    VectorXd bound = VectorXd::Zero(of_velocity.rows());
    for (std::size_t k = states_.size() - 1; k > 0; --k) {
        const State& to = states_[k];
        const Friction F = friction(states_[k - 1]);
        const VectorXd eta =
            each * (to.dt * (F.of_rounding + 4 * extent * F.of_distance).array() +
                    to.dt * (8 + 4 * to.phase) * std::abs(to.force) + to.velocity.array().abs());
        const VectorXd theta = each * (2 * to.dt * to.velocity.array().abs() + extent);
        of_velocity += to.dt * of_slide;
        bound += of_velocity.cwiseAbs() * eta + of_slide.cwiseAbs() * theta;
        of_slide += to.dt * (of_velocity * F.per_slide);
        of_velocity += to.dt * (of_velocity * F.per_velocity);
    }
    return bound.maxCoeff();
}

} // namespace aneurysm::analytic
