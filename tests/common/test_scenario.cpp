// SPDX-License-Identifier: Apache-2.0
// Reading, writing and refusing scenarios. The cases are made from
// the field table itself, so that none is forgotten.
#include "common/file.hpp"
#include "common/scenario/fields.hpp"
#include "common/scenario/limits.hpp"
#include "tests/files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <set>
#include <type_traits>

using namespace aneurysm;
using namespace aneurysm::test;
using namespace std::string_literals;
using Json = nlohmann::ordered_json;

namespace
{

Scenario base()
{
    return shipped_scenario("base");
}

Json::json_pointer pointer(std::string_view path)
{
    std::string text = "/" + std::string(path);
    if (const auto dot = text.find('.'); dot != std::string::npos) {
        text[dot] = '/';
    }
    return Json::json_pointer(text);
}

/// Whether reading the text ends in an InputError of one line that names origin and path.
bool refused(const std::string& text, const std::string& path)
{
    const std::string message = message_of([&] { parse_scenario(text, "here"); });
    return message.starts_with("here: " + path) && message.find('\n') == std::string::npos;
}

bool refused_with(std::string_view path, const Json& value)
{
    Json json = Json::parse(to_json(base()));
    json[pointer(path)] = value;
    return refused(json.dump(), std::string(path));
}

} // namespace

BOOST_AUTO_TEST_CASE(the_table_has_every_member_once)
{
    Scenario s;
    std::size_t size = sizeof(s.assumed); // NOLINT(bugprone-sizeof-container)
    std::set<const void*> members;
    std::set<std::string_view> paths;
    fields::visit(s, [&](const fields::Field& field, auto& member) {
        constexpr bool is_enum = std::is_enum_v<std::remove_reference_t<decltype(member)>>;
        size += is_enum ? alignof(double) : sizeof(member); // NOLINT(bugprone-sizeof-container)
        BOOST_TEST(members.insert(&member).second);
        BOOST_TEST(paths.insert(field.path).second);
        BOOST_TEST(!field.doc.empty());
    });
    BOOST_TEST(size == sizeof(Scenario));
}

BOOST_AUTO_TEST_CASE(every_scenario_reads_and_comes_back_to_the_same_text)
{
    int count = 0;
    for (const auto& entry : fs::directory_iterator(data_directory() / "scenarios")) {
        const Scenario s = read_scenario(entry.path());
        BOOST_TEST(s.name == entry.path().stem().string());
        const std::string json = to_json(s);
        const Scenario again = parse_scenario(json, "text");
        BOOST_TEST(to_json(again) == json);
        BOOST_TEST(scenario_hash(again) == scenario_hash(s));
        ++count;
    }
    BOOST_TEST(count >= 22);
}

BOOST_AUTO_TEST_CASE(doubles_come_back_to_the_same_bits)
{
    Scenario s = base();
    int count = 0;
    fields::visit(s, [&](const fields::Field& field, auto& member) {
        if constexpr (std::is_same_v<decltype(member), double&>) {
            const double next = std::nextafter(member, 0.0);
            if (member != 0 &&
                !field.path.starts_with("aneurysm")) { // contradicts the rest when changed alone
                member = next;
                s.assumed[std::string(field.path)] = "test";
                ++count;
            }
        }
    });
    BOOST_TEST(count > 35);
    const Scenario again = parse_scenario(to_json(s), "text");
    std::vector<double> expected;
    fields::visit(s, [&](const fields::Field&, const auto& member) {
        if constexpr (std::is_same_v<decltype(member), const double&>) {
            expected.push_back(member);
        }
    });
    std::size_t i = 0;
    fields::visit(again, [&](const fields::Field& field, const auto& member) {
        if constexpr (std::is_same_v<decltype(member), const double&>) {
            BOOST_TEST(member == expected.at(i++), field.path);
        }
    });
}

BOOST_AUTO_TEST_CASE(values_land_in_their_members)
{
    const Scenario s = shipped_scenario("paper_tc3");
    BOOST_TEST(s.particles.count == 15456);
    BOOST_TEST(s.fluid.density_kg_m3 == 1050.0);
    BOOST_TEST(s.growth.wave_speed_m_s == 1500.0);
    BOOST_TEST(s.growth.collagen_stiffness_n_m == 3.52);
    BOOST_TEST(s.growth.elastin_area_m2 == 20.0);
    BOOST_TEST(s.rupture.poisson_ratio == 0.4);
    BOOST_TEST(s.rupture.porosity == 0.003);
    BOOST_TEST(s.vessel.angle_deg == 40.0);
    BOOST_TEST((s.aneurysm.shape == SacShape::none));
    BOOST_TEST((s.inlet.waveform == Waveform::sine));
    BOOST_TEST(s.fluid.gravity_m_s2.x == 0.0);
}

