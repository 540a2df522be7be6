// SPDX-License-Identifier: Apache-2.0
// The start of the pressure's solve: a constant in each slice across the parent artery, as in reference/slices.hpp.
#pragma once

#include "common/guards.hpp"
#include "cuda/incompressible.hpp"

namespace aneurysm::device
{

/// Where (3) isn't met by the last step's pressures.
struct StartInSlices {
    Scene* scene;

    ANEURYSM_HD void operator()() const { scene->slicing = scene->solving; }
};

/// Members of slices are those whose potential can still take something off their residual.
template <class Real>
struct FindMembers {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const
    {
        const bool acts = f.alpha[i] > 0 && (f.lowest[i] < f.p[i] || residual(f, i) > 0);
        f.slice[i] = f.c.slices.at(f.body_position[i].y);
        f.member[i] = acts ? 1 : 0;
    }
};

/// b of particle i for its own slice and for the other that it sees: its acceleration by a potential that is 1 at their
/// members; as products.
template <bool kept, class Real>
struct RespondToSlices {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i, Lane lane) const
    {
        using Number = Lanes<Real>;
        const Number zero(0);
        const Lanes<Index> slice(f.slice[i]);
        Vec3T<Number> of_own;
        Vec3T<Number> of_other;
        for (Index b = f.blood.begin[i]; b < f.blood.begin[i + 1]; ++b) {
            const Lanes<Index> j = neighbors(f.blood, b, lane);
            const Vec3T<Number> G = gather(f.member, j) * gradient<kept>(f, i, b, j, lane);
            const Mask is_own = gather(f.slice, j) == slice;
            of_own += {select(is_own, G.x, zero), select(is_own, G.y, zero), select(is_own, G.z, zero)};
            of_other += {select(is_own, zero, G.x), select(is_own, zero, G.y), select(is_own, zero, G.z)};
        }
        const Vec3T<Real> of_itself = f.blood_gradient[i].vector() + f.mirrors[i].vector();
        const Vec3T<Real> own = sum(of_own, lane) + f.member[i] * of_itself;
        const Vec3T<Real> other = sum(of_other, lane);
        if (lane.is_first()) {
            const Real factor = f.is_given[i] == 1 ? 0 : f.c.dt / (f.c.rho_0 * f.c.rho_0);
            f.slice_response[i] = {factor * dot(own, own), factor * dot(own, other),
                                   factor * dot(other, other), f.member[i] * residual(f, i)};
        }
    }
};

/// Of each slice, from the rows of cells that it touches. From its lower half its particles see the slice below.
template <class Real>
struct SumUpSlices {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index c, Lane lane) const
    {
        const SlicesT<Real>& slices = f.c.slices;
        const Real low = slices.low + static_cast<Real>(c) * slices.thickness;
        const Real reach = slices.thickness / 2; // and more than rounding can do to the slice's edges
        const Grid<Real>& grid = f.c.grid;
        const Index first = c == 0 ? 0 : grid.y_cell(low - reach);
        const Index last =
            c == slices.count - 1 ? grid.y_cells - 1 : grid.y_cell(low + slices.thickness + reach);
        const Index end = f.start[grid.index(0, last + 1, 0)];
        const Lanes<Real> middle(low + slices.thickness / 2);
        const Lanes<Index> none(f.c.null_body());
        Lanes<double> own;
        Lanes<double> below;
        Lanes<double> above;
        Lanes<double> with_below;
        Lanes<double> with_above;
        Lanes<double> residuals;
        for (Index k = f.start[grid.index(0, first, 0)]; k < end; k += lane_count) {
            const Lanes<Index> at = Lanes<Index>(k) + numbers(lane);
            const Lanes<Index> i = select(at < Lanes<Index>(end), at, none);
            const Mask is_here = gather(f.slice, i) == Lanes<Index>(c);
            const Mask is_low = gather(f.body_y, i) < middle;
            const RowLanes<Real> r = gather_rows(f.slice_response, select(is_here, i, none));
            const Lanes<Real> zero(0);
            own += widen(r.x);
            with_below += widen(select(is_low, r.y, zero));
            with_above += widen(select(is_low, zero, r.y));
            below += widen(select(is_low, r.z, zero));
            above += widen(select(is_low, zero, r.z));
            residuals += widen(r.w);
        }
        const SliceSums sums{sum(own, lane),        sum(below, lane),      sum(above, lane),
                             sum(with_below, lane), sum(with_above, lane), sum(residuals, lane)};
        if (lane.is_first()) {
            f.slice_sums[c] = sums;
        }
    }
};

/// The constants, from tridiagonal equations: elimination from the first slice on, then back. A pivot that is but
/// rounding belongs to a slice that says nothing.
template <class Real>
struct SolveSlices {
    Fields<Real> f;

    ANEURYSM_HD void operator()() const
    {
        const Index count = f.c.slices.count;
        for (Index c = 0; c < count; ++c) {
            f.slice_row[c] = equation(c);
            eliminate(c);
        }
        for (Index c = count - 1; c >= 0; --c) {
            SliceRow& r = f.slice_row[c];
            r.right = r.inverse * (r.right - (c + 1 < count ? r.beside * f.slice_row[c + 1].right : 0));
        }
    }

private:
    ANEURYSM_HD SliceRow equation(Index c) const
    {
        const SliceSums& sums = f.slice_sums[c];
        SliceRow row{sums.own, 0, sums.residual, 0};
        if (c > 0) {
            row.diagonal += f.slice_sums[c - 1].above;
        }
        if (c + 1 < f.c.slices.count) {
            row.diagonal += f.slice_sums[c + 1].below;
            row.beside = sums.with_above + f.slice_sums[c + 1].with_below;
        }
        return row;
    }
    ANEURYSM_HD void eliminate(Index c) const
    {
        SliceRow& row = f.slice_row[c];
        double pivot = row.diagonal;
        if (c > 0) {
            const SliceRow& before = f.slice_row[c - 1];
            const double factor = before.beside * before.inverse;
            pivot -= factor * before.beside;
            row.right -= factor * before.right;
        }
        row.inverse = pivot > guards::smallest_pivot * row.diagonal ? 1 / pivot : 0;
    }
};

template <class Real>
struct AddSlices {
    Fields<Real> f;

    ANEURYSM_HD void operator()(Index i) const
    {
        const auto constant = static_cast<Real>(f.slice_row[f.slice[i]].right);
        f.p[i] = f.member[i] > 0 ? bounded(f.p[i] + constant, f.lowest[i]) : f.p[i];
        f.p_old[i] = f.p[i];
    }
};

} // namespace aneurysm::device
