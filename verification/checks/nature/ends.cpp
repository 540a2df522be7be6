// SPDX-License-Identifier: Apache-2.0
// The open ends, (25) and (26): what they deliver, and what marks they leave.
#include "common/scenario/shipped.hpp"
#include "common/vessel/geometry.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace aneurysm::checks
{
namespace
{

/// The particles' starts that are looked at: what one of them meets may be luck.
constexpr int seeds = 4;

/// paper_tc1 with a wall that stays as it is.
Scenario rigid_artery()
{
    Scenario s = shipped_scenario("paper_tc1");
    s.growth.warm_up_frames = s.time.frames;
    return s;
}

/// What passes the inlet in a cycle while it pushes or draws, over pi r_0^2 int v dt.
struct Delivery {
    double found = 0;
    double prescribed = 0;

    Delivery& operator+=(const Delivery& other)
    {
        found += other.found;
        prescribed += other.prescribed;
        return *this;
    }
    double error() const { return std::abs(found / prescribed - 1); }
};

/// Blood in the core of the parent artery, between its quarters and within half of its radius, over rho_0 times the volume.
double core_density(const Scenario& s, const Particles& p)
{
    const double r_0 = s.vessel.radius_m;
    const double length = s.vessel.parent_length_radii * r_0;
    const auto in_core = [&](const Vec3& x) {
        return x.y > -3 * length / 4 && x.y < -length / 4 && x.x * x.x + x.z * x.z < r_0 * r_0 / 4;
    };
    double mass = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        mass += p.kind[i] == Kind::fluid && in_core(p.position[i]) ? p.mass : 0;
    }
    return mass / (s.fluid.density_kg_m3 * std::numbers::pi * r_0 * r_0 / 4 * length / 2);
}

/// What comes and goes in the second cycle; in the first the particles find their places.
struct Cycle {
    Delivery in;
    Delivery back;
    double core = 0; ///< mean core_density()
};
Cycle second_cycle(const Probe& probe, const Scenario& s)
{
    const auto flow = probe.simulate(s);
    const double area = std::numbers::pi * s.vessel.radius_m * s.vessel.radius_m;
    const double per_way =
        s.fluid.density_kg_m3 * area / flow->state().particles.mass; // particles in a meter
    Cycle found;
    std::int64_t last = 0;
    const auto cycle = std::llround(s.inlet.cycle_s / s.time.frame_s);
    for (std::int64_t n = 0; n < 2 * cycle; ++n) {
        const FrameRecord r = flow->advance();
        const std::int64_t net = r.ledger.inlet_in - r.ledger.inlet_out;
        if (n >= cycle) {
            Delivery& d = r.inlet_velocity >= 0 ? found.in : found.back;
            d.found += static_cast<double>(net - last);
            d.prescribed += per_way * r.inlet_velocity * s.time.frame_s;
            found.core += core_density(s, flow->state().particles) / static_cast<double>(cycle);
        }
        last = net;
    }
    return found;
}

/// Of all seeds together: that of a single one scatters by a fifth.
void deliver(Probe& probe, const std::string& name, Scenario s, std::optional<KnownLimit> known = {})
{
    Cycle all;
    for (int seed = 1; seed <= seeds; ++seed) {
        s.particles.seed = seed;
        const Cycle found = second_cycle(probe, s);
        all.in += found.in;
        all.back += found.back;
        all.core += found.core / seeds;
    }
    probe.note("mass in the core of the parent over rho_0 and its volume, mean of the cycle, " + name,
               all.core);
    const std::string what = "flux delivered in a cycle, " + name;
    probe.accuracy({what + ": relative error", all.in.error(), 0.01, std::move(known)});
    if (s.inlet.waveform == Waveform::sine) {
        probe.accuracy({what + ", backwards: relative error", all.back.error(), 0.01, measured(0.0469)});
    }
}

void delivered_flux(Probe& probe)
{
    Scenario s = rigid_artery();
    deliver(probe, "sine", s, measured(0.0202));
    s.inlet.waveform = Waveform::rectified_sine;
    deliver(probe, "|sine|", s, measured(0.0197));
    s.inlet.waveform = Waveform::constant;
    deliver(probe, "constant", s, measured(0.0222));
    s.inlet.waveform = Waveform::table; // a steep rise and a slow fall
    s.inlet.table_time_s = {0, 0.1, 0.2, 0.4};
    s.inlet.table_velocity_m_s = {2, 2, 9, 4};
    deliver(probe, "table", s, measured(0.0223));
}

/// Largest errors of the density, of either sign.
struct DensityErrors {
    double excess = 0;
    double hole = 0;

    void add(double error)
    {
        excess = std::max(excess, error);
        hole = std::max(hole, -error);
    }
};

void add_densities(const Probe& probe, const Scenario& s, DensityErrors& ends, DensityErrors& inside)
{
    const Vessel vessel(s, s.vessel.radius_m / std::cbrt(2.0));
    const auto flow = probe.simulate(s);
    for (std::int64_t n = 0; n < s.time.frames; ++n) {
        const Particles before = flow->state().particles;
        flow->advance();
        const std::vector<double>& rho = flow->density(); // where they were
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (before.kind[i] == Kind::fluid) {
                const Vec3& x = before.position[i];
                const bool at_end =
                    vessel.openings().at(vessel.nearest_tube(x)).beyond(x) > -s.vessel.radius_m / 2;
                (at_end ? ends : inside).add(rho[i] / s.fluid.density_kg_m3 - 1);
            }
        }
    }
}

void densities(Probe& probe)
{
    Scenario s = rigid_artery();
    DensityErrors ends;
    DensityErrors inside;
    for (int seed = 1; seed <= seeds; ++seed) {
        s.particles.seed = seed;
        add_densities(probe, s, ends, inside);
    }
    probe.accuracy({"density within half a radius of an end: largest excess", ends.excess, 0.05});
    probe.accuracy({"density within half a radius of an end: deepest hole", ends.hole, 0.05});
    probe.accuracy({"density elsewhere: largest excess", inside.excess, 0.01, measured(0.0139)});
    probe.accuracy({"density elsewhere: deepest hole", inside.hole, 0.01, measured(0.0198)});
}

/// Through a pipe the fastest blood is on the axis, at twice the mean, where the profile has developed.
void speeds(Probe& probe)
{
    const Scenario s = shipped_scenario("verify_pipe");
    const auto flow = probe.simulate(s);
    double fastest = 0;
    for (std::int64_t n = 0; n < 800; ++n) {
        fastest = std::max(fastest, flow->advance().speed_max);
    }
    probe.accuracy({"fastest blood in a pipe against the fastest of the exact profile: relative difference",
                    std::abs(fastest / (2 * s.inlet.peak_velocity_m_s) - 1), 0.5});
}

void open_end_profile(Probe& probe)
{
    densities(probe);
    speeds(probe);
}

} // namespace

std::vector<Check> nature_ends_checks()
{
    return {nature_check("delivered_flux", "the inlet delivers and draws what (25) says",
                         {"pi r_0^2 int v dt"}, delivered_flux),
            nature_check("open_end_profile", "an open end leaves no mark in the density and the velocity",
                         {"rho_0", "Hagen and Poiseuille's parabola"}, open_end_profile)};
}

} // namespace aneurysm::checks
