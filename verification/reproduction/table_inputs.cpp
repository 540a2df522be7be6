// SPDX-License-Identifier: Apache-2.0
// Tables 1 and 2: the paper's given values, and the shapes as the wall has them.
#include "common/scenario/shipped.hpp"
#include "common/text.hpp"
#include "common/vessel/geometry.hpp"
#include "reference/bifurcation.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/reproduction/variants.hpp"

#include <cmath>

namespace aneurysm::reproduction
{
namespace
{

/// "fluid.density_kg_m3" -> "/fluid/density_kg_m3"
nlohmann::json::json_pointer pointer(const std::string& path)
{
    const std::size_t dot = path.find('.');
    return nlohmann::json::json_pointer("/" + path.substr(0, dot) + "/" + path.substr(dot + 1));
}

/// Half the wall's width along z at height y, by bisection of the signed distance [m].
double half_width(const Vessel& vessel, double R, double y)
{
    double inside = 0;
    double outside = 4 * R;
    constexpr int steps = 60;
    for (int k = 0; k < steps; ++k) {
        const double middle = (inside + outside) / 2;
        (vessel.wall({0, y, middle}, R).value < 0 ? inside : outside) = middle;
    }
    return inside;
}

/// Of the neck plane and of the widest place above it, on the developed sac [m].
struct Widths {
    double neck = 0;
    double base = 0;
};

Widths measure(const Scenario& scenario)
{
    const Vessel vessel = reference::vessel_of(scenario);
    const double R = vessel.largest_radius();
    Widths widths{2 * half_width(vessel, R, vessel.apex()), 0};
    constexpr int samples = 2000;
    for (int k = 0; k <= samples; ++k) {
        const double y = vessel.apex() + (vessel.dome(R).y - vessel.apex()) * k / samples;
        if (vessel.wall({0, y, 0}, R).value < 0) {
            widths.base = std::max(widths.base, 2 * half_width(vessel, R, y));
        }
    }
    return widths;
}

/// A scenario's value; a list with spaces, so that a table can break it.
std::string in_words(const nlohmann::json& value)
{
    std::vector<std::string> words;
    for (const nlohmann::json& element : value) {
        words.push_back(element.dump());
    }
    return value.is_array() ? joined(words) : value.dump();
}

} // namespace

Section table1(Reproduction& reproduction)
{
    const Scenario scenario = shipped_scenario("base");
    const nlohmann::json ours = nlohmann::json::parse(to_json(scenario));
    ResultTable table{"", {"symbol", "meaning", "paper", "here", "unit", "scenario key", "same"}};
    std::size_t same = 0;
    for (const auto& row : reproduction.paper.at("table1")) {
        const std::string path = row.at("path");
        const double here = ours.at(pointer(path));
        const double there = row.at("value");
        same += here == there ? 1 : 0;
        table.add(row.at("symbol").get<std::string>(), row.at("meaning").get<std::string>(), there, here,
                  row.at("unit").get<std::string>(), path, here == there ? "yes" : "no");
    }
    ResultTable assumed{"Values that the paper doesn't give, calibrated set",
                        {"scenario key", "value", "why"}};
    const Scenario calibrated = calibrated_scenario();
    const nlohmann::json theirs = nlohmann::json::parse(to_json(calibrated));
    for (const auto& [path, reason] : calibrated.assumed) {
        assumed.rows.push_back({path, in_words(theirs.value(pointer(path), nlohmann::json())), reason});
    }
    Section section{"table1", "Table 1: the given values"};
    section.tables = {table, assumed};
    section.claims = {{"The values of Table 1", same == table.rows.size(),
                       std::to_string(same) + " of " + std::to_string(table.rows.size()) + " in base.json"}};
    return section;
}

Section table2(Reproduction& reproduction)
{
    ResultTable table{"Widths of the developed sac, in artery radii, measured on the wall",
                      {"shape", "neck, paper", "neck, here", "base, paper", "base, here"}};
    bool within = true;
    for (const auto& row : reproduction.paper.at("table2")) {
        const std::string shape = row.at("shape");
        const Scenario scenario = shipped_scenario("paper_shape_" + shape);
        const Widths widths = measure(scenario);
        const double r_0 = scenario.vessel.radius_m;
        const double neck = row.at("neck_width_radii");
        const double base = row.at("base_width_radii");
        within = within && std::abs(widths.neck / r_0 / neck - 1) < 0.01 &&
                 std::abs(widths.base / r_0 / base - 1) < 0.01;
        table.add(shape, neck, widths.neck / r_0, base, widths.base / r_0);
    }
    Section section{"table2", "Table 2: neck and base width of the three shapes"};
    section.text = {
        "The smooth union of sac and tubes may widen the neck by a little; the test test_vessel bounds "
        "that."};
    section.tables = {table};
    section.claims = {{"Neck and base width of Table 2", within, "all within 1 % on the wall itself"}};
    return section;
}

} // namespace aneurysm::reproduction
