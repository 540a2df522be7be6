// SPDX-License-Identifier: Apache-2.0
#include "app/notes.hpp"

#include "common/scenario/limits.hpp"

#include <cmath>
#include <sstream>

namespace aneurysm::app
{

std::string note_before_run(const Scenario& scenario)
{
    // base.json and calibrated.json have about 2; growth at 5 is another one by a seventh (check impact_resolution).
    constexpr double fewest = 2.0 / 3;
    constexpr double most = 6;
    const double particle_mass = scenario.fluid.density_kg_m3 * std::pow(estimated_spacing(scenario), 3);
    const double particles = scenario.rupture.impact_mass_kg / particle_mass;
    if (scenario.aneurysm.shape == SacShape::none || (particles >= fewest && particles <= most)) {
        return "";
    }
    std::ostringstream text;
    text.precision(3);
    text
        << "rupture.impact_mass_kg (" << scenario.rupture.impact_mass_kg << " kg) is the mass of "
        << particles
        << " particles; the values of base.json were chosen where it is that of two, and the sac grows and ruptures "
           "otherwise here (docs/model.md, Limits)";
    return text.str();
}

} // namespace aneurysm::app
