// SPDX-License-Identifier: Apache-2.0
#include "output/checkpoint.hpp"

#include "common/error.hpp"
#include "output/columns.hpp"
#include "output/file.hpp"
#include "output/frames.hpp"
#include "output/hdf5.hpp"

#include <string>
#include <type_traits>

namespace aneurysm::output
{
namespace
{

constexpr std::int64_t version = 1;
constexpr std::string_view format = "aneurysm checkpoint";
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

void check_format(const hdf5::Group& root)
{
    if (!root.has_attribute("format") || root.read_text_attribute("format") != format) {
        root.task().fail("the file", "it is no checkpoint");
    }
    const auto found = root.read_attribute<std::int64_t>("version");
    if (found != version) {
        throw InputError(root.task().where, "checkpoint of another version (" + std::to_string(found) + ")",
                         "needed: version " + std::to_string(version));
    }
}

} // namespace

void write_checkpoint(const std::filesystem::path& file, const Scenario& scenario,
                      const SimulationState& state)
{
    const hdf5::File image(file.string());
    {
        const hdf5::Group root = image.root();
        root.write_attribute("format", std::string(format));
        root.write_attribute("version", version);
        root.write_attribute("scenario_hash", scenario_hash(scenario));
        root.write_attribute("state_hash", state_hash(state));
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
    write_atomically(file, std::span<const std::byte>(image.image()));
}

Checkpoint read_checkpoint(const std::filesystem::path& file)
{
    const std::string where = file.string();
    const std::vector<std::byte> bytes = read_bytes(file);
    const hdf5::File image(bytes, where);
    const hdf5::Group root = image.root();
    check_format(root);
    Checkpoint checkpoint;
    checkpoint.scenario = parse_scenario(root.read_text("scenario"), where + ": scenario");
    if (root.read_text_attribute("scenario_hash") != scenario_hash(checkpoint.scenario)) {
        root.task().fail("the scenario", "it doesn't match its hash");
    }
    checkpoint.state = read_state(root);
    if (root.read_text_attribute("state_hash") != state_hash(checkpoint.state)) {
        root.task().fail("the state", "it doesn't match its hash");
    }
    return checkpoint;
}

} // namespace aneurysm::output
