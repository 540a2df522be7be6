// SPDX-License-Identifier: Apache-2.0
// What stays the same through a run, from double on the host to the precision of the device.
#pragma once

#include "cuda/fields.hpp"
#include "cuda/setup.hpp"

#include <algorithm>
#include <vector>

namespace aneurysm::device
{

template <class Real>
Vec3T<Real> narrow(const Vec3& v)
{
    return {static_cast<Real>(v.x), static_cast<Real>(v.y), static_cast<Real>(v.z)};
}
template <class Real>
Vec3 wide(const Vec3T<Real>& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// One direction of the grid.
struct GridAxis {
    double low = 0;
    double cells_per_meter = 0;
    Index cells = 0;
    Index period = 0; ///< in cells; 0: not periodic
};
/// With cells of `width`. A periodic box has whole cells, at least `fewest`, which are all that a body sees:
/// then it doesn't matter that rounding may make them narrower.
inline GridAxis grid_axis(double low, double high, double box, double width, Index fewest)
{
    if (!(box > 0)) {
        return {low, 1 / width, static_cast<Index>((high - low) / width) + 2, 0};
    }
    const Index cells = std::max(static_cast<Index>(box / width), fewest);
    return {0, cells / box, cells, cells};
}

/// The grid around all places where a body can be without harm; farther out the outermost cells go on.
template <class Real>
Grid<Real> make_grid(const Setup& setup)
{
    Vec3 low = setup.lattice.fluid.front();
    Vec3 high = low;
    const auto include = [&](const std::vector<Vec3>& places) {
        for (const Vec3& x : places) {
            low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
            high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
        }
    };
    include(setup.ghosts.fixed().position);
    include(setup.ghosts.near_sac());
    include(setup.lattice.fluid);
    const double width =
        2 * setup.h * (1 + 1e-5); // for rounding: a cell must not be narrower than the support
    const Vec3& box = setup.vessel.period();
    const GridAxis x = grid_axis(low.x, high.x, box.x, width / 2, 5);
    const GridAxis y = grid_axis(low.y, high.y, box.y, width, 3);
    const GridAxis z = grid_axis(low.z, high.z, box.z, width, 3);
    return {.low = narrow<Real>({x.low, y.low, z.low}),
            .per_width = narrow<Real>({x.cells_per_meter, y.cells_per_meter, z.cells_per_meter}),
            .x_cells = x.cells,
            .y_cells = y.cells,
            .z_cells = z.cells,
            .x_period = x.period,
            .y_period = y.period,
            .z_period = z.period};
}

template <class Real>
Constants<Real> make_constants(const Scenario& s, const Setup& setup)
{
    const auto real = [](double x) { return static_cast<Real>(x); };
    const double r_0 = s.vessel.radius_m;
    Constants<Real> c{.kernel = Kernel<Real>(s.kernel.function, setup.h),
                      .vessel = VesselT<Real>(setup.vessel),
                      .grid = make_grid<Real>(setup),
                      .model = s.pressure.model};
    c.particles = static_cast<Index>(s.particles.count);
    c.walls = static_cast<Index>(setup.ghosts.fixed().size() + setup.ghosts.near_sac().size());
    c.is_periodic = length(setup.vessel.period()) > 0;
    c.slips = s.domain.wall == WallCondition::slip;
    c.dx = real(setup.lattice.spacing);
    c.dt = real(s.time.frame_s / static_cast<double>(s.time.substeps));
    c.mass = real(setup.particle_mass);
    c.rho_0 = real(s.fluid.density_kg_m3);
    c.mu = real(s.fluid.viscosity_pa_s);
    c.kappa = real(s.pressure.stiffness_m2_s2);
    c.omega = real(s.pressure.relaxation);
    c.shifting = real(s.pressure.shifting);
    c.blow_up_ratio = real(s.pressure.blow_up_density_ratio);
    c.impact_band = real(s.rupture.impact_band_spacings * setup.lattice.spacing);
    c.refill_distance = real(s.controller.refill_distance_spacings * setup.lattice.spacing);
    c.open_end = real(r_0);
    c.recycle_distance = real(s.rupture.recycle_distance_radii * r_0);
    c.breach_radius = real(s.rupture.breach_radius_radii * r_0);
    c.p_const = s.outlet.pressure_pa;
    c.profile = s.inlet.profile;
    c.rebounds = s.collision.rebound == Rebound::elastic;
    c.corrects_density = c.model == PressureModel::dfsph && s.pressure.density_correction > 0;
    c.balances_gravity = setup.vessel.is_open(1);
    if (s.pressure.start == PressureStart::slices && setup.vessel.is_open(1)) {
        const Slices slices = make_slices(setup.vessel, 2 * setup.h);
        c.slices = {real(slices.low), real(slices.thickness), slices.count};
    }
    return c;
}

} // namespace aneurysm::device
