// SPDX-License-Identifier: Apache-2.0
// Section 3.4: the particle controller, which keeps the artery full and the number of particles constant. The
// same exchange as in reference/controller.hpp, with prefix sums in the place of its loops.
#pragma once

#include "common/vessel/initial_state.hpp"
#include "common/vessel/sampling.hpp"
#include "cuda/boundary.hpp"
#include "cuda/fields.hpp"
#include "cuda/neighbors.hpp"

namespace aneurysm::device
{

ANEURYSM_HD constexpr Kind ghost_kind(Index k)
{
    return k == 0 ? Kind::inlet : k == 1 ? Kind::outlet_1 : Kind::outlet_2;
}
/// The open end that a ghost of this kind belongs to, else -1.
ANEURYSM_HD constexpr Index open_end(Kind kind)
{
    return kind == Kind::inlet ? 0 : kind == Kind::outlet_1 ? 1 : kind == Kind::outlet_2 ? 2 : -1;
}
template <class Real>
ANEURYSM_HD const OpeningT<Real>& opening(const Fields<Real>& f, Index k)
{
    return f.c.vessel.openings()[static_cast<std::size_t>(k)];
}
template <class Real>
ANEURYSM_HD Index nearest_tube(const Fields<Real>& f, const Vec3T<Real>& x)
{
    return static_cast<Index>(f.c.vessel.nearest_tube(x));
}
/// Whether x is farther than `limit` beyond the end plane of its nearest tube. That tube is only looked for
/// where it matters.
template <class Real>
ANEURYSM_HD bool is_beyond(const Fields<Real>& f, const Vec3T<Real>& x, Real limit)
{
    bool any = false;
    for (Index k = 0; k < 3; ++k) {
        any = any || opening(f, k).beyond(x) > limit;
    }
    return any && opening(f, nearest_tube(f, x)).beyond(x) > limit;
}
/// From a ghost to the place a whole slab behind it [m].
template <class Real>
ANEURYSM_HD Vec3T<Real> behind(const Fields<Real>& f, Index k)
{
    return static_cast<Real>(opening_layers) * f.c.dx * opening(f, k).outward;
}

/// What may happen to a particle in a step; its event word has a bit for each.
enum Event : Index {
    recycled,
    entered_at_inlet,
    entered_at_outlet,
    left_at_inlet,
    left_at_outlet,
    escaped,
    missed,
    collided,
    outside,
    event_count
};
ANEURYSM_HD constexpr Index bit(Event event)
{
    return 1 << event;
}

/// Blood before the outlets, to the probe's depth.
struct OutletProbe {
    double velocity[2] = {0, 0};
    double pressure[2] = {0, 0};
    double count[2] = {0, 0};

    ANEURYSM_HD OutletProbe& operator+=(const OutletProbe& b)
    {
        for (int k = 0; k < 2; ++k) {
            velocity[k] += b.velocity[k];
            pressure[k] += b.pressure[k];
            count[k] += b.count[k];
        }
        return *this;
    }
};
template <class Real>
struct ProbeOutlets {
    Fields<Real> f;

    ANEURYSM_HD OutletProbe operator()(Index id) const
    {
        OutletProbe probe;
        const Vec3T<Real> x = f.position[id].vector();
        for (Index k = 1; k <= 2 && f.kind[id] == Kind::fluid; ++k) {
            if (opening(f, k).beyond(x) > -f.c.probe_depth && nearest_tube(f, x) == k) {
                const Real v = dot(f.velocity[id].vector(), opening(f, k).outward);
                probe.velocity[k - 1] = static_cast<double>(v);
                probe.pressure[k - 1] = f.pressure[id] > 0 ? static_cast<double>(f.pressure[id]) : 0;
                probe.count[k - 1] = 1;
            }
        }
        return probe;
    }
};

/// This step's velocities of the three slabs, and which of them turn inwards and start from their pattern.
template <class Real>
struct DriveOpenings {
    Fields<Real> f;
    const OutletProbe* probe;

