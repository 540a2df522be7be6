// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "common/particles.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace aneurysm::output
{

/// What a particle file shows.
struct ParticleFields {
    const Particles& particles;
    std::span<const double> density; ///< by particle [kg/m^3]; empty when not known yet, which shows as NaN
};

/// The particles but for the reserve, as VTKHDF 1.0 (an unstructured grid of vertices): VTK 9.1,
/// ParaView 5.10 and later read it. Each array has its unit as the attribute `units`. \throws Error
void write_vtk(const std::filesystem::path& file, const ParticleFields& fields);

/// Polygons in space.
struct Surface {
    std::vector<Vec3> points;          ///< [m]
    std::vector<std::int64_t> corners; ///< numbers of points, polygon after polygon
    std::vector<std::int64_t> ends;    ///< by polygon, how many corners there are up to its last
    std::vector<std::uint8_t> part;    ///< by polygon, what it belongs to
};

/// An unstructured grid of polygons with the array `part`; its attribute `meaning` says what the numbers mean.
/// \throws Error
void write_vtk(const std::filesystem::path& file, const Surface& surface, const std::string& meaning);

/// What a particle file holds: all but the reserve, in the order of the particles'
/// numbers. Every array has size() entries.
struct ShownParticles {
    std::vector<std::int64_t> id;
    std::vector<Vec3> position;   ///< [m]
    std::vector<Vec3> velocity;   ///< [m/s]
    std::vector<double> density;  ///< NaN when not known yet [kg/m^3]
    std::vector<double> pressure; ///< 0 where there is none yet [Pa]
    std::vector<Kind> kind;       ///< never the reserve

    std::size_t size() const { return position.size(); }
    /// Whether it is blood in the artery or beyond the breach, not in the buffer of an open end.
    bool is_blood(std::size_t i) const { return kind[i] == Kind::fluid || kind[i] == Kind::escaped; }
};

/// What write_vtk writes of these.
ShownParticles shown_particles(const ParticleFields& fields);

/// The inverse of write_vtk. \throws InputError that names the file and what in it is missing or bad
ShownParticles read_vtk(const std::filesystem::path& file);

} // namespace aneurysm::output
