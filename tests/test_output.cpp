// SPDX-License-Identifier: Apache-2.0
// What a run leaves on disk: complete, exact, and whole when something fails.
#include "common/error.hpp"
#include "common/hash.hpp"
#include "output/columns.hpp"
#include "output/frames.hpp"
#include "output/hdf5.hpp"
#include "output/run_directory.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

using namespace aneurysm;
using namespace aneurysm::output;
namespace fs = std::filesystem;

namespace
{

/// A directory of its own for each test, gone afterwards.
struct Scratch {
    Scratch() : path(fs::temp_directory_path() / ("aneurysm_" + std::to_string(std::random_device{}())))
    {
        fs::create_directory(path);
    }
    ~Scratch() { fs::remove_all(path); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    fs::path path;
};

const Engine engine{"reference", "double", "a test"};

Scenario scenario()
{
    return read_scenario(fs::path(ANEURYSM_DATA) / "scenarios/quick.json");
}

std::string text_of(const fs::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

void write_text(const fs::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}

/// Any bits that make a number, the smallest and the negative zero included.
class Numbers
{
public:
    double next()
    {
        constexpr std::array special{-0.0, 5e-324, 1.7976931348623157e308, 0.1, -1.0 / 3};
        if (count_++ % 7 == 0) {
            return special.at(count_ % special.size());
        }
        double x = std::numeric_limits<double>::quiet_NaN();
        while (!std::isfinite(x)) {
            x = std::bit_cast<double>(engine_());
        }
        return x;
    }
    std::int64_t integer() { return static_cast<std::int64_t>(engine_()); }
    Vec3 vector()
    {
        const double x = next();
        const double y = next();
        return {x, y, next()};
    }

private:
    std::mt19937_64 engine_{1};
    std::size_t count_ = 0;
};

void set(Numbers& numbers, double& x)
{
    x = numbers.next();
}
void set(Numbers& numbers, std::int64_t& x)
{
    x = numbers.integer();
}
void set(Numbers&, Phase& x)
{
    x = Phase::fully_developed;
}

SimulationState any_state(std::int64_t frame, std::size_t count = 50)
{
    Numbers numbers;
    SimulationState s;
    s.frame = frame;
    s.spacing = numbers.next();
    s.particles.mass = numbers.next();
    for (std::size_t i = 0; i < count; ++i) {
        s.particles.position.push_back(numbers.vector());
        s.particles.velocity.push_back(numbers.vector());
        s.particles.pressure.push_back(numbers.next());
        s.particles.kind.push_back(static_cast<Kind>(i % 6));
    }
    visit_aneurysm(s.aneurysm, [&](std::string_view, auto& x) { set(numbers, x); });
    visit_ledger(s.ledger, [&](std::string_view, auto& x) { set(numbers, x); });
    s.outlet_velocity[0] = numbers.next();
    s.outlet_velocity[1] = numbers.next();
    return s;
}

FrameRecord any_record(std::int64_t frame)
{
    Numbers numbers;
    FrameRecord r;
    visit_record(r, [&](std::string_view, auto& x) { set(numbers, x); });
    r.frame = frame;
    return r;
}

template <class Action>
std::string message_of(Action action)
{
    try {
        action();
    } catch (const Error& error) {
        BOOST_TEST_MESSAGE(error.what());
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

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

BOOST_AUTO_TEST_CASE(every_field_is_in_the_hash)
{
    const SimulationState s = any_state(7);
    const auto changes = [&s](auto change) {
        SimulationState other = s;
        change(other);
        return state_hash(other) != state_hash(s);
    };
    BOOST_TEST(!changes([](SimulationState&) {}));
    BOOST_TEST(changes([](SimulationState& o) { ++o.frame; }));
    BOOST_TEST(changes([](SimulationState& o) { o.spacing = 1; }));
    BOOST_TEST(changes([](SimulationState& o) { o.particles.mass = 1; }));
    BOOST_TEST(changes([](SimulationState& o) { o.particles.position.back().z = 1; }));
    BOOST_TEST(changes([](SimulationState& o) { o.particles.velocity.front().x = 1; }));
    BOOST_TEST(changes([](SimulationState& o) { o.particles.pressure.back() = 1; }));
    BOOST_TEST(changes([](SimulationState& o) { o.particles.kind.front() = Kind::escaped; }));
    BOOST_TEST(changes([](SimulationState& o) { o.outlet_velocity[1] = 1; }));
    BOOST_TEST(changes([](SimulationState& o) { o.aneurysm.phase = Phase::ruptured; }));
    BOOST_TEST(changes([](SimulationState& o) { ++o.aneurysm.rupture_frame; }));
    BOOST_TEST(changes([](SimulationState& o) { ++o.ledger.missed; }));
}

BOOST_AUTO_TEST_CASE(a_checkpoint_comes_back_to_the_same_bits)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "checkpoint.h5";
    const SimulationState s = any_state(123);
    write_checkpoint(file, scenario(), s);
    const Checkpoint c = read_checkpoint(file);
    BOOST_TEST(to_json(c.scenario) == to_json(scenario()));
    BOOST_TEST(state_hash(c.state) == state_hash(s));
    BOOST_TEST(c.state.frame == 123);
    BOOST_TEST((c.state.particles.position == s.particles.position));
    BOOST_TEST((c.state.particles.kind == s.particles.kind));
    const std::string bytes = text_of(file);
    write_checkpoint(file, scenario(), s);
    BOOST_TEST((text_of(file) == bytes));
}

BOOST_AUTO_TEST_CASE(a_damaged_checkpoint_is_refused)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "checkpoint.h5";
    const SimulationState s = any_state(123, 10);
    write_checkpoint(file, scenario(), s);
    const std::string good = text_of(file);
    const auto refused = [&] {
        const std::string message = message_of([&] { read_checkpoint(file); });
        return message.starts_with(file.string() + ": ") && message.find('\n') == std::string::npos;
    };
    for (std::size_t size = 0; size < good.size(); size += 331) {
        write_text(file, good.substr(0, size));
        BOOST_TEST(refused(), "truncated to " << size);
    }
    for (std::size_t at = 0; at < good.size(); at += 41) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 1);
        write_text(file, bad);
        // Between the first line and HDF5's part there is nothing to damage.
        BOOST_TEST((refused() || (at > 40 && at < 512)), "byte " << at);
    }
    write_text(file, "not HDF5 at all");
    BOOST_TEST(refused());
    fs::remove(file);
    BOOST_TEST(refused());
}

BOOST_AUTO_TEST_CASE(a_foreign_checkpoint_is_refused)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "checkpoint.h5";
    const auto message = [&] { return message_of([&] { read_checkpoint(file); }); };
    const SimulationState s = any_state(1);
    write_vtk(file, {s.particles, std::vector<double>(50, 1050)});
    BOOST_TEST(contains(message(), "no checkpoint"));
    write_checkpoint(file, scenario(), s);
    const std::string good = text_of(file);
    const std::string start = "aneurysm checkpoint ";
    BOOST_REQUIRE(good.starts_with(start + "1 "));
    write_text(file, start + "2" + good.substr(start.size() + 1));
    BOOST_TEST(contains(message(), "another version (2)"));
    BOOST_TEST(contains(message(), "version 1"));
}

