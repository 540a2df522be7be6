// SPDX-License-Identifier: Apache-2.0
// Eight lanes share the neighbors of one particle: on a CPU they are one vector of eight numbers, on a GPU
// eight threads of a warp with one number each. Code written for lanes does the same operations in the same
// order on both, and so gives the same bits.
//
//     Lane                   which lanes this call stands for: all eight (CPU), its own (GPU)
//     Lanes<T>               a number for each lane, with + - * / < >= !=, sqrt and select
//     Mask                   a truth value for each lane, with & and |
//     widen                  to double
//     load, load_rows        eight neighbors in memory
//     store                  to memory, eight in a row
//     gather, gather_rows    from eight places
//     sum                    ((0+4)+(2+6))+((1+5)+(3+7))
//     first                  of lanes that are all equal
//     append, count          of the lanes that a mask holds
#pragma once

#include "common/host_device.hpp"
#include "common/vec3.hpp"

#include <cmath>
#include <cstdint>

namespace aneurysm::device
{

using Index = std::int32_t; ///< of bodies and of places in lists; a device holds fewer than 2^31

inline constexpr int lane_count = 8;

/// Four numbers that are read together: a vector and a scalar that belongs to it.
template <class Real>
struct alignas(4 * sizeof(Real)) Row {
    Real x;
    Real y;
    Real z;
    Real w;

    ANEURYSM_INLINE Vec3T<Real> vector() const { return {x, y, z}; }
};

template <class Real>
ANEURYSM_INLINE Row<Real> row(const Vec3T<Real>& v, Real w)
{
    return {v.x, v.y, v.z, w};
}

} // namespace aneurysm::device

#ifdef __CUDACC__
#include "cuda/executor/lanes_gpu.hpp"
#else
#include "cuda/executor/lanes_cpu.hpp"
#endif

namespace aneurysm::device
{

/// Rows, taken apart.
template <class Real>
struct RowLanes {
    Lanes<Real> x;
    Lanes<Real> y;
    Lanes<Real> z;
    Lanes<Real> w;

    ANEURYSM_INLINE Vec3T<Lanes<Real>> vector() const { return {x, y, z}; }
};

template <class T>
ANEURYSM_INLINE Lanes<T>& operator+=(Lanes<T>& a, const Lanes<T>& b)
{
    return a = a + b;
}
template <class T>
ANEURYSM_INLINE Lanes<T>& operator-=(Lanes<T>& a, const Lanes<T>& b)
{
    return a = a - b;
}

// One number alone, for code that takes either.
template <class T>
ANEURYSM_INLINE T select(bool m, T a, T b)
{
    return m ? a : b;
}
ANEURYSM_INLINE double widen(float a)
{
    return static_cast<double>(a);
}
ANEURYSM_INLINE double widen(double a)
{
    return a;
}
template <class Number>
ANEURYSM_INLINE Number larger(const Number& a, const Number& b)
{
    return select(a < b, b, a);
}

template <class Real>
ANEURYSM_INLINE Vec3T<Real> sum(const Vec3T<Lanes<Real>>& a, Lane lane)
{
    return {sum(a.x, lane), sum(a.y, lane), sum(a.z, lane)};
}

} // namespace aneurysm::device
