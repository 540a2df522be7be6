// SPDX-License-Identifier: Apache-2.0
// Section 3.4: the radii of a branching artery, (24).
#pragma once

namespace aneurysm::device
{

/// Eq. (24)  Murray's law r_0^3 = r_1^3 + r_2^3 for two equal daughters, 2 r_1^3 = r_0^3:
///
///     r_1 = r_2 = r_0 / 2^(1/3)                                                               [m]
constexpr double daughter_radius(double r_0)
{
    return r_0 / 1.25992104989487316;
}

} // namespace aneurysm::device
