// SPDX-License-Identifier: Apache-2.0
#include "output/frames.hpp"

#include "common/error.hpp"
#include "common/file.hpp"
#include "common/hash.hpp"
#include "common/text.hpp"
#include "output/columns.hpp"

#include <algorithm>
#include <charconv>
#include <span>
#include <sstream>
#include <type_traits>

namespace aneurysm::output
{
namespace
{

constexpr const char* as_written = "needed: the file as it was written";

template <class Number>
std::string text_of(Number x)
{
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), x);
    return {buffer.data(), end.ptr};
}
std::string text_of(Phase phase)
{
    return std::string(name_of(phase));
}

template <class Number>
bool parse(std::string_view text, Number& x)
{
    const auto end = std::from_chars(text.data(), text.data() + text.size(), x);
    return end.ec == std::errc() && end.ptr == text.data() + text.size();
}
bool parse(std::string_view text, Phase& phase)
{
    const auto* const it = std::find(phase_names.begin(), phase_names.end(), text);
    phase = static_cast<Phase>(it - phase_names.begin());
    return it != phase_names.end();
}

void add_comma(std::string& line)
{
    line += line.empty() ? "" : ",";
}

template <class Value>
void add(Fnv1a& hash, const Value& value)
{
    static_assert(std::has_unique_object_representations_v<Value> || std::is_floating_point_v<Value> ||
                  std::is_same_v<Value, Vec3>);
    hash.add(std::as_bytes(std::span(&value, 1)));
}

template <class Value>
std::string hash_of(const std::vector<Value>& values)
{
    Fnv1a hash;
    hash.add(std::as_bytes(std::span(values)));
    return hash.hex();
}

std::string hash_of(const AneurysmState& aneurysm)
{
    Fnv1a hash;
    visit_aneurysm(aneurysm, [&hash](std::string_view, const auto& value) { add(hash, value); });
    return hash.hex();
}

} // namespace

std::string frames_header()
{
    std::string line;
    const FrameRecord record;
    visit_record(record, [&line](std::string_view name, const auto&) {
        add_comma(line);
        line += name;
    });
    return line;
}

std::string frames_row(const FrameRecord& record)
{
    std::string line;
    visit_record(record, [&line](std::string_view, const auto& value) {
        add_comma(line);
        line += text_of(value);
    });
    return line;
}

namespace
{

/// \throws InputError at `where`, which is the line's place
FrameRecord read_row(const std::string& line, const std::string& where)
{
    FrameRecord record;
    std::istringstream cells(line);
    visit_record(record, [&](std::string_view name, auto& value) {
        std::string cell;
        if (!std::getline(cells, cell, ',') || !parse(cell, value)) {
            throw InputError(where, "unreadable " + std::string(name) + " (" + excerpt(cell) + ")",
                             as_written);
        }
    });
    return record;
}

} // namespace

std::vector<FrameRecord> read_frames(const std::filesystem::path& file)
{
    std::istringstream stream(read_text(file));
    std::string line;
    if (!std::getline(stream, line) || line != frames_header() || stream.eof()) {
        throw InputError(file.string() + ": line 1", "other columns than this version writes",
                         "needed: its own frames.csv");
    }
    std::vector<FrameRecord> records;
    while (std::getline(stream, line)) {
        const std::string where = file.string() + ": line " + std::to_string(records.size() + 2);
        records.push_back(read_row(line, where));
        // Another cell, or digits that are lost, don't change what was read; a line that is cut short may read as whole.
        if (stream.eof() || line != frames_row(records.back())) {
            throw InputError(where, "not as a run writes it (" + excerpt(line) + ")", as_written);
        }
    }
    return records;
}

std::string hashes_header()
{
    return "frame,position,velocity,pressure,kappa,drift,kind,aneurysm";
}

std::string hashes_row(const SimulationState& state)
{
    const Particles& p = state.particles;
    return text_of(state.frame) + "," + hash_of(p.position) + "," + hash_of(p.velocity) + "," +
           hash_of(p.pressure) + "," + hash_of(p.kappa) + "," + hash_of(p.drift) + "," + hash_of(p.kind) +
           "," + hash_of(state.aneurysm);
}

std::string state_hash(const SimulationState& state)
{
    Fnv1a hash;
    const std::string fields = hashes_row(state);
    hash.add(std::as_bytes(std::span(fields)));
    add(hash, state.spacing);
    add(hash, state.particles.mass);
    visit_ledger(state.ledger, [&hash](std::string_view, const auto& value) { add(hash, value); });
    for (const double v : state.outlet_velocity) {
        add(hash, v);
    }
    return hash.hex();
}

} // namespace aneurysm::output
