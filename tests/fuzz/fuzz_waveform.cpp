// SPDX-License-Identifier: Apache-2.0
// Tables of the inlet's waveform. The input is what stands in a scenario's group `inlet` beside the name of the
// waveform: {"table_time_s": [0, 0.4], "table_velocity_m_s": [0, 1.5]}
#include "reference/boundary.hpp"
#include "tests/fuzz/same_scenario.hpp"

#include <algorithm>
#include <functional>
#include <string>

using namespace aneurysm;

namespace
{

/// The scenario `quick` with another inlet.
std::string with_inlet(const std::string& inlet)
{
    static const std::string complete = [] {
        auto json = nlohmann::ordered_json::parse(to_json(read_scenario(ANEURYSM_SCENARIOS "/quick.json")));
        json.erase("inlet");
        for (const char* key :
             {"waveform", "profile", "ramp_s", "cycle_s", "table_time_s", "table_velocity_m_s"}) {
            json["assumed"][std::string("inlet.") + key] = "a test";
        }
        return json.dump();
    }();
    return complete.substr(0, complete.size() - 1) + ", \"inlet\": " + inlet + "}";
}

/// The input with what else an inlet needs, where it doesn't say it itself.
std::string completed(std::string inlet)
{
    for (const auto& [key, value] : {std::pair{"waveform", "\"table\""},
                                     {"ramp_s", "0"},
                                     {"cycle_s", "0.8"},
                                     {"peak_velocity_m_s", "1.5"},
                                     {"profile", "\"plug\""}}) {
        if (inlet.starts_with('{') && inlet.find(key) == std::string::npos) {
            inlet.insert(1, std::string("\"") + key + "\": " + value + ", ");
        }
    }
    return inlet;
}

/// Between the points of the table, and at them its velocities.
void check_table(const Scenario& s)
{
    const std::vector<double>& t = s.inlet.table_time_s;
    const std::vector<double>& v = s.inlet.table_velocity_m_s;
    test::require(!t.empty() && t.size() == v.size() && t.front() == 0 && t.back() < s.inlet.cycle_s,
                  "a table from 0 to below the cycle");
    test::require(std::adjacent_find(t.begin(), t.end(), std::greater_equal<>()) == t.end(),
                  "times that rise");
    const auto [low, high] = std::minmax_element(v.begin(), v.end());
    const double slack = 1e-9 * (1 + std::abs(*low) + std::abs(*high));
    const auto velocity = [&s](double time) {
        const auto& in = s.inlet;
        return reference::inlet_velocity(in.waveform, in.peak_velocity_m_s, in.cycle_s, time, in.table_time_s,
                                         in.table_velocity_m_s);
    };
    for (std::size_t k = 0; k < t.size(); ++k) {
        test::require(velocity(t[k]) == v[k], "the table's velocity at its times");
    }
    constexpr int frames = 50;
    for (int k = 0; k <= frames; ++k) {
        const double at = velocity(2.5 * s.inlet.cycle_s * k / frames);
        test::require(at >= *low - slack && at <= *high + slack, "a velocity within those of the table");
    }
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string text = with_inlet(completed(test::text_of(data, size)));
    Scenario scenario;
    if (test::accepts([&] { scenario = parse_scenario(text, "input"); })) {
        test::require_in_range(scenario);
        test::require_same_again(scenario);
        test::require_all_taken(nlohmann::json::parse(text), scenario);
        if (scenario.inlet.waveform == Waveform::table) {
            check_table(scenario);
        }
    }
    return 0;
}
