// SPDX-License-Identifier: Apache-2.0
#include "output/checkpoint.hpp"

#include "common/error.hpp"
#include "common/hash.hpp"
#include "output/columns.hpp"
#include "output/file.hpp"
#include "output/hdf5.hpp"

#include <algorithm>
#include <cstring>
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
constexpr int version = 1;
constexpr std::size_t block_size = 512;
constexpr std::uint8_t last_kind = static_cast<std::uint8_t>(Kind::outlet_2);

static_assert(sizeof(Particles) == 4 * sizeof(std::vector<double>) + 8);
static_assert(sizeof(SimulationState) ==
              16 + sizeof(Particles) + sizeof(AneurysmState) + sizeof(Ledger) + 2 * sizeof(double));

std::span<const double> numbers(const std::vector<Vec3>& vectors)
{
    static_assert(sizeof(Vec3) == 3 * sizeof(double));
    return {reinterpret_cast<const double*>(vectors.data()), 3 * vectors.size()}; // NOLINT
}

std::vector<Vec3> vectors(const std::vector<double>& numbers)
{
    std::vector<Vec3> v(numbers.size() / 3);
    for (std::size_t i = 0; i < v.size(); ++i) {
        v[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    }
    return v;
}

void write_particles(const hdf5::Group& group, const Particles& particles)
{
    group.write_attribute("mass_kg", particles.mass);
    group.write("position_m", numbers(particles.position), 3);
    group.write("velocity_m_s", numbers(particles.velocity), 3);
    group.write("pressure_pa", std::span(particles.pressure));
    std::vector<std::uint8_t> kinds;
    for (const Kind kind : particles.kind) {
        kinds.push_back(static_cast<std::uint8_t>(kind));
    }
    group.write("kind", std::span<const std::uint8_t>(kinds));
}

Particles read_particles(const hdf5::Group& group)
{
    Particles p;
    p.mass = group.read_attribute<double>("mass_kg");
    p.position = vectors(group.read<double>("position_m", 3));
    p.velocity = vectors(group.read<double>("velocity_m_s", 3));
    p.pressure = group.read<double>("pressure_pa");
    for (const std::uint8_t kind : group.read<std::uint8_t>("kind")) {
        if (kind > last_kind) {
            group.task().fail("kind", "unknown value " + std::to_string(kind));
        }
        p.kind.push_back(static_cast<Kind>(kind));
    }
    if (p.velocity.size() != p.size() || p.pressure.size() != p.size() || p.kind.size() != p.size()) {
        group.task().fail("the particles", "arrays of different lengths");
    }
    return p;
}

/// Writes or reads one named number.
template <class Value>
void write_number(const hdf5::Group& group, std::string_view name, const Value& value)
{
    if constexpr (std::is_enum_v<Value>) {
        group.write_attribute(std::string(name), static_cast<std::int64_t>(value));
    } else {
        group.write_attribute(std::string(name), value);
    }
}

template <class Value>
void read_number(const hdf5::Group& group, std::string_view name, Value& value)
{
    if constexpr (std::is_enum_v<Value>) {
        const auto number = group.read_attribute<std::int64_t>(std::string(name));
        if (number < 0 || number >= static_cast<std::int64_t>(phase_names.size())) {
            group.task().fail(std::string(name), "unknown value " + std::to_string(number));
        }
        value = static_cast<Value>(number);
    } else {
        value = group.read_attribute<Value>(std::string(name));
    }
}

SimulationState read_state(const hdf5::Group& root)
{
    SimulationState state;
    state.frame = root.read_attribute<std::int64_t>("frame");
    state.spacing = root.read_attribute<double>("spacing_m");
    state.outlet_velocity[0] = root.read_attribute<double>("outlet_velocity_1_m_s");
    state.outlet_velocity[1] = root.read_attribute<double>("outlet_velocity_2_m_s");
    state.particles = read_particles(root.open_group("particles"));
    const hdf5::Group aneurysm = root.open_group("aneurysm");
    visit_aneurysm(state.aneurysm,
                   [&](std::string_view name, auto& value) { read_number(aneurysm, name, value); });
    const hdf5::Group ledger = root.open_group("ledger");
    visit_ledger(state.ledger, [&](std::string_view name, auto& value) { read_number(ledger, name, value); });
    return state;
}

std::string hash_after_block(const std::vector<std::byte>& bytes)
{
    Fnv1a hash;
    hash.add(std::span(bytes).subspan(std::min(block_size, bytes.size())));
    return hash.hex();
}

void check_block(const std::vector<std::byte>& bytes, const std::string& where)
{
    const std::string block(reinterpret_cast<const char*>(bytes.data()),
                            std::min(block_size, bytes.size())); // NOLINT
    std::istringstream words(block.starts_with(format) ? block.substr(format.size()) : "");
    std::string found_version;
    std::string found_hash;
    words >> found_version >> found_hash;
    if (found_version.empty()) {
        throw InputError(where, "is no checkpoint", "needed: the checkpoint.h5 of a run");
    }
    if (found_version != std::to_string(version)) {
        throw InputError(where, "checkpoint of another version (" + found_version + ")",
                         "needed: version " + std::to_string(version));
    }
    if (found_hash != hash_after_block(bytes)) {
        throw InputError(where, "checkpoint is truncated or damaged (its hash differs)",
                         "needed: the file as it was written");
    }
}

} // namespace

void write_checkpoint(const std::filesystem::path& file, const Scenario& scenario,
                      const SimulationState& state)
{
    const hdf5::File image(file.string(), block_size);
    {
        const hdf5::Group root = image.root();
        root.write("scenario", to_json(scenario));
        root.write_attribute("frame", state.frame);
        root.write_attribute("spacing_m", state.spacing);
        root.write_attribute("outlet_velocity_1_m_s", state.outlet_velocity[0]);
        root.write_attribute("outlet_velocity_2_m_s", state.outlet_velocity[1]);
        write_particles(root.create_group("particles"), state.particles);
        const hdf5::Group aneurysm = root.create_group("aneurysm");
        visit_aneurysm(state.aneurysm,
                       [&](std::string_view name, const auto& v) { write_number(aneurysm, name, v); });
        const hdf5::Group ledger = root.create_group("ledger");
        visit_ledger(state.ledger,
                     [&](std::string_view name, const auto& v) { write_number(ledger, name, v); });
    }
    std::vector<std::byte> bytes = image.image();
    const std::string line =
        std::string(format) + " " + std::to_string(version) + " " + hash_after_block(bytes) + "\n";
    std::memcpy(bytes.data(), line.data(), line.size());
    write_atomically(file, std::span<const std::byte>(bytes));
}

Checkpoint read_checkpoint(const std::filesystem::path& file)
{
    const std::string where = file.string();
    const std::vector<std::byte> bytes = read_bytes(file);
    check_block(bytes, where);
    const hdf5::File image(bytes, where);
    const hdf5::Group root = image.root();
    return {parse_scenario(root.read_text("scenario"), where + ": scenario"), read_state(root)};
}

} // namespace aneurysm::output
