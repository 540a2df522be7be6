// SPDX-License-Identifier: Apache-2.0
// Figures 7, 9 and 10: impact, thickness and critical pressure over the frames.
#include "common/error.hpp"
#include "common/text.hpp"
#include "reference/growth.hpp"
#include "verification/reproduction/ensemble.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/reproduction/variants.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>

namespace aneurysm::reproduction
{
namespace
{

constexpr std::size_t warm_up = 100; ///< frames, section 4.4
constexpr double quarter = 0.25;     ///< what "alike" and "little" are taken to mean

/// A number of each frame, from frame 1.
template <class Frame>
PlotSeries series(const std::string& name, const std::vector<Frame>& frames, double Frame::*member, int color,
                  const std::string& style = "line")
{
    PlotSeries s{name, {}, {}, style, color};
    for (const Frame& frame : frames) {
        s.add(static_cast<double>(s.x.size() + 1), frame.*member);
    }
    return s;
}

/// What is compared with P_c.
PlotSeries load_as_pressure(const Member& member, int color)
{
    PlotSeries pressure = series("load / area", member.records, &FrameRecord::wall_load, color, "thin");
    for (double& y : pressure.y) {
        y /= member.scenario.rupture.conversion_area_m2;
    }
    return pressure;
}

/// Frames of a cycle of the heart. \throws InputError unless the runs have two, each longer than the warm-up, as what is said
/// about their F_b takes for granted
std::size_t frames_of_cycle(const Scenario& scenario)
{
    const auto cycle = static_cast<std::size_t>(std::llround(scenario.inlet.cycle_s / scenario.time.frame_s));
    if (cycle < warm_up || static_cast<std::size_t>(scenario.time.frames) < 2 * cycle) {
        throw InputError(scenario.name + ": time.frames",
                         "too few (" + std::to_string(scenario.time.frames) + ") for Fig. 9",
                         "needed: two cycles (inlet.cycle_s) of at least " + std::to_string(warm_up) +
                             " frames each (now " + std::to_string(cycle) + ")");
    }
    return cycle;
}

/// Amplitude of a period of F_b over whole cycles of 800 frames after the warm-up.
double amplitude(const std::vector<FrameRecord>& records, std::size_t cycle, double period)
{
    const std::size_t cycles = (records.size() - warm_up) / cycle;
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < cycles * cycle; ++k) {
        sum += records[warm_up + k].impact_force *
               std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) / period);
    }
    return 2 * std::abs(sum) / static_cast<double>(cycles * cycle);
}

/// F_b beats with the heart: of all periods that whole cycles hold, T (or T/2, for a flow that turns round)
/// has the largest amplitude.
Claim pulsatility(const std::vector<FrameRecord>& records, std::size_t cycle)
{
    const std::size_t cycles = (records.size() - warm_up) / cycle;
    double largest = 0;
    double at = 0;
    for (std::size_t k = 1; k <= 8 * cycles; ++k) {
        const double period = static_cast<double>(cycles * cycle) / static_cast<double>(k);
        const double a = amplitude(records, cycle, period);
        if (a > largest) {
            largest = a;
            at = period;
        }
    }
    const double T = amplitude(records, cycle, static_cast<double>(cycle));
    return {"F_b is stable after the warm-up and beats with the cardiac cycle of 800 frames",
            std::abs(at - static_cast<double>(cycle)) < 1,
            "the strongest period of F_b is " + number(at) + " frames with an amplitude of " +
                number(largest) + " N; that of 800 frames has " + number(T) + " N"};
}

double mean_impact(const Member& member, std::size_t from, std::size_t to)
{
    return mean(std::span(member.records).subspan(from, to - from), &FrameRecord::impact_force);
}

Claim warm_up_differs(const std::vector<Member>& members, std::size_t cycle)
{
    const double first = mean(members, [](const Member& m) { return mean_impact(m, 0, warm_up); });
    const double later = mean(members, [cycle](const Member& m) {
        double sum = 0; // over the same part of the next cycles
        const std::size_t cycles = m.records.size() / cycle - 1;
        for (std::size_t c = 1; c <= cycles; ++c) {
            sum += mean_impact(m, c * cycle, c * cycle + warm_up) / static_cast<double>(cycles);
        }
        return sum;
    });
    const double ratio = first / later;
    return {"The first 100 frames are abnormal, the warm-up", std::abs(ratio - 1) > quarter,
            "mean F_b of frames 1-100 is " + number(first) + " N, of the same part of later cycles " +
                number(later) + " N"};
}

