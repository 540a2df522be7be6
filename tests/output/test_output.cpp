// SPDX-License-Identifier: Apache-2.0
// What a run leaves on disk: complete, exact, and whole when something fails.
#include "common/hash.hpp"
#include "output/frames.hpp"
#include "output/hdf5.hpp"
#include "output/run_directory.hpp"
#include "tests/files.hpp"

#include <nlohmann/json.hpp>

using namespace aneurysm;
using namespace aneurysm::output;
using namespace aneurysm::test;

namespace
{

const Engine engine{Backend::reference, Precision::double_, "a test"};

} // namespace

BOOST_AUTO_TEST_CASE(fnv1a_gives_its_published_values)
{
    const auto hash = [](std::string_view text) {
        Fnv1a h;
        h.add(std::as_bytes(std::span(text)));
        return h.hex();
    };
    BOOST_TEST(hash("") == "cbf29ce484222325");
    BOOST_TEST(hash("a") == "af63dc4c8601ec8c");
    BOOST_TEST(hash("foobar") == "85944171f73967e8");
}

BOOST_AUTO_TEST_CASE(rows_come_back_to_the_same_bits)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "frames.csv";
    FrameRecord first = any_record(1);
    write_text(file, frames_header() + "\n" + frames_row(first) + "\n");
    std::vector<FrameRecord> rows = read_frames(file);
    BOOST_REQUIRE(rows.size() == 1);
    BOOST_TEST(frames_row(rows[0]) == frames_row(first));
    BOOST_TEST(std::bit_cast<std::uint64_t>(rows[0].radius) == std::bit_cast<std::uint64_t>(first.radius));
    BOOST_TEST(std::bit_cast<std::uint64_t>(rows[0].time) == std::bit_cast<std::uint64_t>(first.time));
    BOOST_TEST(rows[0].ledger.missed == first.ledger.missed);

    write_text(file, frames_header() + "\n1,2,three\n");
    BOOST_TEST(contains(message_of([&] { read_frames(file); }), "line 2"));
    write_text(file, "frame\n1\n");
    BOOST_TEST(contains(message_of([&] { read_frames(file); }), "line 1"));
}

BOOST_AUTO_TEST_CASE(rows_are_taken_only_as_they_are_written)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "frames.csv";
    const std::string header = frames_header() + "\n";
    const std::string row = frames_row(any_record(1));
    const auto message = [&](const std::string& text) {
        write_text(file, text);
        return message_of([&] { read_frames(file); });
    };
    BOOST_TEST(message(header + row + "\n").empty());
    for (const std::string& bad : {row + ",", row + ",5\n", row + "\r\n", "0" + row + "\n"}) {
        BOOST_TEST(contains(message(header + bad), "line 2: "), bad);
    }
    // Cut within the last number, which then is another one.
    BOOST_TEST(contains(message(header + row.substr(0, row.size() - 1)), "line 2: not as a run writes it"));
    BOOST_TEST(contains(message(frames_header()), "line 1"));
    const std::string escape = message(header + "\x1b[2J" + std::string(1000, 'x') + "\n");
    BOOST_TEST(contains(escape, "unreadable frame (?[2Jxxx"));
    BOOST_TEST(escape.size() < 300U);
}

BOOST_AUTO_TEST_CASE(an_atomic_write_that_fails_leaves_the_old_file)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "file";
    write_atomically(file, "old");
    fs::create_directory(scratch.path / "file.tmp"); // in the way
    BOOST_TEST(contains(message_of([&] { write_atomically(file, "new"); }), file.string()));
    BOOST_TEST(read_text(file) == "old");
    BOOST_TEST(
        contains(message_of([&] { write_atomically(scratch.path / "no/file", "new"); }), "No such file"));
}

BOOST_AUTO_TEST_CASE(lines_are_whole_or_not_there)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "lines";
    {
        LineFile lines(file, LineFile::Mode::create);
        lines.append("one");
        lines.append("two");
        lines.append("three");
        BOOST_TEST(contains(message_of([&] { LineFile(file, LineFile::Mode::append); }), "another run"));
    }
    BOOST_TEST(contains(message_of([&] { LineFile(file, LineFile::Mode::create); }), "exists"));
    LineFile lines(file, LineFile::Mode::append);
    lines.keep(2);
    BOOST_TEST(read_text(file) == "one\ntwo\n");
    lines.append("four");
    BOOST_TEST(read_text(file) == "one\ntwo\nfour\n");
    BOOST_CHECK_THROW(lines.keep(4), InputError);

    LineFile full("/dev/full", LineFile::Mode::append);
    BOOST_TEST(contains(message_of([&] { full.append("no space"); }), "/dev/full"));
}

