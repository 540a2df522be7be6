// SPDX-License-Identifier: Apache-2.0
// Running error analysis: numbers that carry a bound of their rounding (Higham, Accuracy and Stability of
// Numerical Algorithms, section 3.3).
#pragma once

#include "common/backend.hpp"
#include "common/vec3.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::bounds
{

/// Largest relative error of one rounding to `precision`: 2^-24 for float, 2^-53 for double.
constexpr double unit_roundoff(Precision precision)
{
    return precision == Precision::float_ ? 0x1p-24 : 0x1p-53;
}

/// What separates two computations of the same number, the reference's in double and the candidate's: both
/// round, so one operation moves them apart by at most U = u_candidate + u_double of its result. Bounds are
/// kept to first order, in units of U.
class Rounding
{
public:
    explicit Rounding(double candidate)
        : unit_(candidate + 0x1p-53), smallest_normal_(candidate > 0x1p-53 ? 0x1p-126 : 0x1p-1022)
    {
    }

    /// A bound in units of U as a number. Products of two relative errors are left out of the units; each is
    /// below 1 % of a first-order term, since no relative error here reaches 1 %. Below the smallest normal number
    /// a rounding is off by a part of that instead, 2^-24 or 2^-53 of it: this covers millions of them.
    double absolute(double units) const { return units == 0 ? 0 : 1.01 * unit_ * units + smallest_normal_; }
    double units(double absolute) const { return absolute / unit_; }
    /// What is lost of a norm whose components' squares lie below the smallest normal number, in units of U.
    double lost_in_norm() const { return units(std::sqrt(4 * unit_ * smallest_normal_)); }

private:
    double unit_;
    double smallest_normal_;
};

/// A number as the reference computes it, and how far the candidate's can be from it [in U].
struct Inexact {
    double value = 0;
    double error = 0;

    Inexact operator-() const { return {-value, error}; }
    Inexact& operator+=(const Inexact& b)
    {
        value += b.value;
        error += b.error + std::abs(value);
        return *this;
    }
    Inexact& operator-=(const Inexact& b) { return *this += -b; }
};

/// A number that the candidate holds rounded: a constant, or one that was computed in double.
inline Inexact rounded(double value)
{
    return {value, std::abs(value)};
}
inline Inexact operator+(Inexact a, const Inexact& b)
{
    return a += b;
}
inline Inexact operator-(Inexact a, const Inexact& b)
{
    return a -= b;
}
inline Inexact operator*(const Inexact& a, const Inexact& b)
{
    const double value = a.value * b.value;
    return {value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + std::abs(value)};
}
inline Inexact operator/(const Inexact& a, const Inexact& b)
{
    const double value = a.value / b.value;
    return {value, (a.error + std::abs(value) * b.error) / std::abs(b.value) + std::abs(value)};
}

/// A sum of products c x y, and how far rounding moves it [in U].
class SumBound
{
public:
    void add(double c, double c_error, const Inexact& x, const Inexact& y)
    {
        size_ += c * x.value * y.value;
        error_ += c * (x.error * y.value + x.value * y.error) + c_error * x.value * y.value;
    }
    /// Of the terms' sizes.
    double size() const { return size_; }
    /// The factors' errors, and the terms' roundings.
    double error(double roundings) const { return error_ + roundings * size_; }

private:
    double size_ = 0;
    double error_ = 0;
};

using InexactVec = Vec3T<Inexact>;

/// A vector each of whose components is within `error` [in U].
inline InexactVec inexact(const Vec3& a, double error)
{
    return {{a.x, error}, {a.y, error}, {a.z, error}};
}
inline InexactVec rounded(const Vec3& a)
{
    return {rounded(a.x), rounded(a.y), rounded(a.z)};
}
inline Vec3 value_of(const InexactVec& a)
{
    return {a.x.value, a.y.value, a.z.value};
}
/// Of the whole vector, as a 2-norm [in U].
inline double error_of(const InexactVec& a)
{
    return std::sqrt(a.x.error * a.x.error + a.y.error * a.y.error + a.z.error * a.z.error);
}
/// A length moves by no more than its vector; squares, sums and root round it by 3 more.
inline Inexact norm(const InexactVec& a)
{
    const double value = length(value_of(a));
    return {value, error_of(a) + 3 * value};
}

/// The outcome of a comparison for both: `open` when their numbers may lie on different sides.
enum class Truth { no, yes, open };

inline Truth is_positive(const Inexact& a, const Rounding& rounding)
{
    if (!(std::abs(a.value) > rounding.absolute(a.error))) {
        return Truth::open;
    }
    return a.value > 0 ? Truth::yes : Truth::no;
}
inline Truth operator&&(Truth a, Truth b)
{
    if (a == Truth::no || b == Truth::no) {
        return Truth::no;
    }
    return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::open;
}
inline Truth operator!(Truth a)
{
    return a == Truth::open ? a : (a == Truth::yes ? Truth::no : Truth::yes);
}

} // namespace aneurysm::bounds
