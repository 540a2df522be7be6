// SPDX-License-Identifier: Apache-2.0
// Section 3.3: how the wall thins while the sac grows (22) and once it is fully developed (23).
#include "analytic/growth.hpp"
#include "analytic/relations.hpp"
#include "analytic/rupture.hpp"
#include "verification/checks/arguments.hpp"
#include "verification/checks/checks.hpp"

#include <algorithm>
#include <cmath>

namespace aneurysm::checks
{
namespace
{

using analytic::Estimate;

/// A sac from R_0 on in n equal steps D, to twice R_0.
constexpr double R_0 = 0.11;
constexpr double h_0 = 0.0075;

double after_growing(const backends::Equations& equations, double sigma, int n)
{
    const double D = R_0 / n;
    double h = h_0;
    for (int k = 0; k < n; ++k) {
        h = equations.thickness_growing(h, R_0 + k * D, sigma, D);
    }
    return h;
}

void eq22_step(Probe& probe)
{
    Quantity& relation =
        probe.quantity("h' - h = -h sigma dR/R, 50 digits [1]", Source::rounding,
                       "gamma_4 of h, the largest term: two products and a quotient, and a difference");
    Quantity& tangent = probe.quantity(
        "h' against the tangent of the power law of (9) [m]", Source::rounding,
        "gamma_4 h of the step, gamma_17 of the slope by the complex step times dR, u of their sum");
    Quantity& oracles = probe.quantity("the tangent in the relation [1]", Source::rounding,
                                       "gamma_17 of the slope times dR, u of their sum, over h");
    Arguments a(22);
    for (int n = 0; n < 200; ++n) {
        const double h = a.between(0.001, 0.03);
        const double R = a.between(0.05, 0.7);
        const double sigma = a.between(0.05, 0.9);
        const double dR = R * a.between(-0.3, 0.9);
        const double after = probe.equations().thickness_growing(h, R, sigma, dR);
        const std::string where = at({{"h", h}, {"R", R}, {"sigma", sigma}, {"dR", dR}});
        relation.within(analytic::thinning_step_imbalance(h, R, sigma, dR, after), 0, rounding(4), where);
        const double change = analytic::thickness_slope({1, sigma, 1, R, h, 0}, R) * dR;
        const double of_tangent = rounding(17) * std::abs(change) + rounding(1) * (h + std::abs(change));
        tangent.within(after, h + change, rounding(4) * (h + std::abs(change)) + of_tangent, where);
        oracles.within(analytic::thinning_step_imbalance(h, R, sigma, dR, h + change), 0, of_tangent / h,
                       where);
    }
}

void eq22_product(Probe& probe)
{
    Quantity& product =
        probe.quantity("h after n steps against Pochhammer's symbols [m]", Source::rounding,
                       "GSL's bound of their logarithms, whose difference is the exponent; n gamma_2 + "
                       "gamma_5: a step rounds twice on h and four times on a change below h/n");
    Quantity& power_law =
        probe.quantity("h over the power law of (9), less 1 [1]", Source::truncation,
                       "two-sided: Euler-Maclaurin's expansion, whose rest is known; n gamma_2 of the steps, "
                       "gamma_10 of the power law (docs/bounds.md, B15)");
    Quantity& oracles = probe.quantity(
        "Pochhammer's symbols over the power law, less 1 [1]", Source::truncation,
        "GSL's bound; the rest of Euler-Maclaurin's expansion; gamma_10 of the power law (docs/bounds.md, "
        "B15)");
    for (const double sigma : {0.2, 0.43, 0.9}) {
        for (const int n : {10, 40, 160, 640}) {
            const std::string where = at({{"sigma", sigma}, {"n", double(n)}});
            const double D = R_0 / n;
            const double h = after_growing(probe.equations(), sigma, n);
            const Estimate exact = analytic::thickness_after_steps(h_0, R_0, sigma, D, n);
            product.within(h, exact, n * rounding(2) + rounding(5), where);
            const analytic::Wall wall{1, sigma, 1, R_0, h_0, 0};
            const double limit = analytic::thickness(wall, R_0 + n * D);
            const Estimate missed = analytic::euler_thinning_error(R_0, sigma, D, n);
            power_law.within(h / limit - 1, missed.value, missed.error + n * rounding(2) + rounding(10),
                             where);
            oracles.within(exact.value / limit - 1, missed.value,
                           missed.error + exact.error / exact.value + rounding(10), where);
        }
    }
}

void eq23_step(Probe& probe)
{
    Quantity& relation = probe.quantity("h' - h = -h alpha min(dR, largest), 50 digits [1]", Source::rounding,
                                        "gamma_3 of h, the largest term: a product, a difference, a product");
    Quantity& power = probe.quantity("h' against h exp(ln(1 - alpha min(dR, largest))) [m]", Source::rounding,
                                     "gamma_3 of h or h'; 4 u of the logarithm and 2 u of the exponential");
    Quantity& oracles = probe.quantity("the exponential in the relation [1]", Source::rounding,
                                       "4 u of the logarithm and 2 u of the exponential, of h' over h");
    Quantity& cap =
        probe.quantity("h' from the largest increment on [m]", Source::exact,
                       "none: a larger increment is cut down to the largest before anything is computed");
    Arguments a(23);
    for (int n = 0; n < 200; ++n) {
        const double h = a.between(0.001, 0.03);
        const double alpha = a.between(0.3, 2);
        const double largest = a.between(0.05, 0.3);
        const auto step = [&](double dR) {
            return probe.equations().thickness_developed(h, alpha, dR, largest);
        };
        for (const double dR :
             {largest * a.between(0.01, 1), largest * a.between(1, 30), -largest * a.between(0.01, 2),
              largest, std::nextafter(largest, 0), std::nextafter(largest, 1)}) {
            const std::string where = at({{"h", h}, {"alpha", alpha}, {"dR/largest", dR / largest}});
            const auto imbalance = [&](double after) {
                return analytic::developed_step_imbalance(h, alpha, dR, largest, after);
            };
            relation.within(imbalance(step(dR)), 0, rounding(3), where);
            const Estimate one =
                analytic::thickness_developed_after_steps(h, alpha, std::min(dR, largest), 1);
            power.within(step(dR), one.value, one.error + rounding(3) * std::max(h, one.value), where);
            oracles.within(imbalance(one.value), 0, one.error / h, where);
            if (dR >= largest) {
                cap.within(step(dR), step(largest), 0, where);
            }
        }
        cap.holds(step(0.9 * largest) > step(largest),
                  at({{"h", h}, {"alpha", alpha}}) + ": thins less below it");
    }
}

void eq23_product(Probe& probe)
{
    Quantity& power = probe.quantity(
        "h after n steps against the power [m]", Source::rounding,
        "4 u of the exponent n ln(1 - alpha D) and 2 u of the exponential; n gamma_3 of the steps");
    Quantity& exponential =
        probe.quantity("h over h_0 exp(-alpha n D), less 1 [1]", Source::truncation,
                       "two-sided: half of the range of the logarithm's remainder; n gamma_3 of the steps, "
                       "gamma_6 of the exponential (docs/bounds.md, B16)");
    Quantity& oracles =
        probe.quantity("power over h_0 exp(-alpha n D), less 1 [1]", Source::truncation,
                       "half of the range of the logarithm's remainder; the power's own bound, gamma_6 of "
                       "the exponential (docs/bounds.md, B16)");
    for (const double alpha : {1.1, 0.7}) {
        for (const int n : {1, 100, 1000, 4000}) {
            const std::string where = at({{"alpha", alpha}, {"n", double(n)}});
            const double D = std::min(0.8 / n, 9e-3);
            double h = h_0;
            for (int k = 0; k < n; ++k) {
                h = probe.equations().thickness_developed(h, alpha, D, 1e-2);
            }
            const Estimate exact = analytic::thickness_developed_after_steps(h_0, alpha, D, n);
            power.within(h, exact, n * rounding(3), where);
            const double limit = h_0 * std::exp(-alpha * n * D);
            const Estimate missed = analytic::exponential_thinning_error(alpha, D, n);
            exponential.within(h / limit - 1, missed.value, missed.error + n * rounding(3) + rounding(6),
                               where);
            oracles.within(exact.value / limit - 1, missed.value,
                           missed.error + exact.error / exact.value + rounding(6), where);
        }
    }
}

} // namespace

std::vector<Check> growth_thinning_checks()
{
    return {
        formula_check("eq22_step", {"22"}, "a step thins the wall by Poisson's ratio of the radius' growth",
                      {"tangent of the power law by the complex step", "the relation, 50 digits"}, eq22_step),
        formula_check("eq22_product", {"22"},
                      "equal steps give the product, which misses the power law by what Euler's method must",
                      {"Pochhammer's symbols of GSL", "power law with Euler-Maclaurin"}, eq22_product),
        formula_check("eq23_step", {"23"},
                      "a fully developed wall thins in proportion to its growth, which is capped",
                      {"exponential of the logarithm", "the relation, 50 digits"}, eq23_step),
        formula_check("eq23_product", {"23"},
                      "equal steps give the power, which misses the exponential by what a product must",
                      {"power", "exponential with its next term"}, eq23_product),
    };
}

} // namespace aneurysm::checks
