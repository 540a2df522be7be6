// SPDX-License-Identifier: Apache-2.0
#include "common/scenario/json.hpp"

#include "common/backend.hpp"
#include "common/json_depth.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <type_traits>
#include <vector>

namespace aneurysm::fields
{

std::string describe(const Range& range, bool integer)
{
    const auto text = [integer](double x) {
        return integer ? Json(static_cast<std::int64_t>(x)).dump() : Json(x).dump();
    };
    return std::string(integer ? "an integer " : "a number ") + (range.low_open ? "> " : ">= ") +
           text(range.low) + " and " + (range.high_open ? "< " : "<= ") + text(range.high);
}

namespace
{

/// Follows the parser through the text: where it is, and which keys each open object has had.
class KeyWatch
{
public:
    explicit KeyWatch(const std::string& origin) : origin_(origin) {}

    bool operator()(int depth, Json::parse_event_t event, const Json& parsed)
    {
        if (depth > deepest_json) {
            throw InputError(place(origin_, path()), nested_too_deep, "allowed: the keys of a scenario");
        }
        if (event == Json::parse_event_t::object_start) {
            open_.emplace_back();
        } else if (event == Json::parse_event_t::object_end) {
            open_.pop_back();
        } else if (event == Json::parse_event_t::key) {
            const auto key = parsed.get<std::string>();
            open_.back().last = key;
            if (!open_.back().keys.insert(key).second) {
                throw InputError(place(origin_, path()),
                                 "key appears twice in its object (" + shown(parsed) + ")",
                                 "allowed: each key once");
            }
        }
        return true;
    }

    std::string path() const
    {
        std::string text;
        for (const Object& object : open_) {
            text += (text.empty() || object.last.empty() ? "" : ".") + object.last;
        }
        return text.empty() ? "(top)" : text;
    }

private:
    struct Object {
        std::set<std::string> keys;
        std::string last;
    };
    const std::string& origin_;
    std::vector<Object> open_;
};

/// The library's message without its own numbering, "parse error at line 3, column 5: ...", and without the
/// text that it quotes where that isn't UTF-8.
std::string reason_of(const nlohmann::json::exception& error)
{
    const std::string text = error.what();
    const auto start = text.find("] ");
    const auto quoted = std::min(text.find("; last read"), text.size());
    const bool printable = text.find("ill-formed UTF-8") == std::string::npos;
    const auto from = start == std::string::npos ? 0 : start + 2;
    constexpr std::size_t longest = 200; // what is quoted may be a whole text
    return excerpt(text.substr(from, printable ? std::string::npos : quoted - from), longest);
}

/// One JSON value into one member.
class Reader
{
public:
    Reader(const Json& json, const std::string& origin, std::set<std::string>& present)
        : json_(json), origin_(origin), present_(present)
    {
    }

    template <class Member>
    void operator()(const Field& field, Member& member) const
    {
        const auto [group, key] = split(field.path);
        const Json* parent = &json_;
        if (!group.empty()) {
            const auto it = json_.find(group);
            if (it == json_.end()) {
                return;
            }
            parent = &*it;
        }
        const auto it = parent->find(key);
        if (it != parent->end()) {
            read(field, *it, member);
            present_.insert(std::string(field.path));
        }
    }

private:
    [[noreturn]] void refuse(const Field& field, const std::string& what, const Json& value,
                             const std::string& allowed) const
    {
        throw InputError(place(origin_, field.path), what + " (" + shown(value) + ")", "allowed: " + allowed);
    }

    double number(const Field& field, const Json& value) const
    {
        if (!value.is_number()) {
            refuse(field, "not a number", value, describe(field.range, false));
        }
        const auto x = value.get<double>();
        if (!std::isfinite(x) || !field.range.contains(x)) {
            refuse(field, "out of range", value, describe(field.range, false));
        }
        return x;
    }

    void read(const Field& field, const Json& value, double& member) const { member = number(field, value); }

    void read(const Field& field, const Json& value, std::int64_t& member) const
    {
        const bool whole = value.is_number_float() && std::trunc(value.get<double>()) == value.get<double>();
        if (!value.is_number_integer() && !whole) { // 3e3 and 20.0 are integers, as JSON Schema has it
            refuse(field, "not an integer", value, describe(field.range, true));
        }
        const bool too_large = value.is_number_unsigned() &&
                               value.get<std::uint64_t>() > std::numeric_limits<std::int64_t>::max();
        if (too_large || !field.range.contains(value.get<double>())) {
            refuse(field, "out of range", value, describe(field.range, true));
        }
        member = value.get<std::int64_t>(); // exact: ranges end far below 2^53
    }

    void read(const Field& field, const Json& value, std::string& member) const
    {
        if (!value.is_string()) {
            refuse(field, "not a string", value, "a string");
        }
        member = value.get<std::string>();
    }

    void read(const Field& field, const Json& value, Vec3& member) const
    {
        if (!value.is_array() || value.size() != 3) {
            refuse(field, "not a vector", value, "an array of three numbers");
        }
        member = {number(field, value[0]), number(field, value[1]), number(field, value[2])};
    }

    void read(const Field& field, const Json& value, std::vector<double>& member) const
    {
        if (!value.is_array()) {
            refuse(field, "not an array", value, "an array of numbers");
        }
        member.clear();
        for (const Json& x : value) {
            member.push_back(number(field, x));
        }
    }

