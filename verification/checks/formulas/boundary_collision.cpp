// SPDX-License-Identifier: Apache-2.0
// Fig. 1: a particle beyond the wall is put back, and its velocity reflected.
#include "analytic/boundary.hpp"
#include "analytic/relations.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"

namespace aneurysm::checks
{
namespace
{

void fig1_collision(Probe& probe)
{
    Quantity& normal =
        probe.quantity("n.(v' + v), or n.(v' - v) of a leaving particle, over |v| [1]", Source::rounding,
                       "gamma_13: 4 in n.v, twice; 1 in the difference; 4 of a unit vector's length");
    Quantity& tangential = probe.quantity("tangential part of v' - v over |v| [1]", Source::rounding,
                                          "gamma_9: 4 in n.v, twice; 1 in the difference");
    Quantity& place = probe.quantity("r - r' - depth n over |r| + depth [1]", Source::rounding,
                                     "gamma_3: a product, a difference, 1 of a unit vector's length");
    Quantity& mirror = probe.quantity("v' against Householder's matrix over |v| [1]", Source::rounding,
                                      "gamma_9, and as much with gamma_4 more for the matrix");
    Quantity& oracles =
        probe.quantity("Householder's matrix against the definition over |v| [1]", Source::rounding,
                       "gamma_17: gamma_13 of a product with the matrix, 4 of a unit vector's length");
    Quantity& bits = probe.quantity("velocity of a particle that leaves or slides over |v| [1]",
                                    Source::exact, "0: nothing is computed");
    Arguments a(101);
    for (int n = 0; n < 300; ++n) {
        const Vec3 toward = a.vector(1);
        const Vec3 unit = toward / length(toward);
        const Vec3 r = a.vector(2);
        const Vec3 v = a.vector(3);
        const double depth = a.between(0, 0.2);
        const double speed = length(v);
        const Collision after = probe.equations().collide(r, v, depth, unit);
        const std::string where = at({{"set", double(n)}, {"n.v", dot(unit, v)}});
        const auto residual = [&](const Vec3& velocity) {
            return analytic::collision_residual(to_eigen(r), to_eigen(v), depth, to_eigen(unit),
                                                to_eigen(after.position), to_eigen(velocity));
        };
        const analytic::CollisionResidual left = residual(after.velocity);
        normal.within(left.normal / speed, 0, rounding(13), where);
        tangential.within(left.tangential / speed, 0, rounding(9), where);
        place.within(left.place / (length(r) + depth), 0, rounding(3), where);
        if (dot(unit, v) > 0) {
            const Vec3 expected = to_vec3(analytic::mirrored(to_eigen(v), to_eigen(unit)));
            mirror.within(after.velocity / speed, expected / speed, rounding(9 + 13 + 2), where);
            const analytic::CollisionResidual of_matrix = residual(expected);
            oracles.within(of_matrix.normal / speed, 0, rounding(17), where);
            oracles.within(of_matrix.tangential / speed, 0, rounding(17), where);
        } else {
            bits.within(after.velocity, v, 0, where);
        }
    }
    const Vec3 axis{0, 1, 0};
    const Vec3 sliding{0.3, 0, -0.7};
    const Collision slid = probe.equations().collide({0.1, 0.2, 0.3}, sliding, 0.03125, axis);
    bits.within(slid.velocity, sliding, 0, "sliding along the wall");
    bits.within(slid.position.y, 0.2 - 0.03125, 0, "put back along an axis");
}

} // namespace

std::vector<Check> boundary_collision_checks()
{
    return {
        formula_check(
            "fig1_collision", {},
            "a particle beyond the wall is put back onto it, its velocity into the wall turned round",
            {"Householder's matrix", "normal and tangential parts, 50 digits"}, fig1_collision),
    };
}

} // namespace aneurysm::checks
