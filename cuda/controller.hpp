// SPDX-License-Identifier: Apache-2.0
// Section 3.4: the particle controller, which keeps the artery full and the number of particles constant. The
// same exchange as in reference/controller.hpp, with prefix sums in the place of its loops.
#pragma once

#include "common/particles.hpp"
#include "common/vessel/sampling.hpp"
#include "cuda/boundary.hpp"
#include "cuda/fields.hpp"
#include "cuda/neighbors.hpp"

namespace aneurysm::device
{

ANEURYSM_HD constexpr Kind buffer_kind(Index k)
{
    return k == 0 ? Kind::inlet : k == 1 ? Kind::outlet_1 : Kind::outlet_2;
}
/// The open end whose buffer blood of this kind is in, else -1.
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
/// What may happen to a particle in a step; its event word has a bit for each.
enum Event : Index {
    recycled,
    entered_at_inlet,
    entered_at_outlet,
    left_at_inlet,
    left_at_outlet,
    escaped,
    collided,
    outside,
    event_count
};
ANEURYSM_HD constexpr Index bit(Event event)
{
    return 1 << event;
}

/// Outward velocities of the outlets' buffers, summed up.
struct BufferSums {
    double velocity[2] = {0, 0};
    double count[2] = {0, 0};

    ANEURYSM_HD BufferSums& operator+=(const BufferSums& b)
    {
        for (int k = 0; k < 2; ++k) {
            velocity[k] += b.velocity[k];
            count[k] += b.count[k];
        }
        return *this;
    }
    /// Of outlet k, 1 or 2; 0 when its buffer is empty [m/s]
    ANEURYSM_HD double mean(int k) const { return count[k - 1] > 0 ? velocity[k - 1] / count[k - 1] : 0; }
};
template <class Real>
struct SumUpBuffers {
    Fields<Real> f;

    ANEURYSM_HD BufferSums operator()(Index id) const
    {
        BufferSums sums;
        const Index k = open_end(f.kind[id]);
        if (k > 0) {
            sums.velocity[k - 1] = static_cast<double>(dot(f.velocity[id].vector(), opening(f, k).outward));
            sums.count[k - 1] = 1;
        }
        return sums;
    }
};

/// This step's velocities at the open ends.
template <class Real>
struct DriveOpenings {
    Fields<Real> f;
    const BufferSums* buffers;

    ANEURYSM_HD void operator()() const
    {
        Scene& s = *f.scene;
        s.record.inlet_velocity = f.inputs[f.step].inlet_velocity;
        for (int k = 1; k <= 2; ++k) {
            s.outlet_velocity[k - 1] = buffers->mean(k);
        }
        s.record.outlet_velocity = 0.5 * (s.outlet_velocity[0] + s.outlet_velocity[1]);
    }
};

/// (25) at a place in the inlet's buffer [m/s]
template <class Real>
ANEURYSM_HD Vec3T<Real> inlet_velocity_of(const Fields<Real>& f, const Vec3T<Real>& x)
{
    const OpeningT<Real>& inlet = opening(f, 0);
    const Vec3T<Real> d = x - inlet.center;
    const Vec3T<Real> across = d - dot(d, inlet.outward) * inlet.outward;
    const auto v = static_cast<Real>(f.inputs[f.step].inlet_velocity);
    return -v * inlet_profile(f.c.profile, dot(across, across), inlet.radius) * inlet.outward;
}

/// Gives the inlet's buffer its velocity.
template <class Real>
struct DriveInlet {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        if (f.kind[id] == Kind::inlet) {
            f.velocity[id] = row(inlet_velocity_of(f, f.position[id].vector()), Real(0));
        }
    }
};

/// What leaves a buffer at its far end joins the reserve, what has crossed an end plane the blood on its other side.
template <class Real>
struct CrossOpenings {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        leave_buffer(id);
        leave_artery(id);
        f.in_reserve[id] = f.kind[id] == Kind::reserve ? 1 : 0;
    }

