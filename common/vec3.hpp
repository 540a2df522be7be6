// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/host_device.hpp"

#include <cmath>

namespace aneurysm
{

/// A vector in three dimensions. Every operation is written out, so that its rounding is fixed by the source.
template <class Real>
struct Vec3T {
    Real x = 0;
    Real y = 0;
    Real z = 0;

    ANEURYSM_INLINE constexpr Vec3T& operator+=(const Vec3T& b)
    {
        x += b.x;
        y += b.y;
        z += b.z;
        return *this;
    }
    ANEURYSM_INLINE constexpr Vec3T& operator-=(const Vec3T& b)
    {
        x -= b.x;
        y -= b.y;
        z -= b.z;
        return *this;
    }
};

template <class Real>
ANEURYSM_INLINE constexpr bool operator==(const Vec3T<Real>& a, const Vec3T<Real>& b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}
template <class Real>
ANEURYSM_INLINE constexpr Vec3T<Real> operator+(Vec3T<Real> a, const Vec3T<Real>& b)
{
    return a += b;
}
template <class Real>
ANEURYSM_INLINE constexpr Vec3T<Real> operator-(Vec3T<Real> a, const Vec3T<Real>& b)
{
    return a -= b;
}
template <class Real>
ANEURYSM_INLINE constexpr Vec3T<Real> operator-(const Vec3T<Real>& a)
{
    return {-a.x, -a.y, -a.z};
}
template <class Real>
ANEURYSM_INLINE constexpr Vec3T<Real> operator*(Real s, const Vec3T<Real>& a)
{
    return {s * a.x, s * a.y, s * a.z};
}
template <class Real>
ANEURYSM_INLINE constexpr Vec3T<Real> operator*(const Vec3T<Real>& a, Real s)
{
    return s * a;
}
template <class Real>
ANEURYSM_INLINE constexpr Vec3T<Real> operator/(const Vec3T<Real>& a, Real s)
{
    return {a.x / s, a.y / s, a.z / s};
}
template <class Real>
ANEURYSM_INLINE constexpr Real dot(const Vec3T<Real>& a, const Vec3T<Real>& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class Real>
ANEURYSM_INLINE constexpr Vec3T<Real> cross(const Vec3T<Real>& a, const Vec3T<Real>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class Real>
ANEURYSM_INLINE Real length(const Vec3T<Real>& a)
{
    return std::sqrt(dot(a, a));
}
template <class Real>
ANEURYSM_HD bool is_finite(const Vec3T<Real>& a)
{
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

using Vec3 = Vec3T<double>;

} // namespace aneurysm
