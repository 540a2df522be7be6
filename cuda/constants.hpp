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

/// The grid around all places where a body can be without harm; farther out the outermost cells go on.
template <class Real>
Grid<Real> make_grid(const Setup& setup)
{
    const double width = 2 * setup.h;
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
    const auto real = [](double x) { return static_cast<Real>(x); };
    const double wide = width * (1 + 1e-5); // for rounding: a cell must not be narrower than the support
    const auto cells = [&](double extent, double of) { return static_cast<Index>(extent / of) + 2; };
    return {.low = narrow<Real>(low),
            .per_width = real(1 / wide),
            .per_x_width = real(2 / wide),
            .x_cells = cells(high.x - low.x, wide / 2),
            .y_cells = cells(high.y - low.y, wide),
            .z_cells = cells(high.z - low.z, wide)};
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
    c.dx = real(setup.lattice.spacing);
    c.dt = real(s.time.frame_s / static_cast<double>(s.time.substeps));
    c.mass = real(setup.particle_mass);
    c.rho_0 = real(s.fluid.density_kg_m3);
    c.mu = real(s.fluid.viscosity_pa_s);
    c.g = narrow<Real>(s.fluid.gravity_m_s2);
    c.kappa = real(s.pressure.stiffness_m2_s2);
    c.omega = real(s.pressure.relaxation);
    c.blow_up_ratio = real(s.pressure.blow_up_density_ratio);
    c.impact_band = real(s.rupture.impact_band_spacings * setup.lattice.spacing);
    c.open_end = real(r_0);
    c.recycle_distance = real(s.rupture.recycle_distance_radii * r_0);
    c.breach_radius = real(s.rupture.breach_radius_radii * r_0);
    c.p_outlet = s.outlet.pressure_pa;
    return c;
}

} // namespace aneurysm::device
