// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/vessel/geometry.hpp"

#include <vtkRenderer.h>

#include <array>
#include <string>
#include <string_view>

namespace aneurysm::pictures
{

/// Where the scene is seen from.
enum class View {
    front,  ///< along -z, the plane of the branches upright
    tilted, ///< from the right and a little above
    side,   ///< along -x, the branches one behind the other
    sac,    ///< the sac alone, tilted
    breach, ///< the sac from above
};
inline constexpr std::array<std::string_view, 5> view_names{"front", "tilted", "side", "sac", "breach"};

/// Points the camera at the artery, or at its sac, such that the largest sac and all blood fit into the
/// middle `width` x `height` of the renderer's picture (1: all of it). \pre the vessel is an artery
void look(vtkRenderer& renderer, const Vessel& vessel, View view, double width, double height);

} // namespace aneurysm::pictures
