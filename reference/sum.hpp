// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vec3.hpp"

#include <cmath>

namespace aneurysm::reference
{

/// A sum with the sum of its terms' magnitudes beside it, from which rounding bounds follow: the computed
/// value is within gamma_n * magnitude of the exact one. Every SPH sum is a template on its accumulator; the
/// solver takes the plain number, verification takes these.
struct BoundedSum {
    double value = 0;
    double magnitude = 0;

    BoundedSum& operator+=(double term)
    {
        value += term;
        magnitude += std::abs(term);
        return *this;
    }
};

/// The same for vectors; the magnitude is that of each component.
struct BoundedVectorSum {
    Vec3 value;
    Vec3 magnitude;

    BoundedVectorSum& operator+=(const Vec3& term)
    {
        value += term;
        magnitude += Vec3{std::abs(term.x), std::abs(term.y), std::abs(term.z)};
        return *this;
    }
};

} // namespace aneurysm::reference