/// One shape of Fig. 7, as its members have it. The curves go on after P_c was exceeded, as the paper's do:
/// the wall holds whatever comes.
struct Shape {
    std::string name;
    std::vector<Member> members;
    std::vector<WallFrame> middle; ///< mean over the members, by frame
    double developed = 0; ///< mean frame with the largest R; where it isn't reached, one behind the last
    Spread early{};       ///< over the members: the share of h lost from frame 400 to 1000
};

/// The share of h that is lost between two frames.
double lost(const std::vector<WallFrame>& frames, std::size_t from, std::size_t to)
{
    return 1 - frames[to - 1].thickness / frames[from - 1].thickness;
}

Shape shape_of(const Variant& variant, std::vector<Member> members)
{
    std::vector<WallHistory> walls;
    std::vector<double> early;
    for (const Member& member : members) {
        walls.push_back(whole_wall(variant.scenario, member));
        early.push_back(lost(walls.back().frames, 400, 1000));
    }
    std::vector<WallFrame> middle;
    for (std::size_t k = 0; k < walls.front().frames.size(); ++k) {
        const auto mean_of = [&](double WallFrame::*number) {
            return mean(walls, [=](const WallHistory& wall) { return wall.frames[k].*number; });
        };
        middle.push_back({mean_of(&WallFrame::radius), mean_of(&WallFrame::thickness),
                          mean_of(&WallFrame::critical_pressure), Phase::growing});
    }
    const auto end = std::ssize(middle) + 1;
    const double developed = mean(walls, [end](const WallHistory& w) { return w.developed.value_or(end); });
    return {variant.name, std::move(members), std::move(middle), developed, spread(early)};
}

std::vector<Shape> shapes(Reproduction& reproduction)
{
    const int seeds = std::min(reproduction.seeds, 4);
    std::vector<Shape> all;
    for (const Variant& v : shape_variants(reproduction)) {
        all.push_back(shape_of(v, ensemble(reproduction.runs, v.scenario, reproduction.first_seed, seeds)));
    }
    return all;
}

/// Standard deviation of F_b of a member, frames 401-3000 [N].
double fluctuation(const Member& member)
{
    std::vector<double> impacts;
    for (const FrameRecord& record : std::span(member.records).subspan(400, 2600)) {
        impacts.push_back(record.impact_force);
    }
    return spread(impacts).deviation;
}

Claim fluctuations_alike(const std::vector<Shape>& all)
{
    std::vector<double> deviations;
    std::vector<std::string> found;
    for (const Shape& shape : all) {
        deviations.push_back(mean(shape.members, fluctuation));
        found.push_back(shape.name + " " + number(deviations.back()));
    }
    const auto [least, most] = std::ranges::minmax(deviations);
    return {"The fluctuations of F_b are alike for the three shapes (Fig. 7a)", most < (1 + quarter) * least,
            "standard deviation in frames 401-3000 [N]: " + joined(found) + "; alike: within a quarter"};
}

Claim little_thinning(const std::vector<Shape>& all)
{
    std::vector<std::string> found;
    for (const Shape& shape : all) {
        found.push_back(shape.name + " " + number(100 * lost(shape.middle, 400, 3000), 3) + " %");
    }
    return {"The thickness of hemispherical and spherical sacs changes little (Fig. 7b)",
            lost(all[0].middle, 400, 3000) < quarter && lost(all[1].middle, 400, 3000) < quarter,
            "h falls from frame 400 to 3000 by: " + joined(found) + "; little: less than a quarter"};
}

/// Slowest beyond chance: by twice the standard error of a difference of two means.
Claim slowest_thinning(const std::vector<Shape>& all)
{
    std::vector<std::string> found;
    for (const Shape& shape : all) {
        const double error = shape.early.deviation / std::sqrt(static_cast<double>(shape.members.size()));
        found.push_back(shape.name + " " + number(100 * shape.early.mean, 3) + " +- " +
                        number(100 * error, 1) + " %");
    }
    const auto slower_than = [&all](const Shape& other) {
        const double error = std::hypot(all[2].early.deviation, other.early.deviation) /
                             std::sqrt(static_cast<double>(other.members.size()));
        return other.early.mean - all[2].early.mean > 2 * error;
    };
    return {"The thickness of the piriform sac falls the most slowly (Fig. 7b)",
            slower_than(all[0]) && slower_than(all[1]),
            "h falls from frame 400 to 1000, before any sac is fully developed, by: " + joined(found) +
                " (standard error); slower: by twice the error of the difference"};
}

