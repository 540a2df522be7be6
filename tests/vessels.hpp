// SPDX-License-Identifier: Apache-2.0
// What the tests of geometry, sampling and simulation share: vessels of shipped scenarios, Table 2, random points.
#pragma once

#include "common/scenario/shipped.hpp"
#include "common/vessel/geometry.hpp"
#include "reference/bifurcation.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace aneurysm::test
{

/// Table 2, in artery radii.
struct SacWidths {
    SacShape shape = SacShape::none;
    double neck = 0;
    double base = 0;
};
inline constexpr std::array table_2{SacWidths{SacShape::hemispherical, 1.6, 1.6},
                                    SacWidths{SacShape::spherical, 1.2, 2.4},
                                    SacWidths{SacShape::piriform, 1.2, 1.6}};
/// Those and none at all.
inline constexpr std::array sacs{table_2[0], table_2[1], table_2[2], SacWidths{}};

/// The same scenario with another sac; without one for the default argument.
inline Scenario with_sac(Scenario scenario, const SacWidths& sac = {})
{
    scenario.aneurysm.shape = sac.shape;
    scenario.aneurysm.neck_width_radii = sac.neck;
    scenario.aneurysm.base_width_radii = sac.base;
    if (sac.shape == SacShape::none) {
        scenario.aneurysm.initial_radius_radii = 0;
    }
    return scenario;
}

/// The vessel of a scenario, with the daughters of (24).
inline Vessel make_vessel(const Scenario& scenario)
{
    return {scenario, reference::daughter_radius(scenario.vessel.radius_m)};
}

/// Angles of Fig. 8, of Table 1, and the ends of the allowed range. [deg]
inline constexpr std::array angles{15.0, 30.0, 40.0, 60.0, 75.0, 85.0};

/// Scenario `base` at another angle, with room for the largest sac between steep daughters.
inline Scenario scenario_at(double angle, const SacWidths& sac)
{
    Scenario scenario = with_sac(shipped_scenario("base"), sac);
    scenario.vessel.angle_deg = angle;
    scenario.vessel.daughter_length_radii = 7;
    return scenario;
}

/// No coordinate or distance in those vessels is larger [m].
inline constexpr double vessel_extent = 10;
/// A distance to a wall is about 30 operations on such numbers [m].
inline constexpr double distance_rounding = vessel_extent * rounding(30);

/// Whether claim(scenario, vessel) holds for every angle and shape.
template <class Claim>
bool for_all_vessels(Claim claim)
{
    return std::ranges::all_of(angles, [&](double angle) {
        return std::ranges::all_of(table_2, [&](const SacWidths& sac) {
            const Scenario scenario = scenario_at(angle, sac);
            return claim(scenario, make_vessel(scenario));
        });
    });
}

/// Uniform numbers, the same with every standard library.
class Random
{
public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}

    double between(double low, double high)
    {
        return low + (high - low) * std::ldexp(static_cast<double>(engine_() >> 11U), -53);
    }
    /// In the cube of half edge `extent` around `center`.
    Vec3 point(double extent, const Vec3& center = {})
    {
        const double x = between(-extent, extent);
        const double y = between(-extent, extent);
        const double z = between(-extent, extent);
        return center + Vec3{x, y, z};
    }
    Vec3 direction()
    {
        while (true) {
            const Vec3 x = point(1);
            const double r = length(x);
            if (r > 0.1 && r <= 1) {
                return x / r;
            }
        }
    }

private:
    std::mt19937_64 engine_;
};

/// Where f, negative at `inside` and positive at `outside`, passes zero; to the last bit.
template <class Function>
double crossing(Function f, double inside, double outside)
{
    for (int bisection = 0; bisection < 100; ++bisection) {
        const double middle = 0.5 * (inside + outside);
        (f(middle) < 0 ? inside : outside) = middle;
    }
    return 0.5 * (inside + outside);
}

} // namespace aneurysm::test
