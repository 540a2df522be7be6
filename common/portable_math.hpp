// SPDX-License-Identifier: Apache-2.0
// The transcendental functions that a run's bits depend on. C libraries, and one library on processors with
// and without fused multiplication, differ in the last bit of double results now and then; rounding the long
// double ones gives the nearest double in all but about one of a thousand such cases.
#pragma once

#include <cmath>

namespace aneurysm
{

inline double sine(double x)
{
    return static_cast<double>(std::sin(static_cast<long double>(x)));
}
inline double cosine(double x)
{
    return static_cast<double>(std::cos(static_cast<long double>(x)));
}
inline double arcsine(double x)
{
    return static_cast<double>(std::asin(static_cast<long double>(x)));
}
inline double arctangent(double y, double x)
{
    return static_cast<double>(std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
}

} // namespace aneurysm