BOOST_AUTO_TEST_CASE(a_run_directory_holds_what_happened)
{
    const Scratch scratch;
    const fs::path out = scratch.path / "some/where";
    const SimulationState s = any_state(1);
    {
        RunDirectory run = RunDirectory::create(out, scenario(), engine);
        BOOST_TEST(contains(message_of([&] { RunDirectory::create(out, scenario(), engine); }), "it exists"));
        run.append(any_record(1), s);
        run.write_checkpoint(s);
        run.close(RunStatus::failed, "on purpose");
    }
    const auto manifest = nlohmann::json::parse(read_text(out / "manifest.json"));
    BOOST_TEST(manifest["status"] == "failed");
    BOOST_TEST(manifest["message"] == "on purpose");
    BOOST_TEST(manifest["frames"] == 1);
    BOOST_TEST(manifest["backend"] == "reference");
    BOOST_TEST(manifest["scenario_hash"] == scenario_hash(scenario()));
    BOOST_TEST(manifest["scenario"]["particles"]["count"] == scenario().particles.count);
    BOOST_TEST(manifest["state_hash"] == state_hash(s));
    for (const char* key :
         {"version", "commit", "compiler", "flags", "precision", "device", "started", "written"}) {
        BOOST_TEST(!manifest[key].get<std::string>().empty(), key);
    }
    BOOST_TEST(read_text(out / "hashes.csv") == hashes_header() + "\n" + hashes_row(s) + "\n");
}

BOOST_AUTO_TEST_CASE(resuming_goes_back_to_the_checkpoint)
{
    const Scratch scratch;
    const fs::path out = scratch.path / "run";
    const std::vector<double> density(1500, 1050);
    const Vessel vessel(scenario(), 0.4);
    {
        RunDirectory run = RunDirectory::create(out, scenario(), engine);
        for (std::int64_t frame = 1; frame <= 4; ++frame) {
            const SimulationState s = any_state(frame);
            run.append(any_record(frame), s);
            run.write_particles(frame, {s.particles, density});
            run.write_wall(frame, vessel, {0.4, std::nullopt});
            if (frame == 2) {
                run.write_checkpoint(s);
            }
        }
    }
    const Checkpoint checkpoint = read_checkpoint(RunDirectory::checkpoint_file(out));
    BOOST_TEST(contains(message_of([&] {
                            RunDirectory::resume(out, checkpoint, {Backend::cpu, Precision::double_, ""});
                        }),
                        "backend"));
    BOOST_TEST(
        contains(message_of([&] { RunDirectory::resume(out / "no", checkpoint, engine); }), "manifest.json"));
    RunDirectory::resume(out, checkpoint, engine);
    BOOST_TEST(read_frames(RunDirectory::frames_file(out)).size() == 2);
    for (const std::string kind : {"particles", "wall"}) {
        BOOST_TEST(fs::exists(out / kind / "frame_000002.hdf"));
        BOOST_TEST(!fs::exists(out / kind / "frame_000003.hdf"));
        const auto series = nlohmann::json::parse(read_text(out / (kind + ".hdf.series")));
        BOOST_TEST(series["files"].size() == 2);
        BOOST_TEST(series["files"][1]["name"] == kind + "/frame_000002.hdf");
        BOOST_TEST(series["files"][1]["time"] == 0.002);
    }
}

BOOST_AUTO_TEST_CASE(particle_files_are_vtkhdf)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "p.hdf";
    SimulationState s = any_state(1, 60); // ten of each kind, the reserve included
    s.particles.pressure[1] = unset_pressure;
    std::vector<double> density;
    for (std::size_t i = 0; i < 60; ++i) {
        density.push_back(static_cast<double>(i));
    }
    write_vtk(file, {s.particles, density});

    const std::string bytes = read_text(file);
    const hdf5::File image(bytes, "p");
    const hdf5::Group grid = image.root().open_group("VTKHDF");
    BOOST_TEST(grid.read_text_attribute("Type") == "UnstructuredGrid");
    for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"}) {
        BOOST_TEST(grid.read<std::int64_t>(name) == std::vector<std::int64_t>{50});
    }
    BOOST_TEST(grid.read<double>("Points", 3).size() == 150);
    BOOST_TEST(grid.read<double>("Points", 3)[2] == s.particles.position[1].z);
    BOOST_TEST(grid.read<std::uint8_t>("Types") == std::vector<std::uint8_t>(50, 1));
    const auto offsets = grid.read<std::int64_t>("Offsets");
    BOOST_TEST(offsets.size() == 51);
    BOOST_TEST(offsets.back() == 50);
    BOOST_TEST(grid.read<std::int64_t>("Connectivity").back() == 49);
    const hdf5::Group points = grid.open_group("PointData");
    const auto id = points.read<std::int64_t>("id");
    const auto kind = points.read<std::uint8_t>("kind");
    for (std::size_t i = 0; i < id.size(); ++i) {
        BOOST_TEST(points.read<double>("density")[i] == static_cast<double>(id[i]));
        BOOST_TEST(kind[i] == id[i] % 6);
        BOOST_TEST(kind[i] != 0);
    }
    BOOST_TEST(points.read<double>("velocity", 3).size() == 150);
    const auto pressure = points.read<double>("pressure");
    BOOST_TEST(pressure.size() == 50);
    BOOST_TEST(pressure[0] == 0);
    BOOST_TEST(pressure[1] == s.particles.pressure[2]);
    BOOST_TEST(points.description("velocity", "units") == "m/s");
    BOOST_TEST(points.description("density", "units") == "kg/m^3");
    BOOST_TEST(points.description("pressure", "units") == "Pa");
    BOOST_TEST(grid.description("Points", "units") == "m");
    BOOST_CHECK_NO_THROW(write_vtk(file, {s.particles, {}}));
}