std::vector<Claim> claims_about(const std::vector<Shape>& all)
{
    std::vector<std::string> when;
    std::vector<std::string> pressures;
    for (const Shape& shape : all) {
        when.push_back(shape.name + " " + (shape.developed > 3000 ? "after 3000" : number(shape.developed)));
        pressures.push_back(shape.name + " " + number(shape.middle[999].critical_pressure));
    }
    const auto threshold = [&all](std::size_t k) { return all[k].middle[999].critical_pressure; };
    std::vector<Claim> claims{
        {"The hemispherical aneurysm is fully developed first (paper: from about frame 1600)",
         all[0].developed < all[1].developed && all[0].developed < all[2].developed,
         "mean frame: " + joined(when)},
        {"Before full development the thresholds of hemispherical and spherical sacs are alike and the "
         "piriform one's is the lowest",
         threshold(2) < threshold(0) && threshold(2) < threshold(1),
         "mean P_c in frame 1000 [Pa]: " + joined(pressures)},
        fluctuations_alike(all),
        little_thinning(all)};
    if (all[0].members.size() > 1) { // one seed has no standard error, so that nothing is decided
        claims.push_back(slowest_thinning(all));
    }
    return claims;
}

} // namespace

Section figure7(Reproduction& reproduction)
{
    const std::vector<Shape> all = shapes(reproduction);
    std::vector<PlotPanel> panels{{"(a) impact force, one seed", "frame", "F_b [N]"},
                                  {"(b) thickness, mean", "frame", "h [m]"},
                                  {"(c) critical pressure, mean", "frame", "P_c [Pa]"},
                                  {"radius, mean", "frame", "R [m]"}};
    ResultTable table{"Means over the seeds",
                      {"shape", "mean F_b, frames 400-3000 [N]", "fully developed in frame", "h at 1000 [m]",
                       "h at 3000 [m]", "P_c at 1000 [Pa]", "P_c at 3000 [Pa]"}};
    int color = 0;
    for (const Shape& shape : all) {
        const std::vector<WallFrame>& middle = shape.middle;
        panels[0].series.push_back(
            series(shape.name, shape.members.front().records, &FrameRecord::impact_force, color, "thin"));
        panels[1].series.push_back(series(shape.name, middle, &WallFrame::thickness, color));
        panels[2].series.push_back(series(shape.name, middle, &WallFrame::critical_pressure, color));
        panels[3].series.push_back(series(shape.name, middle, &WallFrame::radius, color++));
        table.add(shape.name, mean(shape.members, [](const Member& m) { return mean_impact(m, 400, 3000); }),
                  shape.developed > 3000 ? "-" : number(shape.developed), middle[999].thickness,
                  middle[2999].thickness, middle[999].critical_pressure, middle[2999].critical_pressure);
    }
    Section section{"fig7", "Fig. 7: impact force, thickness and critical pressure of the three shapes"};
    section.text = {"Mean over " + std::to_string(all.front().members.size()) +
                    " seeds. The walls are kept from rupturing so that the curves reach frame 3000 as the "
                    "paper's do."};
    section.tables.push_back(table);
    section.claims = claims_about(all);
    section.pictures.push_back(
        plot(reproduction.folder("fig7") / "fig7.png",
             "Impact force, wall thickness, critical pressure and radius of the three shapes.", 2, panels));
    return section;
}

