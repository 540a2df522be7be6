// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/particles.hpp"

namespace aneurysm::backends
{

/// What a float backend keeps of the particles, as it holds it.
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
    for (std::vector<double>* field : {&p.pressure, &p.kappa, &p.drift}) {
        for (double& x : *field) {
            round(x);
        }
    }
}

} // namespace aneurysm::backends
