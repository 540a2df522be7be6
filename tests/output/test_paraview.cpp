// SPDX-License-Identifier: Apache-2.0
// What ParaView gets: the files of a run through VTK's own reader, found by the lists that ParaView opens.
#include "output/run_directory.hpp"
#include "tests/files.hpp"
#include "tests/vessels.hpp"

#include <nlohmann/json.hpp>

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkHDFReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <map>
#include <numbers>

using namespace aneurysm;
using namespace aneurysm::output;
using namespace aneurysm::test;

namespace
{

constexpr std::size_t particles = 60; ///< ten of each kind

/// Of a file by VTK's reader; none if it takes the file for none of its own.
vtkSmartPointer<vtkUnstructuredGrid> read_by_vtk(const fs::path& file)
{
    const vtkNew<vtkHDFReader> reader;
    if (reader->CanReadFile(file.c_str()) == 0) {
        return nullptr;
    }
    reader->SetFileName(file.c_str());
    reader->Update();
    return vtkUnstructuredGrid::SafeDownCast(reader->GetOutputDataObject(0));
}

/// The files of a list, by their times.
std::map<double, fs::path> files_of(const fs::path& series)
{
    std::map<double, fs::path> files;
    const auto json = nlohmann::json::parse(read_text(series));
    for (const auto& entry : json["files"]) {
        files.emplace(entry["time"].get<double>(), series.parent_path() / entry["name"].get<std::string>());
    }
    return files;
}

Vec3 point(vtkUnstructuredGrid& grid, vtkIdType i)
{
    std::array<double, 3> x{};
    grid.GetPoint(i, x.data());
    return {x[0], x[1], x[2]};
}

/// Area times normal of a polygon, in its own sense of rotation [m^2].
Vec3 area(vtkUnstructuredGrid& grid, vtkIdType cell)
{
    const vtkNew<vtkIdList> corners;
    grid.GetCellPoints(cell, corners);
    const Vec3 first = point(grid, corners->GetId(0));
    Vec3 sum;
    for (vtkIdType k = 2; k < corners->GetNumberOfIds(); ++k) {
        sum +=
            0.5 * cross(point(grid, corners->GetId(k - 1)) - first, point(grid, corners->GetId(k)) - first);
    }
    return sum;
}

/// Area times normal of a part, added up [m^2].
Vec3 area_of(vtkUnstructuredGrid& grid, WallPart part)
{
    vtkDataArray* parts = grid.GetCellData()->GetArray("part");
    Vec3 sum;
    for (vtkIdType i = 0; i < grid.GetNumberOfCells(); ++i) {
        if (parts->GetTuple1(i) == static_cast<double>(part)) {
            sum += area(grid, i);
        }
    }
    return sum;
}

/// Of a polygon of 96 corners around a circle [m^2].
double disc(double radius)
{
    return 48 * std::sin(std::numbers::pi / 48) * radius * radius;
}

bool is_near(const Vec3& a, const Vec3& b)
{
    return within(length(a - b), 0, 1e-6);
}

} // namespace

