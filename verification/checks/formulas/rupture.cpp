// SPDX-License-Identifier: Apache-2.0
// Section 3.2: when the wall ruptures, by the criterion F/area > P_c (13) of its load F; impulse (14) and impact (16).
#include "analytic/rupture.hpp"
#include "analytic/relations.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace aneurysm::checks
{
namespace
{

void eq13_criterion(Probe& probe)
{
    Quantity& random = probe.quantity("decision against the exact sign of F - P_c area", Source::rounding,
                                      "none but where |F - P_c area| is below gamma_1 P_c area: a quotient");
    Quantity& tie = probe.quantity("decision at F/area = P_c and next to it", Source::exact,
                                   "none: the area is a power of 2, so that the quotient is exact");
    Quantity& largest =
        probe.quantity("decision next to the largest pressure that the wall's law reaches", Source::solver,
                       "none at 1 +- (gamma_64 + the width of the search): 64 u, product and quotient with "
                       "the area included");
    Arguments a(131);
    for (int n = 0; n < 400; ++n) {
        const double P_c = a.between(500, 5000);
        const double area = a.between(0.1, 3);
        const double distance = std::pow(10, a.between(-15.9, -0.1));
        const double F = P_c * area * (n % 2 == 0 ? 1 + distance : 1 - distance);
        const double excess = analytic::excess(F, area, P_c);
        if (std::abs(excess) > rounding(1)) {
            random.holds(probe.equations().ruptures(F, area, P_c) == (excess > 0),
                         at({{"P_c", P_c}, {"area", area}, {"excess", excess}}));
        }
        for (const double power : {0.25, 1.0, 8.0}) {
            const double equal = P_c * power;
            const std::string where = at({{"P_c", P_c}, {"area", power}});
            tie.holds(!probe.equations().ruptures(equal, power, P_c), where + ": equal");
            tie.holds(!probe.equations().ruptures(std::nextafter(equal, 0), power, P_c), where + ": below");
            tie.holds(probe.equations().ruptures(std::nextafter(equal, 1e9), power, P_c), where + ": above");
        }
    }
    for (const double sigma : {0.2, 0.4, 0.6}) {
        const analytic::Wall wall{41.25, sigma, 4e-3, 0.11, 0.0075, 0};
        const analytic::Estimate P = analytic::largest_pressure_by_search(wall);
        const double R = analytic::critical_radius(wall);
        const double P_c = probe.equations().critical_pressure(analytic::thickness(wall, R), R, wall.Y,
                                                               wall.sigma, wall.phi);
        const double apart = P.error / P.value + rounding(64);
        const double area = 0.37;
        largest.holds(!probe.equations().ruptures(P.value * (1 - apart) * area, area, P_c),
                      at({{"sigma", sigma}}));
        largest.holds(probe.equations().ruptures(P.value * (1 + apart) * area, area, P_c),
                      at({{"sigma", sigma}}));
    }
}

/// The load by which F_b moves and breaks the wall.
void eq16_load(Probe& probe)
{
    Quantity& relation =
        probe.quantity("F m = F_b M, 50 digits [1]", Source::rounding, "gamma_2: a quotient and a product");
    Arguments a(16);
    for (int n = 0; n < 200; ++n) {
        const double F_b = a.between(0, 5000);
        const double M = a.between(0.01, 3);
        const double m = a.between(0.001, 2);
        relation.within(analytic::load_imbalance(F_b, M, m, probe.equations().wall_load(F_b, M, m)), 0,
                        rounding(2), at({{"F_b", F_b}, {"M", M}, {"m", m}}));
    }
}

void eq14_impulse(Probe& probe)
{
    Quantity& relation =
        probe.quantity("F dt = m v, 50 digits [1]", Source::rounding, "gamma_2: a quotient and a product");
    Quantity& pulse = probe.quantity(
        "F against the mean of a half-sine pulse [N]", Source::quadrature,
        "GSL's estimate and 16 u of the pulse; gamma_2 |F|, 2 of the velocity and its direction");
    Quantity& oracles = probe.quantity("speed after the pulse in the relation [1]", Source::quadrature,
                                       "GSL's estimate and 16 u, over the value; 1 of the speed");
    Arguments a(14);
    for (int n = 0; n < 100; ++n) {
        const double m = a.between(0.001, 2);
        const double dt = a.between(1e-4, 0.3);
        const Vec3 mean = a.vector(50);
        const std::string where = at({{"m", m}, {"dt", dt}, {"set", double(n)}});
        const Vec3 v = a.vector(3);
        const Vec3 F = probe.equations().impulse_force(m, v, dt);
        for (const auto& [force, speed] : {std::pair{F.x, v.x}, std::pair{F.y, v.y}, std::pair{F.z, v.z}}) {
            relation.within(analytic::impulse_imbalance(m, speed, dt, force), 0, rounding(2), where);
        }
        const analytic::Estimate unit = analytic::speed_after_pulse(1, m, dt); // of a mean force of 1 N
        const Vec3 found = probe.equations().impulse_force(m, unit.value * mean, dt);
        const double relative = unit.error / unit.value + rounding(4);
        pulse.within(found.x, mean.x, relative * std::abs(mean.x), where);
        pulse.within(found.y, mean.y, relative * std::abs(mean.y), where);
        pulse.within(found.z, mean.z, relative * std::abs(mean.z), where);
        oracles.within(analytic::impulse_imbalance(m, unit.value, dt, 1), 0,
                       unit.error / unit.value + rounding(1), where);
    }
}

/// Particles with the forces on them, and a part of them as S in ascending order.
struct Impacts {
    double m = 0;
    std::vector<double> density;
    std::vector<Vec3> force;
    std::vector<std::int64_t> S;

    explicit Impacts(Arguments& a, int count) : m(a.between(0.01, 0.9))
    {
        for (int i = 0; i < count; ++i) {
            density.push_back(a.between(700, 1400));
            force.push_back(a.vector(5e4));
            if (a.between(0, 1) < 0.6) {
                S.push_back(i);
            }
        }
    }
    Eigen::Matrix3Xd hits() const
    {
        Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(S.size()));
        for (std::size_t c = 0; c < S.size(); ++c) {
            const auto i = static_cast<std::size_t>(S[c]);
            columns.col(static_cast<Eigen::Index>(c)) = m / density[i] * to_eigen(force[i]);
        }
        return columns;
    }
    Impact by(const backends::Equations& equations) const
    {
        return equations.impact_force(S, m, density, force);
    }
};

void eq16_hardest_hit(Probe& probe)
{
    Quantity& norm = probe.quantity("F_b against the largest column norm [N]", Source::rounding,
                                    "gamma_16 F_b: 8 of a norm of a scaled vector on either side");
    Quantity& square =
        probe.quantity("(rho F_b)^2 = m^2 |F|^2 of the particle named, 50 digits [1]", Source::rounding,
                       "2 gamma_6: a quotient and a product, 3 in the sum of squares, halved by the root, "
                       "its own; an error of F_b counts twice");
    Quantity& who = probe.quantity("particle that made it", Source::exact,
                                   "none: the hardest is harder than any other by more than rounding");
    Arguments a(16);
    for (int n = 0; n < 100; ++n) {
        const Impacts impacts(a, 1 + n % 40);
        const std::string where = at({{"set", double(n)}, {"particles", double(impacts.S.size())}});
        const Impact hit = impacts.by(probe.equations());
        if (impacts.S.empty()) {
            norm.within(hit.force, 0, 0, where + ": empty");
            who.equal(hit.particle, -1, where + ": empty");
            continue;
        }
        const Eigen::Matrix3Xd hits = impacts.hits();
        Eigen::Index hardest = 0;
        const double expected = hits.colwise().norm().maxCoeff(&hardest);
        norm.within(hit.force, analytic::largest_norm(hits), rounding(16) * expected, where);
        who.equal(hit.particle, impacts.S[static_cast<std::size_t>(hardest)], where);
        const auto i = static_cast<std::size_t>(std::max<std::int64_t>(hit.particle, 0));
        square.within(
            analytic::hit_imbalance(impacts.m, impacts.density[i], to_eigen(impacts.force[i]), hit.force), 0,
            2 * rounding(6), where);
    }
}

void eq16_special_hits(Probe& probe)
{
    Quantity& who =
        probe.quantity("particle that made it", Source::exact, "none: equal forces are computed alike");
    Quantity& force = probe.quantity("F_b of nobody, and that it shows what is no number", Source::exact,
                                     "none: nobody's force is 0 by definition, and a NaN stays one");
    Arguments a(161);
    Impacts impacts(a, 9);
    impacts.S = {1, 3, 4, 6, 7};
    impacts.force[4] = {7e4, -8e4, 6e4};
    impacts.force[6] = impacts.force[4];
    impacts.density[6] = impacts.density[4];
    who.equal(impacts.by(probe.equations()).particle, 4, "two equal hits: the lower particle");
    Impacts others = impacts;
    others.force[3] = {9e4, -8e4, 6e4};
    others.force[7] = others.force[3];
    others.density[7] = others.density[3];
    who.equal(others.by(probe.equations()).particle, 3,
              "two others, which a reduction may meet in any order");
    impacts.force[0] = {1e9, 0, 0};
    who.equal(impacts.by(probe.equations()).particle, 4, "a harder one that is not in S");
    for (const std::int64_t place : {1, 4, 7}) { // the first, in the middle, the last
        Impacts broken = impacts;
        broken.force[static_cast<std::size_t>(place)].y = std::numeric_limits<double>::quiet_NaN();
        const Impact hit = broken.by(probe.equations());
        force.holds(std::isnan(hit.force), at({{"no number at", double(place)}}));
        who.equal(hit.particle, place, at({{"no number at", double(place)}}));
    }
    impacts.S.clear();
    force.within(impacts.by(probe.equations()).force, 0, 0, "empty S");
    who.equal(impacts.by(probe.equations()).particle, -1, "empty S");
    impacts.S = {5};
    impacts.force[5] = {};
    force.within(impacts.by(probe.equations()).force, 0, 0, "a hit of no force");
    who.equal(impacts.by(probe.equations()).particle, 5, "a hit of no force");
}

} // namespace

std::vector<Check> rupture_checks()
{
    return {
        formula_check("eq13_criterion", {"13"},
                      "the wall ruptures above the critical pressure, and not at it",
                      {"exact sign, 50 digits", "GSL search for the largest pressure"}, eq13_criterion),
        formula_check("eq14_impulse", {"14"}, "the force of an impact takes all momentum in the time given",
                      {"GSL quadrature of a pulse", "the relation, 50 digits"}, eq14_impulse),
        formula_check("eq16_load", {"16"}, "the wall's load is F_b of the mass that strikes it",
                      {"the relation, 50 digits"}, eq16_load),
        formula_check("eq16_hardest_hit", {"16"}, "the impact is the hardest hit in S, by the particle named",
                      {"Eigen's column norms", "squares, 50 digits"}, eq16_hardest_hit),
        formula_check(
            "eq16_special_hits", {"16"},
            "an empty S is no impact, the lower of two equal particles counts, and nothing hides a NaN",
            {"definition", "construction"}, eq16_special_hits),
    };
}

} // namespace aneurysm::checks
