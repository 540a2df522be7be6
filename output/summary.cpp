// SPDX-License-Identifier: Apache-2.0
#include "output/summary.hpp"

#include "output/columns.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iomanip>
#include <sstream>

namespace aneurysm::output
{
namespace
{

/// The run in a few numbers.
struct Totals {
    double largest_ratio = 0; ///< of the wall's load as a pressure and P_c
    std::int64_t ratio_frame = 0;
    double density_error_max = 0;
    double density_error_mean = 0;
    double density_error_max_ends = 0;
    double residual_mean = 0; ///< largest of the frames' means
    double residual_max = 0;
    double iterations = 0;           ///< mean
    double corrections = 0;          ///< mean
    std::int64_t settled_frames = 0; ///< after the warm-up
    std::int64_t outside = 0;        ///< most particles beyond the wall before rupture
    std::int64_t rupture_frame = -1;
    std::int64_t unsolved = 0;       ///< frames, in all of the run
    std::int64_t unsolved_whole = 0; ///< of those, before the wall ruptured
    std::int64_t first_unsolved = 0; ///< frame
    std::int64_t uncorrected = 0;    ///< frames whose correction of the density ended by its limit
    bool constant = true;            ///< the number of particles
};

/// Counts the frames whose solves were ended by their limits.
void count_unsolved(const Scenario& scenario, const FrameRecord& r, Totals& t)
{
    if (!is_solved(scenario, r)) {
        t.first_unsolved = t.unsolved == 0 ? r.frame : t.first_unsolved;
        ++t.unsolved;
        t.unsolved_whole += r.phase == Phase::ruptured ? 0 : 1;
    }
    const std::int64_t limit = scenario.pressure.correction_max_iterations * scenario.time.substeps;
    t.uncorrected += r.corrections >= limit && scenario.pressure.model == PressureModel::dfsph ? 1 : 0;
}

Totals totals_of(const Scenario& scenario, const std::vector<FrameRecord>& records)
{
    Totals t;
    for (const FrameRecord& r : records) {
        t.constant = t.constant && r.total == scenario.particles.count;
        count_unsolved(scenario, r, t);
        if (r.phase == Phase::ruptured) {
            t.rupture_frame = t.rupture_frame < 0 ? r.frame : t.rupture_frame;
        } else {
            t.outside = std::max(t.outside, r.outside);
        }
        if (r.frame <= scenario.growth.warm_up_frames) {
            continue;
        }
        ++t.settled_frames;
        t.density_error_mean += r.density_error_mean;
        t.density_error_max = std::max(t.density_error_max, r.density_error_max);
        t.density_error_max_ends = std::max(t.density_error_max_ends, r.density_error_max_ends);
        t.residual_mean = std::max(t.residual_mean, r.residual_mean);
        t.residual_max = std::max(t.residual_max, r.residual_max);
        t.iterations += static_cast<double>(r.iterations);
        t.corrections += static_cast<double>(r.corrections);
        const double pressure = r.wall_load / scenario.rupture.conversion_area_m2;
        const bool whole = t.rupture_frame < 0 || t.rupture_frame == r.frame;
        if (whole && r.critical_pressure > 0 && pressure / r.critical_pressure > t.largest_ratio) {
            t.largest_ratio = pressure / r.critical_pressure;
            t.ratio_frame = r.frame;
        }
    }
    t.density_error_mean /= static_cast<double>(std::max<std::int64_t>(t.settled_frames, 1));
    t.iterations /= static_cast<double>(std::max<std::int64_t>(t.settled_frames, 1));
    t.corrections /= static_cast<double>(std::max<std::int64_t>(t.settled_frames, 1));
    return t;
}

bool has_sac(const Scenario& scenario)
{
    return scenario.aneurysm.shape != SacShape::none;
}

/// The sac and what hits it; empty without a sac.
std::string wall_lines(const Scenario& scenario, const FrameRecord& last, const Totals& t)
{
    if (!has_sac(scenario)) {
        return {};
    }
    std::ostringstream text;
    text << std::setprecision(4) << "  wall           " << name_of(last.phase);
    if (t.rupture_frame >= 0) {
        text << " in frame " << t.rupture_frame;
    }
    text << "; at the end R " << last.radius << " m, h " << last.thickness << " m\n";
    if (t.settled_frames > 0) {
        text << "  impact         hardest in frame " << t.ratio_frame
             << ": the wall's load over the conversion area was " << t.largest_ratio
             << " P_c; at the end F_b " << last.impact_force << " N, the load " << last.wall_load
             << " N, P_c " << last.critical_pressure << " Pa\n";
    }
    return text.str();
}

/// Net particles, as in "550 out at the outlets" or "550 back in at the outlets".
std::string net(std::int64_t count, const char* forward, const char* back)
{
    return std::to_string(std::abs(count)) + (count < 0 ? back : forward);
}

/// Where the particles are, and which way they went since the start.
std::string particle_lines(const Scenario& scenario, const FrameRecord& last, const Totals& t)
{
    std::ostringstream text;
    text << "  particles      " << last.total << (t.constant ? " in every frame" : ", NOT CONSTANT") << "; "
         << last.fluid << " of them blood at the end, the others behind the open ends and in reserve\n";
    const Ledger& l = last.ledger;
    if (l.inlet_in + l.inlet_out + l.outlet_in + l.outlet_out > 0) {
        text << "  flow, net      " << net(l.inlet_in - l.inlet_out, " in", " back out") << " at the inlet, "
             << net(l.outlet_out - l.outlet_in, " out", " back in") << " at the outlets";
        if (has_sac(scenario)) {
            text << ", " << l.escaped << " through the breach";
        }
        text << " [particles]\n";
    }
    if (has_sac(scenario)) {
        text << "  leaks          at most " << t.outside << " particles beyond the wall before rupture\n";
    }
    if (l.missed > 0) {
        text << "  RESERVE        was empty for " << l.missed
             << " particles: raise particles.reserve_fraction\n";
    }
    return text.str();
}

/// Blood in, blood out and what stayed, over the last whole cycle; empty before the first and without ends.
std::string volume_line(const Scenario& scenario, const std::vector<FrameRecord>& records)
{
    const auto cycle = static_cast<std::size_t>(std::lround(scenario.inlet.cycle_s / scenario.time.frame_s));
    if (records.size() <= cycle) {
        return {};
    }
    const FrameRecord& last = records.back();
    const FrameRecord& first = records[records.size() - 1 - cycle];
    const Ledger& a = first.ledger;
    const Ledger& b = last.ledger;
    const std::int64_t in = b.inlet_in + b.outlet_in - a.inlet_in - a.outlet_in;
    const std::int64_t out = b.inlet_out + b.outlet_out + b.escaped - a.inlet_out - a.outlet_out - a.escaped;
    if (in + out == 0) {
        return {};
    }
    std::ostringstream text;
    text << "  last cycle     " << in << " particles in = " << out << " out + " << last.fluid - first.fluid
         << " more in the artery" << (in == out + last.fluid - first.fluid ? "" : ", WHICH DOESN'T BALANCE")
         << "\n";
    return text.str();
}

/// Errors after the warm-up, and what the scenario's solver allows.
std::string error_lines(const Scenario& scenario, const Totals& t)
{
    std::ostringstream text;
    text << std::setprecision(4);
    text << "  density error  " << 100 * t.density_error_mean << " % mean, " << 100 * t.density_error_max
         << " % largest, " << 100 * t.density_error_max_ends << " % near the open ends, after the warm-up\n";
    if (scenario.pressure.model == PressureModel::dfsph) {
        text << "  residual of (3) at most " << t.residual_mean << " /s mean, " << t.residual_max
             << " /s largest (allowed: " << scenario.pressure.tolerance_per_s << ", "
             << scenario.pressure.max_tolerance_per_s << "); " << t.iterations << " iterations a frame, and "
             << t.corrections << " for the density\n";
    }
    return text.str();
}

/// What the summary has to shout: pressures that are none.
std::string unsolved_lines(const Scenario& scenario, const Totals& t, std::int64_t frames)
{
    std::ostringstream text;
    if (t.unsolved > 0) {
        text << "  NOT SOLVED     (3) in " << t.unsolved << " of " << frames << " frames, from frame "
             << t.first_unsolved << " on, " << t.unsolved_whole
             << " of them before the wall ruptured: pressure.max_iterations ("
             << scenario.pressure.max_iterations << ") ended the solve; raise it\n";
    }
    if (t.uncorrected > 0) {
        text << "  density        corrected only in part in " << t.uncorrected << " of " << frames
             << " frames: pressure.correction_max_iterations (" << scenario.pressure.correction_max_iterations
             << ") ended it\n";
    }
    return text.str();
}

} // namespace

bool is_solved(const Scenario& scenario, const FrameRecord& record)
{
    const auto& p = scenario.pressure;
    return p.model != PressureModel::dfsph ||
           (record.residual_mean <= p.tolerance_per_s && record.residual_max <= p.max_tolerance_per_s);
}

std::string summary(const Scenario& scenario, const std::vector<FrameRecord>& records)
{
    if (records.empty()) {
        return "  no frame yet\n";
    }
    const FrameRecord& last = records.back();
    const Totals t = totals_of(scenario, records);
    std::ostringstream text;
    text << std::setprecision(4);
    text << "  frames         " << last.frame << " (" << last.time << " s)\n";
    text << wall_lines(scenario, last, t) << particle_lines(scenario, last, t)
         << volume_line(scenario, records);
    if (t.settled_frames > 0) {
        text << error_lines(scenario, t);
    }
    text << unsolved_lines(scenario, t, last.frame);
    return text.str();
}

} // namespace aneurysm::output
