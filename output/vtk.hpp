// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/particles.hpp"

#include <filesystem>
#include <span>

namespace aneurysm::output
{

/// What a particle file shows.
struct ParticleFields {
    const Particles& particles;
    std::span<const double> density; ///< by particle [kg/m^3]; empty when not known yet, which shows as NaN
};

/// The particles but for the reserve, as VTKHDF 1.0 (an unstructured grid of vertices): VTK 9.1,
/// ParaView 5.10 and later read it. \throws Error
void write_vtk(const std::filesystem::path& file, const ParticleFields& fields);

} // namespace aneurysm::output
