// SPDX-License-Identifier: Apache-2.0
#include "common/scenario/scenario.hpp"

#include "common/file.hpp"
#include "common/hash.hpp"
#include "common/scenario/json.hpp"

#include <algorithm>
#include <type_traits>

namespace aneurysm
{
namespace
{

using fields::Field;
using fields::Json;
namespace fs = std::filesystem;

/// `where`: the missing key may be written.
void refuse_missing(const std::set<std::string>& present, Scenario& scenario, const std::string& origin,
                    const std::string& where)
{
    fields::visit(scenario, [&](const Field& field, const auto&) {
        if (!present.contains(std::string(field.path))) {
            throw InputError(fields::place(origin, field.path), "missing key",
                             "needed: " + std::string(field.doc) + ", " + where);
        }
    });
}

/// Where a scenario's base is: relative to its file; to the working directory when it comes from a pipe.
fs::path base_of(const fs::path& file, const Json& json, const std::string& origin)
{
    const auto name = json["base"].get<std::string>();
    if (name.empty() || name.find('\0') != std::string::npos) {
        throw InputError(fields::place(origin, "base"),
                         "no name of a file (" + fields::shown(json["base"]) + ")",
                         "allowed: a scenario file, relative to this one");
    }
    std::error_code unused;
    return fs::is_regular_file(file, unused) ? file.parent_path() / name : fs::path(name);
}

/// `chain`: the files that are being read, each the base of the one before.
void read_onto(const fs::path& file, std::vector<fs::path>& chain, Scenario& scenario,
               std::set<std::string>& present)
{
    const std::string origin = file.string();
    const Json json =
        fields::parse_strictly(read_text(file, "needed: a readable scenario file", most_text), origin);
    chain.push_back(file);
    if (json.is_object() && json.contains("base") && json["base"].is_string()) {
        const fs::path base = base_of(file, json, origin);
        if (std::ranges::any_of(chain, [&base](const fs::path& known) { return same_file(known, base); })) {
            throw InputError(fields::place(origin, "base"),
                             "files build on one another in a circle (" + fields::shown(json["base"]) + ")",
                             "allowed: a file that doesn't lead back here");
        }
        if (!is_there(base)) {
            throw InputError(fields::place(origin, "base"),
                             "no such file (" + fields::shown(json["base"]) + ")",
                             "allowed: a scenario file, relative to this one");
        }
        read_onto(base, chain, scenario, present);
    }
    fields::apply(json, origin, scenario, present);
}

Json json_of(const Vec3& v)
{
    return Json::array({v.x, v.y, v.z});
}
template <class Member>
Json json_of(const Member& member)
{
    if constexpr (std::is_enum_v<Member>) {
        return fields::name_of(member);
    } else {
        return member;
    }
}

} // namespace

Scenario read_scenario(const fs::path& file)
{
    Scenario scenario;
    std::set<std::string> present;
    std::vector<fs::path> chain;
    read_onto(file, chain, scenario, present);
    refuse_missing(present, scenario, file.string(), "here or in the file named by base");
    validate(scenario, file.string());
    return scenario;
}

Scenario parse_scenario(const std::string& json, const std::string& origin)
{
    const Json parsed = fields::parse_strictly(json, origin);
    if (parsed.is_object() && parsed.contains("base")) {
        throw InputError(fields::place(origin, "base"),
                         "this text cannot build on a file (" + fields::shown(parsed["base"]) + ")",
                         "allowed: a complete scenario");
    }
    Scenario scenario;
    std::set<std::string> present;
    fields::apply(parsed, origin, scenario, present);
    refuse_missing(present, scenario, origin,
                   "here; what a version without this key has recorded, only that version reads");
    validate(scenario, origin);
    return scenario;
}

std::string to_json(const Scenario& scenario)
{
    Json json = Json::object();
    fields::visit(scenario, [&json](const Field& field, const auto& member) {
        const auto [group, key] = fields::split(field.path);
        (group.empty() ? json : json[group])[key] = json_of(member);
    });
    json["assumed"] = scenario.assumed;
    return json.dump(2) + "\n";
}

std::string scenario_hash(const Scenario& scenario)
{
    const std::string text = to_json(scenario);
    Fnv1a hash;
    hash.add(std::as_bytes(std::span(text)));
    return hash.hex();
}

} // namespace aneurysm
