// SPDX-License-Identifier: Apache-2.0
// A run directory read back: what was written, or an error that names the file and what in it is bad.
#include "output/file.hpp"
#include "output/frames.hpp"
#include "output/hdf5.hpp"
#include "output/recorded_run.hpp"
#include "output/run_directory.hpp"
#include "tests/files.hpp"

#include <vector>

using namespace aneurysm;
using namespace aneurysm::output;
using namespace aneurysm::test;

namespace
{

const Engine engine{Backend::reference, Precision::double_, "a test"};

/// A run of three frames with particles for the first and the last.
fs::path make_run(const fs::path& directory)
{
    RunDirectory run = RunDirectory::create(directory, scenario(), engine);
    for (std::int64_t frame = 1; frame <= 3; ++frame) {
        const SimulationState state = any_state(frame);
        run.append(any_record(frame), state);
        if (frame != 2) {
            run.write_particles(frame, {state.particles, {}});
        }
    }
    run.close(RunStatus::finished, "");
    return directory;
}

/// Both, but for densities that aren't known.
bool same(const ShownParticles& a, const ShownParticles& b)
{
    return a.id == b.id && a.position == b.position && a.velocity == b.velocity && a.pressure == b.pressure &&
           a.kind == b.kind && a.size() == b.size();
}

/// A particle file without the array `missing`, with `extra` more rows of pressure than of the others.
void write_damaged(const fs::path& file, const std::string& missing, std::size_t extra, std::uint8_t kind)
{
    const hdf5::File image(file.string());
    {
        const hdf5::Group grid = image.root().create_group("VTKHDF");
        const hdf5::Group data = grid.create_group("PointData");
        const std::vector<double> three(3);
        const auto write = [&](const hdf5::Group& group, const std::string& name, const auto& values,
                               std::size_t columns = 1) {
            if (name != missing) {
                group.write(name, values, columns);
            }
        };
        const std::vector<double> one(1);
        const std::vector<double> pressures(1 + extra);
        const std::vector<std::int64_t> id(1);
        const std::vector<std::uint8_t> kinds{kind};
        write(grid, "Points", three, 3);
        write(data, "velocity", three, 3);
        write(data, "density", one);
        write(data, "pressure", pressures);
        write(data, "id", id);
        write(data, "kind", kinds);
    }
    write_atomically(file, image.image());
}

} // namespace

BOOST_AUTO_TEST_CASE(particles_come_back_to_the_same_bits)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "p.hdf";
    const SimulationState state = any_state(1, 60);
    std::vector<double> density(60, 1050);
    const ParticleFields fields{state.particles, density};
    write_vtk(file, fields);
    const ShownParticles read = read_vtk(file);
    BOOST_TEST(read.size() == 50); // without the reserve
    BOOST_TEST(same(read, shown_particles(fields)));
    BOOST_TEST(read.density == shown_particles(fields).density);
    ShownParticles other = read;
    other.position[7].z = std::nextafter(other.position[7].z, 0);
    BOOST_TEST(!same(other, shown_particles(fields)));
}

BOOST_AUTO_TEST_CASE(a_bad_particle_file_is_named_with_what_is_bad)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "p.hdf";
    const auto message = [&file] { return message_of([&file] { read_vtk(file); }); };
    BOOST_TEST(contains(message(), file.string()));
    write_damaged(file, "", 0, 1);
    BOOST_TEST(message() == "");
    for (const char* name : {"Points", "velocity", "density", "pressure", "id", "kind"}) {
        write_damaged(file, name, 0, 1);
        BOOST_TEST(contains(message(), file.string()));
        BOOST_TEST(contains(message(), name));
    }
    write_damaged(file, "", 1, 1);
    BOOST_TEST(contains(message(), "pressure (2 rows for 1 particles)"));
    for (const int kind : {0, 6}) {
        write_damaged(file, "", 0, static_cast<std::uint8_t>(kind));
        BOOST_TEST(contains(message(), "kind (unknown value"));
    }
    const SimulationState state = any_state(1, 60);
    write_vtk(file, {state.particles, {}});
    fs::resize_file(file, fs::file_size(file) / 2);
    BOOST_TEST(contains(message(), file.string()));
    write_text(file, "");
    BOOST_TEST(contains(message(), "empty"));
}

BOOST_AUTO_TEST_CASE(a_run_comes_back)
{
    const Scratch scratch;
    const fs::path directory = make_run(scratch.path / "run");
    const RecordedRun run(directory);
    BOOST_TEST(scenario_hash(run.scenario()) == scenario_hash(scenario()));
    BOOST_TEST(run.particle_frames() == (std::vector<std::int64_t>{1, 3}));
    BOOST_TEST(frames_row(run.record(2)) == frames_row(any_record(2)));
    BOOST_TEST(same(run.particles(3), shown_particles({any_state(3).particles, {}})));
    const FrameRecord first = run.record(0);
    BOOST_TEST(first.radius == scenario().aneurysm.initial_radius_radii * scenario().vessel.radius_m);
    BOOST_TEST(first.frame == 0);
}

BOOST_AUTO_TEST_CASE(what_a_run_lacks_is_named)
{
    const Scratch scratch;
    const fs::path directory = make_run(scratch.path / "run");
    const RecordedRun run(directory);
    BOOST_TEST(contains(message_of([&] { run.record(4); }), "up to 3"));
    BOOST_TEST(contains(message_of([&] { run.particles(2); }), "there are: 1, 3"));
    fs::remove(directory / "particles/frame_000003.hdf");
    BOOST_TEST(contains(message_of([&] { run.particles(3); }), "frame_000003.hdf"));
    const auto message = [&] { return message_of([&] { RecordedRun{directory}; }); };
    fs::remove_all(directory / "particles");
    BOOST_TEST(contains(message(), "no particle files"));
    write_text(directory / "frames.csv", frames_header() + "\n" + frames_row(any_record(2)) + "\n");
    BOOST_TEST(contains(message(), "frames.csv: line 2"));
    fs::remove(directory / "frames.csv");
    BOOST_TEST(contains(message(), "frames.csv"));
    write_text(directory / "manifest.json", R"({"version": 1})");
    BOOST_TEST(contains(message(), "manifest.json"));
    write_text(directory / "manifest.json", R"({"scenario": {"time": 1}})");
    BOOST_TEST(contains(message(), "manifest.json"));
    fs::remove(directory / "manifest.json");
    BOOST_TEST(contains(message(), "manifest.json"));
}