    ANEURYSM_HD void operator()() const
    {
        Scene& s = *f.scene;
        const StepInput& input = f.inputs[f.step];
        s.inlet_velocity = input.inlet_velocity;
        s.resets[0] = s.inlet_velocity >= 0 && input.inlet_before < 0 ? 1 : 0;
        for (int k = 0; k < 2; ++k) {
            const double previous = s.outlet_velocity[k];
            s.outlet_was[k] = previous;
            s.outlet_velocity[k] = slab_velocity(k, previous);
            s.resets[k + 1] = s.outlet_velocity[k] < 0 && previous >= 0 ? 1 : 0;
        }
        s.resetting = s.resets[0] + s.resets[1] + s.resets[2] > 0 ? 1 : 0;
        s.record.inlet_velocity = s.inlet_velocity;
        s.record.outlet_velocity = 0.5 * (s.outlet_velocity[0] + s.outlet_velocity[1]);
    }

private:
    /// v' = v + dt (p - p_outlet) / (rho_0 D), see reference/controller.hpp.
    ANEURYSM_HD double slab_velocity(int k, double previous) const
    {
        const double count = probe->count[k];
        if (!(count > 0)) {
            return previous;
        }
        const auto rho_0 = static_cast<double>(f.c.rho_0);
        const double depth = opening_layers * static_cast<double>(f.c.dx);
        const double p_outlet = outlet_pressure(f.c.p_outlet, rho_0, previous);
        return probe->velocity[k] / count +
               static_cast<double>(f.c.dt) * (probe->pressure[k] / count - p_outlet) / (rho_0 * depth);
    }
};

/// The slab that is put back next.
ANEURYSM_HD inline Index next_reset(const Scene& s)
{
    return s.resets[0] > 0 ? 0 : s.resets[1] > 0 ? 1 : 2;
}

/// All ghosts of a slab that is put back go to the reserve; flags what is in it.
template <class Real>
struct EmptySlab {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        if (f.kind[id] == ghost_kind(next_reset(*f.scene))) {
            f.kind[id] = Kind::reserve;
        }
        f.flag[id] = f.kind[id] == Kind::reserve ? 1 : 0;
    }
};
/// The first of the reserve take the places of the pattern.
template <class Real>
struct FillSlab {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        const Index k = next_reset(*f.scene);
        const Index place = f.pattern_begin[k] + f.rank[id];
        if (f.flag[id] == 1 && place < f.pattern_begin[k + 1]) {
            f.kind[id] = ghost_kind(k);
            f.position[id] = f.pattern[place];
            f.velocity[id] = {0, 0, 0, 0};
        }
    }
};
template <class Real>
struct FinishReset {
    Fields<Real> f;

    ANEURYSM_HD void operator()() const
    {
        Scene& s = *f.scene;
        const Index k = next_reset(s);
        const Index wanted = f.pattern_begin[k + 1] - f.pattern_begin[k];
        const Index available = f.rank[f.c.particles];
        s.ledger.missed += wanted > available ? wanted - available : 0;
        s.resets[k] = 0;
        s.resetting = s.resets[0] + s.resets[1] + s.resets[2] > 0 ? 1 : 0;
    }
};

/// Gives the slabs their velocities: the inlet's (25), an outlet's as in reference/controller.hpp.
template <class Real>
struct DriveSlabs {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        const Scene& s = *f.scene;
        const Index k = open_end(f.kind[id]);
        if (k < 0) {
            return;
        }
        const Vec3T<Real> outward = opening(f, k).outward;
        if (k == 0) {
            f.velocity[id] = row(static_cast<Real>(-s.inlet_velocity) * outward, Real(0));
            return;
        }
        const double v = s.outlet_velocity[k - 1];
        const Real own = dot(f.velocity[id].vector(), outward) + static_cast<Real>(v - s.outlet_was[k - 1]);
        const Real speed = v > 0 ? (own > 0 ? own : 0) : static_cast<Real>(v);
        f.velocity[id] = row(speed * outward, Real(0));
    }
};

/// Blood within the piston's reach of the inlet plane is not slower than
/// a forward-moving inlet, and doesn't cross it backwards.
template <class Real>
ANEURYSM_HD void push_as_piston(const Fields<Real>& f, Real v_inlet, Vec3T<Real>& x, Vec3T<Real>& v)
{
    const OpeningT<Real>& inlet = opening(f, 0);
    const Real beyond = inlet.beyond(x);
    if (v_inlet < 0 || beyond < -f.c.piston_reach) {
        return;
    }
    const Real lacking = v_inlet + dot(v, inlet.outward);
    v -= (lacking > 0 ? lacking : Real(0)) * inlet.outward;
    x -= (beyond > 0 ? beyond : Real(0)) * inlet.outward;
}

/// While outlet k's slab moves inwards, blood doesn't cross its plane outwards.
template <class Real>
ANEURYSM_HD void hold_back(const Fields<Real>& f, Index k, Vec3T<Real>& x, Vec3T<Real>& v)
{
    const OpeningT<Real>& end = opening(f, k);
    const Real beyond = end.beyond(x);
    if (beyond > 0 && nearest_tube(f, x) == k) {
        x -= beyond * end.outward;
        const Real outward = dot(v, end.outward);
        v -= (outward > 0 ? outward : Real(0)) * end.outward;
    }
}

