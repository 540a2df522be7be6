// SPDX-License-Identifier: Apache-2.0
// Whole runs of the reference, for the tests of the simulation.
#pragma once

#include "reference/simulation.hpp"
#include "tests/vessels.hpp"

#include <vector>

namespace aneurysm::test
{

/// Frames and the states between them: states[n] is the one that frame n + 1 starts from.
struct Run {
    Scenario scenario;
    std::vector<FrameRecord> frames;
    std::vector<SimulationState> states;
};

inline Run run(const Scenario& scenario, reference::Simulation& simulation, int frames)
{
    Run result{scenario, {}, {simulation.state()}};
    for (int n = 0; n < frames; ++n) {
        result.frames.push_back(simulation.advance());
        result.states.push_back(simulation.state());
    }
    return result;
}

inline Run run(const Scenario& scenario, int frames)
{
    reference::Simulation simulation(scenario);
    return run(scenario, simulation, frames);
}

/// 240 frames of scenario `quick`, through its rupture.
inline const Run& quick_run()
{
    static const Run result = run(shipped_scenario("quick"), 240);
    return result;
}

inline std::array<std::int64_t, 7> entries(const Ledger& l)
{
    return {l.inlet_in, l.inlet_out, l.outlet_out, l.outlet_in, l.escaped, l.recycled, l.missed};
}

/// Whether two states are the same to the last bit.
inline bool same_bits(const SimulationState& a, const SimulationState& b)
{
    const Particles& p = a.particles;
    const Particles& q = b.particles;
    const AneurysmState& s = a.aneurysm;
    const AneurysmState& t = b.aneurysm;
    return a.frame == b.frame && a.spacing == b.spacing && p.mass == q.mass && p.position == q.position &&
           p.velocity == q.velocity && p.pressure == q.pressure && p.kind == q.kind && s.phase == t.phase &&
           s.radius == t.radius && s.thickness == t.thickness && s.displacement == t.displacement &&
           s.wall_velocity == t.wall_velocity && s.rupture_frame == t.rupture_frame &&
           entries(a.ledger) == entries(b.ledger) && a.outlet_velocity[0] == b.outlet_velocity[0] &&
           a.outlet_velocity[1] == b.outlet_velocity[1];
}

} // namespace aneurysm::test
