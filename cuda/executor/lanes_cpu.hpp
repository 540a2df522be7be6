// SPDX-License-Identifier: Apache-2.0
// Included by cuda/lanes.hpp: lanes as one vector, by the compilers' own vector types; they become AVX
// registers where the machine has them. With ANEURYSM_NO_SIMD they are plain arrays, to the same bits.
#pragma once

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace aneurysm::device
{

template <class Real>
struct RowLanes;

struct Lane {
    static constexpr bool is_first() { return true; }
};

#ifndef ANEURYSM_NO_SIMD

template <class T, int n>
struct VectorOf {
    typedef T type __attribute__((vector_size(n * sizeof(T)))); // NOLINT(modernize-use-using): dependent
};
template <class T>
using Eight = typename VectorOf<T, lane_count>::type;

#else

template <class T>
struct Eight {
    T values[lane_count];
    T& operator[](int l) { return values[l]; }
    const T& operator[](int l) const { return values[l]; }
};

#define ANEURYSM_OPERATOR(op, Result, expression)                                                            \
    template <class T>                                                                                       \
    Eight<Result> operator op(const Eight<T>& a, const Eight<T>& b)                                          \
    {                                                                                                        \
        Eight<Result> r;                                                                                     \
        for (int l = 0; l < lane_count; ++l) {                                                               \
            r[l] = expression;                                                                               \
        }                                                                                                    \
        return r;                                                                                            \
    }
ANEURYSM_OPERATOR(+, T, a[l] + b[l])
ANEURYSM_OPERATOR(-, T, a[l] - b[l])
ANEURYSM_OPERATOR(*, T, a[l] * b[l])
ANEURYSM_OPERATOR(/, T, a[l] / b[l])
ANEURYSM_OPERATOR(&, T, a[l] & b[l])
ANEURYSM_OPERATOR(|, T, a[l] | b[l])
ANEURYSM_OPERATOR(<, Index, a[l] < b[l] ? -1 : 0)
ANEURYSM_OPERATOR(>=, Index, a[l] >= b[l] ? -1 : 0)
ANEURYSM_OPERATOR(==, Index, a[l] == b[l] ? -1 : 0)
ANEURYSM_OPERATOR(!=, Index, a[l] != b[l] ? -1 : 0)
#undef ANEURYSM_OPERATOR

#endif

template <class T>
struct Lanes {
    Eight<T> v;

    ANEURYSM_INLINE Lanes(T x = 0) : v{x, x, x, x, x, x, x, x} {}
    ANEURYSM_INLINE Lanes(const Eight<T>& value) : v(value) {}
};

/// -1 in the lanes that it holds, 0 in the others.
struct Mask {
    Eight<Index> v;
};

/// Comparisons of 64-bit numbers give 64-bit masks.
template <class Vector>
ANEURYSM_INLINE Mask narrow(const Vector& m)
{
#ifndef ANEURYSM_NO_SIMD
    if constexpr (sizeof(m[0]) != sizeof(Index)) {
        return {__builtin_convertvector(m, Eight<Index>)};
    } else
#endif
    {
        return {m};
    }
}

template <class T>
ANEURYSM_INLINE Lanes<T> operator+(const Lanes<T>& a, const Lanes<T>& b)
{
    return a.v + b.v;
}
template <class T>
ANEURYSM_INLINE Lanes<T> operator-(const Lanes<T>& a, const Lanes<T>& b)
{
    return a.v - b.v;
}
template <class T>
ANEURYSM_INLINE Lanes<T> operator*(const Lanes<T>& a, const Lanes<T>& b)
{
    return a.v * b.v;
}
template <class T>
ANEURYSM_INLINE Lanes<T> operator/(const Lanes<T>& a, const Lanes<T>& b)
{
    return a.v / b.v;
}
template <class T>
ANEURYSM_INLINE Mask operator<(const Lanes<T>& a, const Lanes<T>& b)
{
    return narrow(a.v < b.v);
}
template <class T>
ANEURYSM_INLINE Mask operator>=(const Lanes<T>& a, const Lanes<T>& b)
{
    return narrow(a.v >= b.v);
}
template <class T>
ANEURYSM_INLINE Mask operator==(const Lanes<T>& a, const Lanes<T>& b)
{
    return narrow(a.v == b.v);
}
template <class T>
ANEURYSM_INLINE Mask operator!=(const Lanes<T>& a, const Lanes<T>& b)
{
    return narrow(a.v != b.v);
}
ANEURYSM_INLINE Mask operator&(const Mask& a, const Mask& b)
{
    return {a.v & b.v};
}
ANEURYSM_INLINE Mask operator|(const Mask& a, const Mask& b)
{
    return {a.v | b.v};
}
/// The same numbers in double.
template <class T>
ANEURYSM_INLINE Lanes<double> widen(const Lanes<T>& a)
{
#ifndef ANEURYSM_NO_SIMD
    return __builtin_convertvector(a.v, Eight<double>);
#else
    Lanes<double> r;
    for (int l = 0; l < lane_count; ++l) {
        r.v[l] = static_cast<double>(a.v[l]);
    }
    return r;
#endif
}

template <class T>
ANEURYSM_INLINE Lanes<T> select(const Mask& m, const Lanes<T>& a, const Lanes<T>& b)
{
#ifndef ANEURYSM_NO_SIMD
    if constexpr (sizeof(T) == sizeof(Index)) {
        return m.v ? a.v : b.v;
    } else {
        return __builtin_convertvector(m.v, Eight<std::int64_t>) ? a.v : b.v;
    }
#else
    Lanes<T> r;
    for (int l = 0; l < lane_count; ++l) {
        r.v[l] = m.v[l] != 0 ? a.v[l] : b.v[l];
    }
    return r;
#endif
}

template <class T>
ANEURYSM_INLINE Lanes<T> sqrt(const Lanes<T>& a)
{
#if defined(__AVX__) && !defined(ANEURYSM_NO_SIMD)
    if constexpr (sizeof(T) == sizeof(float)) {
        return Eight<T>(_mm256_sqrt_ps(a.v));
    }
#endif
    Lanes<T> r;
    for (int l = 0; l < lane_count; ++l) {
        r.v[l] = std::sqrt(a.v[l]);
    }
    return r;
}

ANEURYSM_INLINE Lanes<Index> numbers(Lane)
{
    return Eight<Index>{0, 1, 2, 3, 4, 5, 6, 7};
}

template <class T>
ANEURYSM_INLINE Lanes<T> load(const T* p, Lane)
{
    Eight<T> r;
    __builtin_memcpy(&r, p, sizeof r);
    return r;
}
template <class T>
ANEURYSM_INLINE void store(T* p, const Lanes<T>& a, Lane)
{
    __builtin_memcpy(p, &a.v, sizeof a.v);
}
template <class T>
ANEURYSM_INLINE Lanes<T> gather(const T* p, const Lanes<Index>& i)
{
    const auto& k = i.v;
    return Eight<T>{p[k[0]], p[k[1]], p[k[2]], p[k[3]], p[k[4]], p[k[5]], p[k[6]], p[k[7]]};
}

#ifndef ANEURYSM_NO_SIMD

/// Rows 0 to 7, transposed: each is one load, which costs a quarter of gathering its four numbers.
template <class Real>
ANEURYSM_INLINE RowLanes<Real> transposed(const Row<Real>* r0, const Row<Real>* r1, const Row<Real>* r2,
                                          const Row<Real>* r3, const Row<Real>* r4, const Row<Real>* r5,
                                          const Row<Real>* r6, const Row<Real>* r7)
{
    const auto both = [](const Row<Real>* a, const Row<Real>* b) {
        typename VectorOf<Real, 4>::type low;
        typename VectorOf<Real, 4>::type high;
        __builtin_memcpy(&low, a, sizeof low);
        __builtin_memcpy(&high, b, sizeof high);
        return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    };
    const auto r04 = both(r0, r4); // x0 y0 z0 w0 x4 y4 z4 w4
    const auto r15 = both(r1, r5);
    const auto r26 = both(r2, r6);
    const auto r37 = both(r3, r7);
    const auto xy01 = __builtin_shufflevector(r04, r15, 0, 8, 1, 9, 4, 12, 5, 13); // x0 x1 y0 y1 x4 x5 y4 y5
    const auto xy23 = __builtin_shufflevector(r26, r37, 0, 8, 1, 9, 4, 12, 5, 13);
    const auto zw01 = __builtin_shufflevector(r04, r15, 2, 10, 3, 11, 6, 14, 7, 15);
    const auto zw23 = __builtin_shufflevector(r26, r37, 2, 10, 3, 11, 6, 14, 7, 15);
    return {Lanes<Real>(__builtin_shufflevector(xy01, xy23, 0, 1, 8, 9, 4, 5, 12, 13)),
            Lanes<Real>(__builtin_shufflevector(xy01, xy23, 2, 3, 10, 11, 6, 7, 14, 15)),
            Lanes<Real>(__builtin_shufflevector(zw01, zw23, 0, 1, 8, 9, 4, 5, 12, 13)),
            Lanes<Real>(__builtin_shufflevector(zw01, zw23, 2, 3, 10, 11, 6, 7, 14, 15))};
}

#else

template <class Real, class... Rows>
ANEURYSM_INLINE RowLanes<Real> transposed(const Row<Real>* first, const Rows*... others)
{
    const Row<Real>* const rows[]{first, others...};
    RowLanes<Real> r;
    for (int l = 0; l < lane_count; ++l) {
        r.x.v[l] = rows[l]->x;
        r.y.v[l] = rows[l]->y;
        r.z.v[l] = rows[l]->z;
        r.w.v[l] = rows[l]->w;
    }
    return r;
}

#endif

template <class Real>
ANEURYSM_INLINE RowLanes<Real> gather_rows(const Row<Real>* p, const Lanes<Index>& i)
{
    const auto& k = i.v;
    return transposed(p + k[0], p + k[1], p + k[2], p + k[3], p + k[4], p + k[5], p + k[6], p + k[7]);
}
template <class Real>
ANEURYSM_INLINE RowLanes<Real> load_rows(const Row<Real>* p, Lane)
{
    return transposed(p, p + 1, p + 2, p + 3, p + 4, p + 5, p + 6, p + 7);
}

/// That of lane 0, where all are equal.
template <class T>
ANEURYSM_INLINE T first(const Lanes<T>& a)
{
    return a.v[0];
}
template <class T>
ANEURYSM_INLINE T sum(const Lanes<T>& a, Lane)
{
#ifndef ANEURYSM_NO_SIMD
    const auto four =
        __builtin_shufflevector(a.v, a.v, 0, 1, 2, 3) + __builtin_shufflevector(a.v, a.v, 4, 5, 6, 7);
    const auto two = __builtin_shufflevector(four, four, 0, 1) + __builtin_shufflevector(four, four, 2, 3);
    return two[0] + two[1];
#else
    const auto& v = a.v;
    return ((v[0] + v[4]) + (v[2] + v[6])) + ((v[1] + v[5]) + (v[3] + v[7]));
#endif
}

/// One bit for each lane.
ANEURYSM_INLINE unsigned bits(const Mask& m)
{
#if defined(__AVX__) && !defined(ANEURYSM_NO_SIMD)
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(m.v)));
#else
    unsigned all = 0;
    for (int l = 0; l < lane_count; ++l) {
        all |= m.v[l] != 0 ? 1U << l : 0;
    }
    return all;
#endif
}

/// Without a branch: each value is written, and overwritten unless its lane is held. The list needs eight
/// places behind its last for that.
ANEURYSM_INLINE Index append(Index* list, Index count, const Mask& m, const Lanes<Index>& value, Lane)
{
#if defined(__AVX512VL__) && !defined(ANEURYSM_NO_SIMD)
    const auto held = static_cast<__mmask8>(bits(m));
    const __m256i packed = _mm256_maskz_compress_epi32(held, reinterpret_cast<__m256i>(value.v));
    _mm256_storeu_si256(reinterpret_cast<__m256i_u*>(list + count),
                        packed); // NOLINT: what the instruction takes
    return count + __builtin_popcount(held);
#else
    for (int l = 0; l < lane_count; ++l) {
        list[count] = value.v[l];
        count -= m.v[l];
    }
    return count;
#endif
}
ANEURYSM_INLINE Index count(const Mask& m, Lane)
{
    return __builtin_popcount(bits(m));
}

} // namespace aneurysm::device
