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
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// One vertex cell for each point.
void write_cells(const hdf5::Group& group, std::size_t count)
{
    const auto n = static_cast<std::int64_t>(count);
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
        group.write(name, std::vector{n});
    }
    std::vector<std::int64_t> numbers(count + 1);
    std::iota(numbers.begin(), numbers.end(), 0);
    group.write("Offsets", numbers);
    numbers.pop_back();
    group.write("Connectivity", numbers);
    group.write("Types", std::vector<std::uint8_t>(count, vtk_vertex));
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
        const hdf5::Group root = image.root();
        const hdf5::Group grid = root.create_group("VTKHDF");
        grid.write_attribute("Version", std::array<std::int64_t, 2>{1, 0});
        grid.write_attribute("Type", std::string("UnstructuredGrid"));
        write_cells(grid, shown.id.size());
        grid.write("Points", shown.position);
        const hdf5::Group data = grid.create_group("PointData");
        data.write("id", shown.id);
        data.write("kind", shown.kind);
        data.write("velocity", shown.velocity);
        data.write("density", shown.density);
        data.write("pressure", shown.pressure);
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
