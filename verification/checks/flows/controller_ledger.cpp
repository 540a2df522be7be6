// SPDX-License-Identifier: Apache-2.0
// Section 3.4 over a whole run: what the ledger says of the particles, and the inlet's velocity (25).
#include "analytic/boundary.hpp"
#include "common/scenario/shipped.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace aneurysm::checks
{
namespace
{

std::string frame(const FrameRecord& r)
{
    return "frame " + std::to_string(r.frame);
}

void bookkeeping(Probe& probe)
{
    Quantity& number = probe.quantity("particles in the artery", Source::exact,
                                      "integers: those of frame 0, + in, - out, - escaped");
    Quantity& total =
        probe.quantity("all particles", Source::exact, "integers: the scenario's count in every frame");
    Quantity& inlet = probe.quantity(
        "inlet velocity [m/s]", Source::rounding,
        "gamma_4 of the phase 2 pi t/T times v_0, gamma_4 of the velocity, and the oracle's own bound");
    Quantity& entered = probe.quantity("blood that has just come in and has a pressure", Source::exact,
                                       "integers: none; its ghost's pressure isn't its own");
    const Scenario s = shipped_scenario("quick");
    Quantity& reserve = probe.quantity("change of the reserve in a frame", Source::exact,
                                       "integers: what was recycled, less what came in, each of which takes "
                                       "one, plus what found none; frames in which a slab turns inwards and "
                                       "is put back are left out");
    const auto flow = probe.simulate(s);
    const auto first = std::ranges::count(flow->state().particles.kind, Kind::fluid);
    FrameRecord last;
    last.inlet_velocity = 0;
    for (int n = 0; n < 180; ++n) {
        const std::vector<Kind> before = flow->state().particles.kind;
        const std::array<double, 2> outlets = flow->state().outlet_velocity;
        const FrameRecord r = flow->advance();
        const Particles& p = flow->state().particles;
        const auto turns = [&](std::size_t k) {
            return outlets.at(k) >= 0 && flow->state().outlet_velocity.at(k) < 0;
        };
        if (!(last.inlet_velocity < 0 && r.inlet_velocity >= 0) && !turns(0) && !turns(1)) {
            const Ledger& a = last.ledger;
            const Ledger& b = r.ledger;
            reserve.equal(std::ranges::count(p.kind, Kind::reserve) -
                              std::ranges::count(before, Kind::reserve),
                          b.recycled - a.recycled - (b.inlet_in - a.inlet_in) - (b.outlet_in - a.outlet_in) +
                              (b.missed - a.missed),
                          frame(r));
        }
        last = r;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (before[i] != Kind::fluid && p.kind[i] == Kind::fluid) {
                entered.equal(p.pressure[i] < 0 ? 0 : 1, 0, frame(r));
            }
        }
        const Ledger& l = r.ledger;
        number.equal(r.fluid, first + l.inlet_in - l.inlet_out + l.outlet_in - l.outlet_out - l.escaped,
                     frame(r));
        total.equal(r.total, s.particles.count, frame(r));
        const double t = static_cast<double>(r.frame) * s.time.frame_s;
        const auto v =
            analytic::waveform_velocity(s.inlet.waveform, s.inlet.peak_velocity_m_s, s.inlet.cycle_s, t);
        const double phase = 2 * 3.15 * t / s.inlet.cycle_s;
        inlet.within(r.inlet_velocity, v.value,
                     v.error + rounding(4) * (phase + 1) * s.inlet.peak_velocity_m_s, frame(r));
    }
}

} // namespace

std::vector<Check> controller_ledger_checks()
{
    return {flow_check("eq25_bookkeeping", {"25"},
                       "no particle is lost or made, and the inlet moves as (25) says",
                       {"integer balance", "GSL's sine"}, bookkeeping)};
}

} // namespace aneurysm::checks