/// Whether blood is too near to ghost `id`, now that all have moved. The cells are those from
/// before the move, which is shorter than what they let a particle see.
template <class Real>
ANEURYSM_HD bool is_taken(const Fields<Real>& f, Index id)
{
    const Vec3T<Real> x = f.position[id].vector();
    const Real reach = f.c.closest_entry;
    bool taken = false;
    const auto look = [&](Range range) {
        for (Index s = range.begin; s < range.end; ++s) {
            const Index other = f.order[s];
            const Vec3T<Real> d = shortest(f.position[other].vector() - x, f.c.vessel.period());
            taken = taken || (f.kind[other] == Kind::fluid && length(d) < reach);
        }
    };
    if (f.c.is_periodic) {
        for_each_row<true>(f.c.grid, x, f.start, look);
    } else {
        for_each_row<false>(f.c.grid, x, f.start, look);
    }
    return taken;
}

/// What leaves a slab at its far side joins the reserve; what has crossed the plane inwards is marked.
template <class Real>
struct MarkExchange {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        const Index k = open_end(f.kind[id]);
        f.entering[id] = 0;
        if (k >= 0) {
            const Real beyond = opening(f, k).beyond(f.position[id].vector());
            if (beyond > static_cast<Real>(opening_layers) * f.c.dx) {
                f.kind[id] = Kind::reserve;
                f.event[id] += bit(recycled);
            } else if (beyond <= 0) {
                if (is_taken(f, id)) {
                    f.position[id] = row(f.position[id].vector() + behind(f, k), Real(0));
                } else {
                    f.entering[id] = 1;
                }
            }
        }
        f.flag[id] = f.kind[id] == Kind::reserve ? 1 : 0;
    }
};
/// The reserve as a list, lowest id first.
template <class Real>
struct ListReserve {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        if (f.flag[id] == 1) {
            f.reserve[f.rank[id]] = id;
        }
    }
};
/// What enters becomes blood, and the next of the reserve takes its place a slab behind it.
template <class Real>
struct EnterArtery {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        if (f.entering[id] == 0) {
            return;
        }
        const Kind kind = f.kind[id];
        const Index k = open_end(kind);
        f.kind[id] = Kind::fluid;
        f.pressure[id] = static_cast<Real>(unset_pressure);
        f.event[id] += bit(k == 0 ? entered_at_inlet : entered_at_outlet);
        if (f.entry_rank[id] >= f.rank[f.c.particles]) {
            f.event[id] += bit(missed);
            return;
        }
        const Index next = f.reserve[f.entry_rank[id]];
        f.kind[next] = kind;
        f.position[next] = row(f.position[id].vector() + behind(f, k), Real(0));
        f.velocity[next] = f.velocity[id];
    }
};
/// Blood that has crossed an end plane outwards joins its slab.
template <class Real>
struct CrossOpenings {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        if (f.kind[id] != Kind::fluid) {
            return;
        }
        const Vec3T<Real> x = f.position[id].vector();
        if (is_beyond(f, x, Real(0))) {
            const Index k = nearest_tube(f, x);
            f.kind[id] = ghost_kind(k);
            f.event[id] += bit(k == 0 ? left_at_inlet : left_at_outlet);
        }
    }
};

/// Events of a step, counted.
struct EventCounts {
    Index counts[event_count] = {}; ///< by Event

    ANEURYSM_HD EventCounts& operator+=(const EventCounts& b)
    {
        for (int e = 0; e < event_count; ++e) {
            counts[e] += b.counts[e];
        }
        return *this;
    }
};
template <class Real>
struct CountEvents {
    Fields<Real> f;

    ANEURYSM_HD EventCounts operator()(Index id) const
    {
        EventCounts c;
        for (int e = 0; e < event_count; ++e) {
            c.counts[e] = f.event[id] >> e & 1;
        }
        return c;
    }
};
struct KeepLedger {
    Scene* scene;
    const EventCounts* events;

    ANEURYSM_HD void operator()() const
    {
        const Index* c = events->counts;
        Ledger& l = scene->ledger;
        l.recycled += c[recycled];
        l.inlet_in += c[entered_at_inlet];
        l.outlet_in += c[entered_at_outlet];
        l.inlet_out += c[left_at_inlet];
        l.outlet_out += c[left_at_outlet];
        l.escaped += c[escaped];
        l.missed += c[missed];
        scene->record.collisions += c[collided];
        scene->record.outside = c[outside];
    }
};

} // namespace aneurysm::device