BOOST_AUTO_TEST_CASE(a_file_of_hdf5_that_lacks_something_is_refused)
{
    const auto message = [](auto fill, auto read) {
        const hdf5::File written("file");
        fill(written.root());
        const std::vector<std::byte> bytes = written.image();
        const hdf5::File image(bytes, "file");
        return message_of([&] { read(image.root()); });
    };
    const auto nothing = [](const hdf5::Group&) {};
    const auto numbers = [](const hdf5::Group& root) {
        const std::vector<double> values{1, 2, 3, 4};
        root.write("x", std::span(values));
        root.write_attribute("x", 1.5);
    };
    BOOST_TEST(contains(message(nothing, [](const auto& root) { root.open_group("x"); }), "cannot read x"));
    BOOST_TEST(contains(message(nothing, [](const auto& root) { root.template read<double>("x"); }),
                        "cannot read x"));
    BOOST_TEST(
        contains(message(numbers, [](const auto& root) { root.template read<std::int64_t>("x"); }), "type"));
    BOOST_TEST(
        contains(message(numbers, [](const auto& root) { root.template read<double>("x", 3); }), "columns"));
    BOOST_TEST(contains(message(numbers, [](const auto& root) { root.read_text("x"); }), "string"));
    BOOST_TEST(contains(message(numbers, [](const auto& root) { root.read_text_attribute("x"); }), "string"));
    BOOST_TEST(contains(
        message(numbers, [](const auto& root) { root.template read_attribute<std::int64_t>("x"); }), "type"));
    BOOST_TEST(message(numbers, [](const auto& root) { root.template read<double>("x"); }).empty());
    const std::vector<std::byte> none;
    BOOST_TEST(contains(message_of([&] { const hdf5::File image(none, "file"); }), "empty"));
    const std::vector<std::byte> garbage(1000, std::byte{7});
    BOOST_TEST(
        contains(message_of([&] { const hdf5::File image(garbage, "file"); }), "cannot read the file"));
}

