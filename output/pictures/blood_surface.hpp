// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "output/pictures/wall_surface.hpp"
#include "output/vtk.hpp"

namespace aneurysm::pictures
{

/// What the surface of the blood is kept inside of.
struct Lumen {
    const Vessel& vessel;
    WallShape shape;
    double gap = 0;   ///< between blood and wall, so that both can be seen [m]
    double swell = 0; ///< the blood's surface is moved outwards by this, as far as the wall lets it [m]
};

/// Range of the particles' weight: it is 0 from here on. [particle spacings]
inline constexpr double blood_support = 2.2;

/// The blood's surface. Every particle spreads its volume dx^3 with the weight of Müller et al. (2003),
///
///     W(r) = 315 / (64 pi H^3) (1 - r^2/H^2)^3,    H = blood_support dx,
///
/// and the surface is where the sum is 1/2. Blood that left through the breach counts at least as a drop of
/// its volume. `cell`: distance between the grid's points [m]; `lumen`: null when nothing holds the blood.
vtkSmartPointer<vtkPolyData> blood_surface(const output::ShownParticles& particles, double spacing,
                                           const Lumen* lumen, double cell);

} // namespace aneurysm::pictures
