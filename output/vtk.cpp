// SPDX-License-Identifier: Apache-2.0
#include "output/vtk.hpp"

#include "output/file.hpp"
#include "output/hdf5.hpp"

#include <array>
#include <limits>
#include <numeric>
#include <vector>

namespace aneurysm::output
{
namespace
{

constexpr std::uint8_t vtk_vertex = 1;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The shown particles' values, in the order of their numbers.
struct Shown {
    std::vector<std::int64_t> id;
    std::vector<double> position;
    std::vector<double> velocity;
    std::vector<double> density;
    std::vector<double> pressure;
    std::vector<std::uint8_t> kind;
};

void add(std::vector<double>& numbers, const Vec3& v)
{
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
}

Shown select(const ParticleFields& fields)
{
    const Particles& p = fields.particles;
    Shown shown;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] != Kind::reserve) {
            shown.id.push_back(static_cast<std::int64_t>(i));
            add(shown.position, p.position[i]);
            add(shown.velocity, p.velocity[i]);
            shown.density.push_back(fields.density.empty() ? unknown : fields.density[i]);
            shown.pressure.push_back(p.pressure[i]);
            shown.kind.push_back(static_cast<std::uint8_t>(p.kind[i]));
        }
    }
    return shown;
}

template <class Number>
void write(const hdf5::Group& group, const char* name, const std::vector<Number>& values,
           std::size_t columns = 1)
{
    group.write(name, std::span(values), columns);
}

/// One vertex cell for each point.
void write_cells(const hdf5::Group& group, std::size_t count)
{
    const auto n = static_cast<std::int64_t>(count);
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
        write(group, name, std::vector{n});
    }
    std::vector<std::int64_t> numbers(count + 1);
    std::iota(numbers.begin(), numbers.end(), 0);
    write(group, "Offsets", numbers);
    numbers.pop_back();
    write(group, "Connectivity", numbers);
    write(group, "Types", std::vector<std::uint8_t>(count, vtk_vertex));
}

} // namespace

void write_vtk(const std::filesystem::path& file, const ParticleFields& fields)
{
    const Shown shown = select(fields);
    const hdf5::File image(file.string());
    {
        const hdf5::Group root = image.root();
        const hdf5::Group grid = root.create_group("VTKHDF");
        grid.write_attribute("Version", std::array<std::int64_t, 2>{1, 0});
        grid.write_attribute("Type", std::string("UnstructuredGrid"));
        write_cells(grid, shown.id.size());
        write(grid, "Points", shown.position, 3);
        const hdf5::Group data = grid.create_group("PointData");
        write(data, "id", shown.id);
        write(data, "kind", shown.kind);
        write(data, "velocity", shown.velocity, 3);
        write(data, "density", shown.density);
        write(data, "pressure", shown.pressure);
    }
    write_atomically(file, std::span<const std::byte>(image.image()));
}

} // namespace aneurysm::output
