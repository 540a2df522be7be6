// SPDX-License-Identifier: Apache-2.0
#include "output/checkpoint.hpp"

#include "common/error.hpp"
#include "common/file.hpp"
#include "common/hash.hpp"
#include "common/text.hpp"
#include "output/columns.hpp"
#include "output/file.hpp"
#include "output/hdf5.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <sstream>
#include <string>
#include <type_traits>

namespace aneurysm::output
{
namespace
{

/// The file starts with a line "aneurysm checkpoint VERSION HASH" in HDF5's user block; the hash is that of
/// all bytes after the block, so that nothing damaged reaches HDF5.
constexpr std::string_view format = "aneurysm checkpoint";
constexpr int version = 2;
constexpr std::size_t block_size = 512;

static_assert(sizeof(Particles) == 6 * sizeof(std::vector<double>) + 8);
static_assert(sizeof(SimulationState) ==
              16 + sizeof(Particles) + sizeof(AneurysmState) + sizeof(Ledger) + 2 * sizeof(double));

void write_particles(const hdf5::Group& group, const Particles& particles)
{
    group.write_attribute("mass_kg", particles.mass);
    group.write("position_m", particles.position);
    group.write("velocity_m_s", particles.velocity);
    group.write("pressure_pa", particles.pressure);
    group.write("kappa_pa", particles.kappa);
    group.write("drift_kg_m3", particles.drift);
    group.write("kind", particles.kind);
}

Particles read_particles(const hdf5::Group& group)
{
    Particles p{.mass = group.read_attribute<double>("mass_kg"),
                .position = group.read_vectors("position_m"),
                .velocity = group.read_vectors("velocity_m_s"),
                .pressure = group.read<double>("pressure_pa"),
                .kappa = group.read<double>("kappa_pa"),
                .drift = group.read<double>("drift_kg_m3"),
                .kind = group.read_kinds("kind")};
    const auto differs = [&p](std::size_t size) { return size != p.size(); };
    if (std::ranges::any_of(
            std::array{p.velocity.size(), p.pressure.size(), p.kappa.size(), p.drift.size(), p.kind.size()},
            differs)) {
        group.task().fail("the particles", "arrays of different lengths");
    }
    return p;
}

/// The numbers of a state that stand in groups as attributes, each by its group and its name.
template <class State, class Visitor>
void visit_numbers(State& state, const Visitor& v)
{
    v("/", "frame", state.frame);
    v("/", "spacing_m", state.spacing);
    v("/", "outlet_velocity_1_m_s", state.outlet_velocity[0]);
    v("/", "outlet_velocity_2_m_s", state.outlet_velocity[1]);
    visit_aneurysm(state.aneurysm, [&](std::string_view name, auto& number) { v("aneurysm", name, number); });
    visit_ledger(state.ledger, [&](std::string_view name, auto& number) { v("ledger", name, number); });
}

template <class Number>
void write_number(const hdf5::Group& group, const std::string& name, Number number)
{
    if constexpr (std::is_enum_v<Number>) {
        group.write_attribute(name, static_cast<std::int64_t>(number));
    } else {
        group.write_attribute(name, number);
    }
}

template <class Number>
void read_number(const hdf5::Group& group, const std::string& name, Number& number)
{
    if constexpr (std::is_enum_v<Number>) {
        const auto value = group.read_attribute<std::int64_t>(name);
        if (value < 0 || value >= static_cast<std::int64_t>(phase_names.size())) {
            group.task().fail(name, "unknown value " + std::to_string(value));
        }
        number = static_cast<Number>(value);
    } else {
        number = group.read_attribute<Number>(name);
    }
}

std::string hash_after_block(std::string_view bytes)
{
    Fnv1a hash;
    hash.add(std::as_bytes(std::span(bytes.substr(std::min(block_size, bytes.size())))));
    return hash.hex();
}

void check_block(const std::string& bytes, const std::string& where)
{
    std::istringstream words(bytes.starts_with(format) ? bytes.substr(format.size(), block_size) : "");
    std::string found_version;
    std::string found_hash;
    words >> found_version >> found_hash;
    if (found_version.empty()) {
        throw InputError(where, "is no checkpoint", "needed: the checkpoint.h5 of a run");
    }
    if (found_version == "1") {
        throw InputError(
            where, "checkpoint of version 1, which lacks the potential of the density's correction",
            "needed: version " + std::to_string(version) + ", or the program that wrote this one");
    }
    if (found_version != std::to_string(version)) {
        throw InputError(where, "checkpoint of another version (" + excerpt(found_version) + ")",
                         "needed: version " + std::to_string(version));
    }
    if (found_hash != hash_after_block(bytes)) {
        throw InputError(where, "checkpoint is truncated or damaged (its hash differs)",
                         "needed: the file as it was written");
    }
}

/// What the hash doesn't say of a file that something else has written: that a run can go on from its state.
void check_state(const Checkpoint& checkpoint, const std::string& where)
{
    const auto require = [&where](bool good, const std::string& what) {
        if (!good) {
            throw InputError(where, "no state of a run (" + what + ")", "needed: the file as it was written");
        }
    };
    const SimulationState& s = checkpoint.state;
    const Particles& p = s.particles;
    require(static_cast<std::int64_t>(p.size()) == checkpoint.scenario.particles.count,
            std::to_string(p.size()) + " particles of " +
                std::to_string(checkpoint.scenario.particles.count));
    require(s.frame >= 0, "frame " + std::to_string(s.frame));
    require(s.spacing > 0 && std::isfinite(s.spacing) && p.mass > 0 && std::isfinite(p.mass),
            "particles without size or mass");
    const auto finite = [](double x) { return std::isfinite(x); };
    const auto finite_vector = [](const Vec3& v) { return is_finite(v); };
    require(std::ranges::all_of(p.position, finite_vector) &&
                std::ranges::all_of(p.velocity, finite_vector) && std::ranges::all_of(p.pressure, finite) &&
                std::ranges::all_of(p.kappa, finite) && std::ranges::all_of(p.drift, finite) &&
                std::ranges::all_of(s.outlet_velocity, finite),
            "a particle's number that isn't finite");
    visit_aneurysm(s.aneurysm, [&](std::string_view name, auto number) {
        require(std::isfinite(static_cast<double>(number)), std::string(name) + " isn't finite");
    });
}

} // namespace

void write_checkpoint(const std::filesystem::path& file, const Scenario& scenario,
                      const SimulationState& state)
{
    const hdf5::File image(file.string(), block_size);
    {
        const hdf5::Group root = image.root();
        root.write("scenario", to_json(scenario));
        write_particles(root.create_group("particles"), state.particles);
        root.create_group("aneurysm");
        root.create_group("ledger");
        visit_numbers(state, [&](const char* group, std::string_view name, const auto& number) {
            write_number(root.open_group(group), std::string(name), number);
        });
    }
    std::string bytes = image.image();
    const std::string line =
        std::string(format) + " " + std::to_string(version) + " " + hash_after_block(bytes) + "\n";
    write_atomically(file, bytes.replace(0, line.size(), line));
}

Checkpoint read_checkpoint(const std::filesystem::path& file)
{
    const std::string where = file.string();
    const std::string bytes = read_text(file);
    check_block(bytes, where);
    const hdf5::File image(bytes, where);
    const hdf5::Group root = image.root();
    Checkpoint checkpoint{parse_scenario(root.read_text("scenario"), where + ": scenario"), {}};
    checkpoint.state.particles = read_particles(root.open_group("particles"));
    visit_numbers(checkpoint.state, [&](const char* group, std::string_view name, auto& number) {
        read_number(root.open_group(group), std::string(name), number);
    });
    check_state(checkpoint, where);
    return checkpoint;
}

} // namespace aneurysm::output