BOOST_AUTO_TEST_CASE(an_atomic_write_that_fails_leaves_the_old_file)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "file";
    write_atomically(file, "old");
    fs::create_directory(scratch.path / "file.tmp"); // in the way
    BOOST_TEST(contains(message_of([&] { write_atomically(file, "new"); }), file.string()));
    BOOST_TEST(text_of(file) == "old");
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
    BOOST_TEST(text_of(file) == "one\ntwo\n");
    lines.append("four");
    BOOST_TEST(text_of(file) == "one\ntwo\nfour\n");
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
    const auto manifest = nlohmann::json::parse(text_of(out / "manifest.json"));
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
    BOOST_TEST(text_of(out / "hashes.csv") == hashes_header() + "\n" + hashes_row(s) + "\n");
}

BOOST_AUTO_TEST_CASE(resuming_goes_back_to_the_checkpoint)
{
    const Scratch scratch;
    const fs::path out = scratch.path / "run";
    const std::vector<double> density(50, 1050);
    {
        RunDirectory run = RunDirectory::create(out, scenario(), engine);
        for (std::int64_t frame = 1; frame <= 4; ++frame) {
            const SimulationState s = any_state(frame);
            run.append(any_record(frame), s);
            run.write_particles(frame, {s.particles, density});
            if (frame == 2) {
                run.write_checkpoint(s);
            }
        }
    }
    const Checkpoint checkpoint = read_checkpoint(RunDirectory::checkpoint_file(out));
    BOOST_TEST(contains(message_of([&] {
                            RunDirectory::resume(out, checkpoint, {"cpu", "double", ""});
                        }),
                        "backend"));
    BOOST_TEST(
        contains(message_of([&] { RunDirectory::resume(out / "no", checkpoint, engine); }), "manifest.json"));
    RunDirectory::resume(out, checkpoint, engine);
    BOOST_TEST(read_frames(RunDirectory::frames_file(out)).size() == 2);
    BOOST_TEST(fs::exists(out / "particles/frame_000002.vtkhdf"));
    BOOST_TEST(!fs::exists(out / "particles/frame_000003.vtkhdf"));
    const auto series = nlohmann::json::parse(text_of(out / "particles.vtkhdf.series"));
    BOOST_TEST(series["files"].size() == 2);
    BOOST_TEST(series["files"][1]["name"] == "particles/frame_000002.vtkhdf");
    BOOST_TEST(series["files"][1]["time"] == 0.002);
}

BOOST_AUTO_TEST_CASE(particle_files_are_vtkhdf)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "p.vtkhdf";
    const SimulationState s = any_state(1, 60); // ten of each kind, the reserve included
    std::vector<double> density;
    for (std::size_t i = 0; i < 60; ++i) {
        density.push_back(static_cast<double>(i));
    }
    write_vtk(file, {s.particles, density});

    const std::vector<std::byte> bytes = read_bytes(file);
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
    BOOST_TEST(points.read<double>("pressure").size() == 50);
    BOOST_CHECK_NO_THROW(write_vtk(file, {s.particles, {}}));
}
