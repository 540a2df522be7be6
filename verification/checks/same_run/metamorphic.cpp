// SPDX-License-Identifier: Apache-2.0
// The same run in other words, to the same bits: in other units, mirrored, moved through a seam, interrupted,
// on other threads. No oracle knows the answer, and none is needed.
#include "common/scenario/fields.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"
#include "verification/comparison/bits.hpp"
#include "verification/comparison/hash_file.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>

namespace aneurysm::checks
{
namespace
{

/// New units: a length of 2^length meters, and so on.
struct Units {
    int length = 0;
    int time = 0;
    int mass = 0;

    double of(int l, int t, int m) const { return std::ldexp(1.0, -(length * l + time * t + mass * m)); }
};

/// What multiplies a value whose key ends in its unit.
double factor(const Units& u, std::string_view path)
{
    struct Unit {
        std::string_view suffix;
        int l, t, m;
    };
    // The paper's (19) is a force only if its areas are lengths.
    constexpr std::array<Unit, 15> units{{{"elastin_area_m2", 1, 0, 0},
                                          {"collagen_area_m2", 1, 0, 0},
                                          {"_m2_s2", 2, -2, 0},
                                          {"_kg_m3", -3, 0, 1},
                                          {"_pa_s", -1, -1, 1},
                                          {"_m_s2", 1, -2, 0},
                                          {"_n_m", 0, -2, 1},
                                          {"_m_s", 1, -1, 0},
                                          {"per_s", 0, -1, 0},
                                          {"per_m", -1, 0, 0},
                                          {"_pa", -1, -2, 1},
                                          {"_m2", 2, 0, 0},
                                          {"_kg", 0, 0, 1},
                                          {"_s", 0, 1, 0},
                                          {"_m", 1, 0, 0}}};
    for (const Unit& unit : units) {
        if (path.ends_with(unit.suffix)) {
            return u.of(unit.l, unit.t, unit.m);
        }
    }
    return 1;
}

Scenario in_units(Scenario scenario, const Units& u)
{
    fields::visit(scenario, [&](const fields::Field& field, auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        const double f = factor(u, field.path);
        if constexpr (std::is_same_v<Member, double> || std::is_same_v<Member, Vec3>) {
            member = f * member;
        } else if constexpr (std::is_same_v<Member, std::vector<double>>) {
            for (double& x : member) {
                x *= f;
            }
        }
    });
    return scenario;
}

SimulationState in_units(SimulationState state, const Units& u)
{
    const auto scale = [](auto& values, double f) {
        for (auto& x : values) {
            x = f * x;
        }
    };
    Particles& p = state.particles;
    std::vector<bool> unset; // a mark has no unit
    std::ranges::transform(p.pressure, std::back_inserter(unset),
                           [](double pressure) { return pressure <= unset_pressure; });
    p.mass *= u.of(0, 0, 1);
    scale(p.position, u.of(1, 0, 0));
    scale(p.velocity, u.of(1, -1, 0));
    scale(p.pressure, u.of(-1, -2, 1));
    scale(p.kappa, u.of(-1, -2, 1));
    scale(p.drift, u.of(-3, 0, 1));
    for (std::size_t i = 0; i < p.size(); ++i) {
        p.pressure[i] = unset[i] ? unset_pressure : p.pressure[i];
    }
    state.spacing *= u.of(1, 0, 0);
    scale(state.outlet_velocity, u.of(1, -1, 0));
    AneurysmState& a = state.aneurysm;
    a.radius *= u.of(1, 0, 0);
    a.thickness *= u.of(1, 0, 0);
    a.displacement *= u.of(1, 0, 0);
    a.wall_velocity *= u.of(1, -1, 0);
    return state;
}

constexpr const char* same_bits = "bits: multiplying by powers of two is exact, and so every sum, product, "
                                  "quotient and root of the run only changes its exponent";

/// From frame 40 on: before, blood far from the inlet has velocities so small that single precision loses bits of them.
void units(Probe& probe)
{
    Quantity& state = probe.quantity("hashes of the state in other units, after their conversion",
                                     Source::exact, same_bits);
    Quantity& record = probe.quantity("F_b, R, h, P_c, iterations in other units", Source::exact, same_bits);
    Scenario si = shipped_scenario("quick");
    si.growth.warm_up_frames = 44;
    const std::array<Units, 2> others{Units{3, 0, 0}, Units{1, -2, -3}};
    constexpr int frames = 12; // warm-up and growth
    const auto one = probe.simulate(si);
    const SimulationState sampled = one->state();
    for (int n = 0; n < 40; ++n) {
        one->advance();
    }
    const SimulationState start = one->state();
    std::vector<FrameRecord> records;
    for (int n = 0; n < frames; ++n) {
        records.push_back(one->advance());
    }
    for (const Units& u : others) {
        const Scenario scenario = in_units(si, u);
        const std::string where = "length 2^" + std::to_string(u.length) + ", time 2^" +
                                  std::to_string(u.time) + ", mass 2^" + std::to_string(u.mass);
        const auto same = [&](const SimulationState& found, const SimulationState& expected,
                              const std::string& when) {
            state.holds(comparison::hashes_of(found) == comparison::hashes_of(in_units(expected, u)),
                        where + when);
        };
        same(probe.simulate(scenario)->state(), sampled, ", as sampled");
        const auto other = probe.simulate(scenario, in_units(start, u));
        for (const FrameRecord& a : records) {
            const FrameRecord b = other->advance();
            record.within(b.impact_force, a.impact_force * u.of(1, -2, 1), 0, where);
            record.within(b.radius, a.radius * u.of(1, 0, 0), 0, where);
            record.within(b.thickness, a.thickness * u.of(1, 0, 0), 0, where);
            record.within(b.critical_pressure, a.critical_pressure * u.of(-1, -2, 1), 0, where);
            record.equal(b.iterations, a.iterations, where);
            record.equal(b.corrections, a.corrections, where);
        }
        same(other->state(), one->state(), ", after " + std::to_string(frames) + " frames");
    }
    probe.note(
        "(19) as printed has no unit of force", 0,
        "K A epsilon is N m with A in m^2; the run is the same in all units only if A_E and A_C are lengths");
}

/// Stopped every 30 frames, before and after the wall ruptures.
void restart(Probe& probe)
{
    Quantity& hashes = probe.quantity("hashes of a run that was stopped and taken up again", Source::exact,
                                      "bits: a state holds everything that the run needs to go on");
    Quantity& ruptured = probe.quantity("the run ruptures", Source::exact,
                                        "a claim: else the state of a ruptured wall isn't seen");
    Scenario s = shipped_scenario("quick");
    s.rupture.yield_limit_pa = 120; // ruptures within these frames
    const auto whole = probe.simulate(s);
    std::unique_ptr<Simulation> resumed;
    for (int n = 0; n < 180; ++n) {
        if (n % 30 == 0) {
            resumed = probe.simulate(s, whole->state());
        }
        whole->advance();
        resumed->advance();
        hashes.holds(comparison::hashes_of(whole->state()) == comparison::hashes_of(resumed->state()),
                     "frame " + std::to_string(n + 1));
    }
    ruptured.holds(whole->state().aneurysm.phase == Phase::ruptured);
}

void threads(Probe& probe)
{
    Quantity& hashes = probe.quantity("hashes of a run on two threads, or with other blocks", Source::exact,
                                      "bits: sums have a fixed shape, whoever computes their parts");
    const Scenario s = shipped_scenario("quick");
    backends::BackendChoice other = probe.subject().choice;
    const bool is_cpu = other.backend == Backend::cpu;
    (is_cpu ? other.threads : other.block_size) = is_cpu ? 2 : 64;
    const auto one = probe.simulate(s);
    const auto two = backends::make_simulation(other, s, {});
    for (int n = 0; n < 60; ++n) {
        one->advance();
        two->advance();
        hashes.holds(comparison::hashes_of(one->state()) == comparison::hashes_of(two->state()),
                     "frame " + std::to_string(n + 1));
    }
}

/// A disturbed box after a frame of everything.
SimulationState frame_of(const Probe& probe, const Scenario& s, SimulationState state)
{
    const auto flow = probe.simulate(s, std::move(state));
    flow->advance();
    return flow->state();
}

/// The reference's neighbors come in the order of their indices,
/// so that a picture of a box has the same sums.
void pictures(Probe& probe)
{
    Quantity& mirrored =
        probe.quantity("velocities of the mirrored box [m/s]", Source::exact,
                       "bits: a change of sign is exact, and the sums run in the same order");
    Quantity& moved =
        probe.quantity("velocities of the box moved through its seams [m/s]", Source::exact,
                       "bits: places are multiples of 2^-18 m, so that their differences are exact on either "
                       "side of a seam");
    for (const PressureModel model : {PressureModel::dfsph, PressureModel::eos}) {
        Scenario s = box_scenario();
        s.time.frame_s = 0x1p-12;
        s.pressure.model = model;
        s.pressure.stiffness_m2_s2 = 256;
        s.pressure.density_correction = 0.5;
        s.pressure.tolerance_per_s = 1e-3;
        s.fluid.viscosity_pa_s = 64;
        Box box(probe, s);
        box.disturb(0.25, 0.5, 2444);
        const Vec3 v{box.edge(), box.edge(), box.edge()};
        const SimulationState after = frame_of(probe, s, box.state());
        SimulationState mirror = box.state();
        SimulationState shifted = box.state();
        const double way = 3 * s.domain.spacing_m;
        for (std::size_t i = 0; i < box.size(); ++i) {
            Vec3& x = mirror.particles.position[i];
            x = {v.x - x.x, x.y, x.z};
            mirror.particles.velocity[i].x *= -1;
            Vec3& y = shifted.particles.position[i];
            y.z = y.z + way < v.z ? y.z + way : y.z + way - v.z;
        }
        const SimulationState m = frame_of(probe, s, std::move(mirror));
        const SimulationState t = frame_of(probe, s, std::move(shifted));
        for (std::size_t i = 0; i < box.size(); ++i) {
            const Vec3& w = after.particles.velocity[i];
            mirrored.within(m.particles.velocity[i], {-w.x, w.y, w.z}, 0);
            moved.within(t.particles.velocity[i], w, 0);
        }
    }
}

} // namespace

std::vector<Check> metamorphic_checks()
{
    const std::vector<std::string_view> flow{"1", "2", "3", "5", "6", "7", "15", "EOS"};
    return {
        same_run_check(
            "units", {"1", "2", "3", "5", "7", "13", "15", "16", "19", "21", "22", "24", "25", "26", "28"},
            "a run in other units of length, time and mass is the same run: every formula has its dimension",
            {"the run itself in SI units"}, units),
        same_run_check("restart", flow, "a run that was stopped and taken up again is the same run",
                       {"the uninterrupted run"}, restart),
        same_run_check("threads", flow, "more threads, or other blocks on a GPU, change no bit",
                       {"the run on one thread"}, threads, Scope::backends),
        same_run_check("pictures", flow,
                       "a box that is mirrored or moved through its seams behaves as before",
                       {"the box as it was"}, pictures, Scope::once),
    };
}

} // namespace aneurysm::checks
