// SPDX-License-Identifier: Apache-2.0
// Included by cuda/lanes.hpp: lanes as eight threads of a warp.
#pragma once

namespace aneurysm::device
{

template <class Real>
struct RowLanes;

struct Lane {
    int id = 0;
    unsigned group = 0; ///< the eight threads in their warp's mask

    ANEURYSM_HD bool is_first() const { return id == 0; }
};

template <class T>
struct Lanes {
    T v;
    ANEURYSM_HD Lanes(T value = 0) : v(value) {}
};
using Mask = Lanes<bool>;

#define ANEURYSM_OPERATOR(op, Result)                                                                        \
    template <class T>                                                                                       \
    ANEURYSM_HD Result operator op(const Lanes<T>& a, const Lanes<T>& b)                                     \
    {                                                                                                        \
        return Result(a.v op b.v);                                                                           \
    }
ANEURYSM_OPERATOR(+, Lanes<T>)
ANEURYSM_OPERATOR(-, Lanes<T>)
ANEURYSM_OPERATOR(*, Lanes<T>)
ANEURYSM_OPERATOR(/, Lanes<T>)
ANEURYSM_OPERATOR(<, Mask)
ANEURYSM_OPERATOR(>=, Mask)
ANEURYSM_OPERATOR(==, Mask)
ANEURYSM_OPERATOR(!=, Mask)
#undef ANEURYSM_OPERATOR

ANEURYSM_HD inline Mask operator&(const Mask& a, const Mask& b)
{
    return Mask(a.v && b.v);
}
ANEURYSM_HD inline Mask operator|(const Mask& a, const Mask& b)
{
    return Mask(a.v || b.v);
}
template <class T>
ANEURYSM_HD Lanes<T> select(const Mask& m, const Lanes<T>& a, const Lanes<T>& b)
{
    return m.v ? a : b;
}
/// The same numbers in double.
template <class T>
ANEURYSM_HD Lanes<double> widen(const Lanes<T>& a)
{
    return static_cast<double>(a.v);
}
template <class T>
ANEURYSM_HD Lanes<T> sqrt(const Lanes<T>& a)
{
    return std::sqrt(a.v);
}
ANEURYSM_HD inline Lanes<Index> numbers(Lane lane)
{
    return lane.id;
}
template <class T>
ANEURYSM_HD Lanes<T> load(const T* p, Lane lane)
{
    return p[lane.id];
}
template <class T>
ANEURYSM_HD void store(T* p, const Lanes<T>& a, Lane lane)
{
    p[lane.id] = a.v;
}
template <class T>
ANEURYSM_HD Lanes<T> gather(const T* p, const Lanes<Index>& i)
{
    return p[i.v];
}
template <class Real>
ANEURYSM_HD RowLanes<Real> gather_rows(const Row<Real>* p, const Lanes<Index>& i)
{
    const Row<Real> r = p[i.v];
    return {r.x, r.y, r.z, r.w};
}
template <class Real>
ANEURYSM_HD RowLanes<Real> load_rows(const Row<Real>* p, Lane lane)
{
    const Row<Real> r = p[lane.id];
    return {r.x, r.y, r.z, r.w};
}

/// That of lane 0, where all are equal.
template <class T>
ANEURYSM_HD T first(const Lanes<T>& a)
{
    return a.v;
}
template <class T>
ANEURYSM_HD T sum(const Lanes<T>& a, [[maybe_unused]] Lane lane)
{
    T s = a.v;
#ifdef __CUDA_ARCH__
    for (int distance = lane_count / 2; distance > 0; distance /= 2) {
        s = s + __shfl_xor_sync(lane.group, s, distance, lane_count);
    }
#endif
    return s;
}

/// One bit for each lane of this group.
ANEURYSM_HD inline unsigned bits(const Mask& m, [[maybe_unused]] Lane lane)
{
#ifdef __CUDA_ARCH__
    return (__ballot_sync(lane.group, m.v) >> (threadIdx.x % 32 / lane_count * lane_count)) & 0xffU;
#else
    return m.v;
#endif
}
ANEURYSM_HD inline int ones(unsigned hits)
{
#ifdef __CUDA_ARCH__
    return __popc(hits);
#else
    return static_cast<int>(hits);
#endif
}

ANEURYSM_HD inline Index append(Index* list, Index count, const Mask& m, const Lanes<Index>& value, Lane lane)
{
    const unsigned hits = bits(m, lane);
    if (m.v) {
        list[count + ones(hits & ((1U << lane.id) - 1U))] = value.v;
    }
    return count + ones(hits);
}
ANEURYSM_HD inline Index count(const Mask& m, Lane lane)
{
    return ones(bits(m, lane));
}

} // namespace aneurysm::device
