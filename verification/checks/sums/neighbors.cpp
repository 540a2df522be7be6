// SPDX-License-Identifier: Apache-2.0
// Who is whose neighbor in the sums (5) and (7). One particle of a disturbed box at rest is set in motion: after a
// step friction has moved those within its support, and no others.
#include "verification/checks/box.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace aneurysm::checks
{
namespace
{

/// Square of the distance by the nearest picture in each direction.
double least_square(const Vec3& a, const Vec3& b, double edge)
{
    const auto along = [edge](double d) {
        return std::min({std::abs(d), std::abs(d - edge), std::abs(d + edge)});
    };
    const Vec3 d{along(a.x - b.x), along(a.y - b.y), along(a.z - b.z)};
    return dot(d, d);
}

void neighbors(Probe& probe)
{
    Quantity& sets = probe.quantity(
        "particles that one in motion moves, or doesn't", Source::exact,
        "sets: friction is 0 beyond the support and more than rounding within it; pairs whose distance is "
        "the support's within 64 roundings of the box are left out");
    Quantity& number =
        probe.quantity("neighbors in all", Source::exact, "integers: counted by brute force over all pairs");
    for (const double ratio : {1.0, 1.3}) {
        Scenario s = box_scenario(KernelName::cubic_spline, ratio);
        s.pressure.model = PressureModel::eos;
        s.pressure.stiffness_m2_s2 = 0;
        s.fluid.viscosity_pa_s = 64;
        s.time.frame_s = 0x1p-12;
        Box box(probe, s);
        box.disturb(0.25, 0, 2445);
        const double H = 2 * ratio * s.domain.spacing_m;
        const double margin = 64 * probe.roundoff() * box.edge() * H;
        std::int64_t found = 0;
        std::int64_t wanted = 0;
        // every 7th in x, y and z of the lattice's order: at all seams, in all cells
        for (std::size_t j = 0; j < box.size(); j += 7) {
            SimulationState state = box.state();
            state.particles.velocity[j] = {0.5, -0.25, 0.125};
            const auto flow = probe.simulate(s, state);
            flow->advance();
            for (std::size_t i = 0; i < box.size(); ++i) {
                const Particles& p = state.particles;
                const double square = least_square(p.position[i], p.position[j], box.edge());
                if (i == j || std::abs(square - H * H) <= margin) {
                    continue;
                }
                const Vec3& v = flow->state().particles.velocity[i];
                const bool moves = dot(v, v) > 0;
                const bool near = square < H * H;
                sets.holds(moves == near, "particles " + std::to_string(i) + " and " + std::to_string(j) +
                                              ", h/dx " + std::to_string(ratio).substr(0, 3));
                found += moves ? 1 : 0;
                wanted += near ? 1 : 0;
            }
        }
        number.equal(found, wanted, "h/dx " + std::to_string(ratio).substr(0, 3));
    }
}

} // namespace

std::vector<Check> neighbors_checks()
{
    return {sum_check("eq05_neighbors", {"5", "7"},
                      "each particle feels those within the support, through the seams, too, and no others",
                      {"brute force over all pairs"}, neighbors)};
}

} // namespace aneurysm::checks
