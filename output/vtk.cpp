// SPDX-License-Identifier: Apache-2.0
#include "output/vtk.hpp"

#include "common/file.hpp"
#include "output/file.hpp"
#include "output/hdf5.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

namespace aneurysm::output
{
namespace
{

constexpr std::uint8_t vtk_vertex = 1;
constexpr std::uint8_t vtk_polygon = 7;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Cells of one type: the numbers of their points, one cell after the other, and where each cell ends.
struct Cells {
    std::uint8_t type;
    std::vector<std::int64_t> points;
    std::vector<std::int64_t> ends;
};

Cells vertices(std::size_t count)
{
    Cells cells{vtk_vertex, std::vector<std::int64_t>(count), std::vector<std::int64_t>(count)};
    std::iota(cells.points.begin(), cells.points.end(), 0);
    std::iota(cells.ends.begin(), cells.ends.end(), 1);
    return cells;
}

hdf5::Group create_grid(const hdf5::File& image, const std::vector<Vec3>& points, Cells cells)
{
    const hdf5::Group grid = image.root().create_group("VTKHDF");
    grid.write_attribute("Version", std::array<std::int64_t, 2>{1, 0});
    grid.write_attribute("Type", std::string("UnstructuredGrid"));
    const auto write_count = [&grid](const char* name, std::size_t count) {
        grid.write(name, std::vector{static_cast<std::int64_t>(count)});
    };
    write_count("NumberOfPoints", points.size());
    write_count("NumberOfCells", cells.ends.size());
    write_count("NumberOfConnectivityIds", cells.points.size());
    grid.write("Connectivity", cells.points);
    grid.write("Types", std::vector<std::uint8_t>(cells.ends.size(), cells.type));
    cells.ends.insert(cells.ends.begin(), 0);
    grid.write("Offsets", cells.ends);
    grid.write("Points", points);
    grid.describe("Points", "units", "m");
    return grid;
}

std::vector<Vec3> read_finite(const hdf5::Group& group, const char* name)
{
    const std::vector<Vec3> vectors = group.read_vectors(name);
    const auto bad = std::find_if_not(vectors.begin(), vectors.end(), is_finite<double>);
    if (bad != vectors.end()) {
        group.task().fail(name, "row " + std::to_string(bad - vectors.begin()) + " is not finite");
    }
    return vectors;
}

std::vector<Kind> read_kinds(const hdf5::Group& group)
{
    const std::vector<Kind> kinds = group.read_kinds("kind");
    if (std::ranges::find(kinds, Kind::reserve) != kinds.end()) {
        group.task().fail("kind", "unknown value 0");
    }
    return kinds;
}

/// One number or vector for each particle.
template <class Value>
void check_size(const hdf5::Group& group, const char* name, const std::vector<Value>& values,
                std::size_t count)
{
    if (values.size() != count) {
        group.task().fail(name, std::to_string(values.size()) + " rows for " + std::to_string(count) +
                                    " particles");
    }
}

} // namespace

ShownParticles shown_particles(const ParticleFields& fields)
{
    const Particles& p = fields.particles;
    ShownParticles shown;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] != Kind::reserve) {
            shown.id.push_back(static_cast<std::int64_t>(i));
            shown.position.push_back(p.position[i]);
            shown.velocity.push_back(p.velocity[i]);
            shown.density.push_back(fields.density.empty() ? unknown : fields.density[i]);
            shown.pressure.push_back(p.pressure[i] == unset_pressure ? 0 : p.pressure[i]);
            shown.kind.push_back(p.kind[i]);
        }
    }
    return shown;
}

void write_vtk(const std::filesystem::path& file, const ParticleFields& fields)
{
    const ShownParticles shown = shown_particles(fields);
    const hdf5::File image(file.string());
    {
        const hdf5::Group grid = create_grid(image, shown.position, vertices(shown.size()));
        const hdf5::Group data = grid.create_group("PointData");
        data.write("id", shown.id);
        data.write("kind", shown.kind);
        data.describe("kind", "meaning",
                      "1 blood in the artery, 2 blood beyond the breach, 3 in the inlet's buffer, "
                      "4 and 5 in the buffers of the outlets");
        data.write("velocity", shown.velocity);
        data.describe("velocity", "units", "m/s");
        data.write("density", shown.density);
        data.describe("density", "units", "kg/m^3");
        data.write("pressure", shown.pressure);
        data.describe("pressure", "units", "Pa");
    }
    write_atomically(file, image.image());
}

void write_vtk(const std::filesystem::path& file, const Surface& surface, const std::string& meaning)
{
    const hdf5::File image(file.string());
    {
        const hdf5::Group grid =
            create_grid(image, surface.points, {vtk_polygon, surface.corners, surface.ends});
        const hdf5::Group data = grid.create_group("CellData");
        data.write("part", surface.part);
        data.describe("part", "meaning", meaning);
    }
    write_atomically(file, image.image());
}

ShownParticles read_vtk(const std::filesystem::path& file)
{
    const std::string bytes = read_text(file);
    const hdf5::File image(bytes, file.string());
    const hdf5::Group grid = image.root().open_group("VTKHDF");
    const hdf5::Group data = grid.open_group("PointData");
    ShownParticles shown{.id = data.read<std::int64_t>("id"),
                         .position = read_finite(grid, "Points"),
                         .velocity = read_finite(data, "velocity"),
                         .density = data.read<double>("density"),
                         .pressure = data.read<double>("pressure"),
                         .kind = read_kinds(data)};
    check_size(data, "id", shown.id, shown.size());
    check_size(data, "velocity", shown.velocity, shown.size());
    check_size(data, "density", shown.density, shown.size());
    check_size(data, "pressure", shown.pressure, shown.size());
    check_size(data, "kind", shown.kind, shown.size());
    return shown;
}

} // namespace aneurysm::output
