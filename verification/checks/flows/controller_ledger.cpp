// SPDX-License-Identifier: Apache-2.0
// Section 3.4 over a whole run: what the ledger says of the particles, and the inlet's velocity (25).
#include "analytic/boundary.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"
#include "verification/checks/pressure_level.hpp"

#include <algorithm>
#include <string>

namespace aneurysm::checks
{
namespace
{

std::string frame(const FrameRecord& r)
{
    return "frame " + std::to_string(r.frame);
}

/// Particles that one frame has made `to` of `from`.
std::int64_t became(const std::vector<Kind>& before, const std::vector<Kind>& after, std::vector<Kind> from,
                    std::vector<Kind> to)
{
    std::int64_t n = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const auto is_among = [](const std::vector<Kind>& kinds, Kind kind) {
            return std::ranges::find(kinds, kind) != kinds.end();
        };
        n += is_among(from, before[i]) && is_among(to, after[i]) ? 1 : 0;
    }
    return n;
}

void bookkeeping(Probe& probe)
{
    Quantity& number = probe.quantity("particles in the artery", Source::exact,
                                      "integers: those of frame 0, + in, - out, - escaped");
    Quantity& total =
        probe.quantity("all particles", Source::exact, "integers: the scenario's count in every frame");
    Quantity& passed =
        probe.quantity("particles that passed an end plane in a frame", Source::exact,
                       "integers: those that are in a buffer before and blood after it, or the reverse");
    Quantity& inlet = probe.quantity("inlet velocity [m/s]", Source::rounding,
                                     "gamma_4 of the phase 2 pi t/T times v_0, gamma_12 of the ramp, gamma_4 "
                                     "of the velocity, and the oracle's own bound");
    Quantity& entered = probe.quantity("blood that has just come in and has a pressure", Source::exact,
                                       "integers: none; its buffer's pressure isn't its own");
    const Scenario s = shipped_scenario("quick");
    const auto flow = probe.simulate(s);
    const auto first = std::ranges::count(flow->state().particles.kind, Kind::fluid);
    Ledger last;
    for (int n = 0; n < 180; ++n) {
        const std::vector<Kind> before = flow->state().particles.kind;
        const FrameRecord r = flow->advance();
        const Particles& p = flow->state().particles;
        const Ledger& l = r.ledger;
        const std::vector<Kind> inlets{Kind::inlet};
        const std::vector<Kind> outlets{Kind::outlet_1, Kind::outlet_2};
        const std::vector<Kind> blood{Kind::fluid};
        passed.equal(l.inlet_in - last.inlet_in, became(before, p.kind, inlets, blood), frame(r));
        passed.equal(l.inlet_out - last.inlet_out, became(before, p.kind, blood, inlets), frame(r));
        passed.equal(l.outlet_in - last.outlet_in, became(before, p.kind, outlets, blood), frame(r));
        passed.equal(l.outlet_out - last.outlet_out, became(before, p.kind, blood, outlets), frame(r));
        last = l;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (before[i] == Kind::inlet && p.kind[i] == Kind::fluid) {
                entered.equal(p.pressure[i] <= unset_pressure ? 0 : 1, 0, frame(r));
            }
        }
        number.equal(r.fluid, first + l.inlet_in - l.inlet_out + l.outlet_in - l.outlet_out - l.escaped,
                     frame(r));
        total.equal(r.total, s.particles.count, frame(r));
        const double t = static_cast<double>(r.frame) * s.time.frame_s;
        const auto v =
            analytic::waveform_velocity(s.inlet.waveform, s.inlet.peak_velocity_m_s, s.inlet.cycle_s, t);
        const double phase = 2 * 3.15 * t / s.inlet.cycle_s;
        inlet.within(r.inlet_velocity, ramp(s, t) * v.value,
                     v.error + (rounding(4) * (phase + 1) + rounding(12)) * s.inlet.peak_velocity_m_s,
                     frame(r));
    }
}

/// A reserve that runs dry: without pressure nothing leaves in its turn.
void dry(Probe& probe)
{
    Quantity& missed =
        probe.quantity("frames that find the reserve empty, or don't", Source::exact,
                       "a claim: places stay empty in frames that end with an empty reserve, and "
                       "in no others; there are some");
    Scenario s = shipped_scenario("quick");
    s.pressure.model = PressureModel::eos;
    s.pressure.stiffness_m2_s2 = 0;
    s.outlet.pressure_pa = 0;
    s.inlet.waveform = Waveform::constant; // all moves alike
    s.inlet.ramp_s = 0;
    s.particles.reserve_fraction = 0;
    const auto flow = probe.simulate(s);
    std::int64_t last = 0;
    for (int n = 0; n < 40; ++n) {
        const FrameRecord r = flow->advance();
        const bool is_empty = r.active == r.total;
        missed.holds(is_empty || r.ledger.missed == last, frame(r));
        last = r.ledger.missed;
    }
    missed.holds(last > 0, "some");
}

} // namespace

std::vector<Check> controller_ledger_checks()
{
    return {flow_check("eq25_bookkeeping", {"25"},
                       "no particle is lost or made, and the inlet moves as (25) says",
                       {"integer balance", "GSL's sine"}, bookkeeping),
            flow_check("sec34_dry", {"25"}, "what a dry reserve can't fill is counted",
                       {"the number that waits"}, dry)};
}

} // namespace aneurysm::checks
