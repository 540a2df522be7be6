// SPDX-License-Identifier: Apache-2.0
// Figures 7, 9 and 10: impact, thickness and critical pressure over the frames.
#include "reference/growth.hpp"
#include "verification/reproduction/ensemble.hpp"
#include "verification/reproduction/items.hpp"
#include "verification/reproduction/variants.hpp"
#include "verification/reproduction/wall_history.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>

namespace aneurysm::reproduction
{
namespace
{

constexpr std::size_t warm_up = 100; ///< frames, section 4.4

std::vector<double> frame_numbers(std::size_t first, std::size_t count)
{
    std::vector<double> x(count);
    std::iota(x.begin(), x.end(), static_cast<double>(first));
    return x;
}

PlotSeries series(const std::string& name, const std::vector<WallFrame>& frames, double WallFrame::*member,
                  int color)
{
    PlotSeries s{name, frame_numbers(1, frames.size()), {}, "line", color};
    for (const WallFrame& frame : frames) {
        s.y.push_back(frame.*member);
    }
    return s;
}

PlotSeries impacts(const std::string& name, const std::vector<FrameRecord>& records, int color)
{
    PlotSeries s{name, frame_numbers(1, records.size()), {}, "thin", color};
    for (const FrameRecord& record : records) {
        s.y.push_back(record.impact_force);
    }
    return s;
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

double mean_impact(const std::vector<FrameRecord>& records, std::size_t from, std::size_t to)
{
    double sum = 0;
    for (std::size_t k = from; k < to; ++k) {
        sum += records[k].impact_force;
    }
    return sum / static_cast<double>(to - from);
}

Claim warm_up_differs(const std::vector<Member>& members, std::size_t cycle)
{
    double first = 0;
    double later = 0;
    for (const Member& member : members) {
        first += mean_impact(member.records, 0, warm_up) / static_cast<double>(members.size());
        // The same part of the next cycles.
        const std::size_t cycles = member.records.size() / cycle - 1;
        for (std::size_t c = 1; c <= cycles; ++c) {
            later += mean_impact(member.records, c * cycle, c * cycle + warm_up) /
                     static_cast<double>(members.size() * cycles);
        }
    }
    const double ratio = first / later;
    return {"The first 100 frames are abnormal, the warm-up", std::abs(ratio - 1) > 0.25,
            "mean F_b of frames 1-100 is " + number(first) + " N, of the same part of later cycles " +
                number(later) + " N"};
}

/// One shape of Fig. 7, as its members have it.
struct Shape {
    std::string name;
    std::vector<Member> members;
    std::vector<WallHistory> walls;
};

double mean_developed(const Shape& shape)
{
    double sum = 0;
    for (const WallHistory& wall : shape.walls) {
        sum += static_cast<double>(wall.developed.value_or(std::ssize(wall.frames) + 1));
    }
    return sum / static_cast<double>(shape.walls.size());
}

/// Mean over the members of a number of the wall in a frame.
double mean_at(const Shape& shape, std::int64_t frame, double WallFrame::*member)
{
    double sum = 0;
    for (const WallHistory& wall : shape.walls) {
        sum += wall.frames[static_cast<std::size_t>(frame - 1)].*member;
    }
    return sum / static_cast<double>(shape.walls.size());
}

std::vector<WallFrame> mean_frames(const Shape& shape)
{
    std::vector<WallFrame> frames;
    for (std::int64_t k = 1; k <= std::ssize(shape.walls.front().frames); ++k) {
        frames.push_back({mean_at(shape, k, &WallFrame::radius), mean_at(shape, k, &WallFrame::thickness),
                          mean_at(shape, k, &WallFrame::critical_pressure), Phase::growing});
    }
    return frames;
}

std::vector<Shape> shapes(Reproduction& reproduction)
{
    const std::vector<Variant> variants = shape_variants(reproduction);
    const int seeds = std::min(reproduction.seeds, 4);
    std::vector<Shape> all;
    for (const Variant& v : variants) {
        all.push_back({v.name, ensemble(reproduction.runs, v.scenario, reproduction.first_seed, seeds), {}});
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Scenario& scenario = variants[k].scenario;
        for (const Member& member : all[k].members) {
            // The curves go on after P_c was exceeded, as the paper's do: the wall holds whatever comes.
            WallHistory wall = wall_along(unbreakable(scenario), member.records);
            const double relative =
                scenario.rupture.yield_limit_pa / unbreakable(scenario).rupture.yield_limit_pa;
            for (WallFrame& frame : wall.frames) {
                frame.critical_pressure *= relative;
            }
            all[k].walls.push_back(std::move(wall));
        }
    }
    return all;
}

std::vector<Claim> claims_about(const std::vector<Shape>& all)
{
    std::vector<double> developed;
    std::string when;
    for (const Shape& shape : all) {
        developed.push_back(mean_developed(shape));
        when += (when.empty() ? "" : ", ") + shape.name + " " +
                (developed.back() > 3000 ? "after 3000" : number(developed.back()));
    }
    constexpr std::int64_t early = 1000;
    std::vector<double> thresholds;
    std::string pressures;
    for (const Shape& shape : all) {
        thresholds.push_back(mean_at(shape, early, &WallFrame::critical_pressure));
        pressures += (pressures.empty() ? "" : ", ") + shape.name + " " + number(thresholds.back());
    }
    return {{"The hemispherical aneurysm is fully developed first (paper: from about frame 1600)",
             developed[0] < developed[1] && developed[0] < developed[2], "mean frame: " + when},
            {"Before full development the thresholds of hemispherical and spherical sacs are alike and the "
             "piriform one's is the lowest",
             thresholds[2] < thresholds[0] && thresholds[2] < thresholds[1],
             "mean P_c in frame 1000 [Pa]: " + pressures}};
}

} // namespace

Section figure7(Reproduction& reproduction)
{
    const std::vector<Shape> all = shapes(reproduction);
    std::vector<PlotPanel> panels{{"(a) impact force, one seed", "frame", "F_b [N]", {}},
                                  {"(b) thickness, mean", "frame", "h [m]", {}},
                                  {"(c) critical pressure, mean", "frame", "P_c [Pa]", {}},
                                  {"radius, mean", "frame", "R [m]", {}}};
    ResultTable table{"Means over the seeds",
                      {"shape", "mean F_b, frames 400-3000 [N]", "fully developed in frame", "h at 1000 [m]",
                       "h at 3000 [m]", "P_c at 1000 [Pa]", "P_c at 3000 [Pa]"},
                      {}};
    for (std::size_t k = 0; k < all.size(); ++k) {
        const Shape& shape = all[k];
        const auto color = static_cast<int>(k);
        panels[0].series.push_back(impacts(shape.name, shape.members.front().records, color));
        const std::vector<WallFrame> mean = mean_frames(shape);
        panels[1].series.push_back(series(shape.name, mean, &WallFrame::thickness, color));
        panels[2].series.push_back(series(shape.name, mean, &WallFrame::critical_pressure, color));
        panels[3].series.push_back(series(shape.name, mean, &WallFrame::radius, color));
        double impact = 0;
        for (const Member& member : shape.members) {
            impact += mean_impact(member.records, 400, 3000) / static_cast<double>(shape.members.size());
        }
        const double developed = mean_developed(shape);
        table.rows.push_back({shape.name, number(impact), developed > 3000 ? "-" : number(developed),
                              number(mean[999].thickness), number(mean[2999].thickness),
                              number(mean[999].critical_pressure), number(mean[2999].critical_pressure)});
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
    const std::vector<Member> members =
        ensemble(reproduction.runs, scenario, reproduction.first_seed, reproduction.seeds);
    const Member& shown = members.front();
    PlotPanel force{"F_b and the critical pressures", "frame", "F_b [N], P_c [Pa]", {}};
    PlotPanel wall{"Thickness", "frame", "h [m]", {}};
    force.series.push_back(impacts("F_b", shown.records, 6));
    ResultTable table{
        "One seed: where the triangles are", {"sigma", "frame of rupture", "h [m]", "P_c [Pa]"}, {}};
    int color = 0;
    for (const RuptureRow& row : table4_rows(reproduction.paper)) {
        if (row.phi != 0.003) {
            continue;
        }
        const WallHistory history = wall_along(with_wall(scenario, row), shown.records);
        const std::string name = "sigma " + number(row.sigma);
        force.series.push_back(series(name, history.frames, &WallFrame::critical_pressure, color));
        wall.series.push_back(series(name, history.frames, &WallFrame::thickness, color));
        const WallFrame& last = history.frames.back();
        if (history.rupture_frame) {
            const double frame = static_cast<double>(*history.rupture_frame);
            force.series.push_back({"", {frame}, {last.critical_pressure}, "points", color});
            wall.series.push_back({"", {frame}, {last.thickness}, "points", color});
        }
        table.rows.push_back({number(row.sigma),
                              history.rupture_frame ? std::to_string(*history.rupture_frame) : "holds",
                              number(last.thickness), number(last.critical_pressure)});
        ++color;
    }
    const auto cycle = static_cast<std::size_t>(std::llround(scenario.inlet.cycle_s / scenario.time.frame_s));
    Section section{"fig9", "Fig. 9: impact force, critical pressure and thickness by Poisson's ratio"};
    section.text = {"Seed " + std::to_string(shown.seed) +
                    ", each wall up to its rupture (triangle). Table 4 has the means over all seeds."};
    section.tables.push_back(table);
    section.claims = {pulsatility(shown.records, cycle), warm_up_differs(members, cycle)};
    section.pictures.push_back(plot(
        reproduction.folder("fig9") / "fig9.png",
        "Impact force against the critical pressures of five walls, and their thickness.", 1, {force, wall}));
    return section;
}

Section figure10(Reproduction& reproduction)
{
    const Scenario scenario = calibrated_scenario();
    const double R_0 = scenario.aneurysm.initial_radius_radii * scenario.vessel.radius_m;
    const double R_max = scenario.aneurysm.base_width_radii / 2 * scenario.vessel.radius_m;
    constexpr int steps = 2200;
    const double dR = (R_max - R_0) / steps; // reaches the largest radius where Table 4 has sigma 0.4 rupture
    PlotPanel radius{"Radius at fixed Delta R", "frame", "R [m]", {}};
    PlotPanel thickness{"Thickness", "frame", "h [m]", {}};
    ResultTable table{"After " + std::to_string(steps) + " frames of Delta R = " + number(dR) + " m",
                      {"sigma", "h / h_0 by (22)", "(R/R_0)^-sigma", "relative difference", "Euler's error"},
                      {}};
    bool same_law = true;
    int color = 0;
    for (const double sigma : {0.2, 0.3, 0.4, 0.5, 0.6}) {
        PlotSeries r{"sigma " + number(sigma), frame_numbers(0, steps + 1), {R_0}, "line", color};
        const double h_0 = scenario.rupture.thickness_ratio * scenario.vessel.radius_m;
        PlotSeries h{r.name, r.x, {h_0}, "line", color++};
        for (int k = 0; k < steps; ++k) {
            h.y.push_back(reference::thickness_growing(h.y.back(), r.y.back(), sigma, dR));
            r.y.push_back(r.y.back() + dR);
        }
        const double exact = std::pow(r.y.back() / R_0, -sigma);
        const double off = h.y.back() / h_0 / exact - 1;
        const double expected = -dR / 2 * sigma * (sigma + 1) * (1 / R_0 - 1 / r.y.back()); // of first order
        same_law = same_law && std::abs(off / expected - 1) < 0.01;
        table.rows.push_back({number(sigma), number(h.y.back() / h_0, 6), number(exact, 6), number(off, 3),
                              number(expected, 3)});
        radius.series.push_back(r);
        thickness.series.push_back(h);
    }
    Section section{"fig10", "Fig. 10: radius and thickness by Poisson's ratio at fixed Delta R"};
    section.text = {
        "R grows alike for all; h falls as (R/R_0)^-sigma, the closed form of (9), up to the error of "
        "explicit Euler (22), which is predicted."};
    section.tables.push_back(table);
    section.claims = {{"All sigma have the same law of thinning", same_law,
                       "h R^sigma is constant to the predicted error of Euler's steps, for all five"}};
    section.pictures.push_back(plot(reproduction.folder("fig10") / "fig10.png",
                                    "Radius and thickness at a fixed growth per frame.", 2,
                                    {radius, thickness}));
    return section;
}

} // namespace aneurysm::reproduction
