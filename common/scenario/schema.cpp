// SPDX-License-Identifier: Apache-2.0
#include "common/scenario/json.hpp"

#include <type_traits>

namespace aneurysm
{
namespace
{

using fields::Field;
using fields::Json;
using fields::Origin;
using fields::Range;

std::string description(const Field& field)
{
    std::string text(field.doc);
    if (field.origin.kind == Origin::Kind::assumed) {
        text += ". The paper gives no value: needs a reason in assumed";
    } else if (field.origin.kind == Origin::Kind::paper) {
        text += ". Paper: " + std::string(field.origin.where) + "; other values need a reason in assumed";
    }
    return text;
}

Json numeric(const Range& range, bool integer)
{
    const auto bound = [integer](double x) { return integer ? Json(static_cast<std::int64_t>(x)) : Json(x); };
    Json schema{{"type", integer ? "integer" : "number"}};
    schema[range.low_open ? "exclusiveMinimum" : "minimum"] = bound(range.low);
    schema[range.high_open ? "exclusiveMaximum" : "maximum"] = bound(range.high);
    return schema;
}

template <class Member>
Json schema_of(const Field& field, const Member&)
{
    if constexpr (std::is_enum_v<Member>) {
        return {{"enum", fields::names<Member>}};
    } else if constexpr (std::is_same_v<Member, std::string>) {
        return {{"type", "string"}};
    } else if constexpr (std::is_same_v<Member, Vec3>) {
        return {{"type", "array"}, {"items", numeric(field.range, false)}, {"minItems", 3}, {"maxItems", 3}};
    } else if constexpr (std::is_same_v<Member, std::vector<double>>) {
        return {{"type", "array"}, {"items", numeric(field.range, false)}};
    } else {
        return numeric(field.range, std::is_integral_v<Member>);
    }
}

Json closed_object()
{
    return {{"type", "object"}, {"additionalProperties", false}, {"properties", Json::object()}};
}

} // namespace

std::string scenario_schema()
{
    Json schema{
        {"$schema", "https://json-schema.org/draft/2020-12/schema"},
        {"title", "Scenario of an aneurysm simulation"},
        {"description", "SI units. A file that names a base needs only the values that differ from it."}};
    schema.update(closed_object());
    Json& properties = schema["properties"];
    properties["$schema"] = {{"type", "string"}, {"description", "this schema, for editors"}};
    properties["base"] = {{"type", "string"},
                          {"description", "scenario file to build on, relative to this one"}};
    Json complete{{"required", Json::array()}, {"properties", Json::object()}};
    Json paths = Json::array();
    const Scenario scenario;
    fields::visit(scenario, [&](const Field& field, const auto& member) {
        const auto [group, key] = fields::split(field.path);
        Json* siblings = &properties;
        Json* required = &complete["required"];
        if (!group.empty()) {
            if (!properties.contains(group)) {
                properties[group] = closed_object();
                required->push_back(group);
                complete["properties"][group] = {{"required", Json::array()}};
            }
            siblings = &properties[group]["properties"];
            required = &complete["properties"][group]["required"];
        }
        Json value = schema_of(field, member);
        value["description"] = description(field);
        (*siblings)[key] = value;
        required->push_back(key);
        paths.push_back(field.path);
    });
    properties["assumed"] = {{"type", "object"},
                             {"description", "JSON path -> why, for each value that the paper doesn't give"},
                             {"propertyNames", {{"enum", paths}}},
                             {"additionalProperties", {{"type", "string"}, {"pattern", "\\S"}}}};
    schema["anyOf"] = Json::array({Json{{"required", Json::array({"base"})}}, complete});
    return schema.dump(2) + "\n";
}

} // namespace aneurysm
