// SPDX-License-Identifier: Apache-2.0
// Arithmetic with 50 digits, in which a relation of the paper can be evaluated without an error that counts:
// what is left over is the error of the numbers put into it. For the sources in analytic/ only.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <vector>

namespace aneurysm::analytic
{

using Precise =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

inline Precise precise_pi()
{
    return acos(Precise(-1));
}

/// What is left over of terms that should add up to 0, over half the sum of their magnitudes: where one
/// number is off by a relative amount, about that times its terms' share. 0 if all terms are 0.
inline double imbalance(const std::vector<Precise>& terms)
{
    Precise sum = 0;
    Precise size = 0;
    for (const Precise& term : terms) {
        sum += term;
        size += abs(term) / 2;
    }
    return size == 0 ? 0 : static_cast<double>(sum / size);
}

/// f'(x) by a central difference over `scale` times 1e-16: good to 30 digits where f''' is about f/scale^3.
template <class Function>
Precise precise_slope(Function f, const Precise& x, const Precise& scale)
{
    const Precise step = scale * Precise("1e-16");
    return (f(x + step) - f(x - step)) / (2 * step);
}

/// f''(x) in the same way, good to 20 digits.
template <class Function>
Precise precise_curvature(Function f, const Precise& x, const Precise& scale)
{
    const Precise step = scale * Precise("1e-12");
    return (f(x + step) - 2 * f(x) + f(x - step)) / (step * step);
}

} // namespace aneurysm::analytic
