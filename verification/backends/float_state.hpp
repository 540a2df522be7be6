// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/particles.hpp"

namespace aneurysm::backends
{

/// Places, velocities and pressures as a float holds them.
inline void round_to_float(Particles& p)
{
    const auto round = [](double& x) { x = static_cast<double>(static_cast<float>(x)); };
    const auto round_all = [&round](std::vector<Vec3>& vectors) {
        for (Vec3& a : vectors) {
            round(a.x);
            round(a.y);
            round(a.z);
        }
    };
    round_all(p.position);
    round_all(p.velocity);
    for (double& pressure : p.pressure) {
        round(pressure);
    }
}

} // namespace aneurysm::backends