    template <class Enum>
    requires std::is_enum_v<Enum>
    void read(const Field& field, const Json& value, Enum& member) const
    {
        const auto word =
            value.is_string() ? value_of<Enum>(value.get<std::string>(), names<Enum>) : std::nullopt;
        if (!word) {
            refuse(field, "not one of the choices", value, joined(names<Enum>));
        }
        member = *word;
    }

    const Json& json_;
    const std::string& origin_;
    std::set<std::string>& present_;
};

using Tree = std::map<std::string, std::set<std::string>>; ///< group -> keys

const Tree& known_keys()
{
    static const Tree tree = [] {
        Tree t;
        Scenario scenario;
        visit(scenario, [&t](const Field& field, const auto&) {
            const auto [group, key] = split(field.path);
            t[group].insert(key);
        });
        return t;
    }();
    return tree;
}

/// A key of earlier versions' scenarios, and what is allowed instead.
struct GoneKey {
    std::string_view path;
    std::string_view instead;
};
constexpr std::array gone_keys{
    GoneKey{"controller.probe_depth_spacings", "none, since forces move the blood behind an outlet"},
    GoneKey{"controller.piston_reach_spacings", "none, since the inlet's blood pushes by its pressure"},
    GoneKey{"controller.closest_entry_spacings",
            "controller.refill_distance_spacings, from which distance on a place is filled"},
    GoneKey{"settling.steps", "settling.pushing_rounds, in which blood is only pushed apart"}};

/// What is allowed instead of a path that is no value of a scenario; empty where it never was one.
std::string_view instead_of(std::string_view path)
{
    const auto* const gone = std::ranges::find(gone_keys, path, &GoneKey::path);
    return gone == gone_keys.end() ? "" : gone->instead;
}

[[noreturn]] void refuse_gone(const std::string& where, const Json& value, std::string_view instead)
{
    throw InputError(where, "key of an earlier version (value " + shown(value) + ")",
                     std::string("allowed: ").append(instead));
}

void refuse_unknown_in_group(const std::string& group, const Json& value, const std::string& origin)
{
    if (!value.is_object()) {
        throw InputError(place(origin, group), "not an object (" + shown(value) + ")",
                         "allowed: an object with the keys " + joined(known_keys().at(group)));
    }
    for (const auto& [key, member] : value.items()) {
        if (known_keys().at(group).contains(key)) {
            continue;
        }
        const std::string path = group + "." + key;
        if (const std::string_view instead = instead_of(path); !instead.empty()) {
            refuse_gone(place(origin, path), member, instead);
        }
        throw InputError(place(origin, path), "unknown key (value " + shown(member) + ")",
                         "allowed in " + group + ": " + joined(known_keys().at(group)));
    }
}

void refuse_unknown(const Json& json, const std::string& origin)
{
    if (!json.is_object()) {
        throw InputError(place(origin, "(top)"), "not an object (" + shown(json) + ")",
                         "allowed: a JSON object");
    }
    for (const auto& [key, value] : json.items()) {
        if (key == "base" || key == "$schema") {
            if (!value.is_string()) {
                throw InputError(place(origin, key), "not a string (" + shown(value) + ")",
                                 "allowed: the path of a file");
            }
        } else if (!key.empty() && known_keys().contains(key)) {
            refuse_unknown_in_group(key, value, origin);
        } else if (key != "assumed" && !known_keys().at("").contains(key)) {
            std::set<std::string> allowed = known_keys().at("");
            allowed.insert({"base", "assumed"});
            for (const auto& [group, unused] : known_keys()) {
                if (!group.empty()) {
                    allowed.insert(group);
                }
            }
            throw InputError(place(origin, key), "unknown key (value " + shown(value) + ")",
                             "allowed: " + joined(allowed));
        }
    }
}

void apply_assumed(const Json& json, const std::string& origin, Scenario& scenario)
{
    const auto it = json.find("assumed");
    if (it == json.end()) {
        return;
    }
    if (!it->is_object()) {
        throw InputError(place(origin, "assumed"), "not an object (" + shown(*it) + ")",
                         "allowed: an object of JSON paths and reasons");
    }
    for (const auto& [path, reason] : it->items()) {
        const auto [group, key] = split(path);
        const auto keys = known_keys().find(group);
        if (keys == known_keys().end() || !keys->second.contains(key)) {
            if (const std::string_view instead = instead_of(path); !instead.empty()) {
                refuse_gone(place(origin, "assumed." + path), reason, instead);
            }
            throw InputError(place(origin, "assumed"), "no such value in a scenario (" + shown(path) + ")",
                             "allowed: JSON paths such as vessel.radius_m");
        }
        if (!reason.is_string() ||
            reason.get_ref<const std::string&>().find_first_not_of(" \t\n") == std::string::npos) {
            throw InputError(place(origin, "assumed." + path), "no reason (" + shown(reason) + ")",
                             "allowed: a string that says why this value was taken");
        }
        scenario.assumed[path] = reason.get<std::string>();
    }
}

} // namespace

Json parse_strictly(const std::string& text, const std::string& origin)
{
    KeyWatch watch(origin);
    try {
        return Json::parse(text, std::ref(watch));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(place(origin, watch.path()), "malformed JSON (" + reason_of(error) + ")",
                         "allowed: JSON text as RFC 8259 defines it, with finite numbers");
    }
}

void apply(const Json& json, const std::string& origin, Scenario& scenario, std::set<std::string>& present)
{
    refuse_unknown(json, origin);
    visit(scenario, Reader(json, origin, present));
    apply_assumed(json, origin, scenario);
}

} // namespace aneurysm::fields
