// SPDX-License-Identifier: Apache-2.0
// Claims of the paper's text that the equations of the wall decide, so that no run is needed.
#include "common/text.hpp"
#include "common/error.hpp"
#include "reference/rupture.hpp"
#include "verification/reproduction/ensemble.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/reproduction/variants.hpp"

#include <algorithm>
#include <cmath>
#include <ranges>

namespace aneurysm::reproduction
{
namespace
{

constexpr double impact = 400;          ///< in each frame [N]: any other gives the same order
constexpr std::int64_t frames = 3000;   ///< long enough for full development
const RuptureRow common{0.4, 0.003, 0}; ///< of Table 1

/// A wall of Table 4 under the steady impact, kept from rupturing.
struct SteadyWall {
    RuptureRow row;
    std::vector<WallFrame> frames;
};

/// Those that differ from the common one in one of the two alone, by its size.
std::vector<SteadyWall> walls_by(const Reproduction& reproduction, const Scenario& scenario,
                                 double RuptureRow::*varied, double RuptureRow::*fixed)
{
    std::vector<SteadyWall> walls;
    for (const RuptureRow& row : table4_rows(reproduction.paper)) {
        if (row.*fixed == common.*fixed) {
            walls.push_back({row, wall_under(with_wall(unbreakable(scenario), row), impact, frames)});
        }
    }
    std::ranges::sort(walls, {}, [varied](const SteadyWall& wall) { return wall.row.*varied; });
    return walls;
}

/// Whether a number falls from each wall to the next, in all frames in which the walls may grow.
bool falls(const std::vector<SteadyWall>& walls, double WallFrame::*number)
{
    for (std::size_t w = 1; w < walls.size(); ++w) {
        for (std::size_t k = 0; k < walls[w].frames.size(); ++k) {
            const WallFrame& frame = walls[w].frames[k];
            if (frame.phase != Phase::warm_up && !(frame.*number < walls[w - 1].frames[k].*number)) {
                return false;
            }
        }
    }
    return true;
}

/// Whether a number is the same for all walls, to the bit, in all frames.
bool is_same(const std::vector<SteadyWall>& walls, double WallFrame::*number)
{
    return std::ranges::all_of(walls, [&](const SteadyWall& wall) {
        return std::ranges::equal(wall.frames, walls.front().frames, {}, number, number);
    });
}

/// A number of the last frame, of each wall against the common one.
std::string last(const std::vector<SteadyWall>& walls, double WallFrame::*member)
{
    const auto of = [member](const SteadyWall& wall) { return wall.frames.back().*member; };
    const auto middle = std::ranges::find_if(walls, [](const SteadyWall& wall) {
        return wall.row.sigma == common.sigma && wall.row.phi == common.phi;
    });
    std::vector<std::string> words;
    for (const SteadyWall& wall : walls) {
        words.push_back(number(of(wall) / of(*middle)));
    }
    return joined(words, ", ");
}

Claim thinning_while_growing(const std::vector<SteadyWall>& walls)
{
    const bool holds = std::ranges::all_of(walls, [](const SteadyWall& wall) {
        return std::ranges::adjacent_find(wall.frames, [](const WallFrame& a, const WallFrame& b) {
                   return b.radius > a.radius && b.thickness >= a.thickness;
               }) == wall.frames.end();
    });
    return {"The wall gets thinner as R grows (section 4.1)", holds,
            "(22): h falls in every frame in which R grows, for all five sigma", Basis::follows};
}

/// The porosity that (10) would take away while the sac grows.
Claim constant_porosity(const SteadyWall& wall)
{
    const auto& [sigma, phi, paper] = wall.row;
    double used = 0;
    for (std::size_t k = 1; k < wall.frames.size(); ++k) {
        const double R = wall.frames[k - 1].radius;
        used -= reference::porosity_differential(sigma, R, wall.frames[k].radius - R);
    }
    return {"The porosity varies little while the sac grows (section 3.2)", used < phi,
            "(10) takes " + number(used) + " off phi = " + number(phi) + " while R grows from " +
                number(wall.frames.front().radius) + " to " + number(wall.frames.back().radius) +
                " m, in all units of length: (2 - sigma) ln(R/R_0); all of it is gone when R has grown by " +
                number(100 * std::expm1(phi / (2 - sigma)), 2) + " %",
            Basis::excluded};
}

/// By how much less the wall thins in a frame once it is fully developed.
/// \throws Error when that takes too long or no time
Claim thickness_at_rest(const Scenario& scenario, const SteadyWall& wall)
{
    const auto developed = std::ranges::find(wall.frames, Phase::fully_developed, &WallFrame::phase);
    if (developed - wall.frames.begin() < 3 || developed == wall.frames.end()) {
        throw Error("the walls of the text's claims", "R doesn't grow to its largest in some 3000 frames",
                    "another steady impact in verification/reproduction/text.cpp");
    }
    const auto thinning = [](const WallFrame* frame) {
        return 1 - frame->thickness / (frame - 1)->thickness;
    };
    const WallFrame* first = &*developed;
    const double ratio = thinning(first) / thinning(first - 2); // the frame between takes a part of a step
    const double per_radius = scenario.growth.thinning_intensity_per_m / wall.row.sigma;
    constexpr double little = 0.1;
    return {
        "The change of the hemispherical sac's thickness falls to 0 when it is fully developed (section 4.2)",
        ratio < little,
        "it falls to " + number(ratio, 2) +
            " of what it was at the same F_b: alpha R / sigma of (22) and (23), at R = " +
            number(first->radius) + " m; in an artery of millimeters, with R = 0.0016 m, it would be " +
            number(per_radius * 0.0016, 2)};
}

} // namespace

Section text(Reproduction& reproduction)
{
    const Scenario scenario = calibrated_scenario();
    const auto by_sigma = walls_by(reproduction, scenario, &RuptureRow::sigma, &RuptureRow::phi);
    const auto by_phi = walls_by(reproduction, scenario, &RuptureRow::phi, &RuptureRow::sigma);
    ResultTable table{"Frame " + std::to_string(frames), {"sigma", "phi", "R [m]", "h [m]", "P_c / Y"}};
    const auto add = [&](const SteadyWall& wall) {
        const WallFrame& end = wall.frames.back();
        table.add(wall.row.sigma, wall.row.phi, end.radius, end.thickness,
                  end.critical_pressure / unbreakable(scenario).rupture.yield_limit_pa);
    };
    std::ranges::for_each(by_sigma, add);
    std::ranges::for_each(by_phi | std::views::drop(1), add); // the first is among those by sigma
    double WallFrame::*const P_c = &WallFrame::critical_pressure;
    double WallFrame::*const h = &WallFrame::thickness;
    Section section{"text", "Claims of the text that the equations of the wall decide"};
    section.text = {"The walls of Table 4 under the same impact of " + number(impact) +
                    " N in each frame, kept from rupturing; numbers of frame " + std::to_string(frames) +
                    " against those of sigma 0.4 and phi 0.003."};
    section.tables = {table};
    section.claims = {
        {"The smaller sigma, the larger P_c (section 4.4)", falls(by_sigma, P_c),
         "by (13), in every frame; P_c of sigma 0.2 to 0.6: " + last(by_sigma, P_c), Basis::follows},
        {"The larger phi, the smaller P_c (sections 4.4 and 5)", falls(by_phi, P_c),
         "by (13), in every frame; P_c of phi 0.003 to 0.006: " + last(by_phi, P_c), Basis::follows},
        {"The larger sigma, the faster h falls (section 4.4)", falls(by_sigma, h),
         "by (22), while the sac grows, (23) has no sigma; h of sigma 0.2 to 0.6: " + last(by_sigma, h),
         Basis::follows},
        {"The larger phi, the faster h falls (section 4.4)", !is_same(by_phi, h),
         "(21), (22) and (23) have no phi: h is the same to the bit in every frame", Basis::excluded},
        thinning_while_growing(by_sigma),
        constant_porosity(by_phi.front()),
        thickness_at_rest(scenario, by_phi.front())};
    return section;
}

} // namespace aneurysm::reproduction