private:
    ANEURYSM_HD void leave_buffer(Index id) const
    {
        const Index k = open_end(f.kind[id]);
        if (k < 0) {
            return;
        }
        const Real beyond = opening(f, k).beyond(f.position[id].vector());
        if (beyond > static_cast<Real>(opening_layers) * f.c.dx) {
            f.kind[id] = Kind::reserve;
            f.event[id] += bit(recycled);
        } else if (beyond <= 0) {
            f.kind[id] = Kind::fluid;
            f.pressure[id] = k == 0 ? static_cast<Real>(unset_pressure) : f.pressure[id];
            f.event[id] += bit(k == 0 ? entered_at_inlet : entered_at_outlet);
        }
    }
    ANEURYSM_HD void leave_artery(Index id) const
    {
        const Vec3T<Real> x = f.position[id].vector();
        if (f.kind[id] == Kind::fluid && is_beyond(f, x, Real(0))) {
            const Index k = nearest_tube(f, x);
            f.kind[id] = buffer_kind(k);
            f.event[id] += bit(k == 0 ? left_at_inlet : left_at_outlet);
        }
    }
};

/// The velocities with which the buffers are filled.
template <class Real>
struct BeginFill {
    Fields<Real> f;
    const BufferSums* buffers;

    ANEURYSM_HD void operator()() const
    {
        Scene& s = *f.scene;
        s.fill_velocity[0] = -f.inputs[f.step].inlet_velocity;
        s.fill_velocity[1] = buffers->mean(1);
        s.fill_velocity[2] = buffers->mean(2);
    }
};

/// The buffer that a place of the pattern belongs to.
template <class Real>
ANEURYSM_HD Index buffer_of(const Fields<Real>& f, Index place)
{
    return place < f.pattern_begin[1] ? 0 : place < f.pattern_begin[2] ? 1 : 2;
}

/// Places in the far layers of buffers that don't move outwards, with no blood of the buffer near.
template <class Real>
struct FindPlaces {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index place) const
    {
        const Index k = buffer_of(f, place);
        const Vec3T<Real> x = f.pattern[place].vector();
        const bool is_far = opening(f, k).beyond(x) > static_cast<Real>(opening_layers - 1) * f.c.dx;
        const bool fills = !(f.scene->fill_velocity[k] > 0);
        f.to_fill[place] = fills && is_far && is_free_place(k, x) ? 1 : 0;
    }

private:
    /// The cells are those from before the move, which is shorter than what they let a place see.
    ANEURYSM_HD bool is_free_place(Index k, const Vec3T<Real>& x) const
    {
        bool is_free = true;
        const auto look = [&](Range range) {
            for (Index s = range.begin; s < range.end; ++s) {
                const Index id = f.order[s];
                const Vec3T<Real> d = shortest(f.position[id].vector() - x, f.c.vessel.period());
                is_free = is_free && !(f.kind[id] == buffer_kind(k) && length(d) < f.c.refill_distance);
            }
        };
        if (f.c.is_periodic) {
            for_each_row<true>(f.c.grid, x, f.start, look);
        } else {
            for_each_row<false>(f.c.grid, x, f.start, look);
        }
        return is_free;
    }
};

/// The reserve as a list, lowest id first.
template <class Real>
struct ListReserve {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index id) const
    {
        if (f.in_reserve[id] == 1) {
            f.reserve[f.reserve_rank[id]] = id;
        }
    }
};

/// The first of the reserve take the places.
template <class Real>
struct FillPlaces {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index place) const
    {
        if (f.to_fill[place] == 0 || f.fill_rank[place] >= f.reserve_rank[f.c.particles]) {
            return;
        }
        const Index k = buffer_of(f, place);
        const Index id = f.reserve[f.fill_rank[place]];
        const Vec3T<Real> x = f.pattern[place].vector();
        const auto v = static_cast<Real>(f.scene->fill_velocity[k]);
        f.kind[id] = buffer_kind(k);
        f.position[id] = row(x, Real(0));
        f.velocity[id] = row(k == 0 ? inlet_velocity_of(f, x) : v * opening(f, k).outward, Real(0));
        f.pressure[id] = 0;
        f.kappa[id] = 0;
        f.drift[id] = 0;
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
template <class Real>
struct KeepLedger {
    Fields<Real> f;
    const EventCounts* events;

    ANEURYSM_HD void operator()() const
    {
        const Index* c = events->counts;
        Ledger& l = f.scene->ledger;
        l.recycled += c[recycled];
        l.inlet_in += c[entered_at_inlet];
        l.outlet_in += c[entered_at_outlet];
        l.inlet_out += c[left_at_inlet];
        l.outlet_out += c[left_at_outlet];
        l.escaped += c[escaped];
        const Index lacking = f.fill_rank[f.places()] - f.reserve_rank[f.c.particles];
        l.missed += lacking > 0 ? lacking : 0;
        f.scene->record.collisions += c[collided];
        f.scene->record.outside = c[outside];
    }
};

} // namespace aneurysm::device