BOOST_AUTO_TEST_CASE(the_committed_schema_is_the_programs)
{
    BOOST_TEST(read_text(data_directory() / "scenario.schema.json") == scenario_schema());
}

BOOST_AUTO_TEST_CASE(a_missing_key_is_refused)
{
    const Json complete = Json::parse(to_json(base()));
    const Scenario s;
    fields::visit(s, [&](const fields::Field& field, const auto&) {
        Json json = complete;
        const auto where = pointer(field.path);
        json[where.parent_pointer()].erase(where.back());
        BOOST_TEST(refused(json.dump(), std::string(field.path)), field.path);
    });
}

BOOST_AUTO_TEST_CASE(a_wrong_type_is_refused)
{
    const Scenario s;
    fields::visit(s, [&](const fields::Field& field, const auto& member) {
        for (const Json& value : {Json(nullptr), Json(true), Json::object(), Json::array({"1"})}) {
            BOOST_TEST(refused_with(field.path, value), field.path);
        }
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (std::is_same_v<Member, std::string>) {
            BOOST_TEST(refused_with(field.path, 1), field.path);
        } else {
            BOOST_TEST(refused_with(field.path, "1"), field.path);
        }
        if constexpr (std::is_integral_v<Member>) {
            BOOST_TEST(refused_with(field.path, 100.5), field.path);
        }
    });
}

