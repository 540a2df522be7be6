// SPDX-License-Identifier: Apache-2.0
#include "analytic/beltrami_flow.hpp"

#include "analytic/exact/precise.hpp"

#include <array>

namespace aneurysm::analytic
{
namespace
{

using Vector = std::array<Precise, 3>;

Vector velocity(const BeltramiFlow& f, const Vector& r, const Precise& t)
{
    const Precise decay = exp(-f.mu * Precise(f.k) * f.k * t / f.rho);
    const Precise x = f.k * r[0];
    const Precise y = f.k * r[1];
    const Precise z = f.k * r[2];
    return {decay * (f.A * sin(z) + f.C * cos(y)), decay * (f.B * sin(x) + f.A * cos(z)),
            decay * (f.C * sin(y) + f.B * cos(x))};
}

Precise pressure(const BeltramiFlow& f, const Vector& r, const Precise& t)
{
    const Vector v = velocity(f, r, t);
    const Precise potential = f.g.x() * r[0] + f.g.y() * r[1] + f.g.z() * r[2];
    return f.rho * (potential - (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2);
}

} // namespace

MomentumTerms momentum_terms(const BeltramiFlow& f, const Eigen::Vector3d& r, double t)
{
    const Vector place{r.x(), r.y(), r.z()};
    const auto moved = [&](std::size_t axis, const Precise& to) {
        Vector at = place;
        at[axis] = to;
        return at;
    };
    const Vector v = velocity(f, place, t);
    MomentumTerms terms;
    for (std::size_t a = 0; a < 3; ++a) {
        Precise laplacian = 0;
        for (std::size_t b = 0; b < 3; ++b) {
            laplacian += precise_curvature([&](const Precise& s) { return velocity(f, moved(b, s), t)[a]; },
                                           place[b], 1 / f.k);
        }
        const Precise gradient =
            precise_slope([&](const Precise& s) { return pressure(f, moved(a, s), t); }, place[a], 1 / f.k);
        const Precise acceleration = precise_slope(
            [&](const Precise& s) {
                return velocity(f, {place[0] + s * v[0], place[1] + s * v[1], place[2] + s * v[2]}, t + s)[a];
            },
            0, 1);
        const auto k = static_cast<Eigen::Index>(a);
        terms.viscosity[k] = static_cast<double>(f.mu * laplacian);
        terms.pressure[k] = static_cast<double>(-gradient);
        terms.force[k] = static_cast<double>(f.rho * acceleration);
        terms.acceleration[k] = static_cast<double>(acceleration);
    }
    return terms;
}

} // namespace aneurysm::analytic
