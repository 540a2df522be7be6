// SPDX-License-Identifier: Apache-2.0
// Reading, writing and refusing scenarios. The cases are made from
// the field table itself, so that none is forgotten.
#include "common/error.hpp"
#include "common/file.hpp"
#include "common/scenario/fields.hpp"
#include "common/scenario/limits.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <type_traits>

using namespace aneurysm;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace
{

const fs::path data = ANEURYSM_DATA;

Scenario base()
{
    return read_scenario(data / "scenarios/base.json");
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
    try {
        parse_scenario(text, "here");
    } catch (const InputError& error) {
        const std::string message = error.what();
        BOOST_TEST_MESSAGE(message);
        return message.starts_with("here: " + path) && message.find('\n') == std::string::npos;
    }
    return false;
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
    for (const auto& entry : fs::directory_iterator(data / "scenarios")) {
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
    const Scenario s = read_scenario(data / "scenarios/paper_tc3.json");
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
    BOOST_TEST(read_text(data / "scenario.schema.json") == scenario_schema());
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

BOOST_AUTO_TEST_CASE(contradictions_are_refused)
{
    const auto refuses = [](const std::string& path, auto change) {
        Scenario s = base();
        fields::visit(s, [&s](const fields::Field& field, const auto&) {
            s.assumed[std::string(field.path)] = "test";
        });
        validate(s, "here");
        change(s);
        return refused(to_json(s), path);
    };
    BOOST_TEST(refuses("aneurysm.neck_width_radii", [](Scenario& s) { s.aneurysm.shape = SacShape::none; }));
    BOOST_TEST(refuses("aneurysm.neck_width_radii", [](Scenario& s) { s.aneurysm.neck_width_radii = 1.7; }));
    BOOST_TEST(refuses("aneurysm.neck_width_radii", [](Scenario& s) { s.aneurysm.neck_width_radii = 1.5; }));
    BOOST_TEST(refuses("aneurysm.neck_width_radii", [](Scenario& s) { s.aneurysm.neck_width_radii = 0; }));
    BOOST_TEST(
        refuses("aneurysm.initial_radius_radii", [](Scenario& s) { s.aneurysm.initial_radius_radii = 0; }));
    BOOST_TEST(refuses("aneurysm.initial_radius_radii",
                       [](Scenario& s) { s.aneurysm.initial_radius_radii = 0.81; }));
    BOOST_TEST(refuses("aneurysm.base_width_radii", [](Scenario& s) {
        s.aneurysm.neck_width_radii = s.aneurysm.base_width_radii = 3.3; // gap: 2 r_1 = 1.59 r_0
    }));
    BOOST_TEST(
        refuses("aneurysm.base_width_radii", [](Scenario& s) { s.vessel.daughter_length_radii = 1.7; }));
    BOOST_TEST(refuses("vessel.angle_deg", [](Scenario& s) {
        s.vessel.angle_deg = 15;
        s.vessel.daughter_length_radii = 3.8;
    }));
    BOOST_TEST(refuses("particles.count", [](Scenario& s) { s.particles.count = 20; }));
    BOOST_TEST(refuses("inlet.table_time_s", [](Scenario& s) { s.inlet.waveform = Waveform::table; }));
    const auto table = [](const std::vector<double>& times, const std::vector<double>& velocities) {
        return [times, velocities](Scenario& s) {
            s.inlet.waveform = Waveform::table;
            s.inlet.table_time_s = times;
            s.inlet.table_velocity_m_s = velocities;
        };
    };
    BOOST_TEST(!refuses("", table({0, 0.4}, {1, 2})));
    BOOST_TEST(refuses("inlet.table_velocity_m_s", table({0, 0.4}, {1})));
    BOOST_TEST(refuses("inlet.table_time_s", table({0.1, 0.4}, {1, 2})));
    BOOST_TEST(refuses("inlet.table_time_s", table({0, 0.4, 0.4}, {1, 2, 3})));
    BOOST_TEST(refuses("inlet.table_time_s", table({0, 0.8}, {1, 2})));
    BOOST_TEST(refuses("time.frame_s", [](Scenario& s) { s.inlet.peak_velocity_m_s = 1e5; }));
    BOOST_TEST(refuses("time.frame_s", [](Scenario& s) { s.fluid.viscosity_pa_s = 1e6; }));
    BOOST_TEST(refuses("time.frame_s", [](Scenario& s) {
        s.pressure.model = PressureModel::eos;
        s.pressure.stiffness_m2_s2 = 1e10;
    }));
    BOOST_TEST(refuses("elastic_wall.stiffness_n_m", [](Scenario& s) {
        s.elastic_wall.stiffness_n_m = 4.001 * s.elastic_wall.mass_kg / (s.time.frame_s * s.time.frame_s);
    }));
    BOOST_TEST(refuses("pressure.max_tolerance_per_s",
                       [](Scenario& s) { s.pressure.max_tolerance_per_s = s.pressure.tolerance_per_s / 2; }));
    BOOST_TEST(refuses("growth.largest_increment_m", [](Scenario& s) { s.growth.largest_increment_m = 1; }));
    BOOST_TEST(refuses("rupture.recycle_distance_radii", [](Scenario& s) {
        s.rupture.recycle_distance_radii = s.rupture.breach_radius_radii;
    }));
}

BOOST_AUTO_TEST_CASE(text_that_is_no_scenario_is_refused)
{
    const std::string good = to_json(base());
    BOOST_CHECK_NO_THROW(parse_scenario(good, "here"));
    for (std::size_t end = 0; end + 2 < good.size(); end += 13) {
        BOOST_TEST(refused(good.substr(0, end), ""));
    }
    const auto with = [&good](const std::string& insert) { return "{" + insert + "," + good.substr(1); };
    BOOST_TEST(refused(with(R"("tiem": 1)"), "tiem"));
    BOOST_TEST(refused(with(R"("": 1)"), ": unknown"));
    BOOST_TEST(refused(with(R"("name": "twice")"), "name"));
    BOOST_TEST(refused(with(R"("base": "x.json")"), "base"));
    BOOST_TEST(refused(with(R"("time": {"frame_s": 1, "frame_s": 1})"), "time.frame_s"));
    BOOST_TEST(refused(with(R"("x": 1e999)"), "x: malformed"));
    BOOST_TEST(refused(with(R"("x": NaN)"), "x: malformed"));
    BOOST_TEST(refused("[]", "(top)"));
    BOOST_TEST(refused("3", "(top)"));
    Json json = Json::parse(good);
    json["time"]["step_s"] = 1;
    BOOST_TEST(refused(json.dump(), "time.step_s"));
    json = Json::parse(good);
    json["assumed"]["vessel.color"] = "red";
    BOOST_TEST(refused(json.dump(), "assumed"));
    json = Json::parse(good);
    json["assumed"]["vessel.radius_m"] = "  ";
    BOOST_TEST(refused(json.dump(), "assumed.vessel.radius_m"));
    json["assumed"] = 1;
    BOOST_TEST(refused(json.dump(), "assumed"));
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
