// SPDX-License-Identifier: Apache-2.0
// A round pipe from an inlet (25) to an outlet (26), with a wall that holds the blood (27): how much of the inflow
// arrives.
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

/// The mean of the blood's velocity along a round pipe, between two places and within `aside` of its axis.
double mean_along(const Particles& p, double from, double to, double aside)
{
    double sum = 0;
    double count = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec3& x = p.position[i];
        if (p.kind[i] == Kind::fluid && x.y > from && x.y < to && std::hypot(x.x, x.z) < aside) {
            sum += p.velocity[i].y;
            ++count;
        }
    }
    return count > 0 ? sum / count : 0;
}

/// What of an inlet's flow arrives behind this many diameters, over the inlet's velocity.
struct Arrival {
    double mean = 0;    ///< velocity of the blood in the pipe's second half [1]
    double axis = 0;    ///< velocity near the axis there [1]
    double outflow = 0; ///< particles that leave, over those that the inlet's way holds [1]
};

Arrival arrival(const Probe& probe, const Scenario& s, Quantity& balance)
{
    constexpr int settled = 400; // the slowest mode of the profile decays with 0.15 s
    constexpr int frames = 1000;
    const double L = static_cast<double>(s.domain.cells_y) * s.domain.spacing_m;
    const double U = s.inlet.peak_velocity_m_s;
    const auto flow = probe.simulate(s);
    const auto first = std::ranges::count(flow->state().particles.kind, Kind::fluid);
    Arrival sum;
    std::int64_t before = 0;
    for (int n = 1; n <= frames; ++n) {
        const FrameRecord r = flow->advance();
        const Ledger& l = r.ledger;
        balance.equal(r.fluid, first + l.inlet_in - l.inlet_out + l.outlet_in - l.outlet_out,
                      "frame " + std::to_string(n));
        before = n == settled ? l.outlet_out - l.outlet_in : before;
        if (n > settled) {
            const Particles& p = flow->state().particles;
            sum.mean += mean_along(p, L / 2, L, L) / U;
            sum.axis += mean_along(p, L / 2, L, 1.5 * s.domain.spacing_m) / U;
            sum.outflow = static_cast<double>(l.outlet_out - l.outlet_in - before);
        }
    }
    const double way = (frames - settled) * s.time.frame_s * U;
    return {sum.mean / (frames - settled), sum.axis / (frames - settled),
            sum.outflow / (static_cast<double>(first) / L * way)};
}

/// Hagen and Poiseuille's flow from an inlet that pushes a plug: how much of it arrives, by length.
void pipe_loss(Probe& probe)
{
    Quantity& balance = probe.quantity("blood in the pipe, against what came in and went out", Source::exact,
                                       "integers: each particle that crosses an end is counted once");
    Plot plot{"What arrives of a pipe's inflow",
              "length [diameters]",
              "over the inlet's velocity",
              false,
              false,
              {}};
    Series mean{"mean velocity", {}, {}, false};
    Series axis{"velocity near the axis", {}, {}, false};
    Series outflow{"outflow", {}, {}, false};
    for (const std::int64_t cells : {6, 12, 24}) {
        Scenario s = shipped_scenario("verify_pipe");
        s.particles.count = 124 * (cells + 6);
        s.domain.cells_y = cells;
        const double diameters = static_cast<double>(cells) / static_cast<double>(s.domain.cells_x);
        const Arrival found = arrival(probe, s, balance);
        for (const auto& [series, value] : {std::pair{&mean, found.mean}, std::pair{&axis, found.axis},
                                            std::pair{&outflow, found.outflow}}) {
            series->x.push_back(diameters);
            series->y.push_back(value);
            probe.note(series->name + " over the inlet's, pipe of " + std::to_string(diameters).substr(0, 3) +
                           " diameters [1]",
                       value, "no bound; a parabola has 2 on its axis");
        }
    }
    plot.series = {mean, axis, outflow};
    probe.plot(std::move(plot));
}

} // namespace

std::vector<Check> laminar_pipe_checks()
{
    return {
        limit_check("pipe_velocity_loss", {"25", "26", "27"},
                    "each particle through a pipe is accounted for; how much of the flow arrives is reported",
                    {"particle balance", "Hagen and Poiseuille's parabola"}, pipe_loss)};
}

} // namespace aneurysm::checks