BOOST_AUTO_TEST_CASE(vtk_reads_the_particles_of_each_time)
{
    const Scratch scratch;
    const fs::path out = scratch.path / "run";
    RunDirectory run = RunDirectory::create(out, scenario(), {Backend::reference, Precision::double_, ""});
    SimulationState state;
    state.particles = {.mass = 1,
                       .position = std::vector<Vec3>(particles),
                       .velocity = std::vector<Vec3>(particles),
                       .pressure = std::vector<double>(particles),
                       .kappa = {},
                       .drift = {},
                       .kind = std::vector<Kind>(particles)};
    std::vector<double> density(particles);
    for (const std::int64_t frame : {0, 5}) {
        for (std::size_t i = 0; i < particles; ++i) {
            const auto x = static_cast<double>(i) + static_cast<double>(frame);
            state.particles.position[i] = {x, 2 * x, 3 * x};
            state.particles.velocity[i] = {-x, x, 7};
            state.particles.pressure[i] = 100 * x;
            state.particles.kind[i] = static_cast<Kind>(i % 6);
            density[i] = 1000 + x;
        }
        run.write_particles(frame, {state.particles, density});
    }
    const std::map<double, fs::path> files = files_of(out / "particles.hdf.series");
    BOOST_REQUIRE(files.size() == 2);
    const auto grid = read_by_vtk(files.at(5 * scenario().time.frame_s));
    BOOST_REQUIRE(grid != nullptr);
    BOOST_REQUIRE(grid->GetNumberOfPoints() == 50);
    BOOST_TEST(grid->GetNumberOfCells() == 50);
    BOOST_TEST(grid->GetPointData()->GetNumberOfArrays() == 5);
    const auto number = [&](const char* name, vtkIdType i, int column) {
        return grid->GetPointData()->GetArray(name)->GetComponent(i, column);
    };
    for (vtkIdType i = 0; i < 50; ++i) {
        const double id = number("id", i, 0);
        const double x = id + 5;
        BOOST_TEST((point(*grid, i) == Vec3{x, 2 * x, 3 * x}));
        BOOST_TEST(number("velocity", i, 0) == -x);
        BOOST_TEST(number("velocity", i, 2) == 7);
        BOOST_TEST(number("pressure", i, 0) == 100 * x);
        BOOST_TEST(number("density", i, 0) == 1000 + x);
        BOOST_TEST(number("kind", i, 0) == static_cast<int>(id) % 6);
    }
    fs::resize_file(files.at(0), 1000);
    BOOST_TEST(read_by_vtk(files.at(0)) == nullptr);
}

BOOST_AUTO_TEST_CASE(vtk_reads_wall_breach_and_open_ends)
{
    const Scratch scratch;
    const fs::path out = scratch.path / "run";
    const Scenario s = shipped_scenario("paper_tc1");
    const Vessel vessel = make_vessel(s);
    RunDirectory run = RunDirectory::create(out, s, {Backend::reference, Precision::double_, ""});
    const double r = s.rupture.breach_radius_radii * s.vessel.radius_m;
    run.write_wall(0, vessel, wall_shape(vessel, 0.3, false, r));
    run.write_wall(9, vessel, wall_shape(vessel, 0.35, true, r));
    const std::map<double, fs::path> files = files_of(out / "wall.hdf.series");
    BOOST_REQUIRE(files.size() == 2);
    const auto whole = read_by_vtk(files.at(0));
    const auto open = read_by_vtk(files.at(9 * s.time.frame_s));
    BOOST_REQUIRE(whole != nullptr);
    BOOST_REQUIRE(open != nullptr);
    for (vtkUnstructuredGrid* grid : {whole.Get(), open.Get()}) {
        Vec3 ends;
        for (std::size_t k = 0; k < 3; ++k) {
            const Opening& o = vessel.openings().at(k);
            const auto part = static_cast<WallPart>(static_cast<std::size_t>(WallPart::inlet) + k);
            BOOST_TEST(is_near(area_of(*grid, part), disc(o.radius) * o.outward));
            ends += std::numbers::pi * o.radius * o.radius * o.outward;
        }
        // A closed surface has no area in sum. Where it is cut, chords are c^2/8 over the radius off the rim.
        const double cell = s.vessel.radius_m / 8;
        const double breach = grid == open.Get() ? disc(std::sqrt(r * r + 3 * cell * cell)) : 0;
        const Vec3 sum = area_of(*grid, WallPart::wall) + Vec3{0, breach, 0} + ends;
        BOOST_TEST(length(sum) < 3 * 2 * std::numbers::pi * s.vessel.radius_m * cell * cell);
        BOOST_TEST(length(sum - disc(s.vessel.radius_m) * vessel.openings()[0].outward) > 0.7); // open
    }
    BOOST_TEST((area_of(*whole, WallPart::breach) == Vec3()));
    BOOST_TEST(is_near(area_of(*open, WallPart::breach), Vec3{0, disc(r), 0}));
}
