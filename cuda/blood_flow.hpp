// SPDX-License-Identifier: Apache-2.0
// Section 3.1: blood flow by smoothed particle hydrodynamics, (1), (2), (4)-(7), (15) and the equation of
// state. Sums run over the lists of sorted particle i, by eight lanes; the particle itself is not in them.
#pragma once

#include "cuda/fields.hpp"
#include "cuda/periodic.hpp"

namespace aneurysm::device
{

/// Places of eight neighbors relative to particle i, and their masses.
template <class Real>
struct Pairs {
    Vec3T<Lanes<Real>> x; ///< r_i - r_j [m]
    Lanes<Real> r;        ///< its length
    Lanes<Real> m;        ///< m_j [kg]
};

/// In a periodic box by the shortest way. Known beforehand, its loops have no branch.
template <bool periodic, class Real>
ANEURYSM_INLINE Pairs<Real> pairs(const Fields<Real>& f, Index i, const Lanes<Index>& j)
{
    const Row<Real> own = f.body_position[i];
    const RowLanes<Real> other = gather_rows(f.body_position, j);
    Vec3T<Lanes<Real>> x{Lanes<Real>(own.x) - other.x, Lanes<Real>(own.y) - other.y,
                         Lanes<Real>(own.z) - other.z};
    if constexpr (periodic) {
        x = shortest(x, f.c.vessel.period());
    }
    return {x, sqrt(dot(x, x)), other.w};
}
template <class Real>
ANEURYSM_INLINE Pairs<Real> pairs(const Fields<Real>& f, Index i, const Lanes<Index>& j)
{
    return f.c.is_periodic ? pairs<true>(f, i, j) : pairs<false>(f, i, j);
}

template <class Real>
ANEURYSM_INLINE Vec3T<Lanes<Real>> all_lanes(const Vec3T<Real>& v)
{
    return {Lanes<Real>(v.x), Lanes<Real>(v.y), Lanes<Real>(v.z)};
}

/// m_j grad W_ij [kg/m^4]
template <class Real>
ANEURYSM_INLINE Vec3T<Lanes<Real>> gradient(const Fields<Real>& f, const Pairs<Real>& pair)
{
    return pair.m * f.c.kernel.gradient_factor(pair.r) * pair.x;
}

/// m_j grad W_ij of block b of the blood around i, from memory where it is kept; the same bits.
template <bool kept, class Real>
ANEURYSM_INLINE Vec3T<Lanes<Real>> gradient(const Fields<Real>& f, Index i, Index b, const Lanes<Index>& j,
                                            Lane lane)
{
    if constexpr (kept) {
        const Real* G = f.gradient + 3 * lane_count * b;
        return {load(G, lane), load(G + lane_count, lane), load(G + 2 * lane_count, lane)};
    } else {
        return gradient(f, pairs(f, i, j));
    }
}

/// The eight neighbors in block b.
ANEURYSM_INLINE Lanes<Index> neighbors(const Lists& lists, Index b, Lane lane)
{
    return load(lists.body + lane_count * b, lane);
}

/// Eq. (1)  The forces on a unit volume of blood, rho Dv/Dt = rho g + mu lap v - grad p:
///
///     F = rho g + F^viscosity + F^pressure                                                    [N/m^3]
template <class Real>
ANEURYSM_HD Vec3T<Real> momentum_force(Real rho, const Vec3T<Real>& g, const Vec3T<Real>& F_viscosity,
                                       const Vec3T<Real>& F_pressure)
{
    return rho * g + F_viscosity + F_pressure;
}

/// Eq. (2)  Drho/Dt = -rho div v, as the time derivative of (5). What given bodies add beyond their place in the lists is
/// known before the solve:
///
///     Drho_i/Dt = sum_j m_j (v_i - v_j) . grad W_ij                                           [kg/(m^3 s)]
template <bool kept, class Real>
ANEURYSM_INLINE Real density_rate(const Fields<Real>& f, const Row<Real>* v, Index i, Lane lane)
{
    const Vec3T<Real> own = v[i].vector();
    const Vec3T<Lanes<Real>> v_i = all_lanes(own);
    Lanes<Real> rate;
    for (Index b = f.blood.begin[i]; b < f.blood.begin[i + 1]; ++b) {
        const Lanes<Index> j = neighbors(f.blood, b, lane);
        const Vec3T<Lanes<Real>> v_ij = v_i - gather_rows(v, j).vector();
        rate += dot(v_ij, gradient<kept>(f, i, b, j, lane));
    }
    const Row<Real> mirrors = f.mirrors[i];
    return sum(rate, lane) + (dot(own, mirrors.vector()) - mirrors.w);
}

/// Eq. (4)  A field at a point r from its values A_j at the bodies around it:
///
///     A(r) = sum_j A_j m_j / rho_j W(r - r_j, h)                                              [A]
///
/// `bodies`: rows of place and mass; `values`: rows of A_j (x) and
/// rho_j (y); `count` of both, a multiple of 8.
template <class Real>
ANEURYSM_HD Real interpolate(const Kernel<Real>& W, const Vec3T<Real>& r, const Row<Real>* bodies,
                             const Row<Real>* values, Index count, Lane lane)
{
    Lanes<Real> value;
    for (Index k = 0; k < count; k += lane_count) {
        const RowLanes<Real> body = load_rows(bodies + k, lane);
        const RowLanes<Real> at_body = load_rows(values + k, lane);
        const Vec3T<Lanes<Real>> x = all_lanes(r) - body.vector();
        value += at_body.x * body.w / at_body.y * W.value(sqrt(dot(x, x)));
    }
    return sum(value, lane);
}

/// Eq. (5)  Density by summation, over all neighbors and i itself:
///
///     rho_i = sum_j m_j W_ij                                                                  [kg/m^3]
template <class Real>
ANEURYSM_INLINE Lanes<Real> density(const Fields<Real>& f, const Pairs<Real>& pair)
{
    return pair.m * f.c.kernel.value(pair.r);
}

/// Eq. (EOS)  Equation of state:
///
///     p_i = kappa (rho_i - rho_0)                                                             [Pa]
template <class Number>
ANEURYSM_INLINE Number equation_of_state(const Number& kappa, const Number& rho, const Number& rho_0)
{
    return kappa * (rho - rho_0);
}

/// Eq. (6)  Pressure force, literally:
///
///     F_i^pressure = -sum_j m_j (p_i + p_j) / (2 rho_j) grad W_ij                             [N/m^3]
///
/// with the pressure of (EOS) at free bodies, and p_i at the others.
template <class Real>
ANEURYSM_HD Vec3T<Real> pressure_force(const Fields<Real>& f, Index i, Lane lane)
{
    using Number = Lanes<Real>;
    const Number kappa(f.c.kappa);
    const Number rho_0(f.c.rho_0);
    const Number p_i = equation_of_state(kappa, Number(f.body_velocity[i].w), rho_0);
    Vec3T<Number> force;
    for (Index b = f.blood.begin[i]; b < f.blood.begin[i + 1]; ++b) {
        const Lanes<Index> j = neighbors(f.blood, b, lane);
        const Number rho_j = gather_rows(f.body_velocity, j).w;
        const Mask is_driven = Lanes<Index>(0) < gather(f.is_driven, j);
        const Number p_j = select(is_driven, p_i, equation_of_state(kappa, rho_j, rho_0));
        force -= (p_i + p_j) / (Number(2) * rho_j) * gradient(f, pairs(f, i, j));
    }
    for (Index b = f.walls.begin[i]; b < f.walls.begin[i + 1]; ++b) {
        const Lanes<Index> j = neighbors(f.walls, b, lane);
        force -= (p_i + p_i) / (Number(2) * rho_0) * gradient(f, pairs(f, i, j));
    }
    return sum(force, lane);
}

/// Eq. (7)  Viscosity force; ghosts have the density rho_0:
///
///     F_i^viscosity = mu sum_j m_j (v_j - v_i) / rho_j lap W_ij                               [N/m^3]
///
/// over all j but the ghosts of a wall that lets blood slip; that of the others have the velocity of (27).
template <bool periodic, class Real>
ANEURYSM_INLINE Vec3T<Real> viscosity_force(const Fields<Real>& f, Index i, Lane lane)
{
    using Number = Lanes<Real>;
    const Vec3T<Number> v_i = all_lanes(f.body_velocity[i].vector());
    const Number mu(f.c.mu);
    const Lanes<Index> slips_from(f.c.slips ? f.c.first_wall() : f.c.bodies());
    Vec3T<Number> force;
    for (Index b = f.blood.begin[i]; b < f.blood.begin[i + 1]; ++b) {
        const Lanes<Index> j = neighbors(f.blood, b, lane);
        const Pairs<Real> pair = pairs<periodic>(f, i, j);
        const RowLanes<Real> other = gather_rows(f.body_velocity, j); // w: rho_j
        force += mu * pair.m / other.w * f.c.kernel.viscosity_laplacian(pair.r) * (other.vector() - v_i);
    }
    for (Index b = f.walls.begin[i]; b < f.walls.begin[i + 1]; ++b) {
        const Lanes<Index> j = neighbors(f.walls, b, lane);
        const Pairs<Real> pair = pairs<periodic>(f, i, j);
        const Number m = select(j < slips_from, pair.m, Number(0));
        const Vec3T<Number> v_j = gather_rows(f.body_velocity, j).vector();
        force += mu * m / Number(f.c.rho_0) * f.c.kernel.viscosity_laplacian(pair.r) * (v_j - v_i);
    }
    return sum(force, lane);
}

/// Eq. (15)  Acceleration of a particle by the force (1):
///
///     a_i = (rho_i g + F_i^pressure + F_i^viscosity) / rho_i                                  [m/s^2]
template <class Real>
ANEURYSM_HD Vec3T<Real> acceleration(Real rho, const Vec3T<Real>& force)
{
    return force / rho;
}

} // namespace aneurysm::device