BOOST_AUTO_TEST_CASE(a_value_out_of_range_is_refused)
{
    constexpr double inf = std::numeric_limits<double>::infinity();
    const Scenario s;
    fields::visit(s, [&](const fields::Field& field, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        const fields::Range& r = field.range;
        const double below = r.low_open ? r.low : std::nextafter(r.low, -inf);
        const double above = r.high_open ? r.high : std::nextafter(r.high, inf);
        if constexpr (std::is_integral_v<Member>) {
            BOOST_TEST(refused_with(field.path, static_cast<std::int64_t>(r.low) - 1), field.path);
            BOOST_TEST(refused_with(field.path, static_cast<std::int64_t>(r.high) + 1), field.path);
            BOOST_TEST(refused_with(field.path, std::numeric_limits<std::uint64_t>::max()), field.path);
        } else if constexpr (std::is_same_v<Member, double>) {
            BOOST_TEST(refused_with(field.path, below), field.path);
            BOOST_TEST(refused_with(field.path, above), field.path);
        } else if constexpr (std::is_same_v<Member, Vec3>) {
            BOOST_TEST(refused_with(field.path, Json::array({0, 0, above})), field.path);
            BOOST_TEST(refused_with(field.path, Json::array({0, 0})), field.path);
        } else if constexpr (std::is_same_v<Member, std::vector<double>>) {
            BOOST_TEST(refused_with(field.path, Json::array({0, above})), field.path);
        }
    });
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_are_refused)
{
    const Scenario good = base();
    fields::visit(good, [&](const fields::Field& field, const auto& member) {
        if constexpr (std::is_same_v<decltype(member), const double&>) {
            for (const double bad :
                 {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
                Scenario s = good;
                fields::visit(s, [&](const fields::Field& other, auto& value) {
                    if constexpr (std::is_same_v<decltype(value), double&>) {
                        value = other.path == field.path ? bad : value;
                    }
                });
                BOOST_CHECK_THROW(validate(s, "here"), InputError);
            }
        }
    });
}

BOOST_AUTO_TEST_CASE(a_value_of_our_own_needs_a_reason)
{
    const Scenario good = base();
    fields::visit(good, [&](const fields::Field& field, const auto&) {
        Scenario s = good;
        if (s.assumed.erase(std::string(field.path)) == 1) {
            BOOST_TEST(refused(to_json(s), "assumed." + std::string(field.path)), field.path);
        }
    });
    Scenario s = good;
    s.fluid.density_kg_m3 = 1060;
    BOOST_TEST(refused(to_json(s), "assumed.fluid.density_kg_m3"));
    s.assumed["fluid.density_kg_m3"] = "measured";
    BOOST_CHECK_NO_THROW(parse_scenario(to_json(s), "here"));
}

namespace
{

/// What contradicts the rest of a scenario, and the path that is named; nothing where it doesn't.
struct Contradiction {
    const char* scenario;
    const char* path;
    const char* patch;
};
const Contradiction contradictions[] = {
    {"base", "aneurysm.neck_width_radii", R"({"aneurysm": {"shape": "none"}})"},
    {"base", "aneurysm.neck_width_radii", R"({"aneurysm": {"neck_width_radii": 1.7}})"},
    {"base", "aneurysm.neck_width_radii", R"({"aneurysm": {"neck_width_radii": 1.5}})"},
    {"base", "aneurysm.neck_width_radii", R"({"aneurysm": {"neck_width_radii": 0}})"},
    {"base", "aneurysm.initial_radius_radii", R"({"aneurysm": {"initial_radius_radii": 0}})"},
    {"base", "aneurysm.initial_radius_radii", R"({"aneurysm": {"initial_radius_radii": 0.81}})"},
    // gap: 2 r_1 = 1.59 r_0
    {"base", "aneurysm.base_width_radii",
     R"({"aneurysm": {"neck_width_radii": 3.3, "base_width_radii": 3.3}})"},
    {"base", "aneurysm.base_width_radii", R"({"vessel": {"daughter_length_radii": 1.7}})"},
    {"base", "vessel.angle_deg", R"({"vessel": {"angle_deg": 15, "daughter_length_radii": 3.8}})"},
    {"base", "particles.count", R"({"particles": {"count": 20}})"},
    {"base", "inlet.table_time_s", R"({"inlet": {"waveform": "table"}})"},
    {"base", "",
     R"({"inlet": {"waveform": "table", "table_time_s": [0, 0.4], "table_velocity_m_s": [1, 2]}})"},
    {"base", "inlet.table_velocity_m_s",
     R"({"inlet": {"waveform": "table", "table_time_s": [0, 0.4], "table_velocity_m_s": [1]}})"},
    {"base", "inlet.table_time_s",
     R"({"inlet": {"waveform": "table", "table_time_s": [0.1, 0.4], "table_velocity_m_s": [1, 2]}})"},
    {"base", "inlet.table_time_s",
     R"({"inlet": {"waveform": "table", "table_time_s": [0, 0.4, 0.4], "table_velocity_m_s": [1, 2, 3]}})"},
    {"base", "inlet.table_time_s",
     R"({"inlet": {"waveform": "table", "table_time_s": [0, 0.8], "table_velocity_m_s": [1, 2]}})"},
    {"base", "time.frame_s", R"({"inlet": {"peak_velocity_m_s": 1e5}})"},
    {"base", "time.frame_s", R"({"fluid": {"viscosity_pa_s": 1e6}})"},
    {"base", "time.frame_s", R"({"pressure": {"model": "eos", "stiffness_m2_s2": 1e10}})"},
    // a spring is stable up to 4 m / dt^2 = 4e8 N/m
    {"base", "", R"({"elastic_wall": {"stiffness_n_m": 3.999e8}})"},
    {"base", "elastic_wall.stiffness_n_m", R"({"elastic_wall": {"stiffness_n_m": 4.001e8}})"},
    {"base", "pressure.max_tolerance_per_s",
     R"({"pressure": {"tolerance_per_s": 2, "max_tolerance_per_s": 1}})"},
    {"base", "pressure.correction_max_tolerance_per_s",
     R"({"pressure": {"correction_tolerance_per_s": 2, "correction_max_tolerance_per_s": 1}})"},
    {"base", "", R"({"inlet": {"profile": "parabolic"}})"},
    // twice as fast on the axis
    {"base", "", R"({"inlet": {"peak_velocity_m_s": 11}})"},
    {"base", "time.frame_s", R"({"inlet": {"profile": "parabolic", "peak_velocity_m_s": 11}})"},
    {"base", "outlet.level_margin", R"({"outlet": {"pressure_pa": 0}})"},
    {"base", "", R"({"outlet": {"pressure_pa": 0, "level_margin": 0}})"},
    {"base", "growth.largest_increment_m", R"({"growth": {"largest_increment_m": 1}})"},
    {"base", "rupture.recycle_distance_radii",
     R"({"rupture": {"breach_radius_radii": 0.5, "recycle_distance_radii": 0.5}})"},
    {"verify_channel", "", "{}"},
    {"verify_channel", "domain.spacing_m", R"({"domain": {"spacing_m": 0}})"},
    {"verify_channel", "domain.cells_x", R"({"domain": {"cells_x": 5}})"},
    {"verify_channel", "domain.cells_x", R"({"domain": {"form": "artery", "spacing_m": 0}})"},
    {"verify_channel", "domain.cells_z", R"({"domain": {"form": "tube", "cells_z": 8}})"},
    {"verify_channel", "inlet.profile", R"({"inlet": {"profile": "parabolic"}})"},
    {"verify_channel", "inlet.ramp_s", R"({"inlet": {"ramp_s": 0.05}})"},
    {"verify_duct", "inlet.profile", R"({"inlet": {"profile": "parabolic"}})"},
    {"verify_pipe", "", R"({"inlet": {"profile": "parabolic"}})"},
    {"verify_channel", "aneurysm.shape", R"({"aneurysm": {"shape": "spherical"}})"},
};

} // namespace

BOOST_AUTO_TEST_CASE(contradictions_are_refused)
{
    for (const auto& [scenario, path, patch] : contradictions) {
        Json json = Json::parse(to_json(shipped_scenario(scenario)));
        const Scenario unused;
        fields::visit(unused, [&json](const fields::Field& field, const auto&) {
            json["assumed"][std::string(field.path)] = "test";
        });
        json.merge_patch(Json::parse(patch));
        BOOST_TEST(refused(json.dump(), path) == (*path != '\0'), patch);
    }
}

BOOST_AUTO_TEST_CASE(what_is_quoted_of_a_scenario_is_short_and_printable)
{
    const std::string many(5000, 'x');
    for (const std::string& text :
         {R"({"\u001b[2J": 1})"s, R"({"a\nb": {"c\u007f": 1}, "a\nb": 1})"s, "{\"" + many + "\": 1}",
          "{\"name\": \"" + many, "{\"name\": \"a\"\x7f\"b\"}"s, R"({"vessel": {"\r": 1}})"s,
          R"({"assumed": {"vessel.\u001b": "x"}})"s}) {
        const std::string message = message_of([&] { parse_scenario(text, "here"); });
        BOOST_TEST(message.starts_with("here: "), message);
        BOOST_TEST(message.size() < 1000U, message);
        BOOST_TEST(std::ranges::none_of(message, [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }),
                   message);
    }
}

BOOST_AUTO_TEST_CASE(text_that_is_no_scenario_is_refused)
{
    const std::string good = to_json(base());
    BOOST_CHECK_NO_THROW(parse_scenario(good, "here"));
    for (std::size_t end = 0; end + 2 < good.size(); end += 13) {
        BOOST_TEST(refused(good.substr(0, end), ""));
    }
    const std::pair<const char*, const char*> inserted[] = {
        {R"("tiem": 1)", "tiem"},
        {R"("": 1)", ": unknown"},
        {R"("name": "twice")", "name"},
        {R"("base": "x.json")", "base"},
        {R"("x": 1e999)", "x: malformed"},
        {R"("x": NaN)", "x: malformed"},
        {R"("time": {"frame_s": 1, "frame_s": 1})", "time.frame_s"},
    };
    for (const auto& [text, path] : inserted) {
        BOOST_TEST(refused("{" + std::string(text) + "," + good.substr(1), path));
    }
    BOOST_TEST(refused("[]", "(top)"));
    BOOST_TEST(refused("3", "(top)"));
    BOOST_TEST(refused_with("time.step_s", 1));
    for (const auto& [assumed, path] : {std::pair{Json{{"vessel.color", "red"}}, "assumed"},
                                        {Json{{"vessel.radius_m", "  "}}, "assumed.vessel.radius_m"},
                                        {Json(1), "assumed"}}) {
        Json json = Json::parse(good);
        json.merge_patch({{"assumed", assumed}});
        BOOST_TEST(refused(json.dump(), path));
    }
}

BOOST_AUTO_TEST_CASE(a_key_of_an_earlier_version_is_refused_with_what_took_its_place)
{
    for (const auto& [path, instead] :
         {std::pair{"controller.probe_depth_spacings", "none, since forces move"},
          {"controller.piston_reach_spacings", "none, since the inlet's blood pushes"},
          {"controller.closest_entry_spacings", "controller.refill_distance_spacings"},
          {"settling.steps", "settling.pushing_rounds"}}) {
        Json json = Json::parse(to_json(base()));
        json[pointer(path)] = 2;
        const std::string message = message_of([&] { parse_scenario(json.dump(), "here"); });
        BOOST_TEST(
            message.starts_with("here: " + std::string(path) + ": key of an earlier version (value 2)"));
        BOOST_TEST(contains(message, instead));
        json = Json::parse(to_json(base()));
        json["assumed"][path] = "why";
        const std::string reason = message_of([&] { parse_scenario(json.dump(), "here"); });
        BOOST_TEST(reason.starts_with("here: assumed." + std::string(path) + ": key of an earlier version"));
        BOOST_TEST(contains(reason, instead));
    }
}

BOOST_AUTO_TEST_CASE(the_estimate_is_within_a_tenth_of_the_lattices_spacing)
{
    // dx / r_0 of the prototype's geometry for the three counts of Table 3 (all of them active).
    for (const auto& [count, spacing] : {std::pair{5520, 0.1987}, {15456, 0.1398}, {40296, 0.1005}}) {
        Scenario s = base();
        s.particles.count = count;
        s.particles.reserve_fraction = 0;
        BOOST_TEST(std::abs(estimated_spacing(s) / s.vessel.radius_m / spacing - 1) < 0.1);
    }
}
