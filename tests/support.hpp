// SPDX-License-Identifier: Apache-2.0
// What the tests share. A check is written as a predicate over the candidate function, so that a test can
// assert that it holds for the reference and fails for a mutant of it.
#pragma once

#include "common/error.hpp"
#include "common/vec3.hpp"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::test
{

/// Largest relative error of one rounding of double.
inline constexpr double unit_roundoff = 0x1p-53;

/// gamma_n: largest relative error of n roundings in a row (Higham, Accuracy and Stability of Numerical
/// Algorithms, lemma 3.1).
constexpr double rounding(double n)
{
    return n * unit_roundoff / (1 - n * unit_roundoff);
}

/// Whether |value - expected| <= tolerance; false for NaN. `--log_level=message` shows measured / allowed.
inline bool within(double value, double expected, double tolerance)
{
    const double error = std::abs(value - expected);
    BOOST_TEST_MESSAGE("    error " << error << " / " << tolerance << " allowed, value " << expected);
    return error <= tolerance;
}

/// Largest magnitude among the components of a difference.
inline double distance(const Vec3& a, const Vec3& b)
{
    const Vec3 d = a - b;
    return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
}

/// The usual mutant: `function`, its result off by a relative amount.
template <class Function>
auto off_by(double relative, Function function)
{
    return [=](const auto&... arguments) { return (1 + relative) * function(arguments...); };
}

/// What the error says that action() ends in; nothing when it ends well.
template <class Action>
std::string message_of(Action action)
{
    try {
        action();
    } catch (const Error& error) {
        BOOST_TEST_MESSAGE(error.what());
        return error.what();
    }
    return "";
}

inline bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace aneurysm::test