Section figure9(Reproduction& reproduction)
{
    const Scenario scenario = calibrated_scenario();
    const std::size_t cycle = frames_of_cycle(scenario);
    const std::vector<Member> members =
        ensemble(reproduction.runs, scenario, reproduction.first_seed, reproduction.seeds);
    const Member& shown = members.front();
    PlotPanel pressures{"Load of the wall as a pressure, and the critical pressures", "frame", "[Pa]"};
    PlotPanel wall{"Thickness", "frame", "h [m]"};
    pressures.series.push_back(load_as_pressure(shown, 6));
    ResultTable table{"One seed: where the triangles are",
                      {"sigma", "frame of rupture", "h [m]", "P_c [Pa]"}};
    int color = 0;
    for (const RuptureRow& row : table4_rows(reproduction.paper)) {
        if (row.phi != 0.003) {
            continue;
        }
        const WallHistory history = wall_along(with_wall(scenario, row), shown.records);
        const std::string name = "sigma " + number(row.sigma);
        pressures.series.push_back(series(name, history.frames, &WallFrame::critical_pressure, color));
        wall.series.push_back(series(name, history.frames, &WallFrame::thickness, color));
        const WallFrame& last = history.frames.back();
        if (history.rupture_frame) {
            const double frame = static_cast<double>(*history.rupture_frame);
            pressures.series.push_back({"", {frame}, {last.critical_pressure}, "points", color});
            wall.series.push_back({"", {frame}, {last.thickness}, "points", color});
        }
        table.add(row.sigma, history.rupture_frame ? std::to_string(*history.rupture_frame) : "holds",
                  last.thickness, last.critical_pressure);
        ++color;
    }
    Section section{"fig9", "Fig. 9: impact force, critical pressure and thickness by Poisson's ratio"};
    section.text = {"Seed " + std::to_string(shown.seed()) +
                    ", each wall up to its rupture (triangle). Table 4 has the means over all seeds."};
    section.tables.push_back(table);
    section.claims = {pulsatility(shown.records, cycle), warm_up_differs(members, cycle)};
    section.pictures.push_back(
        plot(reproduction.folder("fig9") / "fig9.png",
             "The wall's load against the critical pressures of five walls, and their thickness.", 1,
             {pressures, wall}));
    return section;
}

Section figure10(Reproduction& reproduction)
{
    const Scenario scenario = calibrated_scenario();
    const double R_0 = scenario.aneurysm.initial_radius_radii * scenario.vessel.radius_m;
    const double R_max = scenario.aneurysm.base_width_radii / 2 * scenario.vessel.radius_m;
    constexpr int steps = 2200;
    const double dR = (R_max - R_0) / steps; // reaches the largest radius where Table 4 has sigma 0.4 rupture
    PlotPanel radius{"Radius at fixed Delta R", "frame", "R [m]"};
    PlotPanel thickness{"Thickness", "frame", "h [m]"};
    ResultTable table{"After " + std::to_string(steps) + " frames of Delta R = " + number(dR) + " m",
                      {"sigma", "h / h_0 by (22)", "(R/R_0)^-sigma", "relative difference", "Euler's error"}};
    bool same_law = true;
    int color = 0;
    for (const double sigma : {0.2, 0.3, 0.4, 0.5, 0.6}) {
        const double h_0 = scenario.rupture.thickness_ratio * scenario.vessel.radius_m;
        PlotSeries R{"sigma " + number(sigma), {0}, {R_0}, "line", color};
        PlotSeries h{R.name, {0}, {h_0}, "line", color++};
        for (int k = 1; k <= steps; ++k) {
            h.add(k, reference::thickness_growing(h.y.back(), R.y.back(), sigma, dR));
            R.add(k, R.y.back() + dR);
        }
        const double exact = std::pow(R.y.back() / R_0, -sigma);
        const double off = h.y.back() / h_0 / exact - 1;
        const double expected = -dR / 2 * sigma * (sigma + 1) * (1 / R_0 - 1 / R.y.back()); // of first order
        same_law = same_law && std::abs(off / expected - 1) < 0.01;
        table.add(sigma, number(h.y.back() / h_0, 6), number(exact, 6), number(off, 3), number(expected, 3));
        radius.series.push_back(R);
        thickness.series.push_back(h);
    }
    Section section{"fig10", "Fig. 10: radius and thickness by Poisson's ratio at fixed Delta R"};
    section.text = {
        "R grows alike for all; h falls as (R/R_0)^-sigma, the closed form of (9), up to the error of "
        "explicit Euler (22), which is predicted."};
    section.tables.push_back(table);
    section.claims = {{"All sigma have the same law of thinning", same_law,
                       "h R^sigma is constant to the predicted error of Euler's steps, for all five",
                       Basis::follows}};
    section.pictures.push_back(plot(reproduction.folder("fig10") / "fig10.png",
                                    "Radius and thickness at a fixed growth per frame.", 2,
                                    {radius, thickness}));
    return section;
}

} // namespace aneurysm::reproduction
