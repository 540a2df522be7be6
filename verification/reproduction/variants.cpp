// SPDX-License-Identifier: Apache-2.0
#include "verification/reproduction/variants.hpp"

#include "common/scenario/shipped.hpp"

namespace aneurysm::reproduction
{
namespace
{

/// Long enough to see, with particles to draw, and enough of them in reserve for the largest sac.
Scenario drawn(std::int64_t frames)
{
    Scenario scenario = calibrated_scenario();
    scenario.time.frames = frames;
    scenario.particles.reserve_fraction = 0.12;
    scenario.assumed["particles.reserve_fraction"] = "spherical and piriform sacs take up more blood than "
                                                     "the hemispherical one: with 0.06 the reserve ran "
                                                     "dry in frame 1478";
    scenario.output.particles_every_frames = 500;
    return scenario;
}

} // namespace

Scenario calibrated_scenario()
{
    return shipped_scenario(read_data("calibration.json").at("scenario"));
}

std::vector<Variant> shape_variants(const Reproduction& reproduction)
{
    std::vector<Variant> all;
    for (const auto& row : reproduction.paper.at("table2")) {
        const std::string name = row.at("shape");
        const nlohmann::json sac{{"shape", name},
                                 {"neck_width_radii", row.at("neck_width_radii")},
                                 {"base_width_radii", row.at("base_width_radii")}};
        all.push_back({name, changed(drawn(3000), {{"aneurysm", sac}}, name, "data/paper.json: table2")});
    }
    return all;
}

std::vector<Variant> angle_variants(const Reproduction& reproduction)
{
    std::vector<Variant> all;
    for (const int angle : reproduction.paper.at("figures").at("fig8_angles_deg")) {
        Scenario scenario = drawn(2500);
        scenario.name += "_angle" + std::to_string(angle);
        scenario.vessel.angle_deg = angle;
        all.push_back({std::to_string(angle) + " degrees", scenario});
    }
    return all;
}

} // namespace aneurysm::reproduction
