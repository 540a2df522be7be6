// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vec3.hpp"

#include <Eigen/Core>

namespace aneurysm::checks
{

inline Vec3 to_vec3(const Eigen::Vector3d& v)
{
    return {v.x(), v.y(), v.z()};
}
inline Eigen::Vector3d to_eigen(const Vec3& v)
{
    return {v.x, v.y, v.z};
}

} // namespace aneurysm::checks
