// SPDX-License-Identifier: Apache-2.0
// Checkpoints: every bit comes back, and nothing else is taken for one.
#include "output/checkpoint.hpp"
#include "output/file.hpp"
#include "output/frames.hpp"
#include "output/hdf5.hpp"
#include "output/vtk.hpp"
#include "tests/files.hpp"

using namespace aneurysm;
using namespace aneurysm::output;
using namespace aneurysm::test;

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
    BOOST_TEST(changes([](SimulationState& o) { o.particles.kappa.front() = 1; }));
    BOOST_TEST(changes([](SimulationState& o) { o.particles.drift.back() = 1; }));
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
    BOOST_TEST((c.state.particles.kappa == s.particles.kappa));
    BOOST_TEST((c.state.particles.drift == s.particles.drift));
    BOOST_TEST((c.state.particles.kind == s.particles.kind));
    const std::string bytes = read_text(file);
    write_checkpoint(file, scenario(), s);
    BOOST_TEST((read_text(file) == bytes));
}

BOOST_AUTO_TEST_CASE(a_damaged_checkpoint_is_refused)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "checkpoint.h5";
    const SimulationState s = any_state(123, 10);
    write_checkpoint(file, scenario(), s);
    const std::string good = read_text(file);
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

BOOST_AUTO_TEST_CASE(a_state_that_no_run_has_is_refused)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "checkpoint.h5";
    const auto message = [&file](auto change) {
        SimulationState s = any_state(1);
        change(s);
        write_checkpoint(file, scenario(), s);
        return message_of([&] { read_checkpoint(file); });
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    const std::string finite = "a particle's number that isn't finite";
    BOOST_TEST(message([](SimulationState&) {}).empty());
    BOOST_TEST(contains(message([](SimulationState& s) { s = any_state(1, 20); }), "20 particles of 1500"));
    BOOST_TEST(contains(message([](SimulationState& s) { s.frame = -1; }), "frame -1"));
    BOOST_TEST(contains(message([](SimulationState& s) { s.spacing = 0; }), "without size or mass"));
    BOOST_TEST(
        contains(message([&](SimulationState& s) { s.particles.mass = nan; }), "without size or mass"));
    BOOST_TEST(contains(message([&](SimulationState& s) { s.particles.position[7].y = nan; }), finite));
    BOOST_TEST(contains(message([&](SimulationState& s) { s.particles.velocity[7].x = infinite; }), finite));
    BOOST_TEST(contains(message([&](SimulationState& s) { s.particles.pressure[7] = nan; }), finite));
    BOOST_TEST(contains(message([&](SimulationState& s) { s.particles.kappa[7] = nan; }), finite));
    BOOST_TEST(contains(message([&](SimulationState& s) { s.particles.drift[7] = nan; }), finite));
    BOOST_TEST(contains(message([&](SimulationState& s) { s.outlet_velocity[1] = nan; }), finite));
    BOOST_TEST(
        contains(message([&](SimulationState& s) { s.aneurysm.radius = nan; }), "radius_m isn't finite"));
}

BOOST_AUTO_TEST_CASE(a_foreign_checkpoint_is_refused)
{
    const Scratch scratch;
    const fs::path file = scratch.path / "checkpoint.h5";
    const auto message = [&] { return message_of([&] { read_checkpoint(file); }); };
    const SimulationState s = any_state(1);
    write_vtk(file, {s.particles, std::vector<double>(s.particles.size(), 1050)});
    BOOST_TEST(contains(message(), "no checkpoint"));
    write_checkpoint(file, scenario(), s);
    const std::string good = read_text(file);
    const std::string start = "aneurysm checkpoint ";
    BOOST_REQUIRE(good.starts_with(start + "2 "));
    write_text(file, start + "3" + good.substr(start.size() + 1));
    BOOST_TEST(contains(message(), "another version (3)"));
    BOOST_TEST(contains(message(), "needed: version 2"));
    write_text(file, start + "1" + good.substr(start.size() + 1));
    BOOST_TEST(contains(message(), "version 1, which lacks"));
    BOOST_TEST(contains(message(), "the program that wrote this one"));
}

BOOST_AUTO_TEST_CASE(a_file_of_hdf5_that_lacks_something_is_refused)
{
    const auto message = [](auto fill, auto read) {
        const hdf5::File written("file");
        fill(written.root());
        const std::string bytes = written.image();
        const hdf5::File image(bytes, "file");
        return message_of([&] { read(image.root()); });
    };
    const auto nothing = [](const hdf5::Group&) {};
    const auto numbers = [](const hdf5::Group& root) {
        const std::vector<double> values{1, 2, 3, 4};
        root.write("x", values);
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
    const std::string none;
    BOOST_TEST(contains(message_of([&] { const hdf5::File image(none, "file"); }), "empty"));
    const std::string garbage(1000, '\7');
    BOOST_TEST(
        contains(message_of([&] { const hdf5::File image(garbage, "file"); }), "cannot read the file"));
}
